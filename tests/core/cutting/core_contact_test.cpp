// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <string>

#include "core/cutting/cut/core_contact.h"
#include "core/cutting/cut/cutting.h"

namespace proveout {
namespace {

constexpr double kX = 20;
constexpr double kY = 15;

Motion downTo(double z) {
    Motion motion;
    motion.kind = MotionKind::feed;
    motion.startKnown = motion.endKnown = kAllAxes;
    motion.start = {kX, kY, 5};
    motion.end = {kX, kY, z};
    return motion;
}

/// The contact of the core of a tool of ⌀10 that plunges to `z` where a hole of ⌀`hole` is `deep` deep.
double contactIn(double hole, double deep, double z, const std::string& keys = ",centre=0") {
    const StockBox stock{{0, 0, 0}, 40, 30, 20};
    ZMap map(stock, makeGrid(stock, 0.25).value());
    if (hole > 0)
        (void)cut(map, parseCutter("flat:d=" + std::to_string(hole)).value(), downTo(-deep));
    const Cutter cutter = parseCutter("flat:d=10" + keys).value();
    return plungesWithCore(cutter, downTo(z)) ? coreContact(map, cutter, downTo(z)).depth : -1;
}

TEST(CoreContact, IsAsDeepAsTheToolPlungesIntoMaterial) {
    EXPECT_NEAR(contactIn(0, 0, -3), 3, 1e-6);
    EXPECT_NEAR(contactIn(0, 0, -25), 20, 1e-6) << "not below the stock";
    EXPECT_EQ(contactIn(0, 0, 1), 0);
}

TEST(CoreContact, AHoleThatIsWideAndDeepEnoughTakesTheCore) {
    EXPECT_EQ(contactIn(6, 8, -8), 0) << "half the diameter of the tool is its core";
    EXPECT_NEAR(contactIn(4, 8, -8), 8, 1e-6) << "too narrow";
    EXPECT_NEAR(contactIn(6, 8, -9.5), 1.5, 1e-6) << "too short";
    EXPECT_EQ(contactIn(6, 8, -8.4), 0) << "the core is ground hollow by half a millimetre";
}

TEST(CoreContact, OnlyOfToolsThatAreNotCentreCuttingAndStraightDown) {
    EXPECT_EQ(contactIn(0, 0, -3, ""), -1);
    const Cutter cutter = parseCutter("flat:d=10,centre=0").value();
    Motion motion = downTo(-3);
    motion.end.x += 1;
    EXPECT_FALSE(plungesWithCore(cutter, motion));
    motion = downTo(-3);
    motion.kind = MotionKind::rapid;
    EXPECT_FALSE(plungesWithCore(cutter, motion)) << "that is a fault of its own";
    EXPECT_FALSE(plungesWithCore(cutter, downTo(6)));
}

} // namespace
} // namespace proveout
