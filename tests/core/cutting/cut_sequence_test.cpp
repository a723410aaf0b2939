// SPDX-License-Identifier: GPL-3.0-or-later
// Compares sequences of motions with the same motions one by one.
#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "core/cutting/cut/sequence_cutter.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

const StockBox kStock{{-3, 5, 2}, 50, 40, 12};

/// Motions of all shapes and kinds; some have no cutter, some an unknown path, some continue the one before.
struct RandomSequence {
    std::vector<Cutter> cutters;
    std::vector<CutterMotion> motions;

    RandomSequence(Random& random, int count) {
        for (const char* shape : {"flat", "ball", "bull", "cone"})
            cutters.push_back(randomCutter(random, shape));
        for (int k = 0; k < count; ++k) {
            Motion motion = k % 7 == 6
                                ? randomArc(random, kStock, static_cast<Plane>(random() % 3),
                                            static_cast<ArcKind>(random() % 4))
                                : randomStraight(random, kStock, static_cast<StraightKind>(random() % 5));
            if (random() % 30 == 0)
                motion.startKnown = 0;
            const Cutter* cutter = random() % 30 == 0 ? nullptr : &cutters[random() % cutters.size()];
            if (!motions.empty() && motion.kind != MotionKind::arc && random() % 2 == 0) {
                motion.start = motions.back().motion.end;
                cutter = motions.back().cutter;
            }
            motions.push_back({cutter, motion});
            motions.back().continues = k > 0 && continues(*(motions.end() - 2), motions.back());
        }
    }
};

ZMap freshMap(double spacing) {
    return {kStock, makeGrid(kStock, spacing).value()};
}

void expectSame(const CutRecord& a, const CutRecord& b) {
    EXPECT_EQ(a.removedMm3, b.removedMm3);
    EXPECT_EQ(a.maxDepth, b.maxDepth);
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.changed, b.changed);
    EXPECT_EQ(a.engagedFrom, b.engagedFrom);
    EXPECT_EQ(a.engagedTo, b.engagedTo);
}

TEST(CutSequence, IsTheMotionsOneByOne) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    for (int round = 0; round < roundsOf(12); ++round) {
        const RandomSequence sequence(random, 60);
        const double spacing = round % 2 == 0 ? 0.15 : 0.7;
        ZMap expected = freshMap(spacing);
        std::vector<CutRecord> records;
        for (const CutterMotion& one : sequence.motions)
            records.push_back(*cut(expected, one, {}));
        for (const std::size_t threads : {1U, 2U, 4U}) {
            const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
            ZMap zmap = freshMap(spacing);
            const ZMapSnapshot held = zmap.snapshot(); // forces a copy of every tile before it is written
            const auto found = cut(zmap, sequence.motions, {});
            ASSERT_TRUE(found);
            EXPECT_TRUE(
                zmap.snapshot().sameHeights(expected.snapshot(), {0, 0, zmap.grid().nx, zmap.grid().ny}));
            ASSERT_EQ(found->size(), records.size());
            for (std::size_t k = 0; k < records.size(); ++k)
                expectSame((*found)[k], records[k]);
            EXPECT_EQ(held.volume(), freshMap(spacing).snapshot().volume());
            ZMap anyOrder(held);
            EXPECT_TRUE(cutHeights(anyOrder, sequence.motions, {}));
            EXPECT_TRUE(
                anyOrder.snapshot().sameHeights(expected.snapshot(), {0, 0, zmap.grid().nx, zmap.grid().ny}));
        }
    }
}

TEST(CutSequence, RecordsWhatIsAskedForAmongMotionsThatAreNot) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    for (int round = 0; round < roundsOf(12); ++round) {
        RandomSequence sequence(random, 60);
        const double spacing = round % 2 == 0 ? 0.15 : 0.7;
        ZMap expected = freshMap(spacing);
        const auto records = cut(expected, sequence.motions, {});
        ASSERT_TRUE(records);
        const auto oneIn = 1 + random() % 6;
        for (CutterMotion& one : sequence.motions)
            one.recorded = random() % oneIn == 0;
        ZMap zmap = freshMap(spacing);
        const auto found = cut(zmap, sequence.motions, {});
        ASSERT_TRUE(found);
        EXPECT_TRUE(zmap.snapshot().sameHeights(expected.snapshot(), {0, 0, zmap.grid().nx, zmap.grid().ny}));
        ASSERT_EQ(found->size(), records->size());
        for (std::size_t k = 0; k < records->size(); ++k)
            if (sequence.motions[k].recorded)
                expectSame((*found)[k], (*records)[k]);
    }
}

TEST(CutSequence, LeavesNothingBehindInTheMemoryItKeeps) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    SequenceCutter cutter;
    std::vector<CutRecord> found;
    for (int round = 0; round < roundsOf(24); ++round) {
        RandomSequence sequence(random, 1 + static_cast<int>(random() % 60));
        const auto oneIn = random() % 3;
        for (CutterMotion& one : sequence.motions)
            one.recorded = oneIn == 0 || random() % oneIn == 0;
        const double spacing = random() % 2 == 0 ? 0.15 : 0.7;
        ZMap expected = freshMap(spacing);
        std::vector<CutRecord> records;
        for (const CutterMotion& one : sequence.motions)
            records.push_back(*cut(expected, one, {}));
        ZMap zmap = freshMap(spacing);
        const bool onlyHeights = random() % 4 == 0;
        ASSERT_TRUE(onlyHeights ? cutter.cutHeights(zmap, GridPart(zmap.grid()), sequence.motions, {})
                                : cutter.cut(zmap, sequence.motions, found, {}));
        EXPECT_TRUE(zmap.snapshot().sameHeights(expected.snapshot(), {0, 0, zmap.grid().nx, zmap.grid().ny}));
        if (onlyHeights)
            continue;
        ASSERT_EQ(found.size(), records.size());
        for (std::size_t k = 0; k < records.size(); ++k)
            if (sequence.motions[k].recorded)
                expectSame(found[k], records[k]);
    }
}

TEST(CutSequence, KnowsWhichMotionLoweredEachPointLast) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    for (int round = 0; round < roundsOf(8); ++round) {
        RandomSequence sequence(random, 60);
        const double spacing = round % 2 == 0 ? 0.15 : 0.7;
        ZMap one = freshMap(spacing);
        const IndexRect all{0, 0, one.grid().nx, one.grid().ny};
        const auto points = static_cast<std::size_t>(all.width()) * static_cast<std::size_t>(all.height());
        std::vector<float> before(points);
        std::vector<float> now(points);
        std::vector<std::uint32_t> last(points, Provenance::kUncut);
        one.snapshot().read(all, before);
        for (std::size_t k = 0; k < sequence.motions.size(); ++k) {
            CutterMotion& motion = sequence.motions[k];
            motion.mark = static_cast<std::uint32_t>(7 * k + 3);
            (void)cut(one, motion, {});
            one.snapshot().read(all, now);
            for (std::size_t at = 0; at < points; ++at) {
                if (now[at] < before[at])
                    last[at] = motion.mark;
            }
            before.swap(now);
        }
        ZMap zmap = freshMap(spacing);
        Provenance provenance(zmap);
        ASSERT_TRUE(cut(zmap, sequence.motions, {}, &provenance));
        for (int j = 0; j < all.j1; ++j) {
            for (int i = 0; i < all.i1; ++i)
                ASSERT_EQ(provenance.at(i, j), last[static_cast<std::size_t>(j * all.i1 + i)])
                    << i << "," << j;
        }
    }
}

TEST(CutSequence, LosesWhatTheMapLoses) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const RandomSequence sequence(random, 200);
    ZMap zmap = freshMap(0.15);
    const double before = zmap.snapshot().volume();
    const auto records = cut(zmap, sequence.motions, {});
    ASSERT_TRUE(records);
    double removed = 0;
    double points = 0;
    for (const CutRecord& record : *records) {
        removed += record.removedMm3;
        points += static_cast<double>(record.points);
    }
    // The height removed at a point is rounded like the height itself; between two planes all points are
    // rounded alike.
    const double rounding = std::ldexp(zmap.stock().height, -24);
    EXPECT_NEAR(removed, before - zmap.snapshot().volume(),
                rounding * points * zmap.grid().hx * zmap.grid().hy);
}

TEST(CutSequence, LeavesTheMapAsItWasWhereItIsStopped) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const RandomSequence sequence(random, roundsOf(400));
    ZMap zmap = freshMap(0.1);
    const ZMapSnapshot before = zmap.snapshot();
    const IndexRect all{0, 0, zmap.grid().nx, zmap.grid().ny};
    ZMap whole = freshMap(0.1);
    (void)cut(whole, sequence.motions, {});
    for (int round = 0; round < roundsOf(20); ++round) {
        std::stop_source source;
        std::jthread stopper([&source, delay = std::chrono::microseconds(random() % 20000)] {
            std::this_thread::sleep_for(delay);
            source.request_stop();
        });
        if (round <= 1)
            stopper.join();
        ZMap fresh(before);
        const bool done = round % 2 == 0 ? cut(fresh, sequence.motions, source.get_token()).has_value()
                                         : cutHeights(fresh, sequence.motions, source.get_token());
        EXPECT_TRUE(fresh.snapshot().sameHeights(done ? whole.snapshot() : before, all));
        EXPECT_TRUE(round > 1 || !done);
    }
}

} // namespace
} // namespace proveout
