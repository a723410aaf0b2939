// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/atomic_file.h"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "tests/core/file_size_limit.h"
#include "tests/core/temporary_folder.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

mode_t modeOf(const fs::path& file) {
    struct stat info {};
    EXPECT_EQ(::stat(file.c_str(), &info), 0);
    return info.st_mode & 07777;
}

TEST(AtomicFile, HoldsEveryByteThatWasWritten) {
    const TemporaryFolder folder;
    std::string expected;
    {
        AtomicFile file(folder / "a");
        for (int i = 0; i < 300'000; ++i) { // larger than the buffer
            const std::string line = std::to_string(i) + "\n";
            file.write(line);
            expected += line;
        }
        EXPECT_EQ(file.bytesWritten(), expected.size());
        EXPECT_FALSE(fs::exists(folder / "a")) << "the target must not be there before the commit";
        ASSERT_TRUE(file.commit());
    }
    EXPECT_EQ(readFile(folder / "a").value(), expected);
    EXPECT_EQ(folder.entries(), 1U);
}

TEST(AtomicFile, LeavesTheOldFileWithoutACommit) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder / "a", "old"));
    {
        AtomicFile file(folder / "a");
        file.write("new");
    }
    EXPECT_EQ(readFile(folder / "a").value(), "old");
    EXPECT_EQ(folder.entries(), 1U);
}

TEST(AtomicFile, MovesWithItsTemporary) {
    const TemporaryFolder folder;
    {
        AtomicFile first(folder / "a");
        first.write("one ");
        AtomicFile second(std::move(first));
        second.write("two");
        ASSERT_TRUE(second.commit());
    }
    EXPECT_EQ(readFile(folder / "a").value(), "one two");
    EXPECT_EQ(folder.entries(), 1U);
}

TEST(AtomicFile, KeepsPermissionsOfTheTargetAndFollowsTheUmaskElsewhere) {
    const TemporaryFolder folder;
    const mode_t old = ::umask(027);
    ASSERT_TRUE(writeFile(folder / "new", "x"));
    ::umask(old);
    EXPECT_EQ(modeOf(folder / "new"), 0640U);

    fs::permissions(folder / "new", fs::perms(0604));
    ASSERT_TRUE(writeFile(folder / "new", "y"));
    EXPECT_EQ(modeOf(folder / "new"), 0604U);
}

TEST(AtomicFile, FollowsSymbolicLinks) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "deep");
    ASSERT_TRUE(writeFile(folder / "deep/real", "old"));
    fs::create_symlink("deep/real", folder / "link");
    fs::create_symlink("link", folder / "link-to-link");
    fs::create_symlink("deep/not-yet", folder / "dangling");

    ASSERT_TRUE(writeFile(folder / "link-to-link", "new"));
    EXPECT_EQ(readFile(folder / "deep/real").value(), "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_TRUE(fs::is_symlink(folder / "link-to-link"));

    ASSERT_TRUE(writeFile(folder / "dangling", "made"));
    EXPECT_TRUE(fs::is_symlink(folder / "dangling"));
    EXPECT_EQ(readFile(folder / "deep/not-yet").value(), "made");
}

TEST(AtomicFile, RefusesALinkThatLeadsToItself) {
    const TemporaryFolder folder;
    fs::create_symlink("b", folder / "a");
    fs::create_symlink("a", folder / "b");
    EXPECT_FALSE(readFile(folder / "a"));
    static_cast<void>(writeFile(folder / "a", "x")); // must end and leave no files
    EXPECT_EQ(folder.entries(), 2U);
}

TEST(AtomicFile, TakesNamesAsLongAsTheSystemDoes) {
    const TemporaryFolder folder;
    const std::string name(255, 'n');
    ASSERT_TRUE(writeFile(folder / name, "x"));
    EXPECT_EQ(readFile(folder / name).value(), "x");
    ASSERT_TRUE(writeFile(folder / "line\nbreak \xff\xfe", "y"));
    EXPECT_FALSE(writeFile(folder / std::string(256, 'n'), "x"));
    EXPECT_EQ(folder.entries(), 2U);
}

TEST(AtomicFile, NeverReplacesFoldersAndSpecialFiles) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "folder");
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    for (const fs::path& target : {folder / "folder", folder / "fifo", fs::path("/dev/null")}) {
        const auto result = writeFile(target, "x");
        ASSERT_FALSE(result) << target;
        EXPECT_STREQ(result.error().front().id, "file-unwritable");
        EXPECT_EQ(result.error().front().file, target.string());
        EXPECT_THAT(message(result.error().front()), testing::Not(HasSubstr("needed")));
    }
    EXPECT_EQ(message(writeFile("/dev/null", "x").error().front()),
              "The file cannot be written: not a regular file.");
    EXPECT_TRUE(fs::is_fifo(folder / "fifo"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(AtomicFile, ReportsAMissingFolder) {
    const TemporaryFolder folder;
    const auto result = writeFile(folder / "no/such/file", "x");
    ASSERT_FALSE(result);
    EXPECT_THAT(message(result.error().front()), HasSubstr("No such file or directory"));
}

TEST(AtomicFile, NeverReplacesAWriteProtectedFile) {
    if (::geteuid() == 0)
        GTEST_SKIP() << "root may write everything";
    const TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder / "a", "old"));
    fs::permissions(folder / "a", fs::perms::owner_read);
    EXPECT_FALSE(writeFile(folder / "a", "new"));
    EXPECT_EQ(readFile(folder / "a").value(), "old");
}

TEST(AtomicFile, FullDiskReportsTheBytesNeededAndKeepsTheOldFile) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder / "a", "old"));
    const std::string large(3'000'000, 'x');
    const FileSizeLimit limit(2'000'000);
    const auto result = writeFile(folder / "a", large);
    ASSERT_FALSE(result);
    EXPECT_THAT(message(result.error().front()), HasSubstr("3.0 MB needed"));
    EXPECT_THAT(message(result.error().front()), HasSubstr("File too large"));
    EXPECT_EQ(readFile(folder / "a").value(), "old");
    EXPECT_EQ(folder.entries(), 1U);
}

/// The bytes that were written after the disk was full count as needed too.
TEST(AtomicFile, FullDiskReportsTheBytesOfAllThatWasWritten) {
    const TemporaryFolder folder;
    const FileSizeLimit limit(2'000'000);
    AtomicFile file(folder / "a");
    for (int piece = 0; piece < 50; ++piece)
        file.write(std::string(1'000'000, 'x'));
    const auto result = file.commit();
    ASSERT_FALSE(result);
    EXPECT_THAT(message(result.error().front()), HasSubstr("50 MB needed"));
}

TEST(AtomicFile, FullDiskReportsTheBytesThatAreExpected) {
    const TemporaryFolder folder;
    const FileSizeLimit limit(2'000'000);
    AtomicFile file(folder / "a", 9'000'000);
    file.write(std::string(3'000'000, 'x'));
    const auto result = file.commit();
    ASSERT_FALSE(result);
    EXPECT_THAT(message(result.error().front()), HasSubstr("(9.0 MB needed)"));
    EXPECT_EQ(folder.entries(), 0U);
}

/// Checks before hours of work whether the file can be written and there is enough space.
TEST(AtomicFile, IsReadyOnlyWhereItCanBeWritten) {
    const TemporaryFolder folder;
    const auto reported = [](const fs::path& file, std::uint64_t bytes) {
        const auto ready = AtomicFile(file, bytes).ready();
        return ready ? std::string() : message(ready.error().front());
    };
    EXPECT_EQ(reported(folder / "a", 1000), "");
    EXPECT_THAT(reported(folder / "no/such/file", 1000), HasSubstr("No such file or directory"));
    EXPECT_THAT(reported(folder.path(), 1000), HasSubstr("Is a directory"));
    EXPECT_THAT(reported(folder / "a", std::uint64_t{1} << 62), HasSubstr("(4612 PB needed)"));
    const FileSizeLimit limit(2'000'000);
    EXPECT_EQ(reported(folder / "a", 2'000'000), "");
    EXPECT_EQ(reported(folder / "a", 2'000'001),
              "The file cannot be written (2.0 MB needed): File too large.");
    EXPECT_EQ(folder.entries(), 0U);
}

/// Saves "A…A" and "B…B" alternately until the process is killed.
[[noreturn]] void saveForever(const fs::path& target) {
    for (char letter = 'A';; letter = letter == 'A' ? 'B' : 'A')
        static_cast<void>(writeFile(target, std::string(200'000, letter)));
}

TEST(AtomicFile, KilledWhileSavingLeavesTheOldOrTheNewFile) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder / "a", std::string(200'000, 'A')));
    for (int round = 0; round < 40; ++round) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0)
            saveForever(folder / "a");
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 12'000));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const auto bytes = readFile(folder / "a");
        ASSERT_TRUE(bytes);
        ASSERT_EQ(bytes->size(), 200'000U);
        ASSERT_EQ(*bytes, std::string(200'000, bytes->front()));
    }
}

TEST(AtomicFile, KilledWhileWritingLeavesNothingBehind) {
    const TemporaryFolder folder;
    const int nameless = ::open((folder / ".").c_str(), O_TMPFILE | O_WRONLY, 0600);
    if (nameless < 0)
        GTEST_SKIP() << "this file system has no files without a name";
    ::close(nameless);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        AtomicFile file(folder / "a");
        file.write(std::string(3'000'000, 'x'));
        ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
    EXPECT_EQ(folder.entries(), 0U);
}

TEST(AtomicFile, ThreadsThatWriteOneFileLeaveOneOfTheirs) {
    const TemporaryFolder folder;
    std::vector<std::thread> threads;
    for (char letter = 'a'; letter < 'e'; ++letter) {
        threads.emplace_back([&folder, letter] {
            for (int i = 0; i < 20; ++i)
                EXPECT_TRUE(writeFile(folder / "x", std::string(10'000, letter)));
        });
    }
    for (auto& thread : threads)
        thread.join();
    const auto bytes = readFile(folder / "x").value();
    EXPECT_EQ(bytes, std::string(10'000, bytes.front()));
    EXPECT_EQ(folder.entries(), 1U);
}

TEST(ReadFile, NamesWhatIsWrong) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "folder");
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    const auto idOf = [](const fs::path& file) {
        const auto result = readFile(file);
        return result ? std::string("read") : std::string(result.error().front().id);
    };
    EXPECT_EQ(idOf(folder / "missing"), "file-unreadable");
    EXPECT_EQ(idOf(folder / "folder"), "file-not-regular");
    EXPECT_EQ(idOf(folder / "fifo"), "file-not-regular");
    EXPECT_EQ(idOf("/dev/zero"), "file-not-regular");
}

TEST(ReadFile, KeepsToItsLimit) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder / "a", "12345"));
    EXPECT_EQ(readFile(folder / "a", 5).value(), "12345");
    const auto result = readFile(folder / "a", 4);
    ASSERT_FALSE(result);
    EXPECT_EQ(message(result.error().front()), "The file has 5 B; the limit is 4 B.");
}

TEST(ReadFile, ReadsFilesWhoseSizeTheSystemDoesNotReport) {
    EXPECT_THAT(readFile("/proc/self/status").value(), HasSubstr("Name:"));
    EXPECT_FALSE(readFile("/proc/self/status", 10));
}

} // namespace
} // namespace proveout
