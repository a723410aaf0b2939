// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"

namespace proveout {

/// A file that appears whole or not at all: bytes go to a temporary file beside the target, and `commit()`
/// flushes them to the disk and renames it. Without a successful commit the temporary file is removed and an
/// older file stays as it was. On most file systems the temporary file has no name until then, so that it
/// disappears even if the program is killed; on others the next write into the folder removes it
/// (unfinished_files.h). Ownership: holds an open descriptor, movable. Errors: kept and reported by
/// `commit()`; writing after an error is harmless and is counted, so that the message can say how many bytes
/// are needed. The permissions of an existing target are kept; a symbolic link is followed, so that the link
/// survives; folders, special files and write-protected files are never replaced.
class AtomicFile {
public:
    /// `expectedBytes`, where it is known, is reserved at once, so that a full disk is reported before the
    /// work, and is released if there is no commit.
    explicit AtomicFile(std::filesystem::path target, std::uint64_t expectedBytes = 0);
    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    AtomicFile& operator=(AtomicFile&&) = delete;
    ~AtomicFile();

    void write(const void* data, std::size_t size);
    void write(std::string_view text) { write(text.data(), text.size()); }
    [[nodiscard]] std::uint64_t bytesWritten() const { return m_written; }
    [[nodiscard]] bool failed() const { return m_error != 0; }
    /// Whether the file could be opened and the expected bytes reserved: the error that commit() would report
    /// for that.
    [[nodiscard]] Result<void> ready() const;

    /// Call it once. Until it returns without an error the target is as it was.
    [[nodiscard]] Result<void> commit();

private:
    void openNamed(unsigned mode); ///< `mode`: permissions, to which the system applies the umask
    void giveName();
    void rename();
    void reserve();
    void flush();
    void discard();
    [[nodiscard]] Diagnostics unwritable() const;

    std::filesystem::path m_target;
    std::filesystem::path m_temporary; ///< empty while the file has no name
    std::string m_buffer;
    std::uint64_t m_written = 0;
    std::uint64_t m_expected = 0; ///< 0: not known
    int m_descriptor = -1;
    int m_error = 0; ///< errno of the first failure, below 0 for those that have none
};

/// Writes a whole file atomically.
[[nodiscard]] Result<void> writeFile(const std::filesystem::path& target, std::string_view bytes);

inline constexpr std::uint64_t kLargestReadFile = 4'000'000'000; ///< bytes

/// Reads a whole regular file; never waits (a FIFO is refused). Errors: missing, unreadable, a folder or
/// special file, larger than `limit` bytes or than the memory that is free, stopped (id "cancelled").
[[nodiscard]] Result<std::string> readFile(const std::filesystem::path& source,
                                           std::uint64_t limit = kLargestReadFile,
                                           const WorkContext& context = {});

} // namespace proveout
