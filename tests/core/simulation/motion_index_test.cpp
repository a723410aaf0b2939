// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/motion_index.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "tests/core/cutting/random_motion.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

const StockBox kStock{{-7, 12, 3}, 40, 30, 10};

/// A map of 6 × 4 tiles; those in the last row and column are smaller.
ZMap freshMap() {
    return {kStock, makeGrid(kStock, 0.12).value()};
}

/// Straight motions and arcs in all planes, spirals among them, above the stock and beside it too, with
/// cutters of several shapes.
class RandomMotions {
public:
    explicit RandomMotions(Random& random) : m_random(random) {
        for (const char* shape : {"ball", "flat", "bull", "cone", "lollipop", "tslot"})
            m_cutters.push_back(randomCutter(random, shape));
    }

    CutterMotion next() {
        CutterMotion one;
        if (m_random() % 20 != 0)
            one.cutter = &m_cutters[m_random() % m_cutters.size()];
        one.motion = path();
        if (m_random() % 4 == 0)
            one.motion.start.z += uniform(m_random, 0, 12);
        if (m_random() % 20 == 0)
            one.motion.startKnown = kAxisX;
        return one;
    }

private:
    Motion path() {
        const auto kind = static_cast<int>(m_random() % 9);
        if (kind < 5)
            return randomStraight(m_random, kStock, static_cast<StraightKind>(kind));
        return randomArc(m_random, kStock, static_cast<Plane>(m_random() % 3),
                         static_cast<ArcKind>(kind - 5));
    }

    Random& m_random;
    std::vector<Cutter> m_cutters;
};

bool isOver(const MotionIndex& index, std::size_t tile, std::size_t motion) {
    return index.endOver(tile, motion + 1) == motion + 1;
}

/// The box of the points that a motion lowers on an uncut map, and those alone if it is asked for them.
class LoweredPoints {
public:
    explicit LoweredPoints(const CutterMotion& one) : m_zmap(freshMap()) {
        m_changed = cut(m_zmap, one, {})->changed;
    }

    [[nodiscard]] bool anyIn(const IndexRect& rect) const {
        const IndexRect part = intersection(rect, m_changed);
        const ZMapSnapshot moment = m_zmap.snapshot();
        for (int j = part.j0; j < part.j1; ++j)
            for (int i = part.i0; i < part.i1; ++i)
                if (moment.height(i, j) < 0)
                    return true;
        return false;
    }

private:
    ZMap m_zmap;
    IndexRect m_changed;
};

/// The points that a tile depends on.
IndexRect around(const ZMap& zmap, std::size_t tile) {
    const IndexRect rect = zmap.tileRect(tile);
    return {rect.i0 - 1, rect.j0 - 1, rect.i0 + Tile::kSize + 2, rect.j0 + Tile::kSize + 2};
}

class MotionIndexOf : public testing::Test {
protected:
    const std::uint32_t seed = randomSeed();
    Random random{seed};
    const testing::ScopedTrace trace{__FILE__, __LINE__, testing::Message() << "seed " << seed};
    const ZMap zmap = freshMap();
};

TEST_F(MotionIndexOf, HasEveryMotionThatLowersPointsOfATileOrNearIt) {
    RandomMotions motions(random);
    MotionIndex index(kStock, zmap.grid());
    const auto count = static_cast<std::size_t>(roundsOf(600));
    std::size_t lowered = 0;
    std::size_t listed = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const CutterMotion one = motions.next();
        index.append(one);
        const LoweredPoints points(one);
        for (std::size_t tile = 0; tile < zmap.tileCount(); ++tile) {
            const bool lowers = points.anyIn(around(zmap, tile));
            lowered += lowers ? 1 : 0;
            listed += isOver(index, tile, k) ? 1 : 0;
            ASSERT_TRUE(isOver(index, tile, k) || !lowers)
                << "tile " << tile << " of motion " << k << ", "
                << (one.cutter != nullptr ? reported(*one.cutter, one.motion) : "no cutter");
        }
    }
    EXPECT_EQ(index.motionCount(), count);
    // Corners of boxes around disks and parts of arcs, and lines near the top of the stock.
    EXPECT_LE(static_cast<double>(listed), 1.5 * static_cast<double>(lowered) + 50);
}

TEST_F(MotionIndexOf, ListsAnyBeginningOfTheProgram) {
    RandomMotions motions(random);
    MotionIndex index(kStock, zmap.grid());
    std::vector<std::vector<bool>> over(zmap.tileCount());
    for (int k = 0; k < 300; ++k) {
        const CutterMotion one = motions.next();
        index.append(one);
        MotionIndex alone(kStock, zmap.grid());
        alone.append(one);
        for (std::size_t tile = 0; tile < over.size(); ++tile)
            over[tile].push_back(isOver(alone, tile, 0));
    }
    for (std::size_t tile = 0; tile < over.size(); ++tile) {
        for (const std::size_t end : {std::size_t{0}, std::size_t{1}, random() % 300, std::size_t{300}}) {
            std::vector<bool> listed(end);
            std::size_t last = 0;
            for (const auto& range : index.over(tile, end)) {
                ASSERT_LT(range.first, range.last);
                ASSERT_TRUE(last < range.first || last == 0) << "ranges meet";
                last = range.last;
                std::fill(listed.begin() + static_cast<std::ptrdiff_t>(range.first),
                          listed.begin() + static_cast<std::ptrdiff_t>(range.last), true);
            }
            EXPECT_EQ(index.endOver(tile, end), last);
            EXPECT_EQ(listed, std::vector<bool>(over[tile].begin(),
                                                over[tile].begin() + static_cast<std::ptrdiff_t>(end)));
        }
    }
}

TEST_F(MotionIndexOf, ContinuesAfterItWasCutBack) {
    RandomMotions motions(random);
    std::vector<CutterMotion> program;
    for (int k = 0; k < 200; ++k)
        program.push_back(motions.next());
    MotionIndex index(kStock, zmap.grid());
    std::ranges::for_each(program, [&](const CutterMotion& one) { index.append(one); });
    for (const std::size_t kept : {std::size_t{150}, std::size_t{77}, std::size_t{0}}) {
        index.truncate(kept);
        for (std::size_t k = kept; k < program.size(); ++k) {
            if (k % 3 == 0)
                program[k] = motions.next();
            index.append(program[k]);
        }
        MotionIndex fresh(kStock, zmap.grid());
        std::ranges::for_each(program, [&](const CutterMotion& one) { fresh.append(one); });
        ASSERT_EQ(index.motionCount(), fresh.motionCount());
        for (std::size_t tile = 0; tile < zmap.tileCount(); ++tile)
            for (std::size_t k = 0; k < program.size(); ++k)
                ASSERT_EQ(isOver(index, tile, k), isOver(fresh, tile, k)) << tile << ", " << k;
    }
}

TEST_F(MotionIndexOf, AThinDiagonalIsOverFewTiles) {
    const StockBox wide{{0, 0, 0}, 640, 640, 10};
    MotionIndex index(wide, makeGrid(wide, 1).value()); // 11 × 11 tiles
    const Cutter cutter = cutterOf("flat:d=2");
    index.append({&cutter, straightMotion({0, 0, -1}, {640, 640, -1})});
    index.append({&cutter, straightMotion({0, 0, 0}, {640, 640, 20})});
    index.append(
        {&cutter, straightMotion({0, 320, 500}, {640, 320, -500})}); // in the stock from the middle on
    std::vector<int> tiles(3);
    for (std::size_t tile = 0; tile < 121; ++tile)
        for (std::size_t k = 0; k < 3; ++k)
            tiles[k] += isOver(index, tile, k) ? 1 : 0;
    EXPECT_LE(tiles[0], 3 * 11);
    EXPECT_EQ(tiles[1], 0);
    EXPECT_LE(tiles[2], 2 * 7);
    EXPECT_GE(tiles[2], 6);
}

/// As in finishing: short motions, which many tiles under a wide cutter have in common.
TEST_F(MotionIndexOf, TakesLessThanAByteForATileOfAMotion) {
    const StockBox wide{{0, 0, 0}, 400, 100, 10};
    const Grid grid = makeGrid(wide, 0.1).value(); // 63 × 16 tiles
    MotionIndex index(wide, grid);
    const Cutter cutter = cutterOf("ball:d=20");
    Vec3 last(0, 0, -1);
    for (int pass = 0; pass < 50; ++pass)
        for (int k = 0; k < 400; ++k) {
            const Vec3 next(pass % 2 == 0 ? k : 400 - k, 2 * pass, -1);
            index.append({&cutter, straightMotion(last, next)});
            last = next;
        }
    std::size_t entries = 0;
    for (std::size_t tile = 0; tile < 63 * 16; ++tile)
        for (const auto& range : index.over(tile, index.motionCount()))
            entries += range.last - range.first;
    EXPECT_GT(entries, 10 * index.motionCount());
    EXPECT_LT(index.bytes(), entries);
}

} // namespace
} // namespace proveout
