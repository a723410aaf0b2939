// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes of what flat cutters leave, with walls where they stand, compared with closed formulas.
#include "core/zmap/wall_volume.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "tests/core/cutting/moment_with_walls.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDepth = 5;
const StockBox kBlank{{0, 0, 0}, 40, 40, 10};
/// Of a volume at 0.1 mm.
constexpr double kShare = 1e-4;

/// What the motions of a cutter of diameter `d` have removed.
double removed(double d, const std::vector<Motion>& motions, double spacing = 0.1) {
    const Cutter mill = cutterOf(fmt::format("flat:d={}", d));
    std::vector<CutterMotion> all;
    all.reserve(motions.size());
    for (const Motion& motion : motions)
        all.push_back({&mill, motion});
    ZMap zmap(kBlank, makeGrid(kBlank, spacing).value());
    EXPECT_TRUE(cutHeights(zmap, all, {}));
    const ZMapSnapshot moment = withWalls(zmap.snapshot(), all);
    return kBlank.width * kBlank.depth * kBlank.height - moment.volume() - volumeAtWalls(moment);
}

Motion around(const Vec2& centre, double radius) {
    return arcMotion(Plane::xy, Vec3(centre, -kDepth), radius, 0, 2 * kPi, 0, radius);
}

TEST(WallVolume, OfHolesAndSlotsOfAnySize) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Random random(seed);
    for (int k = 0; k < 40; ++k) {
        const double d = uniform(random, 3, 20);
        const Vec2 from(uniform(random, 11, 29), uniform(random, 11, 29));
        const Vec2 to = k % 2 == 0 ? from : Vec2(uniform(random, 11, 29), uniform(random, 11, 29));
        const double exact = kDepth * (kPi / 4 * d * d + glm::distance(from, to) * d);
        EXPECT_NEAR(removed(d, {straightMotion(Vec3(from, -kDepth), Vec3(to, -kDepth))}), exact,
                    kShare * exact)
            << "d " << d << " from " << from.x << " " << from.y << " to " << to.x << " " << to.y;
    }
}

TEST(WallVolume, OfAPocketAndABoss) {
    const Vec2 centre(20.03, 19.96);
    const double pocket = kDepth * kPi * 100;
    EXPECT_NEAR(removed(6, {around(centre, 7), around(centre, 2.5)}), pocket, kShare * pocket);
    const double ring = kDepth * kPi * (16 * 16 - 100);
    EXPECT_NEAR(removed(6, {around(centre, 13)}), ring, kShare * ring);
}

TEST(WallVolume, OfARectangleThatIsAslant) {
    const double angle = 17 * kPi / 180;
    const auto at = [&](double x, double y) {
        return Vec3(20 + std::cos(angle) * x - std::sin(angle) * y,
                    20 + std::sin(angle) * x + std::cos(angle) * y, -kDepth);
    };
    const std::vector<Vec3> corners{at(-9, -5), at(9, -5), at(9, 5), at(-9, 5), at(-9, -5)};
    std::vector<Motion> motions;
    for (int y = -4; y <= 4; ++y)
        motions.push_back(straightMotion(at(-9, y), at(9, y)));
    for (std::size_t k = 1; k < corners.size(); ++k)
        motions.push_back(straightMotion(corners[k - 1], corners[k]));
    const double exact = kDepth * (20 * 12 - (4 - kPi)); // rounded by the cutter's radius of 1
    EXPECT_NEAR(removed(2, motions), exact, kShare * exact);
}

/// Below the rim of a ball, the surface is round between its points.
TEST(WallVolume, OfWhatABallLeavesIsTheSumOfHeights) {
    const Cutter ball = cutterOf("ball:d=6");
    for (const double spacing : {0.5, 0.2, 0.1}) {
        ZMap zmap(kBlank, makeGrid(kBlank, spacing).value());
        const std::vector<CutterMotion> slot{{&ball, straightMotion({9, 12, -3}, {31, 25, -3})}};
        EXPECT_TRUE(cutHeights(zmap, slot, {}));
        EXPECT_NEAR(volumeAtWalls(withWalls(zmap.snapshot(), slot)), 0, 1e-9);
    }
}

TEST(WallVolume, ConvergesWithTheGrid) {
    const Vec2 centre(20.03, 19.96);
    const double exact = kDepth * kPi * 100;
    for (const double spacing : {1.0, 0.5, 0.2})
        EXPECT_NEAR(removed(6, {around(centre, 7), around(centre, 2.5)}, spacing), exact, 1e-3 * exact)
            << spacing;
}

/// Where they cross, points are above one wall and below another: what is wrong is in the four corners only.
TEST(WallVolume, OfSlotsOfTwoDepthsThatCross) {
    const double exact = 6 * (40 * kDepth + 40 * 2 - 6 * 2);
    for (const double spacing : {1.0, 0.7, 0.1}) {
        const std::vector<Motion> slots{straightMotion({-10, 20.13, -kDepth}, {50, 20.13, -kDepth}),
                                        straightMotion({19.68, -10, -2}, {19.68, 50, -2})};
        EXPECT_NEAR(removed(6, slots, spacing), exact, 6 * spacing * spacing) << spacing;
    }
}

} // namespace
} // namespace proveout
