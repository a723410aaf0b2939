// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/stock_position.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

using testing::HasSubstr;

/// Cuts 20 mm deep from X5 to X35 with a 4 mm cutter. The stock is 40 × 30 × 10 mm.
const std::string kProgram = "T1 M6\nG0 X5 Y5 Z5\nG1 Z-8 F100\nX35\nY25\nG1 Z50\nM2\n";

Diagnostics warningsAt(const Vec3& corner, const std::string& text = kProgram) {
    auto setup = std::make_shared<Setup>(*smallSetup());
    setup->stock.corner = corner;
    const auto simulation = startedSimulation(programOf(text), setup, {});
    const auto warnings = [&] {
        Diagnostics findings = simulation->frame().findings;
        std::erase_if(findings, [](const Diagnostic& d) {
            return std::string_view(d.id) != "never-cuts" && std::string_view(d.id) != "stock-missed";
        });
        return findings;
    };
    const Diagnostics before = warnings();
    simulation->seek(simulation->blockCount());
    Diagnostics after = warnings();
    EXPECT_LE(before.size(), after.size()) << "what is known is told before the first block";
    return after;
}

TEST(StockPosition, AStockWhereTheProgramCutsIsFine) {
    EXPECT_TRUE(warningsAt({0, 0, 0}).empty());
    EXPECT_TRUE(warningsAt({-10, -2, 1}).empty());
}

TEST(StockPosition, ABottomThatWasGivenForTheTopIsReported) {
    const auto below = warningsAt({0, 0, -10}); // the program ends above it
    ASSERT_EQ(below.size(), 1U);
    EXPECT_STREQ(below[0].id, "never-cuts");
    EXPECT_EQ(below[0].severity, Severity::warning);
    EXPECT_THAT(message(below[0]), HasSubstr("Z-8…50"));
    EXPECT_THAT(message(below[0]), HasSubstr("X0…40 Y0…30 Z-20…-10"));
    const auto above = warningsAt({0, 0, 12}); // the bottom at Z2: the program cuts 10 mm below it
    ASSERT_EQ(above.size(), 1U);
    EXPECT_STREQ(above[0].id, "stock-missed");
    EXPECT_EQ(message(above[0]),
              "Cutting moves extend 10 mm beyond the stock in Z-, where it measures 10 mm.");
}

TEST(StockPosition, AStockBesideThePathIsReported) {
    const auto beside = warningsAt({200, 0, 0});
    ASSERT_EQ(beside.size(), 1U);
    EXPECT_STREQ(beside[0].id, "never-cuts");
    EXPECT_TRUE(warningsAt({36.9, 0, 0}).empty()) << "the cutter's radius reaches it";
    EXPECT_EQ(warningsAt({37, 0, 0}).size(), 1U);
}

TEST(StockPosition, APathThatLeavesTheStockByMoreThanItsSizeIsReported) {
    const auto far = warningsAt({0, 0, 0}, "T1 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX81\nY-40\nM2\n");
    ASSERT_EQ(far.size(), 2U);
    EXPECT_THAT(message(far[0]), HasSubstr("41 mm beyond the stock in X+"));
    EXPECT_THAT(message(far[1]), HasSubstr("40 mm beyond the stock in Y-"));
    EXPECT_TRUE(warningsAt({0, 0, 0}, "T1 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX79\nG0 X500\nM2\n").empty())
        << "a run-out, and a rapid";
}

TEST(StockPosition, AProgramThatHasRemovedNothingInTheEndIsReported) {
    // Down next to the stock, and up again above it: the bounding box of the motions intersects the stock.
    const std::string around = "T1 M6\nG0 X-5 Y15 Z5\nG1 Z-2 F100\nZ5\nX20\nM2\n";
    const auto untouched = warningsAt({0, 0, 0}, around);
    ASSERT_EQ(untouched.size(), 1U);
    EXPECT_STREQ(untouched[0].id, "never-cuts");
    const auto simulation = startedSimulation(programOf(around), smallSetup(), {});
    EXPECT_TRUE(simulation->frame().findings.empty()) << "nobody knows before the end";
    EXPECT_TRUE(warningsAt({0, 0, 0}, "T1 M6\nG0 X5 Y5 Z5\nX30\nM2\n").empty()) << "nothing is to be cut";
    EXPECT_TRUE(warningsAt({0, 0, 0}, "T9 M6\nG0 X5 Y5 Z5\nG1 Z-1 F100\nM2\n").empty()) << "T9 is missing";
}

} // namespace
} // namespace proveout
