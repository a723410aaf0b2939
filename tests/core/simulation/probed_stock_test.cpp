// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that probe the stock that they have cut.
#include "core/simulation/run/probed_stock.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/simulation/run/interpretation.h"
#include "core/simulation/run/simulation.h"

namespace proveout {
namespace {

constexpr double kTolerance = StockContact::kTolerance;

proveout::Setup milledAndProbed() {
    proveout::Setup setup;
    setup.stock = {{0, 0, 0}, 40, 30, 10};
    setup.spacing = 0.7;
    setup.tools.set(1, parseToolOption("1=flat:d=8,l=20")->second);
    setup.tools.set(2, parseToolOption("2=ball:d=6")->second);
    return setup;
}

std::shared_ptr<const Program> interpreted(const std::string& text, const proveout::Setup& setup) {
    return interpret(NcText(text), interpretOptions(setup, {}));
}

const std::string kMillASlot = "G21 G90 F500\nT1 M6\nS5000 M3\nG0 X20 Y-10 Z5\nG1 Z-4\nY40\nG0 Z5\n";

std::size_t lastOf(const Program& program) {
    return program.motionCount() - 1;
}

TEST(ProbedStock, IsTheStockAsItWasCut) {
    const auto program =
        interpreted(kMillASlot + "T2 M6\nM5\nG0 X20 Y15 Z5\nG38.2 Z-8 F50\nG0 Z-3.5\n"
                                 "G38.2 X30\nG0 X20\nG0 Z5\nG0 X5\nG38.2 Z-8\nG0 Z5\nG0 X20\nM2\n",
                    milledAndProbed());
    std::vector<Vec3> stops;
    for (std::size_t k = 0; k < program->motionCount(); ++k)
        if (program->motion(k).probing)
            stops.push_back(program->motion(k).end);
    ASSERT_EQ(stops.size(), 3U);
    EXPECT_NEAR(stops[0].z, -4, kTolerance);
    // With its tip at -3.5, the ball touches the upper edge of the wall at X24 below its middle.
    EXPECT_NEAR(stops[1].x, 24 - 3, kTolerance);
    EXPECT_NEAR(stops[2].z, 0, kTolerance);
    EXPECT_FALSE(program->unverified());
}

TEST(ProbedStock, ComesFreeAndTouchesAgain) {
    const auto program = interpreted(
        kMillASlot + "T2 M6\nG0 X20 Y15 Z5\nG0 Z-2\nG38.2 X30 F50\nG38.4 X20 F20\nG38.2 X30\nM2\n",
        milledAndProbed());
    const double reach = std::sqrt(9.0 - 1); // radius of the ball 2 mm above its tip
    const std::size_t last = lastOf(*program);
    EXPECT_NEAR(program->motion(last).end.x, 24 - reach, kTolerance);
    EXPECT_EQ(program->diagnostics().back().id, std::string("probe-touches"));
}

TEST(ProbedStock, MissesAreReportedByTheCode) {
    const auto program =
        interpreted(kMillASlot + "T2 M6\nG0 X20 Y15 Z5\nG38.3 Z1 F50\nG38.2 Z0.5\nM2\n", milledAndProbed());
    ASSERT_FALSE(program->diagnostics().empty());
    EXPECT_EQ(program->diagnostics().back().id, std::string("probe-missed"));
    EXPECT_EQ(program->motion(lastOf(*program)).end.z, 0.5);
}

TEST(ProbedStock, IsNotCutByProbing) {
    const auto setup = std::make_shared<const proveout::Setup>(milledAndProbed());
    const auto removed = [&](const std::string& text) {
        const auto program = interpreted(text, *setup);
        auto simulation = std::move(Simulation::create(program, setup, {}).value());
        simulation->seek(simulation->blockCount());
        return simulation->zmap().volume();
    };
    const double milled = removed(kMillASlot + "M2\n");
    EXPECT_EQ(removed(kMillASlot + "T2 M6\nG0 X20 Y15 Z5\nG38.3 Z-8 F50\nG0 Z5\nM2\n"), milled);
    // The same for a motion that the stock does not stop.
    EXPECT_EQ(removed(kMillASlot + "T9 M6\nG0 X20 Y15 Z5\nG38.3 Z-8 F50\nG0 Z5\nM2\n"), milled);
}

TEST(ProbedStock, NeedsACutterForTheToolThatProbes) {
    const auto program =
        interpreted(kMillASlot + "T9 M6\nG0 X5 Y15 Z5\nG38.2 Z-8 F50\nM2\n", milledAndProbed());
    EXPECT_EQ(program->motion(lastOf(*program)).end.z, -8);
    EXPECT_TRUE(program->unverified());
}

TEST(ProbedStock, TheOnlyToolIsAssumedAsInTheSimulation) {
    proveout::Setup setup = milledAndProbed();
    setup.tools.remove(1);
    const auto program =
        interpreted("G21 G90 F500\nG0 X10 Y15 Z5\nG1 Z-2\nX30\nG0 Z5\nG0 X20\nG38.2 Z-8\nM2\n", setup);
    // The ball that has cut the groove fits into it.
    EXPECT_NEAR(program->motion(lastOf(*program)).end.z, -2, kTolerance);
}

TEST(ProbedStock, HasASayInTheProgram) {
    const auto probing = interpreted("T2 M6\nG0 X10 Y15 Z5\nF100\nG38.2 Z-2\nM2\n", milledAndProbed());
    const auto plain = interpreted("T2 M6\nG0 X10 Y15 Z5\nM2\n", milledAndProbed());
    proveout::Setup lower = milledAndProbed();
    lower.stock.corner.z = -1;
    proveout::Setup finer = milledAndProbed();
    finer.spacing = 0.1;
    EXPECT_FALSE(interpretedAlike(*probing, milledAndProbed(), lower));
    EXPECT_TRUE(interpretedAlike(*plain, milledAndProbed(), lower));
    EXPECT_TRUE(interpretedAlike(*probing, milledAndProbed(), finer));
}

TEST(ProbedStock, AnswersTheSkipMotionOfFanuc) {
    proveout::Setup setup = milledAndProbed();
    setup.dialect = DialectId::fanuc;
    const auto program =
        interpreted("T2 M6\nG90 G0 X10. Y15. Z5.\nG31 Z-8. F50.\nG0 Z[#5063+2.]\nM30\n", setup);
    EXPECT_NEAR(program->motion(lastOf(*program)).end.z, 2, kTolerance);
}

} // namespace
} // namespace proveout
