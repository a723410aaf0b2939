// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <gmock/gmock.h>

#include "core/formats/npy.h"
#include "core/formats/stl.h"
#include "tests/app/command_line.h"
#include "tests/core/decimation/closed_mesh.h"

namespace proveout {
namespace {

class CliBox : public CommandLine {
protected:
    void SetUp() override { write("p.nc", kSound); }
    Finished simulate(const std::string& more) { return run("simulate p.nc" + kStock + kTool + more); }
    NpyArray heights(const std::string& name) { return readNpy(folder.path() / name).value(); }
};

TEST_F(CliBox, HasTheHeightsOfTheWholeStockOnItsGrid) {
    const Finished done =
        simulate("--box 10,3,25,8 --box-spacing 0.05 --box-heights box.npy --box-stl box.stl --json");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    const auto box = done.json()["box"];
    EXPECT_EQ(box["points"], 301 * 101);
    EXPECT_EQ(box["grid"]["hx"], 0.05);
    EXPECT_EQ(box["x"][0], 10);
    EXPECT_EQ(box["y"][1], 8);
    EXPECT_EQ(box["block"], 5);
    EXPECT_GT(box["motions"], 0);
    EXPECT_GE(box["seconds"], 0);
    EXPECT_GT(box["stl"]["triangles"], 12);
    EXPECT_LE(box["stl"]["largestErrorMm"], 0.025 + 1e-5);
    EXPECT_TRUE(exists("box.stl"));

    ASSERT_EQ(run("simulate p.nc --stock 40x30x10 --grid 0.05 --zmap whole.npy" + kTool).exitCode, 0);
    const NpyArray part = heights("box.npy");
    const NpyArray whole = heights("whole.npy");
    ASSERT_EQ(part.columns, 301);
    ASSERT_EQ(part.rows, 101);
    int differences = 0;
    for (int j = 0; j < part.rows; ++j)
        for (int i = 0; i < part.columns; ++i)
            differences += part.values[static_cast<std::size_t>(j * part.columns + i)] !=
                                   whole.values[static_cast<std::size_t>((j + 60) * whole.columns + i + 200)]
                               ? 1
                               : 0;
    EXPECT_EQ(differences, 0);
}

/// A slot through a box whose sides are at points of the grid, and the slot's are not.
TEST_F(CliBox, HasWallsWhereTheyStand) {
    write("slot.nc", "T1 M6\nS1000 M3\nG0 X2 Y10.1 Z5\nG1 Z-3 F300\nX38\nG0 Z5\nM30\n");
    const auto box = [&](const std::string& more) {
        const auto done =
            run("simulate slot.nc --json --tool 1=flat:d=4.3,l=20 --box 15,5,25,20 --box-spacing 0.5 "
                "--box-stl box.stl" +
                kStock + more);
        EXPECT_EQ(done.exitCode, 0) << done.err;
        return done.json()["box"];
    };
    const double exact = 10 * 15 * 10 - 3 * 10 * 4.3;
    const auto beside = [&] {
        return std::abs(test::signedVolume(readStl(folder.path() / "box.stl").value()) - exact);
    };
    EXPECT_GT(box("")["rims"], 40);
    EXPECT_LT(beside(), 1e-5 * exact);
    EXPECT_FALSE(box(" --rims off").contains("rims"));
    EXPECT_GT(beside(), 1e-3 * exact);
}

TEST_F(CliBox, GoesAsFarAsTheRun) {
    const auto box = simulate("--until 1 --box 10,3,25,8 --json").json()["box"];
    EXPECT_EQ(box["block"], 1);
    EXPECT_EQ(box["grid"]["nx"], 1501) << "0.01 mm where none is given";
}

TEST_F(CliBox, IsReportedInTheSummary) {
    EXPECT_THAT(simulate("--box 10,3,25,8").out,
                testing::HasSubstr("box: 1501 × 501 points, spacing 0.01 mm"));
}

TEST_F(CliBox, RefusesWhatCannotBe) {
    EXPECT_TRUE(
        simulate("--box 10,3,25").reports("proveout-cli: error: --box: “10,3,25” is not", "box-form"));
    EXPECT_TRUE(simulate("--box 10,3,nan,8").reports("proveout-cli: error: --box:", "box-form"));
    EXPECT_TRUE(simulate("--box 10,3,25,8,9").reports("proveout-cli: error: --box:", "box-form"));
    EXPECT_TRUE(simulate("--box 10,3,50,8").reports("proveout-cli: error: --box:", "box-outside-stock"));
    EXPECT_TRUE(simulate("--box 25,3,10,8").reports("proveout-cli: error: --box:", "box-without-area"));
    EXPECT_TRUE(simulate("--box 0,0,40,30 --box-spacing 0.0001")
                    .reports("proveout-cli: error: --box-spacing:", "grid-too-fine"));
    EXPECT_TRUE(simulate("--box 10,3,25,8 --box-spacing -1")
                    .reports("proveout-cli: error: --box-spacing:", "grid-spacing-bad"));
    EXPECT_TRUE(simulate("--box 10,3,25,8 --box-heights p.nc").reports("p.nc: error:", "output-overwrites"));
    EXPECT_EQ(simulate("--box-heights h.npy").exitCode, 3) << "without a box";
    EXPECT_FALSE(exists("h.npy"));
}

} // namespace
} // namespace proveout
