// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/atomic_file.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <limits>
#include <linux/magic.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statfs.h>
#include <sys/statvfs.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "core/base/base_findings.h"
#include "core/base/figures_argument.h"
#include "core/base/memory.h"
#include "core/base/unfinished_files.h"

namespace proveout {

namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 20;
constexpr std::size_t kReportedBytes = std::size_t{1} << 22; ///< bytes written between two progress messages
constexpr off_t kSurelyFits = 16'000'000;                    ///< bytes

/// Used in place of an errno: the target is a device, a pipe or the like.
constexpr int kNotRegular = -1;

std::string reason(int error) {
    return error == kNotRegular ? "not a regular file"
                                : std::error_code(error, std::generic_category()).message();
}

bool lacksRoom(int error) {
    return error == ENOSPC || error == EDQUOT || error == EFBIG;
}

/// Where the bytes finally go: symbolic links are followed, so that they stay links, even one whose target
/// does not exist yet.
std::filesystem::path resolved(std::filesystem::path target) {
    constexpr int kMostLinks = 40; // the system itself reports ELOOP beyond this number
    std::error_code error;
    for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(target, error); ++i) {
        const auto next = std::filesystem::read_symlink(target, error);
        if (error)
            break;
        target = target.parent_path() / next; // an absolute `next` replaces the folder
    }
    return target;
}

/// The error that makes it impossible to put a regular file in the place of `target`; 0 if there is none.
int refusal(const std::filesystem::path& target) {
    std::error_code ignored;
    const auto status = std::filesystem::status(target, ignored);
    if (std::filesystem::is_directory(status))
        return EISDIR;
    if (!std::filesystem::exists(status))
        return 0;
    if (!std::filesystem::is_regular_file(status))
        return kNotRegular;
    // A rename would replace a write-protected file without asking; run as superuser, even one without write
    // permission for anyone.
    constexpr auto kAnyWrite = std::filesystem::perms::owner_write | std::filesystem::perms::group_write |
                               std::filesystem::perms::others_write;
    if ((status.permissions() & kAnyWrite) == std::filesystem::perms::none)
        return EACCES;
    return ::access(target.c_str(), W_OK) == 0 ? 0 : errno;
}

std::filesystem::path folderOf(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

/// The link in /proc that refers to an open file; it is used to give a nameless file its name.
std::string shownAs(int descriptor) {
    return fmt::format("/proc/self/fd/{}", descriptor);
}

/// Opens a file without a name, of which nothing remains if the program is killed. Below 0 where the system
/// or the file system does not support this.
int openNameless(const std::filesystem::path& folder, mode_t mode) {
    const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
    if (descriptor >= 0 && ::access(shownAs(descriptor).c_str(), F_OK) != 0) {
        ::close(descriptor);
        return -1;
    }
    return descriptor;
}

/// In a file system in memory, reserved space uses up memory before any data is written.
bool isInMemory(int descriptor) {
    struct statfs disk {};
    return ::fstatfs(descriptor, &disk) == 0 && disk.f_type == TMPFS_MAGIC;
}

/// The error that keeps `bytes` from fitting into the file, as far as the file system reports it; 0 if none
/// is known. File systems that cannot reserve space say so in several ways.
int reserveRoom(int descriptor, std::uint64_t bytes) {
    struct rlimit limit {};
    if (::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY && bytes > limit.rlim_cur)
        return EFBIG;
    if (bytes > static_cast<std::uint64_t>(std::numeric_limits<off_t>::max()))
        return EFBIG;
    if (!isInMemory(descriptor)) {
        if (::fallocate(descriptor, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(bytes)) == 0)
            return 0;
        if (lacksRoom(errno))
            return errno;
    }
    struct statvfs disk {};
    const bool known = ::fstatvfs(descriptor, &disk) == 0 && disk.f_blocks > 0;
    return known && bytes / disk.f_frsize >= disk.f_bavail ? ENOSPC : 0;
}

/// Makes the rename itself survive a power failure. Some file systems refuse to sync a folder; then nothing
/// can be done about it.
void syncFolder(const std::filesystem::path& file) {
    const int descriptor = ::open(folderOf(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;
    static_cast<void>(::fsync(descriptor));
    ::close(descriptor);
}

tl::unexpected<Diagnostics> cannotRead(const std::filesystem::path& file, int error) {
    return failure(base_finding::kFileUnreadable, {reason(error)}, file.string());
}

} // namespace

AtomicFile::AtomicFile(std::filesystem::path target, std::uint64_t expectedBytes)
    : m_target(resolved(std::move(target))), m_expected(expectedBytes), m_error(refusal(m_target)) {
    if (failed())
        return;
    removeUnfinished(folderOf(m_target)); // before space is reserved, since they may occupy it
    struct stat old {};
    const bool replaces = ::stat(m_target.c_str(), &old) == 0;
    // The mode goes through open(), where the system applies the umask: reading the umask requires
    // setting it, which other threads would see.
    const mode_t mode = replaces ? 0600 : 0666;
    m_descriptor = openNameless(folderOf(m_target), mode);
    if (m_descriptor < 0)
        openNamed(mode);
    if (failed())
        return;
    if (replaces && ::fchmod(m_descriptor, old.st_mode & 07777) != 0)
        m_error = errno;
    m_buffer.reserve(kBufferSize);
    reserve();
}

void AtomicFile::openNamed(unsigned mode) {
    do {
        if (m_descriptor >= 0) // another process mistook it for an abandoned one before it could be claimed
            ::close(m_descriptor);
        m_temporary = m_target.parent_path() / unfinishedName();
        m_descriptor = ::open(m_temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    } while (m_descriptor < 0 ? errno == EEXIST || errno == EINTR : !claimUnfinished(m_descriptor));
    if (m_descriptor < 0) {
        m_error = errno;
        m_temporary.clear();
    }
}

void AtomicFile::giveName() {
    const std::string shown = shownAs(m_descriptor);
    static_cast<void>(claimUnfinished(m_descriptor)); // no other process can open it yet
    int result = 0;
    do {
        m_temporary = m_target.parent_path() / unfinishedName();
        result = ::linkat(AT_FDCWD, shown.c_str(), AT_FDCWD, m_temporary.c_str(), AT_SYMLINK_FOLLOW);
    } while (result != 0 && errno == EEXIST);
    if (result != 0) {
        m_error = errno;
        m_temporary.clear();
    }
}

void AtomicFile::reserve() {
    if (!failed() && m_expected > 0)
        m_error = reserveRoom(m_descriptor, m_expected);
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : m_target(std::move(other.m_target)), m_temporary(std::exchange(other.m_temporary, {})),
      m_buffer(std::move(other.m_buffer)), m_written(other.m_written), m_expected(other.m_expected),
      m_descriptor(std::exchange(other.m_descriptor, -1)), m_error(other.m_error) {}

AtomicFile::~AtomicFile() {
    discard();
}

void AtomicFile::write(const void* data, std::size_t size) {
    if (m_descriptor < 0)
        return;
    m_written += size; // bytes that no longer fit still count as needed
    if (failed())
        return;
    if (m_buffer.size() + size > kBufferSize)
        flush();
    m_buffer.append(static_cast<const char*>(data), size);
}

void AtomicFile::flush() {
    std::size_t done = 0;
    while (done < m_buffer.size() && !failed()) {
        const auto count = ::write(m_descriptor, m_buffer.data() + done, m_buffer.size() - done);
        if (count >= 0)
            done += static_cast<std::size_t>(count);
        else if (errno != EINTR)
            m_error = errno;
    }
    m_buffer.clear();
}

void AtomicFile::discard() {
    if (m_descriptor >= 0)
        ::close(std::exchange(m_descriptor, -1));
    if (!m_temporary.empty())
        ::unlink(std::exchange(m_temporary, {}).c_str());
}

/// Network file systems report late write errors at the close, so it comes before the rename. A second
/// descriptor holds the claim until then; otherwise another process could remove the file in between.
void AtomicFile::rename() {
    const int claim = ::fcntl(m_descriptor, F_DUPFD_CLOEXEC, 0);
    if (::close(std::exchange(m_descriptor, -1)) != 0)
        m_error = errno;
    if (!failed() && ::rename(m_temporary.c_str(), m_target.c_str()) != 0)
        m_error = errno;
    if (claim >= 0)
        ::close(claim);
}

Result<void> AtomicFile::ready() const {
    return failed() ? Result<void>(tl::unexpected(unwritable())) : Result<void>();
}

Result<void> AtomicFile::commit() {
    assert((m_descriptor >= 0 || failed()) && "committed twice, or moved from");
    if (!failed())
        flush();
    if (!failed() && ::fsync(m_descriptor) != 0)
        m_error = errno;
    if (!failed() && m_temporary.empty())
        giveName();
    if (!failed())
        rename();
    if (failed()) {
        discard();
        return tl::unexpected(unwritable());
    }
    m_temporary.clear();
    syncFolder(m_target);
    return {};
}

Diagnostics AtomicFile::unwritable() const {
    const std::uint64_t needed = std::max(m_expected, m_written);
    const std::string file = m_target.string();
    if (needed == 0 || (m_written == 0 && !lacksRoom(m_error)))
        return failure(base_finding::kFileUnwritable, {reason(m_error)}, file).value();
    return failure(base_finding::kFileUnwritableSize,
                   {figures("{}", readableBytes(static_cast<double>(needed))), reason(m_error)}, file)
        .value();
}

Result<void> writeFile(const std::filesystem::path& target, std::string_view bytes) {
    AtomicFile file(target, bytes.size());
    file.write(bytes);
    return file.commit();
}

Result<std::string> readFile(const std::filesystem::path& source, std::uint64_t limit,
                             const WorkContext& context) {
    // O_NONBLOCK: opening a FIFO must not wait for a writer.
    const int descriptor = ::open(source.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0)
        return cannotRead(source, errno);
    struct stat info {};
    if (::fstat(descriptor, &info) != 0 || !S_ISREG(info.st_mode)) {
        ::close(descriptor);
        return failure(S_ISDIR(info.st_mode) ? base_finding::kFileNotRegularFolder
                                             : base_finding::kFileNotRegular,
                       {}, source.string());
    }
    // The memory limit also applies: a file within `limit` may still need more memory than is available.
    // Small files are not checked, because the check takes longer than reading them.
    if (info.st_size > kSurelyFits)
        limit = std::min(limit, memoryLimitBytes());
    if (static_cast<std::uint64_t>(info.st_size) > limit) {
        ::close(descriptor);
        return failure(base_finding::kFileTooLarge,
                       {figures("{}", readableBytes(static_cast<double>(info.st_size))),
                        figures("{}", readableBytes(static_cast<double>(limit)))},
                       source.string());
    }
    std::string bytes;
    bytes.reserve(static_cast<std::size_t>(info.st_size));
    std::array<char, 65536> chunk{};
    int error = 0;
    std::size_t toReport = kReportedBytes;
    while (!context.stopped()) {
        if (bytes.size() >= toReport) {
            toReport += kReportedBytes;
            context.report(
                std::min(1.0, static_cast<double>(bytes.size()) / static_cast<double>(info.st_size)));
        }
        const auto count = ::read(descriptor, chunk.data(), chunk.size());
        if (count > 0) {
            bytes.append(chunk.data(), static_cast<std::size_t>(count));
            if (bytes.size() > limit) // the file grew while it was being read
                error = EFBIG;
        } else if (count < 0 && errno != EINTR) {
            error = errno;
        }
        if (count == 0 || error != 0)
            break;
    }
    ::close(descriptor);
    if (error != 0)
        return cannotRead(source, error);
    if (context.stopped())
        return failure(base_finding::kCancelledReading, {}, source.string());
    return bytes;
}

} // namespace proveout
