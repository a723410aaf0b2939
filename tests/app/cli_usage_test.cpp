// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gmock/gmock.h>

#include "core/cutter/shapes.h"
#include "core/formats/npy.h"
#include "tests/app/command_line.h"

namespace proveout {
namespace {

using testing::HasSubstr;

class CliUsage : public CommandLine {};

TEST_F(CliUsage, HelpIsNoError) {
    const auto help = run("--help");
    EXPECT_EQ(help.exitCode, 0);
    for (const char* command : {"interpret", "simulate", "decimate", "tools", "formats"}) {
        EXPECT_THAT(help.out, HasSubstr(command));
        const auto own = run(std::string(command) + " --help");
        EXPECT_EQ(own.exitCode, 0);
        EXPECT_THAT(own.out, HasSubstr("--"));
    }
    EXPECT_EQ(run("--version").exitCode, 0);
}

TEST_F(CliUsage, MistakesPrintTheUsageOnStderrAndExitWith3) {
    write("a.nc", kSound);
    const std::string simulate = "simulate a.nc" + kStock + kTool;
    for (const std::string& arguments : {std::string(),
                                         std::string("frobnicate"),
                                         std::string("prove a.nc"),
                                         std::string("simulate --frobnicate"),
                                         simulate + "--region 8x",
                                         simulate + "--region 1",
                                         simulate + "--region 300",
                                         simulate + "--region",
                                         simulate + "--period -2",
                                         simulate + "--allowance nan",
                                         simulate + "--allowance -0.1",
                                         simulate + "--method certifiable",
                                         simulate + "--mesh coarse",
                                         simulate + "--until X3",
                                         simulate + "--until L",
                                         simulate + "--until -1",
                                         simulate + "--threads 0",
                                         simulate + "--seed 1.5",
                                         simulate + "--order backwards",
                                         simulate + "--borders none",
                                         simulate + "--dialect klingon",
                                         simulate + "--compensation-start c",
                                         simulate + "--compensation-start",
                                         simulate + "--grid",
                                         simulate + "extra",
                                         std::string("interpret"),
                                         std::string("tools"),
                                         std::string("decimate"),
                                         std::string("decimate a.npy")}) {
        const auto done = run(arguments);
        EXPECT_EQ(done.exitCode, 3) << arguments;
        EXPECT_THAT(done.err, HasSubstr("[usage]")) << arguments;
        EXPECT_THAT(done.err, HasSubstr(". [usage]\n")) << arguments;
        EXPECT_THAT(done.err, HasSubstr("Usage: proveout-cli ")) << arguments;
        EXPECT_LT(std::count(done.err.begin(), done.err.end(), '\n'), 8)
            << "one sees the sentence: " << done.err;
        EXPECT_EQ(done.out, "") << arguments;
    }
}

TEST_F(CliUsage, AnUnwritableStderrKeepsTheExitCode) {
    write("a.nc", kSound + "G999\n");
    for (const std::string arguments : {"frobnicate", "simulate missing.nc", "simulate a.nc --stock 1x1"}) {
        for (const std::string closed : {"2>/dev/full", "2>&-"})
            EXPECT_EQ(run(arguments + " " + closed + "; exit $? #").exitCode, 3) << arguments << closed;
    }
}

TEST_F(CliUsage, SetUpsThatMakeNoSenseExitWith3) {
    write("a.nc", kSound);
    for (const std::string& arguments :
         {std::string("simulate a.nc"), "simulate" + kStock, std::string("simulate a.nc --stock 40x30"),
          std::string("simulate a.nc --stock 40x30x0"), std::string("simulate a.nc --stock 40x30xnan"),
          std::string("simulate a.nc --stock 40x30x-1"), "simulate a.nc --stock-origin 1,2" + kStock,
          "simulate a.nc --start 1,2" + kStock, "simulate a.nc --tool 1=ball" + kStock,
          "simulate a.nc --tool 1=star:d=3" + kStock, "simulate a.nc --tool x=ball:d=4" + kStock,
          std::string("simulate a.nc --stock 40x30x10 --grid 0"),
          std::string("simulate a.nc --stock 40x30x10 --grid -1"),
          std::string("simulate a.nc --stock 40x30x10 --grid nan"),
          std::string("simulate a.nc --stock 40x30x10 --grid 1000"),
          "simulate a.nc --tools missing.toml" + kStock, std::string("simulate --job missing.proveout")}) {
        const auto done = run(arguments);
        EXPECT_EQ(done.exitCode, 3) << arguments;
        EXPECT_THAT(done.err, HasSubstr(": error: ")) << arguments;
        EXPECT_THAT(done.err, testing::EndsWith("]\n")) << arguments;
    }
}

TEST_F(CliUsage, ErrorsOfOptionsNameTheOption) {
    write("a.nc", kSound);
    const auto reported = [this](const std::string& option, const std::string& arguments,
                                 const std::string& id) {
        const auto done = run(arguments);
        EXPECT_EQ(done.exitCode, 3) << arguments;
        EXPECT_TRUE(done.reports("proveout-cli: error: " + option + ": ", id)) << arguments << done.err;
        EXPECT_LT(done.err.size(), 300U) << done.err;
    };
    const std::string stock = "simulate a.nc --stock 40x30x10 ";
    reported("--stock", "simulate a.nc --stock 40x30", "stock-size-form");
    reported("--stock", "simulate a.nc --stock 1e9x30x10", "stock-size-bad");
    reported("--stock-origin", stock + "--stock-origin 1e8,0,0", "stock-origin-bad");
    reported("--start", stock + "--start 1,2", "point-form");
    reported("--start", "interpret a.nc --start 1,2", "point-form");
    reported("--tool", stock + "--tool x=ball:d=4", "tool-number");
    reported("--tool", stock + "--tool 1=ball:d=4 --tool T1=flat:d=3", "tool-twice");
    reported("--grid", stock + "--grid 1e-300", "grid-too-fine");
    for (const std::string grid : {"0", "-1", "nan", "inf"}) {
        reported("--grid", stock + "--grid " + grid, "grid-spacing-bad");
        reported("--grid", "decimate a.npy --grid " + grid, "grid-spacing-bad");
    }
    ASSERT_TRUE(writeNpy(folder / "flat.npy", {2, 2, {1, 1, 1, 1}}));
    reported("--floor", "decimate flat.npy --grid 1 --floor 1", "floor-too-high");
    EXPECT_TRUE(run("simulate").reports("proveout-cli: error: No program: name an NC program", "no-program"));
    EXPECT_TRUE(run("simulate a.nc").reports("proveout-cli: error: No stock: use --stock", "no-stock"));
    reported("--origin", "decimate a.npy --grid 1 --origin 1,2,3", "point-form");
}

TEST_F(CliUsage, OriginsMayBeNegative) {
    write("a.nc", "T1 M6\nG0 X0 Y0 Z5\nG1 Z-2 F100\n");
    const auto done = run("simulate a.nc --json --period -1 --stock-origin -20,-15,0" + kStock + kTool);
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_GT(done.json()["removedMm3"], 1.0);
}

TEST_F(CliUsage, ShapesAreListedFromTheirTable) {
    const auto text = run("tools --shapes");
    EXPECT_EQ(text.exitCode, 0);
    for (const CutterShape& shape : cutterShapes())
        for (const ShapeKey& key : shape.keys)
            EXPECT_THAT(text.out, testing::ContainsRegex(std::string(shape.key) + ": [^:]*\n(  .*\n)*  " +
                                                         key.key + " "));
    const auto json = run("tools --shapes --json").json();
    ASSERT_EQ(json["shapes"].size(), cutterShapes().size());
    EXPECT_EQ(json["shapes"][0]["keys"][0]["key"], "d");
    EXPECT_EQ(json["everyShape"][0]["key"], "l");
    EXPECT_EQ(json["everyShape"][4]["key"], "holder");
    EXPECT_EQ(json["everyShape"][4]["example"], "40x30+40-60x15");
    EXPECT_THAT(text.out, testing::ContainsRegex("Every shape:\n(  .*\n)*  so .*\n  holder .*40x30"));
    EXPECT_EQ(json["everyShape"].back()["key"], "maxmrr");
    EXPECT_EQ(json["shapes"][8]["keys"].back()["key"], "centre") << "a face mill is not centre-cutting";
    EXPECT_THAT(text.out, testing::HasSubstr("e.g. 0/0:3/0:4/1@3/1:6/3@-2:6/8 (required)"));
}

TEST_F(CliUsage, ToolsOfATableAreListed) {
    write("t.toml",
          "[[tool]]\nnumber = 12\ncutter = \"ball:d=4\"\n[[tool]]\nnumber = 2\ncutter = \"flat:d=6\"\n");
    EXPECT_EQ(run("tools t.toml").out, "T2 flat:d=6\nT12 ball:d=4\n");
    const auto json = run("tools t.toml --json").json();
    EXPECT_EQ(json["tools"][1]["number"], 12);
    EXPECT_EQ(json["tools"][1]["cutter"], "ball:d=4");
    const auto missing = run("tools none.toml --json");
    EXPECT_EQ(missing.exitCode, 3);
    EXPECT_EQ(missing.json()["findings"][0]["id"], "file-unreadable");
}

TEST_F(CliUsage, FormatsAreListedFromTheirTable) {
    const auto text = run("formats");
    EXPECT_EQ(text.exitCode, 0);
    EXPECT_THAT(text.out, HasSubstr(".stl"));
    const auto json = run("formats --json").json();
    ASSERT_TRUE(json.contains("formats"));
    bool npy = false;
    for (const auto& row : json["formats"])
        npy = npy || (row["key"] == "npy" && row["reads"] == true && row["writes"] == true);
    EXPECT_TRUE(npy);
}

} // namespace
} // namespace proveout
