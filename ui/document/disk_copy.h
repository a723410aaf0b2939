// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/diagnostic.h"
#include "core/base/file_state.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

/// What a file holds now, compared with what was last read from it or written to it.
enum class DiskState : std::uint8_t { same, changed, missing };

/// What a file contained when this window last read or wrote it, byte for byte. A save uses it to find out
/// whether another program has changed the file since, however quickly and whatever its date says. Shares the
/// bytes of the text. Value type; any thread.
class DiskCopy {
public:
    /// No file is known, so any file that exists was written by another program.
    DiskCopy() = default;
    DiskCopy(NcText text, bool byteOrderMark);
    /// For a file whose bytes cannot be kept: only size and date are compared.
    explicit DiskCopy(const FileState& state) : m_state(state) {}

    /// Whether the bytes of the file are known.
    [[nodiscard]] bool isKnown() const { return m_known; }

    /// Reads the file, at most as many bytes as are known. Errors: the path is a folder or a special file, or
    /// the file cannot be read.
    [[nodiscard]] Result<DiskState> compare(const std::filesystem::path& file) const;
    /// SHA-256 of the bytes as hexadecimal digits; empty if there is no file. Reads all bytes.
    [[nodiscard]] std::string digest() const;

    /// What the file contains now. Errors: those of readFile(), which refuses more than `limit` bytes.
    [[nodiscard]] static Result<DiskCopy> read(const std::filesystem::path& file, std::uint64_t limit);
    [[nodiscard]] const NcText& text() const { return m_text; }

private:
    NcText m_text;
    bool m_byteOrderMark = false;
    bool m_known = false;
    std::optional<FileState> m_state; ///< used instead of the bytes
};

} // namespace proveout
