// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/records/block_records.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/cutting/cut/stock_contact.h"
#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

/// T1, a flat end mill of 8 mm, on 40 × 30 × 10 mm.
std::shared_ptr<const proveout::Setup> millSetup(double spacing = 0.1) {
    proveout::Setup setup = *setupWithTool(1, "flat:d=8,l=30");
    setup.spacing = spacing;
    return std::make_shared<const proveout::Setup>(setup);
}

struct Executed {
    std::shared_ptr<const proveout::Setup> setup;
    std::shared_ptr<const Program> program;
    Frame frame;

    [[nodiscard]] const BlockStatistics& row(std::size_t block) const { return frame.statistics[block]; }
};

Executed runOf(const std::string& text, std::shared_ptr<const proveout::Setup> setup = millSetup()) {
    const auto program = programOf(text);
    DecimationParameters parameters;
    parameters.period = 0;
    const auto simulation = startedSimulation(program, setup, parameters);
    simulation->seek(program->blockCount());
    return {std::move(setup), program, simulation->frame()};
}

/// Blocks: 0 above, 1 down next to the stock, 2 a slot of half the length, 3 back through air, 4 to the side,
/// 5 a step of 2 mm, 6 up.
const std::string kSteps = "G21 G90\nT1 M6\nG0 X-10 Y15 Z5\nG1 Z-3 F600\nX20\nX-10\nY21\nX50\nG0 Z5\n";

TEST(BlockRecords, SumsAreTheChangeOfTheMap) {
    for (std::uint_fast32_t seed = 1; seed <= 25; ++seed) {
        const auto program = programOf(randomProgram(seed, 80));
        const auto simulation = startedSimulation(program, smallSetup(0.25), {});
        const double whole = simulation->zmap().volume();
        simulation->seek(program->blockCount());
        const Frame frame = simulation->frame();
        double sum = 0;
        for (std::size_t block = 0; block < frame.block; ++block) {
            const BlockStatistics& row = frame.statistics[block];
            sum += row.removedMm3;
            EXPECT_GE(row.removedMm3, 0);
            EXPECT_EQ(row.removedMm3 > 0, row.maxDepth > 0);
            EXPECT_GE(row.radialEngagement, 0);
        }
        EXPECT_NEAR(sum, whole - frame.zmap.volume(), 1e-10 * whole) << "seed " << seed;
        EXPECT_GT(sum, 0);
    }
}

TEST(BlockRecords, OfASlotAndAStepAreTheirDepthAndWidth) {
    const Executed run = runOf(kSteps);
    EXPECT_FLOAT_EQ(run.row(2).maxDepth, 3);
    EXPECT_NEAR(run.row(2).radialEngagement, 8, 0.11);
    EXPECT_FLOAT_EQ(run.row(5).maxDepth, 3);
    // In the first half only a strip of 6 mm is left; after that the slot is full.
    EXPECT_NEAR(run.row(5).radialEngagement, 8, 0.11);
    const Executed step = runOf("G21 G90\nT1 M6\nG0 X-10 Y15 Z5\nG1 Z-3 F600\nX50\nY17.5\nX-10\n");
    EXPECT_NEAR(step.row(2).radialEngagement, 8, 0.11);
    EXPECT_NEAR(step.row(4).radialEngagement, 2.5, 0.11);
    const double rate = 8.0 * 3 * 600; // mm³/min if the cutter is in the stock all the way
    const Executed within = runOf("G21 G90\nT1 M6\nG0 X10 Y15 Z5\nG1 Z-3 F200\nF600 X30\n");
    EXPECT_NEAR(removalRate(*within.program, 2, within.row(2)).value(), rate, rate * 0.02);
    EXPECT_FALSE(removalRate(*within.program, 0, within.row(0))); // a rapid
}

/// A slot of 8 × 3 mm at 600 mm/min, then a strip of 2.5 × 3 mm next to it; each in three blocks, of which
/// the middle one is at full feed rate. Then a rapid, an air cut, and a block without motion.
std::string slotAndStrip(const std::string& beforeSlot = "") {
    return "G21 G90\nT1 M6\nG0 X5 Y12 Z5\nG1 Z-3 F200\nX10 F600\n" + beforeSlot +
           "X30\nX35\nY14.5\nX30\nX10\nX5\nG0 Z5\nG1 X30\nX30\n";
}

TEST(BlockRecords, RatesOfASlotAndAStripAreTheirCrossSections) {
    constexpr double kSpacing = 0.1;
    const Executed run = runOf(slotAndStrip(), millSetup(kSpacing));
    const auto times = machineTimes(run.program, {});
    const auto expectSection = [&](std::size_t block, double width) {
        const double perLength = removalPerLength(*times, block, run.row(block));
        EXPECT_NEAR(perLength, width * 3, 1.01 * kSpacing * 3) << block; // accurate to a cell
        EXPECT_NEAR(machineRemovalRate(*times, block, run.row(block)), perLength * 600, 1e-6) << block;
    };
    expectSection(3, 8);
    expectSection(7, 2.5);
    ASSERT_EQ(run.program->blockCount(), 12U);
    for (const std::size_t block : {0U, 9U, 10U, 11U}) {
        EXPECT_EQ(removalPerLength(*times, block, run.row(block)), 0) << block;
        EXPECT_EQ(machineRemovalRate(*times, block, run.row(block)), 0) << block;
    }
}

TEST(BlockRecords, DwellsAndToolChangesTakeNothingFromTheRate) {
    const Executed plain = runOf(slotAndStrip());
    const double rate = machineRemovalRate(*machineTimes(plain.program, {}), 3, plain.row(3));
    for (const char* pause : {"G4 P30\n", "T2 M6\nT1 M6\n"}) {
        const Executed run = runOf(slotAndStrip(pause));
        // Only acceleration and deceleration are slower.
        EXPECT_NEAR(machineRemovalRate(*machineTimes(run.program, {}), 3, run.row(3)), rate, rate * 0.02)
            << pause;
    }
}

TEST(BlockRecords, CuttingAirAndContacts) {
    const Executed run = runOf(kSteps);
    const bool cuts[] = {false, false, true, false, false, true, false};
    ASSERT_EQ(run.frame.block, std::size(cuts));
    for (std::size_t block = 0; block < std::size(cuts); ++block) {
        EXPECT_EQ(run.row(block).cuts(), cuts[block]) << block;
        EXPECT_EQ(isFirstContact(run.frame.statistics, block), cuts[block]) << block; // air before each cut
    }
    const RunTotals totals = totalsOf(*run.program, run.frame.statistics, run.frame.block);
    EXPECT_DOUBLE_EQ(totals.cuttingLength, 30 + 60);
    EXPECT_DOUBLE_EQ(totals.airLength, 8 + 30 + 6);
    EXPECT_DOUBLE_EQ(totals.rapidLength, 8); // the start of the first one is unknown
    EXPECT_EQ(totals.cuttingBlocks, 2U);
    EXPECT_EQ(totals.airBlocks, 3U);
    EXPECT_EQ(totals.contacts, 2U);
    EXPECT_EQ(totals.firstContact, 2U);
    EXPECT_FLOAT_EQ(totals.axialDepth.value, 3);
    EXPECT_EQ(totals.axialDepth.block, 2U);
    const RunTotals none = totalsOf(*run.program, run.frame.statistics, 2);
    EXPECT_FALSE(none.firstContact);
    EXPECT_EQ(none.axialDepth.value, 0);
}

TEST(BlockRecords, FeedThatIsNotKnownHasNoRate) {
    const Executed run = runOf("G21 G90\nT1 M6\nS1000 M3\nG0 X10 Y15 Z5\nG95 G1 Z-3 F0.1\nX30\n");
    EXPECT_FALSE(removalRate(*run.program, 1, run.row(1)));
    EXPECT_GT(run.row(2).removedMm3, 0);
}

TEST(BlockRecords, PlaceOfContactIsThatOfTheTip) {
    const Executed run = runOf(kSteps);
    const auto place = [&run](std::size_t block) { return contactPlace(run.setup, *run.program, block); };
    constexpr double kTolerance = StockContact::kTolerance;
    EXPECT_FALSE(place(0));
    EXPECT_FALSE(place(1));
    ASSERT_TRUE(place(2));
    EXPECT_NEAR(place(2)->x, -4, kTolerance);
    EXPECT_NEAR(place(2)->z, -3, 1e-9);
    // It starts in contact with the walls of the slot that it has cut.
    ASSERT_TRUE(place(5));
    EXPECT_NEAR(place(5)->x, -std::sqrt(16.0 - 4), 4); // somewhere on the edge of the step
    EXPECT_FALSE(place(6) && place(6)->z > 0);
}

TEST(BlockRecords, PlaceOfContactOnAnArcAndInAPlunge) {
    // A half circle of radius 17 mm around X-20 Y15 reaches the stock at its far side.
    const Executed arc =
        runOf("G21 G90\nT1 M6\nG0 X-20 Y-2 Z5\nG1 Z-2 F500\nG3 X-20 Y32 I0 J17\nG0 Z5\nG0 X20 Y15\n"
              "G1 Z-4\n");
    const auto at = contactPlace(arc.setup, *arc.program, 2);
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->x, -4, 0.01);
    EXPECT_NEAR(std::hypot(at->x + 20, at->y - 15), 17, 2 * kChordError);
    EXPECT_LT(at->y, 15); // the first of two contacts
    const auto plunge = contactPlace(arc.setup, *arc.program, 5);
    ASSERT_TRUE(plunge);
    EXPECT_NEAR(plunge->z, 0, StockContact::kTolerance);
}

TEST(BlockRecords, EveryBlockOfFirstContactHasItsPlace) {
    int reported = 0;
    for (std::uint_fast32_t seed = 1; seed <= 3; ++seed) {
        const auto program = programOf(randomProgram(seed, 30));
        const auto setup = smallSetup();
        const auto frames = straightRun(program, setup, {});
        const auto& rows = frames.back().statistics;
        for (std::size_t block = 1; block < rows.size(); ++block)
            if (isFirstContact(rows, block)) {
                ++reported;
                EXPECT_TRUE(contactPlace(setup, *program, block))
                    << fmt::format("seed {}, block {}", seed, block);
            }
    }
    EXPECT_GT(reported, 3);
}

} // namespace
} // namespace proveout
