// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/automatic_grid.h"

#include <string_view>

#include <gtest/gtest.h>

#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

constexpr GridLimits kLimits; // one to four million points

StockBox plate(double width, double depth) {
    return {Vec3(0), width, depth, 10};
}

double points(const StockBox& stock, double diameter, const GridLimits& limits = kLimits) {
    return gridPoints(stock, automaticSpacing(stock, CutterInUse{1, diameter}, limits));
}

TEST(AutomaticGrid, IsATenthOfTheSmallestCutter) {
    EXPECT_EQ(automaticSpacing(plate(150, 150), CutterInUse{1, 1}, kLimits), 0.1);
    EXPECT_EQ(automaticSpacing(plate(300, 200), CutterInUse{1, 1.5}, kLimits), 0.15);
}

TEST(AutomaticGrid, HasAMillionPointsAtLeastAndFourMillionAtMost) {
    for (const double side : {40.0, 137.0, 300.0, 1000.0, 5000.0}) {
        for (const double diameter : {0.5, 3.0, 11.0, 80.0}) {
            EXPECT_GE(points(plate(side, side / 3), diameter), 0.999e6) << side << " / " << diameter;
            EXPECT_LE(points(plate(side, side / 3), diameter), 4e6) << side << " / " << diameter;
        }
    }
    EXPECT_LE(points(plate(500, 500), 1, {1e6, 1e6}), 1e6) << "one core";
    EXPECT_LE(points(plate(500, 500), 1, {1e5, 1e5}), 1e5) << "little memory";
}

TEST(AutomaticGrid, ATinyStockIsNotCutFinerThanAnybodySees) {
    EXPECT_EQ(automaticSpacing(plate(2, 2), CutterInUse{1, 6}, kLimits), 0.01);
    EXPECT_EQ(automaticSpacing(plate(2, 2), CutterInUse{1, 0.05}, kLimits), 0.005)
        << "the cutter asks for it";
    EXPECT_EQ(automaticSpacing(plate(0.5, 0.5), CutterInUse{1, 0.001}, kLimits), 0.001);
}

TEST(AutomaticGrid, IsAGridForEveryStock) {
    for (const StockBox& stock : {plate(100, 0.5), plate(5000, 1), plate(0.02, 0.02), plate(1e6, 1e6)}) {
        for (const double diameter : {0.1, 10.0, 1000.0}) {
            const auto grid = makeGrid(stock, automaticSpacing(stock, CutterInUse{1, diameter}, kLimits));
            ASSERT_TRUE(grid) << message(grid.error().front());
            EXPECT_LE(double{1} * grid->nx * grid->ny, 4e6 * 1.001);
        }
    }
    EXPECT_EQ(automaticSpacing(plate(0, 5), {}, kLimits), 1) << "makeGrid() refuses the stock";
}

TEST(AutomaticGrid, OnlyToolsThatTheProgramCutsWithCount) {
    auto setup = std::make_shared<proveout::Setup>(*setupWithTool(2, "flat:d=1"));
    setup->tools.set(3, parseCutter("flat:d=0.2").value());
    const auto smallest = [&](const char* text) {
        const auto program = programOf(text);
        return smallestCutter(*program, *setup, ToolChoice(*program, *setup));
    };
    const auto both = smallest("T1 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\nT2 M6\nG1 X5\nT3 M6\nG0 Z5\nM2\n");
    ASSERT_TRUE(both);
    EXPECT_EQ(both->tool, 2);
    EXPECT_EQ(both->diameter, 1);
    EXPECT_EQ(smallest("T1 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\nM2\n")->diameter, 4);
    EXPECT_FALSE(smallest("T9 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\nM2\n")) << "T9 is not in the table";
    setup->startTool = 3;
    const auto program = programOf("G0 X0 Y0 Z5\nM2\n");
    EXPECT_FALSE(smallestCutter(*program, *setup, ToolChoice(*program, *setup))) << "nothing at feed";
}

TEST(AutomaticGrid, AGivenSpacingStays) {
    proveout::Setup setup = *smallSetup();
    const auto program = programOf("T1 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\nM2\n");
    EXPECT_EQ(gridSpacing(setup, *program, kLimits), 0.5);
    setup.automaticGrid = true;
    EXPECT_EQ(gridSpacing(setup, *program, kLimits),
              automaticSpacing(setup.stock, CutterInUse{1, 4}, kLimits));
}

TEST(AutomaticGrid, TheLimitsOfThisComputerAreSane) {
    const GridLimits limits = gridLimits({});
    EXPECT_GE(limits.most, 1e4);
    EXPECT_LE(limits.most, 4e6);
    EXPECT_LE(limits.fewest, limits.most);
}

TEST(AutomaticGrid, FewerThanFivePointsAcrossACutterAreAWarning) {
    const auto warned = [](double spacing, bool automatic = false) {
        auto setup = std::make_shared<proveout::Setup>(*smallSetup(spacing));
        setup->automaticGrid = automatic;
        const auto simulation =
            startedSimulation(programOf("T1 M6\nG0 X5 Y5 Z5\nG1 Z-1 F100\nX30\nM2\n"), setup, {});
        return simulation->frame().findings;
    };
    EXPECT_TRUE(warned(0.5).empty());
    const auto coarse = warned(1);
    ASSERT_EQ(coarse.size(), 1U);
    EXPECT_STREQ(coarse[0].id, "grid-coarse");
    EXPECT_EQ(coarse[0].severity, Severity::warning);
    EXPECT_FALSE(coarse[0].unverified);
    EXPECT_EQ(message(coarse[0]),
              "The grid spacing of 1 mm is too coarse for T1 (⌀4 mm): it has only 4.0 points across it.");
    const auto advisesAutomatic = [](const Diagnostic& warning) {
        return std::string_view(warning.hint).find("automatic") != std::string_view::npos;
    };
    EXPECT_TRUE(advisesAutomatic(coarse[0]));
    const auto chosen = warned(1, true);
    ASSERT_EQ(chosen.size(), 1U);
    EXPECT_FALSE(advisesAutomatic(chosen[0])) << "the grid is automatic already";
}

} // namespace
} // namespace proveout
