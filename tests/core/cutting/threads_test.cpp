// SPDX-License-Identifier: GPL-3.0-or-later
// Compares heights and records bit for bit for one, two and four threads.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <thread>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "core/cutting/cut/lower_tile.h"
#include "tests/core/cutting/random_motion.h"

namespace proveout {
namespace {

struct Outcome {
    std::vector<float> heights;
    std::vector<double> volumes;

    friend bool operator==(const Outcome&, const Outcome&) = default;
};

Outcome cutWith(std::size_t threads, unsigned seed) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    // Fine enough for motions to be cut in parallel, with snapshots held at times so that tiles are copied.
    const StockBox stock{{0, 0, 0}, 60, 50, 15};
    ZMap zmap(stock, makeGrid(stock, 0.05).value());
    Random random(seed);
    Outcome outcome;
    ZMapSnapshot held;
    const char* shapes[] = {"flat", "ball", "bull", "cone"};
    for (int k = 0; k < 12; ++k) {
        const Cutter cutter = randomCutter(random, shapes[random() % 4]);
        const Motion motion = k % 4 == 3 ? randomArc(random, stock, Plane::xy, ArcKind::level)
                                         : randomStraight(random, stock, StraightKind::sloped);
        outcome.volumes.push_back(cut(zmap, cutter, motion).removedMm3);
        if (k % 3 == 0)
            held = zmap.snapshot();
    }
    const ZMapSnapshot moment = zmap.snapshot();
    outcome.heights.resize(static_cast<std::size_t>(zmap.grid().nx) *
                           static_cast<std::size_t>(zmap.grid().ny));
    moment.read({0, 0, zmap.grid().nx, zmap.grid().ny}, outcome.heights);
    return outcome;
}

TEST(Threads, ChangeNothing) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(fmt::format("seed {}", seed));
        const Outcome one = cutWith(1, seed);
        for (const std::size_t threads : {2, 4})
            EXPECT_TRUE(cutWith(threads, seed) == one) << threads << " threads";
    }
}

/// Threads of its own, which use nothing of oneTBB.
TileCut lowerAlone(ZMap& zmap, std::size_t tile, const PreparedSweep& prepared) {
    const std::uint32_t first = 0;
    CutRecord record;
    return lowerTile(zmap, tile, {&prepared, 1}, {&first, 1}, {&record, 1}, {});
}

TEST(Threads, LowerDifferentTilesAtOnce) {
    constexpr std::size_t kThreads = 4;
    const StockBox stock{{0, 0, 0}, 60, 50, 15};
    const Grid grid = makeGrid(stock, 0.2).value();
    ZMap zmap(stock, grid);
    ZMap expected(stock, grid);
    Random random(11);
    const char* shapes[] = {"flat", "ball", "bull", "cone"};
    ZMapSnapshot held;
    for (int k = 0; k < 10; ++k) {
        const Cutter cutter = randomCutter(random, shapes[random() % 4]);
        const Motion motion = k % 3 == 2 ? randomArc(random, stock, Plane::xy, ArcKind::helix)
                                         : randomStraight(random, stock, StraightKind::sloped);
        // The workers copy shared tiles and write owned ones in place.
        if (k % 2 == 0)
            held = zmap.snapshot();
        const PreparedSweep prepared(cutter, motion, zmap);
        std::vector<TileCut> done(zmap.tileCount());
        std::vector<std::thread> workers;
        for (std::size_t worker = 0; worker < kThreads; ++worker)
            workers.emplace_back([&, worker] {
                for (std::size_t tile = worker; tile < done.size(); tile += kThreads)
                    done[tile] = lowerAlone(zmap, tile, prepared);
            });
        for (std::thread& worker : workers)
            worker.join();
        for (std::size_t tile = 0; tile < done.size(); ++tile) {
            if (done[tile].copy)
                zmap.adoptTile(tile, std::move(done[tile].copy));
        }
        (void)cut(expected, cutter, motion);
    }
    EXPECT_TRUE(zmap.snapshot().sameHeights(expected.snapshot(), {0, 0, grid.nx, grid.ny}));
}

} // namespace
} // namespace proveout
