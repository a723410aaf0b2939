// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/unfinished_files.h"

#include <csignal>
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/atomic_file.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

namespace fs = std::filesystem;

/// A process that writes an unfinished file until it is killed.
class Writer {
public:
    explicit Writer(const fs::path& file) {
        int ready[2];
        EXPECT_EQ(::pipe(ready), 0);
        m_process = ::fork();
        EXPECT_GE(m_process, 0);
        if (m_process == 0) {
            const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0600);
            const char claimed = claimUnfinished(descriptor) ? 'y' : 'n';
            static_cast<void>(::write(descriptor, "half", 4) + ::write(ready[1], &claimed, 1));
            for (;;)
                ::pause();
        }
        char claimed = 'n';
        EXPECT_EQ(::read(ready[0], &claimed, 1), 1);
        EXPECT_EQ(claimed, 'y');
        ::close(ready[0]);
        ::close(ready[1]);
    }
    ~Writer() { kill(); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    void kill() {
        if (m_process > 0) {
            ::kill(m_process, SIGKILL);
            ::waitpid(m_process, nullptr, 0);
        }
        m_process = 0;
    }

private:
    pid_t m_process = 0;
};

TEST(UnfinishedFiles, OfAKilledProcessAreRemovedByTheNextWriteIntoTheFolder) {
    const TemporaryFolder folder;
    const fs::path part = folder / unfinishedName();
    Writer writer(part);
    ASSERT_TRUE(writeFile(folder / "a", "x"));
    EXPECT_TRUE(fs::exists(part)) << "its writer is still there";
    writer.kill();
    ASSERT_TRUE(writeFile(folder / "a", "y"));
    EXPECT_FALSE(fs::exists(part));
    EXPECT_EQ(folder.entries(), 1U);
}

TEST(UnfinishedFiles, OfAnotherComputerAndOfTheUserStay) {
    const TemporaryFolder folder;
    std::string elsewhere = unfinishedName();
    for (std::size_t i = 10; i < 18; ++i) // the digits that identify the computer
        elsewhere[i] = elsewhere[i] == 'f' ? '0' : 'f';
    const std::string mine = unfinishedName();
    fs::create_symlink("target", folder / mine);
    for (const std::string& name :
         {elsewhere, std::string("target"), std::string(".proveout-notes.part"),
          fmt::format("x{}", unfinishedName()), fmt::format("{}x", unfinishedName())})
        ASSERT_TRUE(writeFile(folder / name, "x"));
    removeUnfinished(folder.path());
    EXPECT_EQ(folder.entries(), 6U);
    removeUnfinished(folder / "no-such-folder");
}

TEST(UnfinishedFiles, AFileWithoutANameIsNotClaimed) {
    const TemporaryFolder folder;
    const fs::path part = folder / unfinishedName();
    const int descriptor = ::open(part.c_str(), O_WRONLY | O_CREAT, 0600);
    ASSERT_GE(descriptor, 0);
    removeUnfinished(folder.path()); // at a moment between the two steps of its writer
    EXPECT_FALSE(fs::exists(part));
    EXPECT_FALSE(claimUnfinished(descriptor));
    ::close(descriptor);
}

TEST(UnfinishedFiles, NamesDoNotGrowAndDiffer) {
    EXPECT_NE(unfinishedName(), unfinishedName());
    EXPECT_EQ(unfinishedName().size(), std::string(".proveout-0123456701234567.part").size());
}

} // namespace
} // namespace proveout
