// SPDX-License-Identifier: GPL-3.0-or-later
// Runs on stock that is not a box.
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

#include "core/cutting/cut/stock_contact.h"
#include "core/simulation/run/interpretation.h"
#include "core/zmap/extruded_stock.h"
#include "core/zmap/saved_stock.h"
#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

/// A round bar of 40 mm in place of the box of smallSetup().
std::shared_ptr<const proveout::Setup> roundSetup() {
    proveout::Setup setup = *smallSetup();
    setup.shape.kind = StockKind::cylinder;
    setup.shape.body = extrudedStock({circleOutline(30)}, 10).value();
    setup.stock = setup.shape.body->box();
    return std::make_shared<const proveout::Setup>(setup);
}

TEST(StockOfAShape, IsWhatIsCut) {
    const auto setup = roundSetup();
    const auto grid = makeGrid(setup->stock, setup->spacing).value();
    const double whole = uncutStock(setup->stock, setup->shape, grid).zmap.snapshot().volume();
    for (std::uint_fast32_t seed = 1; seed <= 8; ++seed) {
        const auto frames = straightRun(programOf(randomProgram(seed, 60)), setup, {});
        EXPECT_NEAR(frames.front().zmap.volume(), whole, 1e-9);
        double removed = 0;
        for (std::size_t block = 0; block < frames.back().block; ++block)
            removed += frames.back().statistics[block].removedMm3;
        EXPECT_NEAR(whole - frames.back().zmap.volume(), removed, 1e-6 * whole) << "seed " << seed;
        EXPECT_NEAR(frames.back().removedMm3, removed, 1e-9 * whole);
        EXPECT_GT(removed, 0);
    }
}

TEST(StockOfAShape, AnySeekIsAStraightRun) {
    const auto setup = roundSetup();
    for (std::uint_fast32_t seed = 1; seed <= 5; ++seed) {
        const auto program = programOf(randomProgram(seed, 50));
        const auto frames = straightRun(program, setup, {});
        const auto simulation = startedSimulation(program, setup, {});
        std::mt19937 random(seed);
        for (int k = 0; k < 40; ++k) {
            simulation->seek(random() % frames.size());
            EXPECT_EQ(difference(simulation->frame(), frames[simulation->position()]), "")
                << fmt::format("seed {}, block {}", seed, simulation->position());
        }
    }
}

TEST(StockOfAShape, ItsFindingsAreThereFromTheFirstFrameOn) {
    const StockBox box{{0, 0, 0}, 40, 30, 10};
    ZMap zmap(box, makeGrid(box, 0.5).value());
    zmap.tileForWriting(0).at(20, 20) = -4;
    proveout::Setup setup = *smallSetup();
    setup.shape.kind = StockKind::saved;
    setup.shape.file = "side1.pvstock";
    setup.shape.body = savedStock(zmap.snapshot(), 0.5, StockTurn::none, StockFlip::aboutX).value();
    const auto simulation = startedSimulation(programOf("G0 X5 Y5 Z5\nG1 Z-2 F100\n"),
                                              std::make_shared<const proveout::Setup>(setup), {});
    for (const std::size_t block : {0U, 2U}) {
        simulation->seek(block);
        const Diagnostics findings = simulation->frame().findings;
        ASSERT_FALSE(findings.empty());
        EXPECT_EQ(findings.front().id, std::string("stock-undercut"));
        EXPECT_EQ(findings.front().file, "side1.pvstock");
    }
}

std::vector<Vec3> probedStops(const Program& program) {
    std::vector<Vec3> stops;
    for (std::size_t k = 0; k < program.motionCount(); ++k)
        if (program.motion(k).probing)
            stops.push_back(program.motion(k).end);
    return stops;
}

const std::string kProbe = "G21 G90 F500\nT2 M6\nG0 X-20 Y15 Z-4\nG38.2 X20\nG0 X-20\nG0 Y6\nG38.3 X20\nG0 "
                           "X-20\nG0 Y0.5\nG38.3 X-10\nG0 Z5\nG0 X15 Y15\nG38.2 Z-8\nM2\n";

TEST(StockOfAShape, IsProbedWhereItIs) {
    proveout::Setup setup = *roundSetup();
    setup.tools.set(2, parseToolOption("2=flat:d=6")->second);
    const auto program = interpret(NcText(kProbe), interpretOptions(setup, {}));
    const auto stops = probedStops(*program);
    ASSERT_EQ(stops.size(), 4U);
    constexpr double kTolerance = StockContact::kTolerance;
    // A probe of 3 mm next to a cylinder of 15 mm.
    EXPECT_NEAR(stops[0].x, 15 - 18, kTolerance);
    EXPECT_NEAR(stops[1].x, 15 - std::sqrt(18.0 * 18 - 9 * 9), kTolerance);
    EXPECT_NEAR(stops[2].x, -10, 1e-12); // no contact
    EXPECT_NEAR(stops[3].z, 0, kTolerance);
}

TEST(StockOfAShape, OfASavedOneIsProbedAsItsMapIs) {
    const StockBox box{{0, 0, 0}, 40, 30, 10};
    ZMap zmap(box, makeGrid(box, 0.5).value());
    Tile& tile = zmap.tileForWriting(0);
    for (int j = 0; j < Tile::kSize; ++j)
        for (int i = 0; i < 20; ++i) // up to X9.5
            tile.at(i, j) = -6;
    tile.refreshMaximum();
    proveout::Setup setup = *smallSetup();
    setup.tools.set(2, parseToolOption("2=flat:d=6")->second);
    setup.shape.kind = StockKind::saved;
    setup.shape.body = savedStock(zmap.snapshot(), 0.5).value();
    const auto program = interpret(NcText(kProbe), interpretOptions(setup, {}));
    const auto stops = probedStops(*program);
    ASSERT_EQ(stops.size(), 4U);
    // The wall rises between X9.5 and X10; Z-4 is reached at a third of that.
    EXPECT_NEAR(stops[0].x, 9.5 + 0.5 / 3 - 3, 2 * StockContact::kTolerance);
    EXPECT_NEAR(stops[3].z, 0, StockContact::kTolerance);
}

TEST(StockOfAShape, AnotherShapeIsReinterpretedOnlyWhereItIsProbed) {
    proveout::Setup round = *roundSetup();
    round.tools.set(2, parseToolOption("2=flat:d=6")->second);
    proveout::Setup box = round;
    box.shape = {};
    const auto probing = interpret(NcText(kProbe), interpretOptions(round, {}));
    const auto plain = interpret(NcText("G21 G90\nG0 X0 Y0 Z5\nM2\n"), interpretOptions(round, {}));
    EXPECT_FALSE(interpretedAlike(*probing, round, box));
    EXPECT_TRUE(interpretedAlike(*plain, round, box));
}

} // namespace
} // namespace proveout
