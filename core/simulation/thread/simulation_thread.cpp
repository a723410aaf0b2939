// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/thread/simulation_thread.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <new>
#include <optional>
#include <thread>
#include <utility>

#include "core/simulation/run/rim_finder.h"
#include "core/simulation/run/simulation.h"
#include "core/simulation/thread/command_queue.h"
#include "core/simulation/thread/mailbox.h"
#include "core/simulation/thread/progress_reporter.h"
#include "core/simulation/thread/run_findings.h"

namespace proveout {

namespace {

using Clock = std::chrono::steady_clock;

/// Playback checks for commands at least this often.
constexpr std::chrono::milliseconds kSlice{10};
/// While the user steps from block to block, the simulation does not count as idle.
constexpr std::chrono::milliseconds kBeforeRefining{150};

/// For walls, a frame: more after a seek or step, less while the playback does not keep its speed.
constexpr std::chrono::microseconds kWallsPaused{25'000};
constexpr std::chrono::microseconds kWalls{3000};
constexpr std::chrono::microseconds kWallsBehind{300};
constexpr double kKeepsUp = 0.98;

std::chrono::nanoseconds timeForWalls(const Frame& frame) {
    if (!frame.playing)
        return kWallsPaused;
    return frame.keptSpeed < kKeepsUp ? kWallsBehind : kWalls;
}

template<class... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};
template<class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

Diagnostics broken(const FindingRow& row, std::vector<Argument> arguments) {
    return {diagnosticOf(row, std::move(arguments))};
}

} // namespace

struct SimulationThread::State {
    explicit State(SimulationListener theListener) : listener(std::move(theListener)) {}

    SimulationListener listener;
    CommandQueue queue;
    Mailbox<FramePtr> mailbox;

    // The members below are used by the simulation thread only.
    std::unique_ptr<Simulation> simulation;
    RimFinder rims;
    std::optional<std::size_t> goal; ///< a requested block that has not been reached yet
    bool measures = false;           ///< the way to it is measured
    std::uint64_t seekStarted = 0;   ///< ticket of the newest seek or step
    std::uint64_t seekOver = 0;
    PlaybackClock clock;
    bool playing = false;
    bool everyBlock = false;
    Breakpoints breakpoints;
    std::optional<std::size_t> playedFrom; ///< no breakpoint stops the run before this block again:
                                           ///< playback started here
    std::shared_ptr<const BreakpointHit> stoppedBy;
    bool resting = false; ///< cancelled: nothing is resumed before the next command
    Clock::time_point restsFrom;
    bool patient = false; ///< whether the previous work was interrupted
    std::uint64_t generation = 0;
    std::uint64_t sequence = 0;

    std::jthread thread; ///< last, so that it ends before the members it uses

    void run() {
        while (!queue.closed()) {
            try {
                turn();
            } catch (const std::bad_alloc&) {
                fail(broken(run_finding::kOutOfMemory, {}));
            } catch (const std::exception& exception) {
                fail(broken(run_finding::kInternalError, {exception.what()}));
            }
        }
    }

    void turn() {
        if (auto command = queue.take())
            execute(std::move(*command));
        else if (simulation && !resting && (goal || !simulation->settled()))
            work();
        else if (simulation && playing)
            playSlice();
        else if (simulation && !resting && simulation->canRefine())
            rest();
        else
            queue.wait();
    }

    void fail(Diagnostics diagnostics) {
        simulation.reset();
        rims = {};
        goal.reset();
        playing = false;
        if (listener.failed)
            listener.failed(std::move(diagnostics), generation);
    }

    void publish() {
        restsFrom = Clock::now() + kBeforeRefining;
        auto frame = std::make_shared<Frame>(simulation->frame());
        frame->generation = generation;
        frame->sequence = ++sequence;
        if (!goal)
            seekOver = seekStarted;
        frame->seekOver = seekOver;
        frame->playing = playing;
        frame->atRest = isAtRest();
        frame->keptSpeed = playing && !everyBlock ? clock.keptPart() : 1;
        addWalls(*frame);
        frame->stoppedBy = stoppedBy;
        mailbox.put(std::move(frame));
        if (listener.frameReady)
            listener.frameReady();
    }

    [[nodiscard]] bool isAtRest() const {
        const bool works = goal || playing || !simulation->settled() || simulation->canRefine();
        return resting || !works;
    }

    /// Unless the frame has all of them, or its method none.
    void addWalls(Frame& frame) {
        if (!simulation->canRefine())
            return;
        try {
            frame.zmap.setWalls(rims.findSome(frame, timeForWalls(frame)));
        } catch (const std::bad_alloc&) { // the picture does without
            rims = {};
        }
    }

    // --- commands: they note the request and return at once; work() follows when no command is waiting

    void execute(SimulationCommand command) {
        resting = false;
        if (auto* load = std::get_if<LoadCommand>(&command)) {
            carryOut(std::move(*load));
            return;
        }
        if (!simulation)
            return;
        std::visit(Overloaded{[](const LoadCommand&) {}, [this](auto other) { carryOut(std::move(other)); }},
                   std::move(command));
    }

    void carryOut(LoadCommand&& load) {
        simulation.reset(); // its memory is needed for the next one
        rims = {};
        goal.reset();
        playing = false;
        stoppedBy.reset();
        breakpoints = {};
        generation = load.generation;
        auto prepared = Simulation::prepare(std::move(load.program), std::move(load.setup), load.parameters);
        if (!prepared) {
            fail(std::move(prepared.error()));
            return;
        }
        simulation = std::move(*prepared);
        // An uncut stock is decimated very quickly, while drawing all its points may take longer.
        if (simulation->settled())
            publish();
    }

    void carryOut(EditCommand&& edit) {
        generation = edit.generation;
        const std::size_t wanted = simulation->noteProgram(std::move(edit.program));
        breakpoints.follow(simulation->program(), simulation->tools());
        if (simulation->position() == wanted)
            publish();
        else if (!goal)
            goal = wanted;
    }

    void carryOut(ParametersCommand&& command) {
        simulation->noteParameters(command.parameters);
        // With nothing to decimate there is no work, but the picture has changed.
        if (simulation->settled())
            publish();
    }

    void carryOut(PlayCommand&& play) {
        const std::size_t from = goal.value_or(simulation->position());
        if (!std::exchange(playing, true))
            playedFrom = from;
        stoppedBy.reset();
        everyBlock = play.everyBlock;
        clock.setMeasure(std::move(play.measure));
        clock.start(from, play.unitsPerSecond, Clock::now());
    }

    void carryOut(BreakpointsCommand&& command) {
        breakpoints.set(command.breakpoints, simulation->program(), simulation->tools());
    }

    void carryOut(BudgetCommand&& command) { simulation->setCheckpointBudget(command.bytes); }

    void carryOut(PauseCommand&&) {
        playing = false;
        goal.reset();
        publish();
    }

    void carryOut(SeekCommand&& seek) {
        stoppedBy.reset();
        seekStarted = seek.ticket;
        measures = seek.measured;
        goal = std::min(seek.block, simulation->blockCount());
    }

    void carryOut(StepCommand&& step) {
        stoppedBy.reset();
        playing = false;
        seekStarted = step.ticket;
        measures = false;
        const auto from = static_cast<std::ptrdiff_t>(goal.value_or(simulation->position()));
        const auto last = static_cast<std::ptrdiff_t>(simulation->blockCount());
        goal = static_cast<std::size_t>(std::clamp(step.blocks, -from, last - from) +
                                        from); // the sum itself might overflow
    }

    // --- long work: any command stops it, and it is resumed afterwards

    void work() {
        bool cut = false;
        {
            ProgressReporter reporter(listener.progress);
            // Seeks and steps must not wait for the measurement of a whole program.
            const WorkContext context{queue.beginWork(patient && !measures),
                                      [&reporter](double done) { reporter.report(done); }};
            const std::size_t wanted =
                std::min(goal.value_or(simulation->position()), simulation->blockCount());
            const bool measured = measures && goal;
            if (measured)
                simulation->play(wanted, context);
            else
                simulation->seek(wanted, context);
            cut = context.stopped();
            if (simulation->position() == wanted && !(measured && cut)) // it may pass there on its way
                goal.reset();
        }
        patient = cut;
        if (queue.endWork())
            giveUp();
        clock.start(simulation->position(), clock.unitsPerSecond(), Clock::now());
        publish();
    }

    /// Nothing is requested: makes the refined surface, which any command stops.
    void rest() {
        queue.waitUntil(restsFrom);
        const WorkContext context{queue.beginWork(false), {}};
        if (!context.stopped())
            simulation->refine(rims, context);
        if (queue.endWork())
            giveUp();
        if (resting || !simulation->canRefine())
            publish();
    }

    /// Cancelled.
    void giveUp() {
        goal.reset();
        playing = false;
        resting = true;
    }

    /// Executes the next block, unless a breakpoint stops the run before or after it.
    void playBlock(const WorkContext& context) {
        const std::size_t block = simulation->position();
        if (playedFrom != block)
            stopWhere(breakpoints.before(simulation->program(), block));
        if (!playing)
            return;
        simulation->step(context);
        if (simulation->position() == block)
            return; // it was stopped
        playedFrom.reset();
        if (!breakpoints.empty())
            stopWhere(breakpoints.after(simulation->program(), block,
                                        {simulation->rows(), simulation->findings().foundAt(block)}));
    }

    void stopWhere(const Breakpoint* breakpoint) {
        if (breakpoint == nullptr)
            return;
        playing = false;
        stoppedBy = std::make_shared<const BreakpointHit>(BreakpointHit{*breakpoint, simulation->position()});
    }

    void playSlice() {
        const auto begin = Clock::now();
        bool due = everyBlock || clock.isDue(simulation->position(), begin);
        const WorkContext context{queue.beginWork(false), {}};
        while (due && playing && !simulation->atEnd() && !context.stopped() &&
               Clock::now() - begin < kSlice) {
            playBlock(context);
            due = !everyBlock && clock.isDue(simulation->position(), begin);
        }
        if (queue.endWork())
            giveUp();

        const auto now = Clock::now();
        clock.reached(simulation->position(), now);
        if (simulation->atEnd())
            playing = false;
        publish();
        if (!playing)
            return;
        if (everyBlock)
            queue.waitForShown(sequence);
        queue.waitUntil(clock.next(simulation->position(), now));
    }
};

SimulationThread::SimulationThread(SimulationListener listener)
    : m_state(std::make_unique<State>(std::move(listener))) {
    m_state->thread = std::jthread([state = m_state.get()] { state->run(); });
}

SimulationThread::~SimulationThread() {
    m_state->queue.close();
}

void SimulationThread::post(SimulationCommand command) {
    m_state->queue.post(std::move(command));
}

void SimulationThread::cancel() {
    m_state->queue.cancel();
}

FramePtr SimulationThread::takeFrame() {
    return m_state->mailbox.take().value_or(nullptr);
}

void SimulationThread::frameShown(std::uint64_t sequence) {
    m_state->queue.frameShown(sequence);
}

} // namespace proveout
