// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the inner loops of every instruction set that this processor supports.
#include <cstdint>
#include <gtest/gtest.h>
#include <hwy/targets.h>
#include <iostream>
#include <string>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

const StockBox kStock{{-3, 5, 2}, 40, 36, 12};

Motion randomMotion(Random& random, int k) {
    if (k % 2 == 0)
        return randomStraight(random, kStock, static_cast<StraightKind>(k / 2 % 5));
    return randomArc(random, kStock, static_cast<Plane>(k / 2 % 3), static_cast<ArcKind>(k / 6 % 4));
}

/// Heights after random motions of all shapes, slopes and planes, cut with one instruction set, one by one or
/// all at once.
std::vector<float> heightsWith(std::int64_t target, std::uint32_t seed, bool atOnce) {
    hwy::SetSupportedTargetsForTest(target);
    Random random(seed);
    const Grid grid = makeGrid(kStock, 0.1).value();
    ZMap zmap(kStock, grid);
    const char* shapes[] = {"flat", "ball", "bull", "cone", "taperball", "centre", "form"};
    std::vector<Cutter> cutters;
    std::vector<CutterMotion> motions(static_cast<std::size_t>(roundsOf(200)));
    cutters.reserve(motions.size());
    for (int k = 0; cutters.size() < motions.size(); ++k) {
        cutters.push_back(randomCutter(random, shapes[k % 7]));
        motions[static_cast<std::size_t>(k)].motion = randomMotion(random, k);
    }
    for (std::size_t k = 0; k < motions.size(); ++k)
        motions[k].cutter = &cutters[k];
    for (std::size_t k = 2; k < motions.size(); k += 4) { // straight
        motions[k].cutter = motions[k - 1].cutter;
        motions[k].motion.start = motions[k - 1].motion.end;
        motions[k].continues = continues(motions[k - 1], motions[k]);
    }
    if (atOnce) {
        EXPECT_TRUE(cutHeights(zmap, motions, {}));
    } else {
        for (const CutterMotion& one : motions)
            (void)cut(zmap, one, {});
    }
    hwy::SetSupportedTargetsForTest(0);
    std::vector<float> heights(static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny));
    zmap.snapshot().read({0, 0, grid.nx, grid.ny}, heights);
    return heights;
}

TEST(VectorTargets, GiveTheSameHeightsToTheLastBit) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
    const std::vector<float> best = heightsWith(targets.front(), seed, false);
    for (const std::int64_t target : targets) {
        std::cout << hwy::TargetName(target) << "\n";
        EXPECT_EQ(heightsWith(target, seed, false), best) << hwy::TargetName(target);
        EXPECT_EQ(heightsWith(target, seed, true), best) << hwy::TargetName(target);
    }
}

} // namespace
} // namespace proveout
