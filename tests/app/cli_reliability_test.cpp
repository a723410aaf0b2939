// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of files and setups, by their numbers in the list of guarantees, with the real binary.
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/app/command_line.h"

namespace proveout {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class Reliability : public CommandLine {};

/// A file name quoted for the shell, whatever it contains.
std::string quoted(const std::string& name) {
    return " '" + name + "' ";
}

TEST_F(Reliability, Fault01EmptyProgramsAreUnverified) {
    write("p.nc", "");
    EXPECT_EQ(run("interpret p.nc").exitCode, 2);
}

/// The names that a program may use: short ones, and the longest that fit into a line, where the text itself
/// needs a quarter of the memory.
TEST_F(Reliability, Fault13NamesTakeLittleMemory) {
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "sanitizers take memory of their own";
#endif
    constexpr int kNames = 100'200;
    const auto peak = [this](std::size_t longer) {
        std::string program;
        for (int i = 0; i < kNames; ++i)
            program += fmt::format("#<n{:06}{}>=1\n", i, std::string(longer, 'a'));
        write("names.nc", program + "M2\n");
        const auto done = run("simulate names.nc --stock 10x10x10 --grid 1 --json" + kTool);
        EXPECT_EQ(done.exitCode, 2);
        EXPECT_THAT(done.err, HasSubstr("[names-too-many]"));
        return done.json()["peakBytes"].get<double>();
    };
    EXPECT_LT(peak(0), 50e6);
    constexpr std::size_t kLonger = 240; // in lines of 252 characters, the most that LinuxCNC reads
    EXPECT_LT(peak(kLonger), 50e6 + 4.0 * kNames * kLonger);
}

TEST_F(Reliability, Fault32ToolsWithoutACutterLeaveThePartUnverified) {
    write("p.nc", "G21 T777 M6\nG0 X1 Y1 Z5\nG1 Z-1 F100\nM30\n");
    const auto done = run("simulate p.nc --json" + kStock + kTool);
    EXPECT_EQ(done.exitCode, 2);
    EXPECT_FALSE(done.json()["unverified"].empty());
    EXPECT_TRUE(done.reports("p.nc:2:1: error: ", "tool-undefined")) << done.err;
}

TEST_F(Reliability, Fault34StockOfAThousandKilometresIsRefusedWithItsSize) {
    write("p.nc", "G21 F1000 G0 X0 Y0 Z5\nG1 X1000000000\nM30\n");
    const auto done = run("simulate p.nc --stock 1000000000x1000000000x10 --grid 1" + kTool);
    EXPECT_EQ(done.exitCode, 3);
    EXPECT_THAT(done.err, HasSubstr("--stock"));
    EXPECT_THAT(done.err, Not(HasSubstr("bad_alloc")));
}

TEST_F(Reliability, Fault37WhatIsNoFile) {
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    fs::create_directory(folder / "folder");
    const auto begin = std::chrono::steady_clock::now();
    for (const std::string name : {"fifo", "/dev/zero", "folder", "/dev/stdin"}) {
        const auto done = run("interpret " + name);
        EXPECT_EQ(done.exitCode, 3) << name;
        EXPECT_TRUE(done.reports(name + ": error: ", "file-not-regular")) << done.err;
    }
    for (const std::string name : {"gone.nc", "gone/p.nc"})
        EXPECT_TRUE(run("interpret " + name).reports(name + ": error: ", "file-unreadable")) << name;
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(taken.count(), 60); // none of them waits
}

TEST_F(Reliability, Fault37WithoutPermission) {
    if (::geteuid() == 0)
        GTEST_SKIP() << "the superuser may read everything";
    write("p.nc", "M30\n");
    fs::permissions(folder / "p.nc", fs::perms::none);
    EXPECT_TRUE(run("interpret p.nc").reports("p.nc: error: ", "file-unreadable"));
}

TEST_F(Reliability, Fault38StrangeFileNames) {
    const std::string strange[] = {"line\nbreak.nc", std::string(252, 'n') + ".nc", "caf\xe9\xff.nc",
                                   "\xe2\x80\xaegnp.nc"};
    for (const std::string& name : strange) {
        write(name, "G0 X1\nG777\nM30\n");
        const auto done = run("interpret" + quoted(name));
        EXPECT_EQ(done.exitCode, 2) << name;
        EXPECT_THAT(done.out, HasSubstr("\"rapid\"")) << name;
        EXPECT_THAT(done.err, HasSubstr(":2:1: error: G777")) << name;
        // One line per message, without control characters that affect a terminal.
        EXPECT_THAT(done.err, Not(HasSubstr("line\nbreak"))) << done.err;
        EXPECT_THAT(done.err, Not(HasSubstr("\xe2\x80\xae"))) << done.err;
        EXPECT_THAT(done.err, Not(HasSubstr("\xff"))) << done.err;
    }
    EXPECT_THAT(run("interpret" + quoted("line\nbreak.nc")).err, HasSubstr("line\\x0abreak.nc"));
}

} // namespace
} // namespace proveout
