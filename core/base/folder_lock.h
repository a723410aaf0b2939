// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace proveout {

/// Locks a folder for one writer: others that ask for it wait, in this process and in others, until this
/// object is destroyed or its process has ended. It makes comparing a file and replacing it a single step.
/// The wait is two seconds at most; then, and where a file system has no locks, the writer continues without
/// a lock and relies on the comparison alone. Blocks the thread; not movable.
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int m_descriptor = -1;
};

} // namespace proveout
