// SPDX-License-Identifier: GPL-3.0-or-later
// The worker thread of the simulation: takes commands as values and publishes immutable frames.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include "core/simulation/run/frame.h"
#include "core/simulation/thread/breakpoints.h"
#include "core/simulation/thread/playback_clock.h"

namespace proveout {

/// A new program and setup; the position becomes 0. Older frames are stale from now on.
struct LoadCommand {
    std::shared_ptr<const Program> program;
    std::shared_ptr<const Setup> setup;
    DecimationParameters parameters;
    std::uint64_t generation = 0;
};
/// An edited program for the same setup: continues at the first changed block (Simulation::noteProgram).
struct EditCommand {
    std::shared_ptr<const Program> program;
    std::uint64_t generation = 0;
};
struct ParametersCommand {
    DecimationParameters parameters;
};
struct PlayCommand {
    double unitsPerSecond = 50; ///< infinity: as fast as possible
    bool everyBlock = false;    ///< paper mode: one frame per block, the next block after frameShown()
    std::shared_ptr<const PlaybackMeasure> measure = {}; ///< the scale of the units; null: blocks
};
/// Sets the breakpoints of playback. A load discards them.
struct BreakpointsCommand {
    std::vector<Breakpoint> breakpoints;
};
/// Sets Simulation::setCheckpointBudget. A load discards it.
struct BudgetCommand {
    std::size_t bytes = 0;
};
struct PauseCommand {};
struct SeekCommand {
    std::size_t block = 0;
    std::uint64_t ticket = 0; ///< rising; reported back in Frame::seekOver
    bool measured = false;    ///< Simulation::play(): measures every block on the way
};
/// Relative to the current position, or to the target of a seek in progress when the command is executed, so
/// that quick key presses add up.
struct StepCommand {
    std::ptrdiff_t blocks = 1;
    std::uint64_t ticket = 0; ///< like that of a seek
};
using SimulationCommand = std::variant<LoadCommand, EditCommand, ParametersCommand, PlayCommand, PauseCommand,
                                       SeekCommand, StepCommand, BreakpointsCommand, BudgetCommand>;

/// Callbacks of the thread; called on the simulation thread, must return at once (post to your own event
/// loop).
struct SimulationListener {
    std::function<void()> frameReady;     ///< a newer frame is in the mailbox
    std::function<void(double)> progress; ///< of long work, in [0, 1]; 1 ends it
    /// A load that failed, or work that failed; there is no simulation until the next load. With the
    /// generation of the newest command that was executed.
    std::function<void(Diagnostics, std::uint64_t generation)> failed;
};

/// Owns the simulation and its thread. Methods may be called from one other thread and never wait for work.
/// Every command stops the work in progress; afterwards the work continues if it is still needed. A newer
/// seek or load replaces an older one, a pause cancels a seek, a step pauses playback, and playback continues
/// from the block of a seek.
class SimulationThread {
public:
    explicit SimulationThread(SimulationListener listener);
    ~SimulationThread(); ///< stops the work and joins
    SimulationThread(const SimulationThread&) = delete;
    SimulationThread& operator=(const SimulationThread&) = delete;

    void post(SimulationCommand command);
    /// Stops long work in progress (a seek, a load) within 200 ms and pauses; the state stays valid, and
    /// nothing is resumed before the next command.
    void cancel();
    /// The newest frame that was not taken yet, or null.
    [[nodiscard]] FramePtr takeFrame();
    /// Paper mode: the frame with this sequence number is on the screen.
    void frameShown(std::uint64_t sequence);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace proveout
