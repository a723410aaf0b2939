// SPDX-License-Identifier: GPL-3.0-or-later
// Work that was stopped leaves a state that later work completes to the same result.
#include <chrono>
#include <gtest/gtest.h>
#include <random>
#include <thread>

#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

WorkContext stoppedContext() {
    std::stop_source source;
    source.request_stop();
    return {source.get_token(), {}};
}

/// Requests a stop when the work reports progress for the `calls`-th time, so that equal seeds stop at the
/// same point.
class StopAfter {
public:
    explicit StopAfter(std::uint_fast32_t calls) : m_left(calls) {}
    WorkContext context() {
        return {m_source.get_token(), [this](double) {
                    if (m_left-- == 0)
                        m_source.request_stop();
                }};
    }
    bool stopped() const { return m_source.stop_requested(); }

private:
    std::stop_source m_source;
    std::uint_fast32_t m_left;
};

TEST(Stop, AtOnceLeavesAValidState) {
    const auto program = programOf(randomProgram(8, 60));
    auto created = Simulation::create(program, smallSetup(), {}, stoppedContext());
    ASSERT_TRUE(created);
    Simulation& simulation = **created;
    EXPECT_FALSE(simulation.settled());
    EXPECT_EQ(simulation.frame().surface.faces, simulation.frame().surface.facesFull);
    simulation.seek(30, stoppedContext());
    EXPECT_EQ(simulation.position(), 0U);
    simulation.seek(0);
    EXPECT_TRUE(simulation.settled());
    EXPECT_EQ(simulation.frame().surface.dirtyRegions, 0U);
}

TEST(Stop, BeforeAnyWorkIsWhatIsOnlyPrepared) {
    const auto program = programOf(randomProgram(8, 60));
    DecimationParameters never;
    never.period = 0;
    for (const DecimationParameters& parameters : {DecimationParameters{}, never}) {
        const auto stopped =
            std::move(Simulation::create(program, smallSetup(), parameters, stoppedContext()).value());
        const auto prepared = std::move(Simulation::prepare(program, smallSetup(), parameters).value());
        EXPECT_EQ(prepared->settled(), stopped->settled());
        EXPECT_EQ(difference(prepared->frame(), stopped->frame()), "");
    }
}

TEST(Stop, AnywhereIsCompletedLater) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const auto program = programOf(randomProgram(random(), 120));
    const auto setup = smallSetup();
    DecimationParameters fine;
    fine.period = 10;
    fine.regionCells = 8;
    DecimationParameters coarse = fine;
    coarse.allowance = 0.2;
    const auto straight = straightRun(program, setup, fine);
    const auto straightCoarse = straightRun(program, setup, coarse);
    const auto simulation = startedSimulation(program, setup, fine);
    bool isFine = true;
    int stops = 0;
    for (int round = 0; round < 150; ++round) {
        SCOPED_TRACE(testing::Message() << "round " << round);
        StopAfter stop(random() % 60);
        const WorkContext context = stop.context();
        if (random() % 3 == 0) {
            isFine = !isFine;
            apply(*simulation, isFine ? fine : coarse, context);
        } else {
            simulation->seek(random() % (program->blockCount() + 1), context);
        }
        stops += stop.stopped() ? 1 : 0;
        ASSERT_TRUE(sameZMap(simulation->zmap(), straight[simulation->position()].zmap));
        if (random() % 2 == 0) {
            simulation->seek(simulation->position());
            ASSERT_TRUE(simulation->settled());
            const auto& wanted = (isFine ? straight : straightCoarse)[simulation->position()];
            ASSERT_EQ(difference(simulation->frame(), wanted), "");
        }
    }
    EXPECT_GT(stops, 20) << "too few of the rounds were stopped to prove anything";
    // Rows of stopped blocks must not describe surfaces that never existed.
    if (!isFine)
        apply(*simulation, fine);
    const auto fresh = startedSimulation(program, setup, fine);
    simulation->seek(0);
    while (!simulation->atEnd())
        simulation->step();
    fresh->play(program->blockCount());
    const auto rows = simulation->frame().statistics;
    const auto wanted = fresh->frame().statistics;
    ASSERT_EQ(rows.size(), wanted.size());
    for (std::size_t row = 0; row < rows.size(); ++row) {
        EXPECT_EQ(rows[row].facesShown, wanted[row].facesShown) << "row " << row;
        EXPECT_EQ(rows[row].regionsDecimated, wanted[row].regionsDecimated) << "row " << row;
    }
}

TEST(Stop, RowsOfAnInterruptedRunAreTrue) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const auto program = programOf(randomProgram(random(), 100));
    DecimationParameters parameters;
    parameters.period = 3;
    const auto wanted = straightRun(program, smallSetup(), parameters).back().statistics;
    const auto simulation = startedSimulation(program, smallSetup(), parameters);
    for (int round = 0; round < 40; ++round) {
        StopAfter stop(random() % 60);
        if (random() % 4 == 0)
            simulation->seek(program->blockCount(), stop.context());
        else
            simulation->play(program->blockCount(), stop.context());
        if (random() % 4 == 0) // leaves a block whose decimation may not have finished
            simulation->seek(random() % (simulation->position() + 1));
    }
    simulation->play(program->blockCount());
    const auto rows = simulation->frame().statistics;
    ASSERT_EQ(rows.size(), wanted.size());
    for (std::size_t row = 0; row < rows.size(); ++row) {
        EXPECT_EQ(rows[row].facesShown, wanted[row].facesShown) << "row " << row;
        EXPECT_EQ(rows[row].regionsDirty, wanted[row].regionsDirty) << "row " << row;
        EXPECT_EQ(rows[row].regionsDecimated, wanted[row].regionsDecimated) << "row " << row;
    }
}

TEST(Stop, InTheMiddleOfABlockCountsItAsNotExecuted) {
    const auto program = programOfOneLongBlock();
    DecimationParameters parameters;
    parameters.method = DecimationMethod::none;
    const auto simulation = startedSimulation(program, wideSetup(), parameters);
    simulation->seek(2);
    const Frame before = simulation->frame();
    for (const int milliseconds : {0, 30, 200}) {
        std::stop_source source;
        std::jthread stopper([&source, milliseconds] {
            std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
            source.request_stop();
        });
        simulation->seek(4, {source.get_token(), {}});
        ASSERT_EQ(simulation->position(), 2U) << milliseconds << " ms";
        EXPECT_EQ(difference(simulation->frame(), before), "") << milliseconds << " ms";
        EXPECT_EQ(simulation->frame().statistics.size(), 2U);
    }
}

} // namespace
} // namespace proveout
