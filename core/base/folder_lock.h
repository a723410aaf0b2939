// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace proveout {

/// The turn of one writer in a folder: others that ask for it wait, in this process and in others, until this
/// object is gone or its process has ended. It makes one step of comparing a file and replacing it. At most
/// two seconds are waited; then, and where a file system has no locks, the work goes on without: the
/// comparison alone has to do. Blocks the thread; not movable.
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
