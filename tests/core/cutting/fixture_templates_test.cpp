// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/fixtures/fixture_templates.h"

#include <gtest/gtest.h>

namespace proveout {
namespace {

const StockBox kStock{{10, 20, 5}, 80, 60, 30}; // its floor is at -25

TEST(FixtureTemplates, AViceTouchesFrontAndBackOfTheStock) {
    const ViceParts vice = partsOf(viceFor(kStock), kStock);
    EXPECT_EQ(vice.fixedJaw.y, 80);
    EXPECT_EQ(vice.movingJaw.y + vice.movingJaw.d, 20);
    for (const FixtureBox& jaw : {vice.fixedJaw, vice.movingJaw}) {
        EXPECT_EQ(jaw.x, 10);
        EXPECT_EQ(jaw.w, 80);
        EXPECT_EQ(jaw.z, -25);
        EXPECT_EQ(jaw.z + jaw.h, -10) << "half of the stock stands above the jaws";
    }
    EXPECT_EQ(vice.bed.z + vice.bed.h, -25);
    EXPECT_EQ(vice.bed.y, vice.movingJaw.y);
    EXPECT_EQ(vice.bed.y + vice.bed.d, vice.fixedJaw.y + vice.fixedJaw.d);
}

TEST(FixtureTemplates, AViceHasTheSizesThatWereAskedFor) {
    const ViceParts vice = partsOf(Vice{.jawWidth = 125, .opening = 70, .jawHeight = 40}, kStock);
    EXPECT_EQ(vice.fixedJaw.w, 125);
    EXPECT_EQ(vice.fixedJaw.x + vice.fixedJaw.w / 2, 50) << "centred at the stock";
    EXPECT_EQ(vice.fixedJaw.y - (vice.movingJaw.y + vice.movingJaw.d), 70);
    EXPECT_EQ(vice.movingJaw.h, 40);
    EXPECT_EQ(viceFor({{0, 0, 0}, 20, 30, 10}).jawWidth, 50);
}

TEST(FixtureTemplates, AStepClampPressesOnTheStock) {
    const StepClamp sizes{.length = 60, .width = 30, .thickness = 15, .bolt = 20};
    const StepClampParts clamp = partsOf(sizes, kStock);
    EXPECT_EQ(clamp.bar.z, 5) << "on the stock";
    EXPECT_EQ(clamp.bar.x + clamp.bar.w, 20) << "10 mm over its edge";
    EXPECT_EQ(clamp.bar.y + clamp.bar.d / 2, 50);
    EXPECT_GT(clamp.bolt.z + clamp.bolt.h, 20) << "above the bar";
    EXPECT_LT(clamp.bolt.x + clamp.bolt.d / 2, 10) << "beside the stock";
    EXPECT_GT(clamp.bolt.x - clamp.bolt.d / 2, clamp.bar.x);
    EXPECT_EQ(clamp.bolt.z, -25);
}

TEST(FixtureTemplates, AreFixturesThatCanBeRead) {
    for (const Fixture& fixture :
         {Fixture(partsOf(viceFor(kStock), kStock).bed), Fixture(partsOf(stepClampFor(kStock), kStock).bolt)})
        EXPECT_EQ(parseFixture(fixtureText(fixture)).value(), fixture);
}

} // namespace
} // namespace proveout
