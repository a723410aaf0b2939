// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/diagnostic.h"

struct archive;

namespace proveout {

/// Reads the entries of a ZIP archive, one after the other, and of each no more than is asked for: whatever
/// an archive says or inflates to, nothing is taken for it here. Owned by one thread.
class ZipReader {
public:
    ZipReader();
    ZipReader(const ZipReader&) = delete;
    ZipReader& operator=(const ZipReader&) = delete;
    ~ZipReader();

    /// A regular file. Errors: missing, unreadable, a folder or special file, no ZIP archive.
    [[nodiscard]] Result<void> open(const std::filesystem::path& file);
    /// The name of the next entry; empty where there is none, or none that can be read.
    [[nodiscard]] std::string nextEntry();
    /// Of the entry, as many bytes as there are, at most `count`; less than `count` only at its end or where
    /// it is broken, which `intact()` tells apart.
    [[nodiscard]] std::size_t read(void* bytes, std::size_t count);
    /// Whether the entry ends here, and its checksum is right.
    [[nodiscard]] bool intact();

private:
    archive* m_archive;
    bool m_broken = false;
};

} // namespace proveout
