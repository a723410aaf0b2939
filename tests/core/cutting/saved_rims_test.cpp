// SPDX-License-Identifier: GPL-3.0-or-later
// Rims of a second setup in the stock of the first one, compared with those of one setup with all motions.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/cutter/shapes.h"
#include "core/cutting/cut/cutting.h"
#include "core/cutting/cut/tile_rims.h"
#include "core/zmap/saved_stock.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/core/random_rims.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr double kTwoSetupsSpacing = 0.5;
const StockBox kTwoSetups{{0, 0, 0}, 45, 34, 12};

using Motions = std::vector<CutterMotion>;

/// A map after motions in a stock, with its rims.
ZMapSnapshot cutFrom(ZMap zmap, const StockTop* uncut, const Motions& motions) {
    EXPECT_TRUE(cutHeights(zmap, motions, {}));
    ZMapSnapshot map = zmap.snapshot();
    RimMap rims;
    for (std::size_t tile = 0; tile < map.tileCount(); ++tile)
        rims.push_back(rimsOfTile(map, tile, uncut, motions, {}, RimEdges::atLevels));
    map.setRims(std::move(rims));
    return map;
}
ZMapSnapshot cutBox(const Motions& motions) {
    return cutFrom(ZMap(kTwoSetups, makeGrid(kTwoSetups, kTwoSetupsSpacing).value()), nullptr, motions);
}
ZMapSnapshot cutSaved(const ZMapSnapshot& saved, const Motions& motions, StockTurn turn = StockTurn::none) {
    StockShape shape;
    shape.kind = StockKind::saved;
    shape.body = savedStock(saved, kTwoSetupsSpacing, turn).value();
    const StockBox stock = shape.body->box();
    const Grid grid = makeGrid(stock, kTwoSetupsSpacing).value();
    const auto top = topOf(stock, shape, grid);
    return cutFrom(shape.body->uncut(stock, grid).zmap, top.get(), motions);
}

Motions pocketAndSlot(const Cutter& mill) {
    return {{&mill, arcMotion(Plane::xy, {15.03, 15.01, -4}, 8, 0.3, 2 * std::numbers::pi, 0, 8)},
            {&mill, straightMotion({-10, 5, -3}, {60, 30, -3})}};
}

TEST(SavedRims, AreKeptToTheLastBitWhereNothingIsCut) {
    for (const char* spec : {"flat:d=6", "ball:d=6"}) {
        const Cutter mill = cutterOf(spec);
        const ZMapSnapshot first = cutBox(pocketAndSlot(mill));
        EXPECT_GT(countOf(first.rims()), 200U);
        EXPECT_TRUE(sameRims(cutSaved(first, {}).rims(), first.rims()));
        // Motions within what is cut already, near all walls of the slot.
        const Motions again{{&mill, straightMotion({-10, 5, -2.5}, {60, 30, -2.5})}};
        EXPECT_TRUE(sameRims(cutSaved(first, again).rims(), first.rims()));
    }
}

TEST(SavedRims, TurnWithTheStock) {
    const Cutter mill = cutterOf("flat:d=6");
    const ZMapSnapshot first = cutBox(pocketAndSlot(mill));
    ZMapSnapshot turned = first;
    for (int quarter = 0; quarter < 4; ++quarter) {
        turned = cutSaved(turned, {}, StockTurn::quarter);
        EXPECT_EQ(countOf(turned.rims()), countOf(first.rims()));
    }
    EXPECT_TRUE(sameRims(turned.rims(), first.rims()));
}

struct Difference {
    std::size_t missing = 0; ///< rims of the one setup that the second of two has not
    std::size_t extra = 0;
    std::size_t places = 0; ///< elsewhere by more than 2/65536
    std::size_t normals = 0;
    std::size_t all = 0;
};

Difference difference(const RimMap& one, const RimMap& two) {
    Difference result;
    const auto ofEdge = [](const RimTilePtr& tile, std::uint16_t edge) -> const Rim* {
        if (tile == nullptr)
            return nullptr;
        const auto found = std::ranges::find(tile->rims, edge, &Rim::edge);
        return found == tile->rims.end() ? nullptr : &*found;
    };
    for (std::size_t tile = 0; tile < one.size(); ++tile) {
        for (const Rim& rim : one[tile] == nullptr ? std::vector<Rim>() : one[tile]->rims) {
            ++result.all;
            const Rim* other = ofEdge(two[tile], rim.edge);
            if (other == nullptr) {
                ++result.missing;
                continue;
            }
            result.places += std::abs(rim.highPlace - other->highPlace) > 2 ? 1 : 0;
            const bool isTurned = glm::distance(rim.normal(), other->normal()) > 0.01;
            result.normals += isTurned && rim.normal() != Vec2(0) ? 1 : 0; // 0: it has none
        }
        for (const Rim& rim : two[tile] == nullptr ? std::vector<Rim>() : two[tile]->rims)
            result.extra += ofEdge(one[tile], rim.edge) == nullptr ? 1 : 0;
    }
    return result;
}

void expectAsOfOneSetup(const Motions& first, const Motions& second) {
    Motions all = first;
    all.insert(all.end(), second.begin(), second.end());
    const ZMapSnapshot one = cutBox(all);
    const ZMapSnapshot two = cutSaved(cutBox(first), second);
    ASSERT_TRUE(one.sameHeights(two, {0, 0, one.grid().nx, one.grid().ny}));
    const Difference found = difference(one.rims(), two.rims());
    EXPECT_GT(found.all, 100U);
    EXPECT_EQ(found.missing, 0U) << found.all;
    EXPECT_EQ(found.extra, 0U);
    EXPECT_EQ(found.places, 0U);
    EXPECT_EQ(found.normals, 0U);
}

/// Lines with cutters whose walls are upright, at random depths.
Motions randomLines(std::mt19937& random, const std::vector<Cutter>& mills, int count) {
    const auto between = [&](double lo, double hi) {
        return std::uniform_real_distribution<double>(lo, hi)(random);
    };
    Motions motions;
    for (int k = 0; k < count; ++k) {
        const double depth = between(-7, -1);
        motions.push_back(
            {&mills[random() % mills.size()], straightMotion({between(-5, 50), between(-5, 40), depth},
                                                             {between(-5, 50), between(-5, 40), depth})});
    }
    return motions;
}

/// Walls nearer together than an eighth of an edge, and corners, may be found differently.
TEST(SavedRims, OfRandomLinesAreThoseOfOneSetup) {
    const std::vector<Cutter> mills{cutterOf("flat:d=6"), cutterOf("flat:d=3")};
    const std::uint32_t first = randomSeed();
    Difference sum;
    for (int k = 0; k < roundsOf(12); ++k) {
        const std::uint32_t seed = first + static_cast<std::uint32_t>(k);
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        const Motions before = randomLines(random, mills, 4);
        const Motions after = randomLines(random, mills, 4);
        Motions all = before;
        all.insert(all.end(), after.begin(), after.end());
        const ZMapSnapshot one = cutBox(all);
        const Difference found = difference(one.rims(), cutSaved(cutBox(before), after).rims());
        EXPECT_LE(found.missing + found.extra + found.places, found.all / 25);
        sum.all += found.all;
        sum.missing += found.missing;
        sum.extra += found.extra;
        sum.places += found.places;
        sum.normals += found.normals;
    }
    for (const auto& [name, value] : {std::pair("all", sum.all),
                                      {"missing", sum.missing},
                                      {"extra", sum.extra},
                                      {"places", sum.places},
                                      {"normals", sum.normals}})
        RecordProperty(name, std::to_string(value));
    EXPECT_LE(sum.missing + sum.extra + sum.places, sum.all / 200);
}

TEST(SavedRims, AreFollowedDeeperAndCutAway) {
    const Cutter mill = cutterOf("flat:d=6");
    const Cutter small = cutterOf("flat:d=3");
    const Motions first = pocketAndSlot(mill);
    // Deeper along the wall of the slot, across its walls, and a little wider between points.
    expectAsOfOneSetup(first, {{&mill, straightMotion({-10, 5, -6}, {60, 30, -6})}});
    expectAsOfOneSetup(first, {{&small, straightMotion({30, -10, -2}, {20, 50, -2})}});
    expectAsOfOneSetup(first, {{&mill, straightMotion({-10, 5.07, -3}, {60, 30.07, -3})}});
}

} // namespace
} // namespace proveout
