// SPDX-License-Identifier: GPL-3.0-or-later
// The setup of a run: start tool and position, automatic grid, position of the stock.
#include <algorithm>
#include <gmock/gmock.h>

#include "tests/app/command_line.h"

namespace proveout {
namespace {

using testing::HasSubstr;

class CliSetup : public CommandLine {
protected:
    void SetUp() override {
        write("p.nc", kSound);
        write("uncalled.nc", "G21 G90\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX30\nG0 Z5\nM30\n");
        write("zero.nc", "G21 G90\nT0 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX30\nG0 Z5\nM30\n");
    }
    Finished simulate(const std::string& program, const std::string& more) {
        return run("simulate " + program + " --stock 40x30x10 --json " + more);
    }
    static bool has(const nlohmann::json& messages, const std::string& id) {
        return std::ranges::any_of(messages, [&](const auto& message) { return message["id"] == id; });
    }
};

TEST_F(CliSetup, TheToolAtStartIsSetOrAssumedAndShownAsAssumed) {
    const auto assumed = simulate("uncalled.nc", "--grid 0.5" + kTool);
    EXPECT_EQ(assumed.exitCode, 2) << "what is assumed is not verified";
    EXPECT_TRUE(has(assumed.json()["unverified"], "tool-assumed"));
    EXPECT_EQ(assumed.json()["startTool"], (nlohmann::json{{"number", 1}, {"assumed", true}}));
    EXPECT_GT(assumed.json()["removedMm3"], 0);
    const auto timed = assumed.json()["machineSeconds"]["tools"];
    ASSERT_EQ(timed.size(), 1);
    EXPECT_EQ(timed[0]["tool"], 1);
    EXPECT_EQ(timed[0]["assumed"], true);

    const auto set = simulate("uncalled.nc", "--grid 0.5 --start-tool 1" + kTool);
    EXPECT_EQ(set.exitCode, 0) << set.err;
    EXPECT_EQ(set.json()["startTool"], (nlohmann::json{{"number", 1}, {"assumed", false}}));
    EXPECT_EQ(set.json()["removedMm3"], assumed.json()["removedMm3"]);

    EXPECT_TRUE(simulate("p.nc", "--grid 0.5" + kTool).json()["startTool"].is_null());
    const auto empty = simulate("uncalled.nc", "--grid 0.5 --start-tool 0" + kTool);
    EXPECT_EQ(empty.exitCode, 2);
    EXPECT_TRUE(has(empty.json()["unverified"], "no-tool"));
}

TEST_F(CliSetup, AJobHasTheToolAtStart) {
    write("j.proveout", R"({"proveout": 2, "program": "uncalled.nc", "startTool": 2, "grid": 0.5,
        "stock": {"minX": 0, "minY": 0, "topZ": 0, "width": 40, "depth": 30, "height": 10},
        "tools": {"1": "flat:d=1", "2": "flat:d=4"}})");
    EXPECT_EQ(run("simulate --job j.proveout --json").exitCode, 0);
    EXPECT_EQ(run("simulate --job j.proveout --json").json()["startTool"]["number"], 2);
    const auto other = run("simulate --job j.proveout --json --start-tool 1 --grid 0.1").json();
    EXPECT_EQ(other["startTool"]["number"], 1) << "an option outranks the job";
}

TEST_F(CliSetup, T0IsACutterOfTheTable) {
    const auto zero = simulate("zero.nc", "--grid 0.5 --tool 0=ball:d=4,l=20");
    EXPECT_EQ(zero.exitCode, 0) << zero.err;
    EXPECT_GT(zero.json()["removedMm3"], 0);
    EXPECT_TRUE(has(simulate("zero.nc", "--grid 0.5" + kTool).json()["unverified"], "no-tool"));
    write("t.toml", "[[tool]]\nnumber = 0\ncutter = \"ball:d=4,l=20\"\n");
    EXPECT_EQ(simulate("zero.nc", "--grid 0.5 --tools t.toml").json()["removedMm3"],
              zero.json()["removedMm3"]);
}

TEST_F(CliSetup, InterpretKnowsTheToolAtStart) {
    EXPECT_THAT(run("interpret uncalled.nc --start-tool 3").out, HasSubstr("\"t\":3"));
    EXPECT_THAT(run("interpret uncalled.nc").out, testing::Not(HasSubstr("\"t\":3")));
}

TEST_F(CliSetup, TheStartIsRefusedWithItsRangeWhereItIsOut) {
    const auto far = simulate("p.nc", "--start 0,0,1e9" + kTool);
    EXPECT_EQ(far.exitCode, 3);
    EXPECT_TRUE(far.reports("proveout-cli: error: --start:", "start-out-of-range")) << far.err;
    EXPECT_THAT(far.err, HasSubstr("from -1e+07 to 1e+07 mm"));
    for (const char* wrong : {"-1", "100000000", "T1", "1.5"})
        EXPECT_EQ(simulate("p.nc", std::string("--start-tool ") + wrong + kTool).exitCode, 3) << wrong;
}

TEST_F(CliSetup, TheGridIsAutomaticUntilOneIsGiven) {
    const auto done = simulate("p.nc", kTool);
    ASSERT_EQ(done.exitCode, 0) << done.err;
    const auto grid = done.json()["grid"];
    EXPECT_EQ(grid["automatic"], true);
    EXPECT_LE(grid["spacing"].get<double>(), 0.4) << "a tenth of the 4 mm cutter";
    const double points = grid["nx"].get<double>() * grid["ny"].get<double>();
    EXPECT_GE(points, 0.98e6);
    EXPECT_LE(points, 4e6);
    // The same spacing as an explicit option gives the same surface.
    const auto given = simulate("p.nc", "--grid " + grid["spacing"].dump() + kTool).json();
    EXPECT_EQ(given["grid"]["automatic"], false);
    EXPECT_EQ(given["grid"]["nx"], grid["nx"]);
    EXPECT_EQ(given["removedMm3"], done.json()["removedMm3"]);
    EXPECT_EQ(given["regions"], done.json()["regions"]);
    EXPECT_EQ(simulate("p.nc", "--grid 0.5" + kTool).json()["grid"]["nx"], 81);
}

TEST_F(CliSetup, AJobThatNamesAGridKeepsItUnlessAutomaticIsAskedFor) {
    write("j.proveout", R"({"proveout": 1, "program": "p.nc", "grid": 1, "tools": {"1": "ball:d=4,l=20"},
        "stock": {"corner": [0, 0, 0], "width": 40, "depth": 30, "height": 10}})");
    EXPECT_EQ(run("simulate --job j.proveout --json").json()["grid"]["nx"], 41);
    EXPECT_EQ(run("simulate --job j.proveout --json --grid auto").json()["grid"]["automatic"], true);
    EXPECT_EQ(run("simulate --job j.proveout --grid fine").exitCode, 3);
}

TEST_F(CliSetup, AGridTooCoarseForACutterIsAWarning) {
    const auto coarse = simulate("p.nc", "--grid 1" + kTool);
    EXPECT_EQ(coarse.exitCode, 0);
    EXPECT_TRUE(has(coarse.json()["findings"], "grid-coarse"));
    EXPECT_FALSE(has(simulate("p.nc", "--grid 0.8" + kTool).json()["findings"], "grid-coarse"))
        << "five points";
}

TEST_F(CliSetup, AStockInTheWrongPlaceDoesNotPassWithoutAWord) {
    const auto below = simulate("p.nc", "--grid 0.5 --stock-origin 0,0,-10" + kTool);
    EXPECT_EQ(below.exitCode, 0);
    EXPECT_TRUE(below.reports("p.nc: warning: The program never cuts the stock", "never-cuts")) << below.err;
    const auto above = simulate("p.nc", "--grid 0.5 --stock-origin 0,0,18" + kTool);
    EXPECT_TRUE(has(above.json()["findings"], "stock-missed")) << above.err;
    EXPECT_FALSE(has(simulate("p.nc", "--grid 0.5" + kTool).json()["findings"], "stock-missed"));
}

TEST_F(CliSetup, AStockWhoseFileIsNotChosenIsRefused) {
    write("j.proveout", R"({"proveout": 2, "program": "p.nc", "tools": {"1": "ball:d=4,l=20"},
                            "stock": {"shape": "stl", "file": ""}})");
    const auto refused = run("simulate --job j.proveout");
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_THAT(refused.err, HasSubstr("[stock-incomplete]"));
}

TEST_F(CliSetup, AJobReadsNoFileOutsideItsFolderUnlessAllowed) {
    std::filesystem::create_directory(folder / "jobs");
    write("p.nc", kSound);
    write("jobs/j.proveout",
          R"({"proveout": 2, "program": "../p.nc", "tools": {"1": "ball:d=4,l=20"}, "grid": 1,
        "stock": {"width": 40, "depth": 30, "height": 10}})");
    const auto refused = run("simulate --job jobs/j.proveout --json");
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_TRUE(refused.reports("jobs/j.proveout:1:17: error: The field \"program\" names ", "job-outside"))
        << refused.err;
    EXPECT_THAT(refused.err, testing::HasSubstr("--allow-outside"));
    EXPECT_FALSE(refused.json().contains("removedMm3"));
    EXPECT_EQ(run("simulate --job jobs/j.proveout --allow-outside").exitCode, 0);
}

} // namespace
} // namespace proveout
