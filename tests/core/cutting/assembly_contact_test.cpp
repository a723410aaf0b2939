// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of shank and holder with the stock, compared with closed formulas and with brute force.
#include "core/cutting/cut/assembly_contact.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "tests/core/cutting/oracle.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr double kExact = ToolAssembly::kExact;
const StockBox kStock{{0, 0, 30}, 60, 40, 30}; // from 0 to its top at 30

ZMap freshMap(double spacing = 0.5) {
    return {kStock, makeGrid(kStock, spacing).value()};
}

AssemblyContact contactOf(const ZMap& zmap, const Cutter& cutter, const Motion& motion,
                          double clearance = 0) {
    return ToolAssembly(cutter, clearance).contact(zmap, motion, {}).value();
}

/// From above down to `z` in the middle of the stock.
Motion plungeTo(double z) {
    return straightMotion({30, 20, 40}, {30, 20, z});
}

TEST(AssemblyContact, OfAPlungeIntoANarrowerPocketIsAsDeepAsTheFaceIsBelowTheTop) {
    ZMap zmap = freshMap();
    (void)cut(zmap, cutterOf("flat:d=20"), plungeTo(5));
    const Cutter cutter = cutterOf("flat:d=10,l=15,so=18,holder=24x30");
    EXPECT_FALSE(contactOf(zmap, cutter, plungeTo(12)).any()) << "the face is level with the top";
    const PartContact found = contactOf(zmap, cutter, plungeTo(9)).holder;
    EXPECT_NEAR(found.depth, 3, 1e-5);
    EXPECT_NEAR(found.place.z, 27, 1e-5) << "the face of the holder";
    const double away = std::hypot(found.place.x - 30, found.place.y - 20);
    EXPECT_GT(away, 10);
    EXPECT_LE(away, 12 + 1e-9);
    EXPECT_FALSE(contactOf(zmap, cutterOf("flat:d=10,l=15,so=18,holder=20x30"), plungeTo(6)).any())
        << "a holder that fits into the pocket";
}

TEST(AssemblyContact, OfAConeIsAsDeepAsItIsWideAtTheEdgeOfThePocket) {
    ZMap zmap = freshMap(0.1);
    (void)cut(zmap, cutterOf("flat:d=20"), plungeTo(5));
    // The face is at 16; the cone reaches a radius of 10 mm at 16 + 10 = 26, 4 mm below the top.
    const Cutter cutter = cutterOf("flat:d=8,l=8,so=10,holder=10-30x20+60x5");
    const PartContact found = contactOf(zmap, cutter, plungeTo(6)).holder;
    EXPECT_NEAR(found.depth, 4, 0.1) << "within one spacing of the edge";
    EXPECT_LE(found.depth, 4 + 1e-5);
    EXPECT_FALSE(contactOf(zmap, cutter, plungeTo(10.001)).any());
}

TEST(AssemblyContact, IsThatOfThePartThatHides) {
    // The second segment is narrower, so that only the first one counts, wherever the material is.
    const ZMap zmap = freshMap();
    const Cutter cutter = cutterOf("flat:d=10,l=10,so=12,holder=30x5+20x50");
    EXPECT_NEAR(contactOf(zmap, cutter, plungeTo(0)).holder.depth, 18, 1e-5);
}

TEST(AssemblyContact, OfAShankBeginsAtTheEndOfTheFlutes) {
    const ZMap zmap = freshMap();
    const AssemblyContact found = contactOf(zmap, cutterOf("flat:d=6,l=9,sd=10"), plungeTo(10));
    EXPECT_NEAR(found.shank.depth, 11, 1e-5);
    EXPECT_EQ(found.holder.depth, 0);
    EXPECT_FALSE(contactOf(zmap, cutterOf("flat:d=6,l=9"), plungeTo(10)).any()) << "the shank is not given";
    EXPECT_FALSE(contactOf(zmap, cutterOf("flat:d=6,l=9,sd=5"), plungeTo(10)).any()) << "thinner";
}

TEST(AssemblyContact, CountsTheMaterialAheadOfTheCutter) {
    // A ridge as wide as the cutter: when the motion is over, nothing of it is left.
    ZMap zmap = freshMap();
    const Cutter slot = cutterOf("flat:d=12");
    for (const double y : {4.0, 36.0})
        (void)cut(zmap, slot, straightMotion({-10, y, 5}, {70, y, 5}));
    for (const double y : {10.0, 30.0})
        (void)cut(zmap, cutterOf("flat:d=10"), straightMotion({-10, y, 5}, {70, y, 5}));
    const Cutter cutter = cutterOf("flat:d=10,l=12,so=12,holder=16x40");
    const Motion along = straightMotion({-30, 20, 5}, {70, 20, 5});
    EXPECT_NEAR(contactOf(zmap, cutter, along).holder.depth, 13, 1e-5);
    (void)cut(zmap, cutterOf("flat:d=10"), straightMotion({-30, 20, 18}, {70, 20, 18}));
    EXPECT_NEAR(contactOf(zmap, cutter, along).holder.depth, 1, 1e-5);
    (void)cut(zmap, cutterOf("flat:d=10"), straightMotion({-30, 20, 17}, {70, 20, 17}));
    EXPECT_FALSE(contactOf(zmap, cutter, along).any());
}

TEST(AssemblyContact, IgnoresWhatTheCutterHasRemovedBefore) {
    // A ridge as wide as the cutter that ends at x = 10. The motion is so steep that the holder comes to be
    // lower than the ridge was, behind the cutter.
    ZMap zmap = freshMap();
    for (const double y : {4.0, 36.0})
        (void)cut(zmap, cutterOf("flat:d=22"), straightMotion({-30, y, 1}, {90, y, 1}));
    for (const double x : {20.0, 40.0, 55.0})
        (void)cut(zmap, cutterOf("flat:d=20"), straightMotion({x, -20, 1}, {x, 60, 1}));
    const Motion down = straightMotion({7, 20, 40}, {17, 20, 2});
    EXPECT_FALSE(contactOf(zmap, cutterOf("flat:d=10,l=12,so=12,holder=11x40"), down).any());
    EXPECT_GT(contactOf(zmap, cutterOf("flat:d=1,l=12,so=12,holder=11x40"), down).holder.depth, 8)
        << "what a thin cutter leaves";
}

TEST(AssemblyContact, CountsWhatTheCutterHasLeftBehind) {
    // A block from x = 53 to the edge of the stock, 4 mm wide, which the cutter leaves while it descends.
    ZMap zmap = freshMap();
    for (const double y : {7.0, 33.0})
        (void)cut(zmap, cutterOf("flat:d=22"), straightMotion({-30, y, 1}, {90, y, 1}));
    for (const double x : {10.0, 28.0, 43.0})
        (void)cut(zmap, cutterOf("flat:d=20"), straightMotion({x, -20, 1}, {x, 60, 1}));
    const Motion motion = straightMotion({58, 20, 25}, {66, 20, -10});
    const PartContact found = contactOf(zmap, cutterOf("flat:d=10,l=12,so=12,holder=24x40"), motion).holder;
    // That far it moves from where the cutter leaves a point, 1.5 mm beside the path, to where the holder
    // does.
    const double way = std::sqrt(12 * 12 - 1.5 * 1.5) - std::sqrt(5 * 5 - 1.5 * 1.5);
    EXPECT_NEAR(found.depth, 35.0 / 8 * way - 12, 1e-4);
    EXPECT_NEAR(std::abs(found.place.y - 20), 1.5, 1e-9);
}

TEST(AssemblyContact, BeginsAtTheClearance) {
    ZMap zmap = freshMap(0.1);
    (void)cut(zmap, cutterOf("flat:d=20"), plungeTo(5));
    const Cutter narrow = cutterOf("flat:d=10,l=15,so=18,holder=16x30");
    EXPECT_FALSE(contactOf(zmap, narrow, plungeTo(9), 1.9).any()) << "2 mm on each side";
    EXPECT_NEAR(contactOf(zmap, narrow, plungeTo(9), 2.2).holder.depth, 3 + 2.2, 1e-5);
    const Cutter wide = cutterOf("flat:d=10,l=15,so=18,holder=30x30");
    EXPECT_FALSE(contactOf(zmap, wide, plungeTo(14), 1.9).any()) << "2 mm above the top";
    EXPECT_NEAR(contactOf(zmap, wide, plungeTo(14), 2.5).holder.depth, 0.5, 1e-5);
    EXPECT_NEAR(contactOf(zmap, wide, plungeTo(14), 50).holder.depth, 16, 1e-5) << "not below the cutter";
}

TEST(AssemblyContact, OfAnUnknownMotionIsNone) {
    Motion motion = plungeTo(0);
    motion.startKnown = kAxisX;
    EXPECT_FALSE(contactOf(freshMap(), cutterOf("flat:d=10,l=10,so=12,holder=30x5"), motion).any());
}

TEST(AssemblyContact, IsEmptyWhereNothingCanTouch) {
    EXPECT_TRUE(ToolAssembly(cutterOf("flat:d=10")).empty());
    EXPECT_TRUE(ToolAssembly(cutterOf("flat:d=10,so=60")).empty());
    EXPECT_TRUE(ToolAssembly(cutterOf("face:d=80,angle=45,h=6,so=60,holder=50x40")).empty());
    EXPECT_FALSE(ToolAssembly(cutterOf("flat:d=10,so=60,holder=50x40")).empty());
}

TEST(AssemblyContact, IsNotMeasuredToTheEndWhenStopped) {
    std::stop_source source;
    source.request_stop();
    const ToolAssembly assembly(cutterOf("flat:d=10,l=10,so=12,holder=30x5"));
    EXPECT_FALSE(assembly.contact(freshMap(), plungeTo(0), source.get_token()).has_value());
}

/// A random holder: its text, and its lower surface computed segment by segment.
struct RandomHolder {
    struct Segment {
        double lower;
        double upper;
        double base;
        double height;
    };
    double stickOut;
    std::vector<Segment> segments;
    std::string text;

    RandomHolder(Random& random, double lowest) : stickOut(lowest + uniform(random, 0, 6)) {
        double base = stickOut;
        for (unsigned count = 1 + random() % 4; count > 0; --count) {
            const double lower = uniform(random, 1, 9);
            const double upper = random() % 2 == 0 ? lower : uniform(random, 1, 9);
            const double height = uniform(random, 0.5, 6);
            segments.push_back({lower, upper, base, height});
            text += fmt::format("{}{}{}x{}", text.empty() ? "" : "+", 2 * lower,
                                lower == upper ? "" : fmt::format("-{}", 2 * upper), height);
            base += height;
        }
    }

    [[nodiscard]] double radius() const {
        double widest = 0;
        for (const Segment& segment : segments)
            widest = std::max({widest, segment.lower, segment.upper});
        return widest;
    }
    /// The lowest height at which the holder is as wide as `r`.
    [[nodiscard]] double height(double r) const {
        double lowest = std::numeric_limits<double>::infinity();
        for (const Segment& segment : segments) {
            if (r <= segment.lower)
                lowest = std::min(lowest, segment.base);
            else if (r <= segment.upper)
                lowest = std::min(lowest, segment.base + segment.height * (r - segment.lower) /
                                                             (segment.upper - segment.lower));
        }
        return lowest;
    }
};

/// Bounds of the deepest contact, from many positions of the tip: no place of the path is farther than half a
/// step from one of them.
struct Bounds {
    double least = 0;
    double most = 0;
};

/// One point of the map while the tip moves from position to position.
class WatchedPoint {
public:
    WatchedPoint(const Cutter& cutter, const RandomHolder& holder, double half, double floor, const Vec2& at,
                 double height)
        : m_cutter(cutter), m_holder(holder), m_half(half), m_floor(floor), m_at(at), m_highest(height),
          m_lowest(height) {}

    void pass(const Vec3& tip, Bounds& bounds) {
        const double r = glm::distance(Vec2(tip), m_at);
        const double inner = std::max(0.0, r - m_half);
        // Under the cutter for half a step on both sides: there the holder is above what is being cut.
        if (r > m_cutter.radius() - m_half)
            bounds.most = std::max(bounds.most, depthOf(m_highest, tip.z - m_half + m_holder.height(inner)));
        if (inner <= m_cutter.radius())
            m_lowest = std::min(m_lowest, tip.z - m_half + m_cutter.height(inner));
        bounds.least = std::max(bounds.least, depthOf(m_lowest, tip.z + m_holder.height(r)));
        if (r <= m_cutter.radius())
            m_highest = std::min(m_highest, tip.z + m_cutter.height(r));
    }

private:
    /// There is no material below the floor.
    [[nodiscard]] double depthOf(double material, double part) const {
        return material - std::max(part, m_floor);
    }

    const Cutter& m_cutter;
    const RandomHolder& m_holder;
    double m_half;
    double m_floor;
    Vec2 m_at;
    double m_highest; ///< the material may be lower, but not higher
    double m_lowest;
};

Bounds bruteForce(const ZMap& zmap, const Cutter& cutter, const RandomHolder& holder, const Motion& motion) {
    const int steps = std::clamp(static_cast<int>(pathLength(motion) / 0.1), 20, 1200);
    const OraclePath path(motion, steps);
    double half = 0;
    for (std::size_t k = 1; k < path.samples().size(); ++k)
        half = std::max(half, glm::distance(path.samples()[k - 1], path.samples()[k]) * 0.505);
    const Grid& grid = zmap.grid();
    const ZMapSnapshot before = zmap.snapshot();
    const double reach = std::max(holder.radius(), cutter.radius()) + half;
    const Box3 box = bounds(motion);
    Bounds found;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            const Vec2 at(grid.x(i), grid.y(j));
            const Vec2 beside = glm::max(Vec2(box.lo) - at, at - Vec2(box.hi));
            if (std::max(beside.x, beside.y) > reach || before.height(i, j) <= before.floor())
                continue;
            WatchedPoint point(cutter, holder, half, zmap.stock().floorZ(), at,
                               zmap.stock().topZ() + static_cast<double>(before.height(i, j)));
            for (const Vec3& tip : path.samples())
                point.pass(tip, found);
        }
    return found;
}

/// A stock with some pockets and slots, deeper than the cutters go, or less deep.
ZMap randomStock(Random& random, const StockBox& stock) {
    ZMap zmap(stock, makeGrid(stock, 1.4).value());
    for (unsigned count = random() % 4; count > 0; --count) {
        const Cutter cutter = cutterOf(fmt::format("flat:d={}", uniform(random, 6, 26)));
        (void)cut(
            zmap, cutter,
            randomStraight(random, stock, random() % 2 == 0 ? StraightKind::level : StraightKind::plunge));
    }
    return zmap;
}

Motion randomMotion(Random& random, const StockBox& stock, int round) {
    if (round % 2 == 0)
        return randomStraight(random, stock, static_cast<StraightKind>(round / 2 % 5));
    return randomArc(random, stock, static_cast<Plane>(round / 2 % 3), static_cast<ArcKind>(round / 6 % 4));
}

TEST(AssemblyContact, AgreesWithBruteForce) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Random random(seed);
    const StockBox stock{{-3, 5, 2}, 24, 18, 30};
    const char* shapes[] = {"flat", "ball", "bull", "cone", "taperball", "form", "tslot"};
    const int rounds = roundsOf(10'000);
    int touching = 0;
    int free = 0;
    int tight = 0;
    for (int round = 0; round < rounds; ++round) {
        const Cutter plain = randomCutter(random, shapes[random() % std::size(shapes)]);
        const RandomHolder holder(random, plain.profileHeight());
        const Cutter cutter =
            cutterOf(fmt::format("{},so={},holder={}", plain.spec(), holder.stickOut, holder.text));
        const Motion motion = randomMotion(random, stock, round);
        SCOPED_TRACE(reported(cutter, motion));
        const ZMap zmap = randomStock(random, stock);
        const Bounds expected = bruteForce(zmap, cutter, holder, motion);
        const double found = contactOf(zmap, cutter, motion).holder.depth;
        ASSERT_GE(found, expected.least - kExact) << "round " << round;
        ASSERT_LE(found, expected.most + kExact) << "round " << round;
        touching += expected.least > kExact ? 1 : 0;
        free += expected.most < kExact ? 1 : 0;
        tight += expected.most - expected.least < 0.3 ? 1 : 0;
    }
    if (rounds >= 100) {
        EXPECT_GT(touching, rounds / 5);
        EXPECT_GT(free, rounds / 20);
        EXPECT_GT(tight, rounds / 2) << "bounds that are far apart show nothing";
    }
}

} // namespace
} // namespace proveout
