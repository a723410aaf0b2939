// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/unfinished_files.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <fmt/format.h>
#include <random>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace proveout {

namespace {

constexpr std::string_view kBeginning = ".proveout-";
constexpr std::string_view kEnding = ".part";
constexpr std::size_t kRandomDigits = 8;

/// FNV-1a hash of the name of this computer: a lock does not show whether a process of another computer is
/// still writing.
std::uint32_t computerTag() {
    std::array<char, 256> name{};
    static_cast<void>(::gethostname(name.data(), name.size() - 1));
    std::uint32_t hash = 2166136261U;
    for (const char letter : std::string_view(name.data()))
        hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619U;
    return hash;
}

std::string beginningHere() {
    return fmt::format("{}{:08x}", kBeginning, computerTag());
}

/// Opened without following a link, so that no other file can be removed by means of a link.
void removeIfAbandoned(const std::filesystem::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0)
        return;
    struct stat opened {};
    struct stat named {};
    // The name is checked again once the lock is held: the writer may have renamed the file in the meantime.
    if (::fstat(descriptor, &opened) == 0 && S_ISREG(opened.st_mode) && opened.st_uid == ::geteuid() &&
        ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ::lstat(file.c_str(), &named) == 0 &&
        named.st_dev == opened.st_dev && named.st_ino == opened.st_ino)
        ::unlink(file.c_str());
    ::close(descriptor);
}

} // namespace

std::string unfinishedName() {
    std::random_device random;
    return fmt::format("{}{:08x}{}", beginningHere(), random(), kEnding);
}

bool claimUnfinished(int descriptor) {
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0)
        return errno != EWOULDBLOCK; // a file system without locks: no process removes what cannot be locked
    struct stat info {};
    return ::fstat(descriptor, &info) != 0 || info.st_nlink > 0;
}

void removeUnfinished(const std::filesystem::path& folder) {
    const std::string beginning = beginningHere();
    const std::size_t size = beginning.size() + kRandomDigits + kEnding.size();
    std::error_code error;
    std::filesystem::directory_iterator entry(folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.size() == size && name.starts_with(beginning) && name.ends_with(kEnding))
            removeIfAbandoned(entry->path());
    }
}

} // namespace proveout
