// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/thread/simulation_thread.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <gtest/gtest.h>
#include <limits>
#include <mutex>
#include <numeric>
#include <random>
#include <thread>

#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr auto kPatience = 30s; // far more than a loaded machine needs; only a failure waits that long

// The guaranteed limit. A sanitized build is about ten times slower, and slower still next to others: there
// it is sufficient that the response comes during the work.
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr auto kCancelLimit = kPatience;
#else
constexpr auto kCancelLimit = 200ms;
#endif

/// A method that shows the surface of the schedule at rest too, so that frames do not depend on timing.
DecimationParameters bySchedule() {
    DecimationParameters parameters;
    parameters.method = DecimationMethod::lee;
    parameters.regionCells = 8;
    parameters.period = 20;
    return parameters;
}

/// A thread with a listener that lets a test wait for frames.
class Listening {
public:
    Listening()
        : m_thread({[this] { wake(); },
                    [this](double done) {
                        const std::scoped_lock lock(m_mutex);
                        m_progress = done;
                        m_changed.notify_all();
                    },
                    [this](Diagnostics diagnostics, std::uint64_t generation) {
                        const std::scoped_lock lock(m_mutex);
                        m_failure = std::move(diagnostics);
                        m_failedGeneration = generation;
                        m_changed.notify_all();
                    }}) {}

    SimulationThread& thread() { return m_thread; }

    /// The first frame for which `wanted` is true; null if none arrives in time.
    template<class Wanted>
    FramePtr waitFor(Wanted wanted) {
        const auto end = Clock::now() + kPatience;
        std::unique_lock lock(m_mutex);
        while (Clock::now() < end) {
            if (auto frame = m_thread.takeFrame()) {
                m_last = frame;
                m_thread.frameShown(frame->sequence);
            }
            if (m_last && wanted(*m_last))
                return m_last;
            m_changed.wait_for(lock, 20ms);
        }
        return nullptr;
    }
    FramePtr waitForBlock(std::size_t block) {
        return waitFor([block](const Frame& frame) {
            return frame.block == block && (frame.surface.dirtyRegions == 0 || block % 20 != 0);
        });
    }
    /// Whether `block` is published in time if frames are received but never reported as shown.
    bool waitForUndrawn(std::size_t block) {
        const auto end = Clock::now() + kPatience;
        std::unique_lock lock(m_mutex);
        while (Clock::now() < end) {
            if (const auto frame = m_thread.takeFrame(); frame && frame->block == block)
                return true;
            m_changed.wait_for(lock, 20ms);
        }
        return false;
    }
    /// Waits until work that started after the last forget() reports progress.
    bool waitForProgress() {
        std::unique_lock lock(m_mutex);
        return m_changed.wait_for(lock, kPatience, [this] { return m_progress > 0 && m_progress < 1; });
    }
    Diagnostics waitForFailure() {
        std::unique_lock lock(m_mutex);
        m_changed.wait_for(lock, kPatience, [this] { return !m_failure.empty(); });
        return m_failure;
    }
    std::uint64_t failedGeneration() {
        const std::scoped_lock lock(m_mutex);
        return m_failedGeneration;
    }
    void forget() {
        const std::scoped_lock lock(m_mutex);
        m_last.reset();
        m_progress = 0;
    }

private:
    void wake() {
        const std::scoped_lock lock(m_mutex);
        m_changed.notify_all();
    }

    std::mutex m_mutex;
    std::condition_variable m_changed;
    Diagnostics m_failure;
    std::uint64_t m_failedGeneration = 0;
    double m_progress = 0;
    FramePtr m_last;
    SimulationThread m_thread; // last member: it must end before what its listener uses is destroyed
};

TEST(SimulationThread, LoadsSeeksAndSteps) {
    const auto program = programOf(randomProgram(21, 100));
    const auto straight = straightRun(program, smallSetup(), bySchedule());
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{program, smallSetup(), bySchedule(), 5});
    const auto first = listening.waitForBlock(0);
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first->generation, 5U);
    EXPECT_EQ(difference(*first, straight[0]), "");

    thread.post(SeekCommand{60});
    const auto second = listening.waitForBlock(60);
    ASSERT_NE(second, nullptr);
    EXPECT_EQ(difference(*second, straight[60]), "");
    EXPECT_GT(second->sequence, first->sequence);

    for (int press = 0; press < 5; ++press)
        thread.post(StepCommand{-1});
    const auto third = listening.waitForBlock(55);
    ASSERT_NE(third, nullptr) << "quick key presses add up";
    EXPECT_EQ(difference(*third, straight[55]), "");
    thread.post(StepCommand{std::numeric_limits<std::ptrdiff_t>::max()});
    EXPECT_NE(listening.waitForBlock(100), nullptr);
    thread.post(StepCommand{std::numeric_limits<std::ptrdiff_t>::min()});
    EXPECT_NE(listening.waitForBlock(0), nullptr);
}

TEST(SimulationThread, MeasuresEveryBlockIfAskedTo) {
    Listening listening;
    const auto program = programOf(randomProgram(4, 100));
    listening.thread().post(LoadCommand{program, smallSetup(), bySchedule(), 1});
    listening.thread().post(SeekCommand{70, 1});
    const auto sought = listening.waitForBlock(70);
    ASSERT_TRUE(sought);
    EXPECT_FALSE(sought->statistics[30].isPlayed());
    listening.thread().post(SeekCommand{100, 2, true});
    const auto measured =
        listening.waitFor([](const Frame& frame) { return frame.block == 100 && frame.seekOver == 2; });
    ASSERT_TRUE(measured);
    const auto straight = straightRun(program, smallSetup(), bySchedule()).back();
    for (std::size_t row = 0; row < 100; ++row) {
        EXPECT_TRUE(measured->statistics[row].isPlayed()) << row;
        EXPECT_EQ(measured->statistics[row].facesShown, straight.statistics[row].facesShown) << row;
    }
}

/// Work that follows interrupted work is not stopped by seeks; a measurement would then take minutes.
TEST(SimulationThread, ASeekDoesNotWaitForAMeasurement) {
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{programOf(randomProgram(29, 100'000)), smallSetup(0.05), bySchedule(), 1});
    ASSERT_NE(listening.waitFor([](const Frame& shown) { return shown.surface.dirtyRegions == 0; }), nullptr);
    for (const bool measured : {false, true}) {
        listening.forget();
        thread.post(SeekCommand{100'000, measured ? 2U : 1U, measured});
        ASSERT_TRUE(listening.waitForProgress());
    }
    thread.post(SeekCommand{10, 3});
    const auto frame =
        listening.waitFor([](const Frame& shown) { return shown.block == 10 && shown.seekOver == 3; });
    ASSERT_NE(frame, nullptr);
    const std::size_t rows = frame->statistics.size();
    EXPECT_TRUE(rows < 100'000 || !frame->statistics[rows - 2].isPlayed()) << "it was measured to the end";
}

TEST(SimulationThread, PlaysToTheEndAndStops) {
    const auto program = programOf(randomProgram(22, 200));
    const auto straight = straightRun(program, smallSetup(), bySchedule());
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{program, smallSetup(), bySchedule(), 1});
    thread.post(PlayCommand{kInfinity, false});
    const auto end =
        listening.waitFor([](const Frame& frame) { return frame.block == 200 && !frame.playing; });
    ASSERT_NE(end, nullptr);
    EXPECT_EQ(difference(*end, straight[200]), "");
}

TEST(SimulationThread, PlaysByTheWallClock) {
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{programOf(randomProgram(23, 400)), smallSetup(), bySchedule(), 1});
    ASSERT_NE(listening.waitForBlock(0), nullptr);
    const auto start = Clock::now();
    thread.post(PlayCommand{200, false});
    const auto frame = listening.waitFor([](const Frame& shown) { return shown.block >= 60; });
    ASSERT_NE(frame, nullptr);
    // 60 blocks at 200 per second take at least 0.3 s; the upper limit depends on the machine.
    EXPECT_GE(Clock::now() - start, 290ms);
}

TEST(SimulationThread, PlaysByAMeasure) {
    const auto program = programOf(randomProgram(4, 40));
    Listening listening;
    listening.thread().post(LoadCommand{program, smallSetup(), bySchedule(), 1});
    // The first ten blocks take no time, the eleventh takes an hour.
    PlaybackMeasure measure(program->blockCount() + 1, 3600);
    std::fill_n(measure.begin(), 11, 0);
    const auto shared = std::make_shared<const PlaybackMeasure>(std::move(measure));
    listening.thread().post(PlayCommand{1, false, shared});
    ASSERT_NE(listening.waitForBlock(10), nullptr);
    std::this_thread::sleep_for(100ms);
    listening.thread().post(PauseCommand{});
    const auto paused = listening.waitFor([](const Frame& frame) { return !frame.playing; });
    ASSERT_NE(paused, nullptr);
    EXPECT_EQ(paused->block, 10U);
    listening.thread().post(PlayCommand{1e9, false, shared});
    EXPECT_NE(listening.waitForBlock(program->blockCount()), nullptr);
}

TEST(SimulationThread, StopsAtBreakpointsAndContinuesFromThem) {
    const auto program = programOf("G0 X5 Y5 Z5\nG1 Z-1 F300\nG1 X20\nG1 Z-3\nG1 X30\nG1 Z-5\nG0 Z5\n");
    Breakpoint below;
    below.kind = BreakpointKind::condition;
    below.condition = "Z < -2";
    Breakpoint contact;
    contact.kind = BreakpointKind::firstContact;
    Breakpoint line;
    line.line = 6;
    for (const bool everyBlock : {false, true}) {
        Listening listening;
        listening.thread().post(LoadCommand{program, smallSetup(), bySchedule(), 1});
        listening.thread().post(BreakpointsCommand{{below, contact, line}});
        for (const auto& [block, kind] :
             std::initializer_list<std::pair<std::size_t, BreakpointKind>>{{2, BreakpointKind::firstContact},
                                                                           {3, BreakpointKind::condition},
                                                                           {5, BreakpointKind::line}}) {
            listening.thread().post(PlayCommand{kInfinity, everyBlock});
            const auto stopped = listening.waitFor(
                [block = block](const Frame& frame) { return frame.stoppedBy && frame.block == block; });
            ASSERT_NE(stopped, nullptr) << block;
            EXPECT_FALSE(stopped->playing);
            EXPECT_EQ(stopped->stoppedBy->breakpoint.kind, kind);
            EXPECT_EQ(stopped->stoppedBy->block, block);
        }
        listening.thread().post(PlayCommand{kInfinity, everyBlock});
        const auto end = listening.waitForBlock(program->blockCount());
        ASSERT_NE(end, nullptr);
        EXPECT_EQ(end->stoppedBy, nullptr);
        // Seeks do not stop at them.
        listening.thread().post(SeekCommand{0});
        ASSERT_NE(listening.waitForBlock(0), nullptr);
        listening.thread().post(SeekCommand{7});
        ASSERT_NE(listening.waitForBlock(7), nullptr);
    }
}

TEST(SimulationThread, PaperModeShowsEveryBlock) {
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{programOf(randomProgram(24, 50)), smallSetup(), bySchedule(), 1});
    ASSERT_NE(listening.waitForBlock(0), nullptr);
    thread.post(PlayCommand{kInfinity, true});
    std::vector<std::size_t> blocks{0}; // seen above, and not necessarily published again
    const auto end = listening.waitFor([&blocks](const Frame& frame) {
        if (blocks.back() != frame.block)
            blocks.push_back(frame.block);
        return frame.block == 50;
    });
    ASSERT_NE(end, nullptr);
    std::vector<std::size_t> every(51);
    std::iota(every.begin(), every.end(), std::size_t{0});
    EXPECT_EQ(blocks, every);
}

TEST(SimulationThread, PaperModeAnswersCommandsWhileNobodyDraws) {
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{programOf(randomProgram(24, 50)), smallSetup(), bySchedule(), 1});
    ASSERT_NE(listening.waitForBlock(0), nullptr);
    thread.post(PlayCommand{kInfinity, true});
    ASSERT_TRUE(listening.waitForUndrawn(1));
    thread.post(PauseCommand{});
    const auto paused =
        listening.waitFor([](const Frame& frame) { return frame.block > 0 && !frame.playing; });
    ASSERT_NE(paused, nullptr);
    EXPECT_EQ(paused->block, 1U);
}

TEST(SimulationThread, PauseHoldsThePosition) {
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{programOf(randomProgram(25, 3000)), smallSetup(), bySchedule(), 1});
    thread.post(PlayCommand{500, false});
    ASSERT_NE(listening.waitFor([](const Frame& frame) { return frame.block > 10; }), nullptr);
    thread.post(PauseCommand{});
    const auto paused =
        listening.waitFor([](const Frame& frame) { return !frame.playing && frame.block > 0; });
    ASSERT_NE(paused, nullptr);
    // The block is the same as the one reached after the pause.
    DecimationParameters marked = bySchedule();
    marked.seed = 77;
    thread.post(ParametersCommand{marked});
    const auto later = listening.waitFor([&](const Frame& frame) { return frame.parameters == marked; });
    ASSERT_NE(later, nullptr);
    EXPECT_EQ(later->block, paused->block);
}

TEST(SimulationThread, AppliesEditsAndParametersInOrder) {
    const auto before = programOf(randomProgram(26, 60));
    const auto after = programOf(randomProgram(27, 60));
    DecimationParameters coarse = bySchedule();
    coarse.allowance = 0.4;
    const auto straight = straightRun(after, smallSetup(), coarse);
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{before, smallSetup(), bySchedule(), 1});
    thread.post(SeekCommand{50});
    thread.post(ParametersCommand{coarse});
    thread.post(EditCommand{after, 2});
    thread.post(SeekCommand{60});
    const auto frame = listening.waitFor([](const Frame& shown) {
        return shown.generation == 2 && shown.block == 60 && shown.surface.dirtyRegions == 0;
    });
    ASSERT_NE(frame, nullptr);
    EXPECT_EQ(difference(*frame, straight[60]), "");
}

TEST(SimulationThread, ShowsABetterPictureAtRestUntilTheNextBlock) {
    const auto program = programOf(randomProgram(28, 60));
    const DecimationParameters certified;
    const auto straight = straightRun(program, smallSetup(), certified);
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{program, smallSetup(), certified, 1});
    thread.post(SeekCommand{43});
    const auto atRest = [](std::size_t block) {
        return [block](const Frame& shown) {
            EXPECT_EQ(shown.atRest, shown.level == ErrorLevel::surface);
            return shown.block == block && shown.atRest;
        };
    };
    const auto rested = listening.waitFor(atRest(43));
    ASSERT_NE(rested, nullptr);
    EXPECT_EQ(rested->surface.dirtyRegions, 0U);
    // Fewer triangles, but for the walls, which the surface of the schedule does not have.
    EXPECT_LT(rested->surface.faces, straight[43].surface.faces + rested->zmap.walls().count());
    thread.post(StepCommand{1});
    const auto stepped = listening.waitFor(atRest(44));
    ASSERT_NE(stepped, nullptr);
    EXPECT_NE(stepped->surface.triangles(), rested->surface.triangles());
}

TEST(SimulationThread, IsAtRestWhereNoBetterPictureFollows) {
    DecimationParameters everyPoint;
    everyPoint.method = DecimationMethod::none;
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{programOf(randomProgram(28, 60)), smallSetup(), everyPoint, 1});
    thread.post(PlayCommand{1e-3, false});
    const auto played = listening.waitFor([](const Frame& shown) { return shown.playing; });
    ASSERT_NE(played, nullptr);
    EXPECT_FALSE(played->atRest);
    thread.post(PauseCommand{});
    thread.post(SeekCommand{43});
    EXPECT_NE(listening.waitFor([](const Frame& shown) { return shown.block == 43 && shown.atRest; }),
              nullptr);
}

TEST(SimulationThread, ReportsWhyALoadFailed) {
    auto setup = std::make_shared<proveout::Setup>(*smallSetup());
    setup->stock.width = 1e9;
    setup->spacing = 1e-3;
    Listening listening;
    listening.thread().post(LoadCommand{programOf(randomProgram(28, 10)), setup, {}, 7});
    EXPECT_FALSE(listening.waitForFailure().empty());
    EXPECT_EQ(listening.failedGeneration(), 7U);
    // Commands without a simulation are harmless, and the next load works.
    listening.thread().post(SeekCommand{3});
    listening.thread().post(LoadCommand{programOf(randomProgram(28, 10)), smallSetup(), bySchedule(), 8});
    EXPECT_NE(listening.waitFor([](const Frame& frame) { return frame.generation == 8; }), nullptr);
}

TEST(SimulationThread, AnswersACancelOfLongWorkSoon) {
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{programOf(randomProgram(29, 100'000)), smallSetup(0.05), {}, 1});
    ASSERT_NE(listening.waitFor([](const Frame& shown) { return shown.surface.dirtyRegions == 0; }), nullptr);
    listening.forget();
    thread.post(SeekCommand{100'000});
    ASSERT_TRUE(listening.waitForProgress());
    listening.forget();
    const auto asked = Clock::now();
    thread.cancel();
    const auto frame = listening.waitFor([](const Frame&) { return true; });
    ASSERT_NE(frame, nullptr);
    EXPECT_LT(frame->block, 100'000U);
    EXPECT_LT(Clock::now() - asked, kCancelLimit);
    thread.post(PauseCommand{});
    const auto later =
        listening.waitFor([&](const Frame& shown) { return shown.sequence > frame->sequence; });
    ASSERT_NE(later, nullptr);
    EXPECT_EQ(later->block, frame->block) << "cancelled work is not taken up again";
}

TEST(SimulationThread, AnswersACancelAndItsEndInTheMiddleOfABlock) {
    auto listening = std::make_unique<Listening>();
    auto& thread = listening->thread();
    DecimationParameters parameters = bySchedule();
    parameters.method = DecimationMethod::none;
    thread.post(LoadCommand{programOfOneLongBlock(), wideSetup(), parameters, 1});
    ASSERT_NE(listening->waitFor([](const Frame&) { return true; }), nullptr);
    thread.post(SeekCommand{3});
    std::this_thread::sleep_for(200ms);
    listening->forget();
    auto asked = Clock::now();
    thread.cancel();
    const auto frame = listening->waitFor([](const Frame&) { return true; });
    EXPECT_LT(Clock::now() - asked, kCancelLimit);
    ASSERT_NE(frame, nullptr);
    EXPECT_EQ(frame->block, 2U);

    thread.post(SeekCommand{3});
    std::this_thread::sleep_for(100ms);
    asked = Clock::now();
    listening.reset();
    EXPECT_LT(Clock::now() - asked, kCancelLimit);
}

TEST(SimulationThread, ACancelBeforeAnythingIsRefinedKeepsThePicture) {
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{programOf(randomProgram(33, 60)), smallSetup(), {}, 1});
    const auto asked = Clock::now();
    thread.post(SeekCommand{30});
    ASSERT_NE(listening.waitFor([](const Frame& shown) { return shown.block == 30; }), nullptr);
    thread.cancel();
    if (Clock::now() - asked > 140ms)
        GTEST_SKIP() << "this machine is too busy to be quicker than the picture at rest";
    std::this_thread::sleep_for(400ms); // longer than the delay of the refined frame at rest
    const auto frame = listening.waitFor([](const Frame&) { return true; });
    EXPECT_EQ(frame->level, ErrorLevel::sample);
}

TEST(SimulationThread, ACancelOfPlaybackPauses) {
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{programOf(randomProgram(31, 20'000)), smallSetup(), {}, 1});
    thread.post(PlayCommand{200, false});
    ASSERT_NE(listening.waitFor([](const Frame& shown) { return shown.playing && shown.block > 5; }),
              nullptr);
    thread.cancel();
    const auto rested = listening.waitFor([](const Frame& shown) { return !shown.playing; });
    ASSERT_NE(rested, nullptr);
    std::this_thread::sleep_for(100ms);
    const auto later = thread.takeFrame();
    EXPECT_TRUE(later == nullptr || later->block == rested->block);
}

TEST(SimulationThread, ACancelOfALoadHoldsForWhatFollowsFromIt) {
    // The load and the seek take tens of milliseconds. A busy machine may let this thread wait for longer
    // than that before it can cancel, so a late cancel is tried again.
    constexpr auto kSurelyLoading = 4ms;
    const auto program = programOf(randomProgram(32, 20'000));
    for (int attempt = 0; attempt < 20; ++attempt) {
        Listening listening;
        auto& thread = listening.thread();
        const auto asked = Clock::now();
        thread.post(LoadCommand{program, smallSetup(0.05), {}, 1});
        thread.post(SeekCommand{20'000});
        std::this_thread::sleep_for(1ms); // most likely during the load
        thread.cancel();
        if (Clock::now() - asked > kSurelyLoading)
            continue;
        const auto frame = listening.waitFor([](const Frame&) { return true; });
        ASSERT_NE(frame, nullptr);
        std::this_thread::sleep_for(300ms);
        EXPECT_LT(listening.waitFor([](const Frame&) { return true; })->block, 20'000U);
        return;
    }
    GTEST_SKIP() << "this machine is too busy to cancel during a load";
}

/// Random commands from another thread for some seconds; afterwards the state must match the last ones.
TEST(SimulationThread, SurvivesAStormOfCommands) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const std::vector<std::shared_ptr<const Program>> programs{programOf(randomProgram(31, 150)),
                                                               programOf(randomProgram(32, 150)),
                                                               programOf(randomProgram(33, 90))};
    DecimationParameters parameters = bySchedule();
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{programs[0], smallSetup(), parameters, 1});
    std::uint64_t generation = 1;
    for (int command = 0; command < 2000; ++command) {
        switch (random() % 11) {
        case 0:
            thread.post(LoadCommand{programs[random() % 3], smallSetup(), parameters, ++generation});
            break;
        case 1:
            thread.post(EditCommand{programs[random() % 3], ++generation});
            break;
        case 2:
            parameters.allowance = 0.01 * static_cast<double>(random() % 20);
            parameters.period = static_cast<int>(random() % 30) - 1;
            thread.post(ParametersCommand{parameters});
            break;
        case 3:
            thread.post(PlayCommand{random() % 2 == 0 ? kInfinity : 300.0, random() % 3 == 0});
            break;
        case 4:
            thread.post(PauseCommand{});
            break;
        case 5:
            thread.cancel();
            break;
        case 6:
        case 7:
            thread.post(StepCommand{static_cast<std::ptrdiff_t>(random() % 9) - 4});
            break;
        default:
            thread.post(SeekCommand{random() % 160});
        }
        if (const auto frame = thread.takeFrame()) {
            ASSERT_LE(frame->block, frame->program->blockCount());
            ASSERT_GE(frame->statistics.size(), frame->block);
            thread.frameShown(frame->sequence);
        }
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 3000));
    }
    parameters = {};
    const auto& last = programs[1];
    // Before the commands: once they are done, the picture at rest follows soon.
    const auto straight = straightRun(last, smallSetup(), parameters);
    thread.post(PauseCommand{});
    thread.post(ParametersCommand{parameters});
    thread.post(EditCommand{last, ++generation});
    thread.post(SeekCommand{123});
    const auto frame = listening.waitFor([&](const Frame& shown) {
        return shown.generation == generation && shown.block == 123 &&
               difference(shown, straight[123]).empty();
    });
    ASSERT_NE(frame, nullptr);
    EXPECT_EQ(frame->parameters, parameters);
}

/// Half a thousand seeks in two seconds, as when the timeline is dragged during playback.
TEST(SimulationThread, AnswersAStormOfSeeks) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const auto program = programOf(randomProgram(random(), 400));
    Listening listening;
    auto& thread = listening.thread();
    thread.post(LoadCommand{program, smallSetup(0.2), bySchedule(), 1});
    thread.post(BudgetCommand{2'000'000}); // so small that tiles are packed
    Breakpoint contact;
    contact.kind = BreakpointKind::firstContact;
    const auto measure =
        std::make_shared<const PlaybackMeasure>(PlaybackMeasure(program->blockCount() + 1, 0.0));
    for (int seek = 0; seek < 500; ++seek) {
        thread.post(SeekCommand{random() % (program->blockCount() + 1)});
        if (seek % 20 == 0)
            thread.post(PlayCommand{random() % 2 == 0 ? kInfinity : 300.0, false,
                                    random() % 2 == 0 ? measure : nullptr});
        if (seek % 50 == 0)
            thread.post(BreakpointsCommand{{contact}});
        if (seek % 70 == 0)
            thread.cancel();
        if (const auto frame = thread.takeFrame()) {
            ASSERT_LE(frame->block, program->blockCount());
        }
        std::this_thread::sleep_for(4ms);
    }
    thread.post(PauseCommand{});
    thread.post(SeekCommand{321});
    const auto straight = straightRun(program, smallSetup(0.2), bySchedule());
    ASSERT_NE(listening.waitFor([&](const Frame& shown) {
        return shown.block == 321 && difference(shown, straight[321]).empty();
    }),
              nullptr);
}

TEST(SimulationThread, EndsInTheMiddleOfWork) {
    for (int round = 0; round < 5; ++round) {
        Listening listening;
        listening.thread().post(LoadCommand{programOf(randomProgram(40, 5000)), smallSetup(0.2), {}, 1});
        listening.thread().post(SeekCommand{5000});
        std::this_thread::sleep_for(std::chrono::milliseconds(10 * round));
    }
}

} // namespace
} // namespace proveout
