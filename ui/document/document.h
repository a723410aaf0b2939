// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/diagnostic.h"
#include "core/base/file_state.h"
#include "core/base/work_context.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

enum class LineEnd : std::uint8_t { lf, crLf, cr };

/// Texts with more bytes are read-only: an insertion moves up to all of them.
inline constexpr std::size_t kEditableBytes = 1'000'000'000;

/// Texts with a longer line are read-only and their long lines are cut off, because the editor lays out a
/// whole line whenever it paints a part of it.
inline constexpr std::size_t kEditableLine = 20'000;

/// An NC text together with everything that a save must preserve. The text is bytes: offsets of edits are
/// byte offsets, and bytes that are not UTF-8 survive. Value type.
struct Document {
    std::filesystem::path path; ///< empty: not saved yet
    NcText text;
    bool byteOrderMark = false;
    bool utf8 = true;              ///< false: shown as Latin-1, one byte per character
    LineEnd lineEnd = LineEnd::lf; ///< the most frequent one; new lines get it
    bool modified = false;
    bool readOnly = false;
    std::size_t tooLongLine = 0; ///< 1-based, the first line longer than kEditableLine; 0 if there is none
    FileState onDisk;            ///< state of the file just before it was read
};

/// Any thread. Errors: those of NcText::load.
[[nodiscard]] Result<Document> loadDocument(const std::filesystem::path& file,
                                            const WorkContext& context = {});

/// The same for a text that will not be open when an error is shown: errors have no location.
[[nodiscard]] Result<Document> loadClosedDocument(const std::filesystem::path& file,
                                                  const WorkContext& context = {});

/// Writes the text atomically, including the byte order mark.
[[nodiscard]] Result<void> saveDocument(const Document& document, const std::filesystem::path& file);

[[nodiscard]] LineEnd mostFrequentLineEnd(std::string_view text);

} // namespace proveout
