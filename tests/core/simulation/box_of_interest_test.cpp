// SPDX-License-Identifier: GPL-3.0-or-later
// Compares a detail region with a simulation of the whole stock on the fine grid.
#include "core/simulation/records/box_of_interest.h"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <oneapi/tbb/global_control.h>
#include <random>
#include <tuple>
#include <vector>

#include "core/simulation/run/rim_finder.h"
#include "core/simulation/run/simulation.h"
#include "core/zmap/extruded_stock.h"
#include "core/zmap/mesh_stock.h"
#include "core/zmap/saved_stock.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr double kPlenty = 4e9; // bytes
constexpr double kFine = 0.07;  // mm; no side is a multiple of it

DecimationParameters undecimated() {
    DecimationParameters parameters;
    parameters.method = DecimationMethod::none;
    return parameters;
}

/// The same except for the stock, which is offset from the origin like that of smallSetup().
Setup setupOf(StockKind kind, std::shared_ptr<const StockBody> body) {
    Setup setup = *smallSetup();
    setup.shape.kind = kind;
    setup.shape.body = std::move(body);
    setup.stock = setup.shape.body->box();
    return setup;
}

/// A roof that has no vertex on a grid point.
std::shared_ptr<const StockBody> roof() {
    StockMesh mesh;
    mesh.vertices = {{0, 0, -10},   {40.3, 0, -10},   {40.3, 30.1, -10}, {0, 30.1, -10}, {0, 0, -6},
                     {40.3, 0, -6}, {40.3, 30.1, -6}, {0, 30.1, -6},     {0, 14, 0},     {40.3, 17, 0}};
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {2, 3, 7}, {2, 7, 6}, {4, 5, 9}, {4, 9, 8},
                      {6, 7, 8}, {6, 8, 9}, {1, 2, 6}, {1, 6, 9}, {1, 9, 5}, {3, 0, 4}, {3, 4, 8}, {3, 8, 7}};
    return meshStock(std::move(mesh)).value();
}

std::shared_ptr<const StockBody> savedSlopes(std::mt19937& random) {
    const StockBox box{{0, 0, 0}, 40, 30, 10};
    ZMap zmap(box, makeGrid(box, 0.9).value());
    std::uniform_real_distribution<float> height(-3, 0);
    for (std::size_t index = 0; index < zmap.tileCount(); ++index) {
        const IndexRect rect = zmap.tileRect(index);
        Tile& tile = zmap.tileForWriting(index);
        for (int j = 0; j < rect.height(); ++j)
            for (int i = 0; i < rect.width(); ++i)
                tile.at(i, j) = height(random);
        tile.refreshMaximum();
    }
    return savedStock(zmap.snapshot(), 0.9).value();
}

std::vector<Setup> setupsOfAllKinds(std::mt19937& random) {
    const OutlineLoop plate{{{0, 0}, 0}, {{38, 1}, 0.4}, {{40, 29}, 0}, {{3, 30}, -0.2}};
    std::vector<Setup> setups{
        *smallSetup(), setupOf(StockKind::cylinder, extrudedStock({circleOutline(30)}, 10).value()),
        setupOf(StockKind::outline, extrudedStock({plate}, 10).value()), setupOf(StockKind::mesh, roof()),
        setupOf(StockKind::saved, savedSlopes(random))};
    // A position without round coordinates.
    std::uniform_real_distribution<double> anywhere(-2, 2);
    for (Setup& setup : setups)
        setup.stock.corner += Vec3(anywhere(random), anywhere(random), 0);
    return setups;
}

/// At least as wide as the fine grid's spacing, because a narrower box is refused.
BoxOfInterest randomBox(const StockBox& stock, std::mt19937& random) {
    std::uniform_real_distribution<double> part(0, 1);
    const auto range = [&](double from, double length) {
        const double a = from + (length - kFine) * part(random);
        const double b = from + (length - kFine) * part(random);
        return Vec2(std::min(a, b), std::max(a, b) + kFine);
    };
    const Vec2 x = range(stock.corner.x, stock.width);
    const Vec2 y = range(stock.corner.y, stock.depth);
    return {{{x.x, y.x}, {x.y, y.y}}, kFine};
}

ZMapSnapshot wholeStock(const std::shared_ptr<const Program>& program, Setup setup, std::size_t blocks) {
    setup.spacing = kFine;
    auto simulation =
        Simulation::create(program, std::make_shared<const Setup>(std::move(setup)), undecimated()).value();
    simulation->seek(blocks);
    return simulation->zmap();
}

GridPart partOf(const Setup& setup, const BoxOfInterest& box) {
    return fineGrid(setup, box, undecimated(), {}, kPlenty).value();
}

/// The number of points at which they differ.
std::size_t differences(const ZMapSnapshot& whole, const ZMapSnapshot& part, const GridPart& place) {
    std::size_t count = 0;
    for (int j = 0; j < part.grid().ny; ++j)
        for (int i = 0; i < part.grid().nx; ++i)
            if (part.height(i, j) !=
                whole.height(static_cast<int>(place.firstI) + i, static_cast<int>(place.firstJ) + j))
                ++count;
    return count;
}

TEST(BoxOfInterest, HasTheHeightsOfTheWholeStockOnTheFineGrid) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (const auto& setup : setupsOfAllKinds(random)) {
        const auto program = programOf(randomProgram(random(), 80));
        const std::size_t blocks = 1 + random() % program->blockCount();
        const ZMapSnapshot whole = wholeStock(program, setup, blocks);
        for (int k = 0; k < 12; ++k) {
            const BoxOfInterest box = randomBox(setup.stock, random);
            const GridPart place = partOf(setup, box);
            const FineMap fine = cutBox(*program, setup, blocks, place).value();
            SCOPED_TRACE(fmt::format("kind {}, block {}, X{}…{} Y{}…{}", static_cast<int>(setup.shape.kind),
                                     blocks, box.box.lo.x, box.box.hi.x, box.box.lo.y, box.box.hi.y));
            EXPECT_EQ(differences(whole, fine.zmap, place), 0U);
            EXPECT_EQ(fine.zmap.grid().nx, place.nx);
            EXPECT_EQ(fine.zmap.stock().topZ(), setup.stock.topZ());
            EXPECT_EQ(fine.zmap.floor(), whole.floor());
            // Its sides are within half a spacing of the requested ones, except for the last cell.
            EXPECT_NEAR(fine.zmap.grid().x0, box.box.lo.x, place.hx);
            EXPECT_NEAR(fine.zmap.grid().x(place.nx - 1), box.box.hi.x, place.hx);
            EXPECT_NEAR(fine.zmap.grid().y0, box.box.lo.y, place.hy);
            EXPECT_NEAR(fine.zmap.grid().y(place.ny - 1), box.box.hi.y, place.hy);
        }
    }
}

/// By the points of its edge in the whole grid.
using RimsOfGrid = std::map<std::tuple<int, int, bool>, Rim>;

/// Those on edges between points from (2, 2) to the last but two of a part, which is at `firstI`, `firstJ`.
RimsOfGrid rimsInside(const ZMapSnapshot& map, const IndexRect& part, int firstI, int firstJ) {
    RimsOfGrid rims;
    for (std::size_t tile = 0; tile < map.tileCount(); ++tile) {
        const IndexRect rect = map.tileRect(tile);
        for (const Rim& rim : map.rims()[tile] == nullptr ? std::vector<Rim>() : map.rims()[tile]->rims) {
            const RimEdge edge = RimEdge::of(rim.edge);
            const int i = rect.i0 + edge.i + firstI;
            const int j = rect.j0 + edge.j + firstJ;
            if (i >= part.i0 + 2 && j >= part.j0 + 2 && i < part.i1 - 3 && j < part.j1 - 3)
                rims[{i, j, edge.alongY}] = rim;
        }
    }
    return rims;
}

/// The number of rims that one has and the other has not, or at another place.
std::size_t differences(const RimsOfGrid& one, const RimsOfGrid& other) {
    std::size_t count = 0;
    for (const auto& [edge, rim] : one) {
        const auto found = other.find(edge);
        const bool isSame = found != other.end() && std::abs(rim.highPlace - found->second.highPlace) <= 1 &&
                            std::abs(rim.lowPlace - found->second.lowPlace) <= 1 &&
                            rim.top == found->second.top && rim.bottom == found->second.bottom &&
                            glm::distance(rim.normal(), found->second.normal()) < 1e-3;
        count += isSame ? 0 : 1;
    }
    return count;
}

TEST(BoxOfInterest, HasTheWallsOfTheWholeStockOnTheFineGrid) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::size_t seen = 0;
    std::size_t walls = 0;
    for (auto& setup : setupsOfAllKinds(random)) {
        setup.tools.set(1, parseCutter("flat:d=4").value());
        setup.spacing = kFine;
        const auto shared = std::make_shared<const proveout::Setup>(setup);
        const auto program = programOf(randomProgram(random(), 80));
        const std::size_t blocks = 1 + random() % program->blockCount();
        auto simulation = Simulation::create(program, shared, undecimated()).value();
        simulation->seek(blocks);
        const ZMapSnapshot whole = RimFinder().find(simulation->frame());
        for (int k = 0; k < 6; ++k) {
            const BoxOfInterest box = randomBox(setup.stock, random);
            const GridPart place = partOf(setup, box);
            FineMap fine = cutBox(*program, setup, blocks, place).value();
            EXPECT_TRUE(fine.zmap.rims().empty());
            ASSERT_TRUE(addWalls(fine, program, shared));
            SCOPED_TRACE(fmt::format("kind {}, block {}, X{}…{} Y{}…{}", static_cast<int>(setup.shape.kind),
                                     blocks, box.box.lo.x, box.box.hi.x, box.box.lo.y, box.box.hi.y));
            const int firstI = static_cast<int>(place.firstI);
            const int firstJ = static_cast<int>(place.firstJ);
            const IndexRect part{firstI, firstJ, firstI + place.nx, firstJ + place.ny};
            const RimsOfGrid wanted = rimsInside(whole, part, 0, 0);
            const RimsOfGrid found = rimsInside(fine.zmap, part, firstI, firstJ);
            EXPECT_EQ(differences(wanted, found), 0U);
            EXPECT_EQ(found.size(), wanted.size());
            walls += fine.zmap.walls().count();
            seen += wanted.size();
        }
    }
    EXPECT_GT(seen, 1000U);
    EXPECT_GT(walls, 1000U);
}

/// On the grid of a saved stock, its own walls are those that were saved.
TEST(BoxOfInterest, HasTheWallsOfSavedStock) {
    const auto first = setupWithTool(1, "flat:d=4");
    const auto slot = programOf("T1 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX35 Y21\nG0 Z5\n");
    auto simulation = Simulation::create(slot, first, undecimated()).value();
    simulation->seek(slot->blockCount());
    const ZMapSnapshot saved = RimFinder().find(simulation->frame());
    auto setup = std::make_shared<proveout::Setup>(*first);
    setup->shape.kind = StockKind::saved;
    setup->shape.body = savedStock(saved, setup->spacing).value();
    const auto nothing = programOf("G0 X0\n");
    const auto boxOf = [&](double spacing) {
        FineMap fine = cutBox(*nothing, *setup, 1, partOf(*setup, {{{3, 3}, {38, 27}}, spacing})).value();
        EXPECT_TRUE(addWalls(fine, nothing, setup));
        return fine;
    };
    const IndexRect part{6, 6, 77, 55};
    const RimsOfGrid wanted = rimsInside(saved, part, 0, 0);
    EXPECT_GT(wanted.size(), 50U);
    const FineMap same = boxOf(0.5);
    EXPECT_EQ(differences(wanted, rimsInside(same.zmap, part, 6, 6)), 0U);
    EXPECT_EQ(unknownTiles(same.zmap.rims()), 0U);
    EXPECT_GT(unknownTiles(boxOf(0.2).zmap.rims()), 0U);
}

TEST(BoxOfInterest, IsTheSameOnOneThread) {
    const auto program = programOf(randomProgram(7, 80));
    const auto setup = *smallSetup();
    const GridPart place = partOf(setup, {{{5, 5}, {25, 20}}, 0.03});
    const FineMap many = cutBox(*program, setup, 80, place).value();
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const FineMap single = cutBox(*program, setup, 80, place).value();
    EXPECT_TRUE(many.zmap.sameHeights(single.zmap, {0, 0, place.nx, place.ny}));
    EXPECT_EQ(many.motions, single.motions);
}

TEST(BoxOfInterest, CutsOnlyWhatComesNear) {
    const auto program = programOf("T1 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX12\nG0 Z5\nX30 Y25\nG1 Z-1\nX35\n");
    const auto setup = *smallSetup(); // the tool is a ball of 4 mm
    const FineMap left = cutBox(*program, setup, 99, partOf(setup, {{{0, 0}, {13.9, 10}}, 0.1})).value();
    EXPECT_EQ(left.motions, 3U); // in, along, and out
    EXPECT_EQ(left.block, program->blockCount());
    const FineMap between = cutBox(*program, setup, 99, partOf(setup, {{{15, 0}, {20, 10}}, 0.1})).value();
    EXPECT_EQ(between.motions, 0U);
}

TEST(BoxOfInterest, StopsWhenAsked) {
    const auto program = programOfOneLongBlock();
    const auto setup = wideSetup();
    const GridPart place = partOf(*setup, {{{200, 200}, {240, 240}}, 0.02});
    std::stop_source source;
    source.request_stop();
    EXPECT_FALSE(cutBox(*program, *setup, program->blockCount(), place, {source.get_token(), {}}));
    FineMap uncut = cutBox(*program, *setup, 0, place).value();
    EXPECT_FALSE(addWalls(uncut, program, setup, {source.get_token(), {}}));
}

TEST(BoxOfInterest, ReportsHowFarItIs) {
    const auto program = programOf(randomProgram(3, 50));
    double last = 0;
    const WorkContext context{{}, [&](double done) {
                                  EXPECT_GE(done, last);
                                  last = done;
                              }};
    const auto setup = *smallSetup();
    EXPECT_TRUE(cutBox(*program, setup, 50, partOf(setup, {{{5, 5}, {25, 20}}, 0.1}), context));
    EXPECT_EQ(last, 1);
}

TEST(BoxOfInterest, MemoryIsAskedForBeforeItIsTaken) {
    const auto setup = *smallSetup();
    for (const double megabytes : {0.2, 1.0, 3.0, 20.0}) {
        BoxOfInterest box{{{5, 5}, {25, 25}}, 0.001};
        const auto refused = fineGrid(setup, box, undecimated(), {}, megabytes * 1e6);
        ASSERT_FALSE(refused);
        const Diagnostic& reported = refused.error().front();
        ASSERT_STREQ(reported.id, "box-needs-too-much-memory");
        box.spacing = std::stod(reported.arguments.back());
        EXPECT_TRUE(fineGrid(setup, box, undecimated(), {}, megabytes * 1e6)) << message(reported);
    }
}

struct BadBox {
    const char* id;
    BoxOfInterest box;
};

class BoxThatCannotBe : public testing::TestWithParam<BadBox> {};

TEST_P(BoxThatCannotBe, IsRefused) {
    const auto refused = fineGrid(*smallSetup(), GetParam().box, undecimated(), {}, kPlenty);
    ASSERT_FALSE(refused);
    EXPECT_STREQ(refused.error().front().id, GetParam().id);
}

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
INSTANTIATE_TEST_SUITE_P(BoxOfInterest, BoxThatCannotBe,
                         testing::Values(BadBox{"box-outside-stock", {{{-1, 0}, {10, 10}}, 0.1}},
                                         BadBox{"box-outside-stock", {{{0, 0}, {10, 30.01}}, 0.1}},
                                         BadBox{"box-outside-stock", {{{1e300, 0}, {1.1e300, 10}}, 0.1}},
                                         BadBox{"box-without-area", {{{10, 0}, {10, 10}}, 0.1}},
                                         BadBox{"box-without-area", {{{10, 10}, {0, 0}}, 0.1}},
                                         BadBox{"box-without-area", {{{kNoNumber, 10}, {20, 20}}, 0.1}},
                                         BadBox{"grid-spacing-bad", {{{0, 0}, {10, 10}}, 0}},
                                         BadBox{"grid-spacing-bad", {{{0, 0}, {10, 10}}, kNoNumber}},
                                         BadBox{"grid-too-coarse", {{{0, 0}, {10, 10}}, 100}},
                                         BadBox{"grid-too-fine", {{{0, 0}, {10, 10}}, 1e-5}}));

} // namespace
} // namespace proveout
