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

/// Texts above this size are shown read-only: an insertion in the middle of them would hold up the window.
inline constexpr std::size_t kEditableBytes = 10'000'000;

/// Texts with a longer line are shown read-only, and their lines cut off: the editor lays out a whole line
/// whenever it paints a part of it.
inline constexpr std::size_t kEditableLine = 20'000;

/// An NC text with what a save must bring back as it was. The text is bytes: offsets of edits are byte
/// offsets, and bytes that are not UTF-8 survive. Value type.
struct Document {
    std::filesystem::path path; ///< empty: not saved yet
    NcText text;
    bool byteOrderMark = false;
    bool utf8 = true;              ///< false: shown as Latin-1, one byte a character
    LineEnd lineEnd = LineEnd::lf; ///< of most lines; a new line gets it
    bool modified = false;
    bool readOnly = false;
    std::size_t tooLongLine = 0; ///< 1-based, the first one beyond kEditableLine; 0 where there is none
    FileState onDisk;            ///< of the file, from before it was read
};

/// Any thread. Errors: those of NcText::load.
[[nodiscard]] Result<Document> loadDocument(const std::filesystem::path& file,
                                            const WorkContext& context = {});

/// Writes the text atomically, byte order mark included.
[[nodiscard]] Result<void> saveDocument(const Document& document, const std::filesystem::path& file);

[[nodiscard]] LineEnd mostFrequentLineEnd(std::string_view text);

} // namespace proveout
