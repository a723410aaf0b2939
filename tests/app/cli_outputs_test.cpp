// SPDX-License-Identifier: GPL-3.0-or-later
// Output files: refused before the work if they cannot be written, and reported if writing fails in the end.
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/formats/npy.h"
#include "tests/app/command_line.h"

namespace proveout {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Every option of `simulate` that names an output file, with the other options that it needs.
const std::vector<std::string> kFileOptions{"--stl",
                                            "--export",
                                            "--zmap",
                                            "--provenance",
                                            "--records",
                                            "--save-stock",
                                            "--box 1,1,9,9 --box-stl",
                                            "--box 1,1,9,9 --box-heights"};

class CliOutputs : public CommandLine {
protected:
    /// The faulty line would be reported if the program was interpreted.
    void SetUp() override { write("p.nc", "G777\n" + kSound); }
    Finished simulate(const std::string& more, const std::string& before = {}) {
        return run("simulate p.nc --json --stock 40x30x10" + kTool + more, before);
    }
    void expectRefusedBefore(const Finished& done, const std::string& file, const std::string& option) {
        EXPECT_EQ(done.exitCode, 3) << option;
        EXPECT_TRUE(done.reports(file + ": error: The file cannot be written", "file-unwritable"))
            << option << done.err;
        EXPECT_THAT(done.err, Not(HasSubstr("G777"))) << "the program was read before: " << option;
        EXPECT_FALSE(done.json().contains("removedMm3")) << option;
    }
};

TEST_F(CliOutputs, AreCheckedBeforeTheProgramIsRead) {
    std::filesystem::create_directory(folder / "folder.stl");
    write("kept.stl", "kept");
    ::chmod((folder / "kept.stl").c_str(), 0);
    for (const std::string& option : kFileOptions)
        for (const std::string file : {"none/a.stl", "folder.stl", "kept.stl", "/dev/null"}) {
            if (option == "--export" && !file.ends_with(".stl"))
                continue;
            const auto done = simulate("--grid 0.5 " + option + " " + file);
            expectRefusedBefore(done, file, option);
        }
    ::chmod((folder / "kept.stl").c_str(), 0600);
    EXPECT_EQ(read("kept.stl"), "kept");
}

TEST_F(CliOutputs, OfDecimateAreCheckedBeforeTheMapIsRead) {
    const auto done = run("decimate not-there.npy --grid 1 --json --stl none/a.stl");
    expectRefusedBefore(done, "none/a.stl", "--stl");
}

TEST_F(CliOutputs, OfAStudyAreCheckedBeforeItsRuns) {
    write("p.nc", kSound);
    write("file", "");
    for (const std::string out : {"file", "file/below"}) {
        const auto done = run("study p.nc --sweep region --out " + out + kStock + kTool);
        EXPECT_EQ(done.exitCode, 3) << out;
        EXPECT_THAT(done.err, HasSubstr("[folder-unwritable]")) << out;
        EXPECT_THAT(done.err, Not(HasSubstr(" runs\n"))) << out;
    }
}

TEST_F(CliOutputs, LeaveNothingBehindThatWasOnlyChecked) {
    write("old.stl", "old");
    const auto before = folder.entries();
    const auto done = run("simulate gone.nc --stl old.stl --zmap new.npy" + kStock);
    EXPECT_TRUE(done.reports("gone.nc: error: ", "file-unreadable")) << done.err;
    EXPECT_EQ(read("old.stl"), "old");
    EXPECT_FALSE(exists("new.npy"));
    EXPECT_EQ(folder.entries(), before + 2) << "stdout.txt and stderr.txt";
}

/// 801 × 601 points: a full mesh of 960,000 triangles at 50 bytes each.
TEST_F(CliOutputs, SpaceForTheForecastIsAskedBeforeTheWork) {
    write("p.nc", kSound);
    const auto reported = [this](const std::string& more) {
        const auto done = simulate("--grid 0.05 " + more, "ulimit -f 2000;"); // in units of 512 bytes
        EXPECT_EQ(done.exitCode, 3) << more;
        EXPECT_FALSE(done.json().contains("removedMm3")) << more;
        return done.err;
    };
    EXPECT_THAT(reported("--mesh full --stl a.stl"),
                HasSubstr("a.stl: error: The file cannot be written (48 MB"));
    EXPECT_THAT(reported("--method none --stl a.stl"), HasSubstr("(48 MB needed): File too large."));
    EXPECT_THAT(reported("--mesh full --export a.ply"), HasSubstr("(24 MB needed)"));
    EXPECT_THAT(reported("--zmap a.npy"), HasSubstr("(1.9 MB needed)"));
    EXPECT_THAT(reported("--provenance a.npy"), HasSubstr("(1.9 MB needed)"));
    EXPECT_THAT(reported("--box 0,0,40,30 --box-spacing 0.05 --box-heights b.npy"),
                HasSubstr("(1.9 MB needed)"));
    NpyArray map{801, 601, std::vector<double>(801 * 601, 1.0)};
    ASSERT_TRUE(writeNpy(folder / "map.npy", map));
    const auto done = run("decimate map.npy --grid 0.05 --method none --json --stl a.stl", "ulimit -f 2000;");
    EXPECT_EQ(done.exitCode, 3);
    EXPECT_THAT(done.err, HasSubstr("(48 MB needed)"));
    EXPECT_FALSE(done.json().contains("facesOut"));
}

/// A disk of 3 MB has space for one map of 1.9 MB.
TEST_F(CliOutputs, SpaceIsAskedForAllTogether) {
    write("p.nc", kSound);
    std::filesystem::create_directory(folder / "disk");
    const std::string mount = "mount -t tmpfs -o size=3m tmpfs disk";
    const auto in = [&](const std::string& command) {
        const std::string user = ::geteuid() == 0 ? "" : "r";
        return fmt::format("cd '{}' && unshare -{}m sh -c '{} && {}' >/dev/null 2>stderr.txt </dev/null",
                           folder.path().string(), user, mount, command);
    };
    if (std::system(in("true").c_str()) != 0)
        GTEST_SKIP() << "no file system can be mounted here";
    const std::string cli = PROVEOUT_CLI " simulate p.nc --stock 40x30x10 --grid 0.05" + kTool;
    EXPECT_EQ(std::system(in(cli + "--zmap disk/a.npy").c_str()), 0) << read("stderr.txt");
    const int both = std::system(in(cli + "--zmap disk/a.npy --provenance disk/b.npy").c_str());
    EXPECT_EQ(WEXITSTATUS(both), 3);
    EXPECT_EQ(read("stderr.txt"),
              "disk/b.npy: error: The outputs need 3.9 MB on this disk, but only 3.1 MB is "
              "free. [outputs-lack-space]\n");
    const int one = std::system(in(cli + "--mesh full --stl disk/a.stl").c_str());
    EXPECT_EQ(WEXITSTATUS(one), 3);
    EXPECT_EQ(read("stderr.txt"),
              "disk/a.stl: error: The file cannot be written (48 MB needed): No space left "
              "on device. [file-unwritable]\n");
}

TEST_F(CliOutputs, ALimitOnTheSizeOfFilesIsAMessage) {
    write("p.nc", kSound);
    const auto done = simulate("--grid 0.2 --ascii --stl a.stl", "ulimit -f 20;");
    EXPECT_EQ(done.exitCode, 3) << "-1: ended by a signal";
    EXPECT_THAT(done.err, HasSubstr("a.stl: error: The file cannot be written ("));
    EXPECT_THAT(done.err, HasSubstr("File too large. [file-unwritable]"));
    EXPECT_TRUE(done.json().contains("removedMm3"));
    EXPECT_FALSE(exists("a.stl"));
}

TEST_F(CliOutputs, AStandardOutputThatCannotBeWrittenIsAMessage) {
    std::string program;
    for (int i = 0; i < 5000; ++i)
        program += fmt::format("G1 X{} Y0 Z0 F100\n", i);
    write("p.nc", program + "M30\n");
    // A pipe whose reading end is closed.
    constexpr int kShellCanName = 9;
    int pipe[2];
    ASSERT_EQ(::pipe(pipe), 0);
    ASSERT_EQ(::dup2(pipe[1], kShellCanName), kShellCanName);
    ::close(pipe[0]);
    ::close(pipe[1]);
    for (const std::string& arguments :
         {std::string("interpret p.nc"), std::string("formats"), std::string("tools --shapes"),
          std::string("--help"), "simulate p.nc --json --grid 1 --stock 40x30x10" + kTool}) {
        for (const auto& [out, why] :
             {std::pair{"&9", "Broken pipe"}, std::pair{"/dev/full", "No space left on device"}}) {
            const auto done = run(arguments, {}, out);
            EXPECT_EQ(done.exitCode, 3) << arguments << " >" << out << ", -1: ended by a signal";
            EXPECT_TRUE(
                done.reports("proveout-cli: error: Cannot write to standard output", "output-unwritable"))
                << arguments << " >" << out << done.err;
            if (!arguments.starts_with("interpret")) { // it detects the reason too late
                EXPECT_THAT(done.err, HasSubstr(why)) << arguments << " >" << out;
            }
        }
    }
    ::close(kShellCanName);
}

/// For example from a script variable that was never set.
TEST_F(CliOutputs, EmptyValuesAreUsageErrors) {
    write("p.nc", kSound);
    std::vector<std::string> options = kFileOptions;
    for (const char* other : {"--job", "--tools", "--tool", "--stock", "--grid", "--start", "--machine",
                              "--ignore-m", "--until", "--stock-origin", "--dialect", "--box"})
        options.emplace_back(other);
    for (const std::string& option : options)
        for (const std::string empty : {" ''", "=''"}) {
            const auto done = simulate("--grid 0.5 " + option + empty);
            EXPECT_EQ(done.exitCode, 3) << option << empty;
            EXPECT_TRUE(
                done.reports("proveout-cli: error: " + option.substr(option.rfind("--")) + ": ", "usage"))
                << option << empty << done.err;
        }
    for (const std::string& option : kFileOptions)
        EXPECT_THAT(simulate("--grid 0.5 " + option + " ''").err, HasSubstr(": must not be empty. [usage]"));
    EXPECT_THAT(run("interpret ''").err, HasSubstr("PROG: must not be empty"));
    EXPECT_THAT(run("decimate a.npy --grid 1 --stl ''").err, HasSubstr("--stl: must not be empty"));
    EXPECT_THAT(run("study p.nc --sweep all --out ''").err, HasSubstr("--out: must not be empty"));
}

} // namespace
} // namespace proveout
