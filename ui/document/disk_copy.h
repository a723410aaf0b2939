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

/// What a file held when this window last read or wrote it, byte for byte: so a save can find out whether
/// somebody else has changed it since, however quickly and whatever its date says. Shares the bytes of the
/// text. Value type; any thread.
class DiskCopy {
public:
    /// Of no file: whatever is there is somebody else's.
    DiskCopy() = default;
    DiskCopy(NcText text, bool byteOrderMark);
    /// Of a file whose bytes cannot be kept: size and date have to do.
    explicit DiskCopy(const FileState& state) : m_state(state) {}

    /// Whether its bytes are known.
    [[nodiscard]] bool isKnown() const { return m_known; }

    /// Reads the file, at most as many bytes as are known. Errors: a folder or a special file is there, or
    /// the file cannot be read.
    [[nodiscard]] Result<DiskState> compare(const std::filesystem::path& file) const;
    /// SHA-256 of the bytes, in hexadecimal digits; empty of no file. Reads them all.
    [[nodiscard]] std::string digest() const;

    /// What the file holds now. Errors: those of readFile(), which refuses more than `limit` bytes.
    [[nodiscard]] static Result<DiskCopy> read(const std::filesystem::path& file, std::uint64_t limit);
    [[nodiscard]] const NcText& text() const { return m_text; }

private:
    NcText m_text;
    bool m_byteOrderMark = false;
    bool m_known = false;
    std::optional<FileState> m_state; ///< in the place of bytes
};

} // namespace proveout
