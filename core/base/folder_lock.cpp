// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/folder_lock.h"

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

namespace proveout {

namespace {

constexpr std::chrono::milliseconds kBetweenTries{5};
constexpr int kTries = 400; // two seconds: another program may hold such a lock indefinitely

} // namespace

FolderLock::FolderLock(const std::filesystem::path& folder)
    : m_descriptor(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    for (int i = 0; m_descriptor >= 0 && i < kTries; ++i) {
        if (::flock(m_descriptor, LOCK_EX | LOCK_NB) == 0 || (errno != EWOULDBLOCK && errno != EINTR))
            return;
        std::this_thread::sleep_for(kBetweenTries);
    }
}

FolderLock::~FolderLock() {
    if (m_descriptor >= 0)
        ::close(m_descriptor);
}

} // namespace proveout
