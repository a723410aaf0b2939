// SPDX-License-Identifier: GPL-3.0-or-later
// However a moment is reached, its rims are those that all motions before it give each tile.
#include "core/simulation/run/rim_finder.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/cutting/cut/tile_rims.h"
#include "core/simulation/run/block_cutter.h"
#include "core/simulation/run/frame.h"
#include "core/zmap/extruded_stock.h"
#include "core/zmap/mesh_stock.h"
#include "core/zmap/saved_stock.h"
#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"
#include "tests/core/zmap/mesh_bodies.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

/// 4 × 3 tiles; T1 and T2 are a ball and a flat end mill.
std::shared_ptr<proveout::Setup> toolsSetup(double spacing = 0.2) {
    auto setup = std::make_shared<proveout::Setup>(*smallSetup(spacing));
    setup->tools.set(2, parseCutter("flat:d=3").value());
    return setup;
}

/// Lines and arcs in all planes with both tools.
std::string randomText(std::mt19937& random, int blocks) {
    const auto between = [&](double lo, double hi) {
        return std::uniform_real_distribution<double>(lo, hi)(random);
    };
    std::string text = "G21 G90 G17\nT1 M6\nG0 X5 Y5 Z5\n";
    for (int block = 1; block < blocks; ++block) {
        switch (random() % 8) {
        case 0:
            text += fmt::format("G0 Z2\nT{} M6\n", 1 + random() % 2);
            break;
        case 1:
            text += fmt::format("G17 G3 I{:.3f} J{:.3f} F900\n", between(-3, 3), between(0.5, 3));
            break;
        case 2:
            text += fmt::format("G18 G2 I{:.3f} K{:.3f} F900\n", between(-2, 2), between(0.5, 2));
            break;
        case 3:
            text += fmt::format("G19 G3 J{:.3f} K{:.3f} F900\n", between(-2, 2), between(0.5, 2));
            break;
        default:
            text += fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f} F900\n", between(-3, 43), between(-3, 33),
                                between(-6, 0.5));
        }
    }
    return text + "M30\n";
}

/// Rims by their definition: from all motions before the moment, without an index.
std::vector<RimTilePtr> rimsByDefinition(const Simulation& simulation, const proveout::Setup& setup) {
    const ZMapSnapshot zmap = simulation.zmap();
    const auto uncut = setup.shape.body == nullptr ? nullptr : topOf(zmap.stock(), setup.shape, zmap.grid());
    const auto motions =
        cutterMotions(simulation.program(), 0, simulation.position(), setup, simulation.tools());
    std::vector<RimTilePtr> rims;
    for (std::size_t tile = 0; tile < zmap.tileCount(); ++tile)
        rims.push_back(rimsOfTile(zmap, tile, uncut.get(), motions, {}, RimEdges::atLevels));
    return rims;
}

/// Without its ribs, which other tests look for.
RimTile withoutRibs(const RimTilePtr& tile) {
    RimTile rims = tile == nullptr ? RimTile() : *tile;
    rims.unseenRibs.clear();
    return rims;
}

std::size_t differentTiles(const RimMap& rims, const std::vector<RimTilePtr>& wanted) {
    std::size_t different = rims.size() == wanted.size() ? 0 : wanted.size();
    for (std::size_t tile = 0; different < wanted.size() && tile < wanted.size(); ++tile)
        different += withoutRibs(rims[tile]) == withoutRibs(wanted[tile]) ? 0 : 1;
    return different;
}

std::size_t rimCount(const RimMap& rims) {
    std::size_t count = 0;
    for (std::size_t tile = 0; tile < rims.size(); ++tile)
        count += rims[tile] == nullptr ? 0 : rims[tile]->rims.size();
    return count;
}

bool sameWalls(const WallPoints& a, const WallPoints& b, std::size_t tiles) {
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        const WallTile* one = a.tile(tile);
        const WallTile* other = b.tile(tile);
        if (one == nullptr || other == nullptr ? one != other : !(*one == *other))
            return false;
    }
    return true;
}

/// Those of a tile that are not in `all`; near its border, they depend on other tiles.
std::size_t countOthers(const WallTile* walls, const WallTile* all) {
    constexpr int kBorder = 3;
    const auto isOther = [&](const WallPoint& wall) {
        const int column = wall.point % Tile::kSize;
        const int row = wall.point / Tile::kSize;
        const bool inside =
            std::min({column, row, Tile::kSize - 1 - column, Tile::kSize - 1 - row}) > kBorder;
        return inside && (all == nullptr || std::ranges::find(all->points, wall) == all->points.end());
    };
    return walls == nullptr ? 0 : static_cast<std::size_t>(std::ranges::count_if(walls->points, isOther));
}

class RimFinderOf : public testing::Test {
protected:
    const std::uint32_t seed = randomSeed();
    std::mt19937 random{seed};
    const testing::ScopedTrace trace{__FILE__, __LINE__, testing::Message() << "seed " << seed};

    std::unique_ptr<Simulation> started(std::shared_ptr<const Program> program,
                                        std::shared_ptr<const proveout::Setup> setup) {
        DecimationParameters parameters;
        parameters.period = 0;
        return startedSimulation(std::move(program), std::move(setup), parameters);
    }
    /// Seeks, steps and edits, and compares the rims of each moment.
    void compareOnAnyPath(const std::shared_ptr<const proveout::Setup>& setup) {
        RimFinder finder;
        std::string text = randomText(random, 50);
        const auto simulation = started(programOf(text), setup);
        for (int step = 0; step < roundsOf(18); ++step) {
            if (step % 6 == 5) {
                const std::size_t line = text.find('\n', 40 + random() % (text.size() - 50)) + 1;
                text.insert(line, "G1 X20 Y15 Z-5 F500\n");
                simulation->seek(simulation->noteProgram(programOf(text)));
            } else if (step % 3 == 2) {
                simulation->step();
            } else {
                simulation->seek(random() % (simulation->blockCount() + 1));
            }
            SCOPED_TRACE(testing::Message() << "step " << step << ", block " << simulation->position());
            const RimMap rims = finder.find(simulation->frame()).rims();
            ASSERT_EQ(differentTiles(rims, rimsByDefinition(*simulation, *setup)), 0U);
        }
        simulation->seek(simulation->blockCount());
        const RimMap rims = finder.find(simulation->frame()).rims();
        const auto fresh = started(programOf(text), setup);
        fresh->seek(fresh->blockCount());
        RimMap alone;
        onThisThread([&] { alone = RimFinder().find(fresh->frame()).rims(); });
        EXPECT_GT(rimCount(alone), 0U);
        for (std::size_t tile = 0; tile < rims.size(); ++tile)
            EXPECT_TRUE(rims[tile] == nullptr ? alone[tile] == nullptr : *rims[tile] == *alone[tile]) << tile;
    }
};

TEST_F(RimFinderOf, FindsTheRimsOfAnyMoment) {
    compareOnAnyPath(toolsSetup());
}

TEST_F(RimFinderOf, FindsThoseOfStockThatIsNoBox) {
    const auto setup = toolsSetup(0.3);
    setup->shape.kind = StockKind::cylinder;
    setup->shape.body = extrudedStock({circleOutline(30)}, 10).value();
    setup->stock = setup->shape.body->box();
    EXPECT_GT(rimCount(RimFinder().find(started(programOf("G0 X0\n"), setup)->frame()).rims()), 0U)
        << "uncut";
    compareOnAnyPath(setup);
}

TEST_F(RimFinderOf, FindsThoseOfAMesh) {
    const auto setup = toolsSetup(0.3);
    setup->shape.kind = StockKind::mesh;
    setup->shape.body = meshStock(roundBody(15, 10, 90)).value();
    setup->stock = setup->shape.body->box();
    EXPECT_GT(rimCount(RimFinder().find(started(programOf("G0 X0\n"), setup)->frame()).rims()), 0U)
        << "uncut";
    compareOnAnyPath(setup);
}

TEST_F(RimFinderOf, FindsThoseOfSavedStock) {
    const auto before = toolsSetup();
    const auto first = started(programOf("T2 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX35 Y21\nG3 I-5 J3\n"), before);
    first->seek(first->blockCount());
    const ZMapSnapshot saved = RimFinder().find(first->frame());
    const auto setup = toolsSetup();
    setup->shape.kind = StockKind::saved;
    setup->shape.body = savedStock(saved, setup->spacing).value();
    const RimMap uncut = RimFinder().find(started(programOf("G0 X0\n"), setup)->frame()).rims();
    EXPECT_GT(rimCount(uncut), 100U);
    std::vector<RimTilePtr> wanted;
    for (std::size_t tile = 0; tile < saved.rims().size(); ++tile)
        wanted.push_back(saved.rims()[tile]);
    EXPECT_EQ(differentTiles(uncut, wanted), 0U);
    compareOnAnyPath(setup);
}

/// A setup in what another one has left.
std::shared_ptr<proveout::Setup> setupIn(const ZMapSnapshot& saved, const proveout::Setup& before,
                                         StockTurn turn = StockTurn::none) {
    auto setup = std::make_shared<proveout::Setup>(before);
    setup->shape.kind = StockKind::saved;
    setup->shape.body = savedStock(saved, before.spacing, turn).value();
    setup->stock = setup->shape.body->box();
    return setup;
}

/// Nobody knows how high they are: until everything between their points is cut, they are there.
TEST_F(RimFinderOf, KeepsUnseenRibsOfSavedStockUntilTheyAreCut) {
    const auto before = toolsSetup(0.5);
    const auto ribsAfter = [&](const std::string& text, const std::shared_ptr<const proveout::Setup>& setup) {
        const auto simulation = started(programOf(text), setup);
        simulation->seek(simulation->blockCount());
        const ZMapSnapshot map = RimFinder().find(simulation->frame());
        return std::pair(unseenRibs(map.rims()), map);
    };
    // Two slots of 3 mm, and 0.2 mm between them: from y = 11.65 to 11.85.
    const auto [ribs, saved] = ribsAfter(
        "T2 M6\nG0 X10 Y10.15 Z5\nG1 Z-2 F100\nX30\nG0 Z5\nX10 Y13.35\nG1 Z-2\nX30\nG0 Z5\n", before);
    EXPECT_GT(ribs, 40U);
    for (const StockTurn turn : {StockTurn::none, StockTurn::quarter, StockTurn::half})
        EXPECT_EQ(ribsAfter("G0 X0\n", setupIn(saved, *before, turn)).first, ribs);
    const auto setup = setupIn(saved, *before);
    EXPECT_EQ(ribsAfter("T2 M6\nG0 X10 Y11.7 Z5\nG1 Z-1.5 F100\nX30\n", setup).first, ribs) << "above";
    const std::size_t half = ribsAfter("T2 M6\nG0 X5 Y11.7 Z5\nG1 Z-2 F100\nX18.6\n", setup).first;
    EXPECT_GT(half, ribs / 3);
    EXPECT_LT(half, ribs * 2 / 3);
    EXPECT_EQ(ribsAfter("T2 M6\nG0 X5 Y11.7 Z5\nG1 Z-2 F100\nX35\n", setup).first, 0U);
    // Deeper slots leave them again.
    EXPECT_GE(
        ribsAfter("T2 M6\nG0 X10 Y10.15 Z5\nG1 Z-3 F100\nX30\nG0 Z5\nX10 Y13.35\nG1 Z-3\nX30\n", setup).first,
        ribs);
    // And another setup after that.
    const ZMapSnapshot again = ribsAfter("G0 X0\n", setup).second;
    EXPECT_EQ(ribsAfter("G0 X0\n", setupIn(again, *before)).first, ribs);
}

/// Where nothing stands, nothing is missing.
TEST_F(RimFinderOf, UnknownTilesOfSavedStockRemainUnknownWhereTheyHaveWalls) {
    const auto before = toolsSetup(0.5); // 2 × 1 tiles; the slot is in the first one
    const auto first = started(programOf("T2 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX20\n"), before);
    first->seek(first->blockCount());
    ZMapSnapshot saved = RimFinder().find(first->frame());
    saved.setRims(unknownRims(saved.tileCount()));
    const auto setup = setupIn(saved, *before);
    const auto simulation = started(programOf("T2 M6\nG0 X30 Y25 Z5\nG1 Z-1 F100\nX35\n"), setup);
    simulation->seek(simulation->blockCount());
    const RimMap rims = RimFinder().find(simulation->frame()).rims();
    EXPECT_EQ(unknownTiles(rims), 1U);
    EXPECT_TRUE(rims[0]->areUnknown);
    EXPECT_GT(countOf(rims), 0U) << "those of the new slot are known";
    // On another grid too.
    setup->spacing = 0.25;
    const auto finer = started(programOf("G0 X0\n"), setup);
    EXPECT_GT(unknownTiles(RimFinder().find(finer->frame()).rims()), 0U);
}

/// So many long triangles over one place that they have no index.
TEST_F(RimFinderOf, WallsOfAFanOfTrianglesAreUnknown) {
    const auto setup = toolsSetup(0.5);
    setup->shape.kind = StockKind::mesh;
    setup->shape.body = meshStock(roundBody(15, 10, 40'000)).value();
    setup->stock = setup->shape.body->box();
    const auto simulation = started(programOf("G0 X0\n"), setup);
    const ZMapSnapshot map = RimFinder().find(simulation->frame());
    EXPECT_EQ(unknownTiles(map.rims()), map.tileCount());
    const Diagnostics findings = simulation->frame().findings;
    EXPECT_TRUE(std::ranges::any_of(
        findings, [](const Diagnostic& finding) { return finding.id == std::string("stock-mesh-walls"); }));
}

TEST_F(RimFinderOf, TilesAwayFromTheCutKeepTheirPointers) {
    const auto simulation = started(
        programOf(
            "T2 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX35\nG0 Z5\nX30 Y25\nG1 Z-3\nX35\nG0 Z5\nX5 Y5\nG1 Z-1\n"),
        toolsSetup());
    RimFinder finder;
    simulation->seek(4);
    const ZMapSnapshot before = finder.find(simulation->frame());
    simulation->seek(7); // a slot in the last two tiles of the second row
    const ZMapSnapshot after = finder.find(simulation->frame());
    for (std::size_t tile = 0; tile < 3; ++tile) {
        EXPECT_NE(after.rims()[tile], nullptr) << tile;
        EXPECT_EQ(before.rims()[tile], after.rims()[tile]) << tile;
    }
    EXPECT_NE(before.rims()[6], after.rims()[6]);
    simulation->seek(10); // within the first slot, above its bottom: no height changes, but a motion is new
    const ZMapSnapshot same = finder.find(simulation->frame());
    EXPECT_EQ(same.tile(0), after.tile(0));
    EXPECT_EQ(differentTiles(same.rims(), rimsByDefinition(*simulation, *toolsSetup())), 0U);
}

TEST_F(RimFinderOf, InSomeTimeItFindsSomeAndNoneOfBefore) {
    const auto setup = toolsSetup(0.1);
    const auto program = programOf(randomText(random, 80));
    const auto simulation = started(program, setup);
    RimFinder finder;
    for (int step = 0; step < 20; ++step) {
        simulation->seek(random() % (simulation->blockCount() + 1));
        const Frame moment = simulation->frame();
        const ZMapSnapshot all = RimFinder().find(moment);
        const WallPoints none = finder.findSome(moment, std::chrono::nanoseconds(0));
        const WallPoints some = finder.findSome(moment, std::chrono::microseconds(random() % 500));
        for (std::size_t tile = 0; tile < all.tileCount(); ++tile) {
            for (const WallPoints* walls : {&none, &some})
                EXPECT_EQ(countOthers(walls->tile(tile), all.walls().tile(tile)), 0U) << step << ' ' << tile;
        }
        EXPECT_TRUE(sameWalls(finder.findSome(moment, std::chrono::hours(1)), all.walls(), all.tileCount()));
    }
}

TEST_F(RimFinderOf, SeesThatAnEditReplacesAMotion) {
    const std::string slot = "T2 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX35\n";
    const auto setup = toolsSetup();
    const auto simulation = started(programOf(slot + "G1 X5 Z-2\n"), setup);
    simulation->seek(4);
    RimFinder finder;
    const RimMap before = finder.find(simulation->frame()).rims();
    simulation->seek(simulation->noteProgram(programOf(slot + "G1 X5 Z-4\n")));
    simulation->seek(4); // over the same tiles, but deeper
    const RimMap after = finder.find(simulation->frame()).rims();
    EXPECT_EQ(differentTiles(after, rimsByDefinition(*simulation, *setup)), 0U);
    EXPECT_NE(before[0], after[0]);
}

TEST_F(RimFinderOf, StartsAgainWithAnotherSetup) {
    const auto program = programOf(randomText(random, 30));
    RimFinder finder;
    for (const double spacing : {0.2, 0.5, 0.2}) {
        const auto setup = toolsSetup(spacing);
        const auto simulation = started(program, setup);
        simulation->seek(program->blockCount());
        EXPECT_EQ(
            differentTiles(finder.find(simulation->frame()).rims(), rimsByDefinition(*simulation, *setup)),
            0U);
    }
}

TEST_F(RimFinderOf, AfterAStopItFindsTheRest) {
    const auto setup = toolsSetup(0.03); // 336 tiles
    const auto simulation = started(programOf("T2 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX35\nY25\nX5\n"), setup);
    simulation->seek(simulation->blockCount());
    RimFinder finder;
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(finder.find(simulation->frame(), {stop.get_token(), {}}).rims().empty());
    std::stop_source later;
    int reports = 0;
    const auto afterAPart = [&](double) {
        ++reports;
        later.request_stop();
    };
    EXPECT_TRUE(finder.find(simulation->frame(), {later.get_token(), afterAPart}).rims().empty());
    EXPECT_EQ(reports, 1);
    const ZMapSnapshot whole = finder.find(simulation->frame());
    EXPECT_EQ(differentTiles(whole.rims(), rimsByDefinition(*simulation, *setup)), 0U);
    EXPECT_GT(rimCount(whole.rims()), 0U);
}

} // namespace
} // namespace proveout
