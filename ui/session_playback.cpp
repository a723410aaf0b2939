// SPDX-License-Identifier: GPL-3.0-or-later
// How the session plays the program: speed, the machine's time, breakpoints.
#include <algorithm>
#include <cstddef>
#include <new>
#include <utility>

#include "ui/program_index.h"
#include "ui/session.h"

namespace proveout {

void Session::play() {
    if (!m_program || isForeign() || m_playback.playing)
        return;
    if (!m_loadedSetup)
        load(); // it failed; where it does so again the reason is told again
    m_search.cancel();
    takeFrame(); // an older frame must not look like the end of what starts now
    if (target() == blockCount())
        m_simulation->post(seekTo(0));
    m_playback.playing = true;
    if (!m_played.isWeighing())
        restartHoldBack();
    postParameters();
    postPlay();
    emit playbackChanged();
}

void Session::pause() {
    m_sought.reset();
    m_simulation->post(PauseCommand{});
    stopPlaying();
}

void Session::togglePlay() {
    if (m_playback.playing)
        pause();
    else
        play();
}

void Session::step(std::ptrdiff_t blocks) {
    m_search.cancel();
    const auto last = static_cast<std::ptrdiff_t>(blockCount());
    const auto from = std::min(static_cast<std::ptrdiff_t>(target()), last);
    m_sought = {static_cast<std::size_t>(from + std::clamp(blocks, -from, last - from)), ++m_ticket};
    // The command pauses by itself; a PauseCommand before it would drop the steps that are still under way.
    m_simulation->post(StepCommand{blocks, m_ticket});
    stopPlaying();
}

void Session::seek(std::size_t block) {
    m_search.cancel();
    m_simulation->post(seekTo(block));
    if (m_playback.playing)
        postPlay();
}

/// Where the play head stands or is on its way to.
std::size_t Session::target() const {
    return m_sought ? m_sought->block : block();
}

/// A load forgets where the simulation was on its way to, so it is kept here until it is there.
SeekCommand Session::seekTo(std::size_t block) {
    m_sought = {std::min(block, blockCount()), ++m_ticket};
    return {m_sought->block, m_ticket};
}

void Session::stepToToolChange(int direction) {
    if (!m_program)
        return;
    const std::size_t from = target();
    pause();
    if (const auto block = neighbouringToolChange(*m_program, from, direction))
        seek(*block);
}

void Session::seekToLine(std::uint32_t line) {
    if (m_program)
        seek(m_program->blocksAfterLine(line));
}

void Session::setSpeed(double unitsPerSecond, bool everyBlock) {
    m_playback.unitsPerSecond = unitsPerSecond;
    m_playback.everyBlock = everyBlock;
    if (m_playback.playing)
        postPlay();
    emit playbackChanged();
}

void Session::setPlayBy(PlayBy by) {
    m_playback.unitsPerSecond *= unitSpeed(by) / unitSpeed(m_playback.by);
    m_playback.by = by;
    if (m_playback.playing)
        postPlay();
    emit playbackChanged();
}

/// Until the program is measured, playback goes by blocks.
void Session::postPlay() {
    PlayCommand command{m_playback.unitsPerSecond, m_playback.everyBlock, {}};
    if (m_times && m_playback.by != PlayBy::blocks)
        command.measure = {m_times,
                           m_playback.by == PlayBy::time ? &m_times->secondsAfter : &m_times->lengthAfter};
    else
        command.unitsPerSecond *= kUnitBlocksPerSecond / unitSpeed(m_playback.by);
    m_simulation->post(std::move(command));
}

// The machine's time.

void Session::setMachine(const Machine& machine) {
    if (m_job.machine() == machine)
        return;
    stopOpening();
    const JobValues before = m_job.values();
    m_job.setMachine(machine);
    askForTimes();
    emit machineChanged();
    emit documentChanged();
    m_history.record(before, m_job.values());
}

/// A million blocks take some tenths of a second: not on this thread.
void Session::askForTimes() {
    if (!m_times || m_times->program != m_program)
        m_times.reset();
    if (!m_program)
        return;
    m_timing.start(
        [this, program = m_program, machine = machine().value_or(Machine())](const NewestTask::Reply& reply) {
            try {
                auto times = machineTimes(program, machine, {reply.stop, {}});
                reply.post([this, times = std::move(times)] {
                    if (!times || times->program != m_program)
                        return;
                    m_times = times;
                    if (m_playback.playing && m_playback.by != PlayBy::blocks)
                        postPlay();
                    emit timesChanged();
                    requestTick();
                });
            } catch (const std::bad_alloc&) {
                // Playback goes by blocks, and no time is shown: the program can still be looked at.
            }
        });
}

// From a place of the stock to its block, and back.

void Session::goToBlockThatMade(const PickedPlace& place) {
    using Kind = PlaceAnswer::Kind;
    m_search.cancel();
    if (place.moment == nullptr)
        emit placeTold({Kind::noStock, block()});
    else if (!isPresent(*place.moment))
        emit placeTold({Kind::outdated, block()});
    else if (!place.point)
        emit placeTold({Kind::neverCut, place.moment->block});
    else {
        pause();
        m_search.ask(place.moment, *place.point);
    }
}

/// A pending edit has moved the lines already.
bool Session::isPresent(const Frame& moment) const {
    return m_isRead && moment.program == m_program && moment.setup == m_loadedSetup;
}

void Session::goTo(const PlaceAnswer& answer) {
    if (answer.kind == PlaceAnswer::Kind::cut) {
        if (block() != answer.block) {
            m_leftBlocks.push_back(block());
            emit playbackChanged();
        }
        seek(answer.block);
        emit lineRequested(answer.line, 1);
    }
    emit placeTold(answer);
}

void Session::returnFromJump() {
    if (m_leftBlocks.empty())
        return;
    const std::size_t block = m_leftBlocks.back();
    m_leftBlocks.pop_back();
    pause();
    seek(block);
    emit playbackChanged();
}

void Session::forgetJumps() {
    if (!std::exchange(m_leftBlocks, {}).empty())
        emit playbackChanged();
}

// Breakpoints and checkpoints.

void Session::setBreakpoints(std::vector<Breakpoint> breakpoints) {
    if (breakpoints == m_breakpoints)
        return;
    m_breakpoints = std::move(breakpoints);
    m_simulation->post(BreakpointsCommand{m_breakpoints});
    emit breakpointsChanged();
}

void Session::addBreakpoint(const Breakpoint& added) {
    std::vector<Breakpoint> changed = m_breakpoints;
    const auto known = std::ranges::find_if(changed, [&added](Breakpoint each) {
        each.enabled = added.enabled;
        return each == added;
    });
    if (known == changed.end())
        changed.push_back(added);
    else
        known->enabled = true;
    setBreakpoints(std::move(changed));
}

void Session::toggleBreakpoint(std::uint32_t line) {
    std::vector<Breakpoint> changed = m_breakpoints;
    const auto removed = std::erase_if(changed, [line](const Breakpoint& breakpoint) {
        return breakpoint.kind == BreakpointKind::line && breakpoint.line == line;
    });
    if (removed == 0) {
        Breakpoint added;
        added.line = line;
        changed.push_back(added);
    }
    setBreakpoints(std::move(changed));
}

void Session::moveBreakpoints(std::uint32_t line, bool fromItsStart, std::ptrdiff_t added) {
    const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(line) + (fromItsStart ? 0 : 1);
    const std::ptrdiff_t goneBefore = added < 0 ? from - added : from;
    std::vector<Breakpoint> moved;
    for (Breakpoint breakpoint : m_breakpoints) {
        const auto at = static_cast<std::ptrdiff_t>(breakpoint.line);
        if (breakpoint.kind == BreakpointKind::line && at >= from) {
            if (at < goneBefore)
                continue; // its line is gone
            breakpoint.line = static_cast<std::uint32_t>(at + added);
        }
        moved.push_back(std::move(breakpoint));
    }
    setBreakpoints(std::move(moved));
}

void Session::setCheckpointBudget(std::size_t bytes) {
    m_checkpointBudget = bytes;
    m_simulation->post(BudgetCommand{bytes});
}

/// What a load forgets.
void Session::postStops() {
    if (!m_breakpoints.empty())
        m_simulation->post(BreakpointsCommand{m_breakpoints});
    if (m_checkpointBudget)
        m_simulation->post(BudgetCommand{*m_checkpointBudget});
}

} // namespace proveout
