// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/diagnostic.h"

struct archive;

namespace proveout {

/// Reads the entries of a ZIP archive, one after the other, and no more of each than is requested: no memory
/// is allocated because of what an archive claims or inflates to. Owned by one thread.
class ZipReader {
public:
    ZipReader();
    ZipReader(const ZipReader&) = delete;
    ZipReader& operator=(const ZipReader&) = delete;
    ~ZipReader();

    /// Opens a regular file. Errors: missing, unreadable, a folder or special file, not a ZIP archive.
    [[nodiscard]] Result<void> open(const std::filesystem::path& file);
    /// The name of the next entry; empty if there is none, or none that can be read.
    [[nodiscard]] std::string nextEntry();
    /// Reads the next bytes of the entry, at most `count`; less than `count` only at its end or where it is
    /// damaged, which `intact()` distinguishes.
    [[nodiscard]] std::size_t read(void* bytes, std::size_t count);
    /// Whether the entry ends here, and its checksum is right.
    [[nodiscard]] bool intact();

private:
    archive* m_archive;
    bool m_broken = false;
};

} // namespace proveout
