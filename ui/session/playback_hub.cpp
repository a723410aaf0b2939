// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/playback_hub.h"

#include <utility>

#include "ui/program/program_index.h"
#include "ui/session/breakpoint_list.h"
#include "ui/session/document_hub.h"
#include "ui/session/program_hub.h"
#include "ui/session/simulation_hub.h"

namespace proveout {

namespace {

constexpr int kPaperWatchdogMs = 2000;

} // namespace

PlaybackHub::PlaybackHub(const DocumentHub& document, const ProgramHub& program, SimulationHub& simulation,
                         BreakpointList& breakpoints)
    : m_document(document), m_program(program), m_simulation(simulation), m_breakpoints(breakpoints) {
    connectTick();
    connect(&simulation, &SimulationHub::taken, this, &PlaybackHub::onStarted);
    connect(&simulation, &SimulationHub::failed, this, &PlaybackHub::stopPlaying);
    connect(&simulation, &SimulationHub::cancelled, this, &PlaybackHub::stopPlaying);
    connect(&program, &ProgramHub::timesChanged, this, [this] {
        if (m_state.playing && m_state.by != PlayBy::blocks)
            postPlay();
        requestTick();
    });
}

void PlaybackHub::connectTick() {
    m_paperWatchdog.setSingleShot(true);
    m_paperWatchdog.setInterval(kPaperWatchdogMs);
    connect(&m_paperWatchdog, &QTimer::timeout, this, [this] {
        if (const FramePtr& frame = m_simulation.frame())
            m_simulation.frameShown(frame->sequence);
    });
    connect(&m_simulation, &SimulationHub::frameReady, &m_tick, &RepaintTick::request);
    connect(&m_tick, &RepaintTick::fired, this, &PlaybackHub::onTick);
}

// Simulation

void PlaybackHub::simulate(bool more) {
    if (m_program.isForeign()) {
        // The text is not an NC program; an uncut stock would look like its result.
        m_frameLog.clear();
        m_simulation.unload();
        requestTick();
        stopPlaying();
    } else if (!m_simulation.runsOn(m_document.job().setup()) || !m_simulation.frame())
        load();
    else if (!more)
        continueWithEdit();
    else {
        // The program was extended: the target block stays the same, unless all of it is measured.
        m_simulation.edit();
        if (m_simulation.isMeasuring())
            m_simulation.seek(m_program.blockCount(), true);
        if (m_state.playing)
            postPlay();
    }
}

void PlaybackHub::continueWithEdit() {
    // At the end of the program the view follows to the new end; otherwise the current block stays and is cut
    // again.
    const bool atEnd = m_simulation.target() == m_simulation.frame()->program->blockCount();
    const std::size_t block = atEnd ? m_program.blockCount() : m_simulation.target();
    const bool measuring = m_simulation.isMeasuring();
    m_simulation.edit();
    if (!m_state.playing)
        m_simulation.seek(block, measuring);
}

void PlaybackHub::load() {
    if (!m_program.current() || m_program.isForeign())
        return;
    if (const Result<void> whole = checkShape(m_document.job().setup()->shape); !whole) {
        m_frameLog.clear();
        m_simulation.refuse(whole.error());
        requestTick();
        return;
    }
    emit headSent();
    m_frameLog.clear();
    m_played.loaded(m_document.job().parameters());
    m_simulation.load();
    m_breakpoints.post();
    if (m_checkpointBudget)
        m_simulation.post(BudgetCommand{*m_checkpointBudget});
    if (m_state.playing)
        postPlay();
}

void PlaybackHub::reset() {
    m_state.playing = false;
    m_frameLog.clear();
    m_simulation.reset();
}

void PlaybackHub::setCheckpointBudget(std::size_t bytes) {
    m_checkpointBudget = bytes;
    m_simulation.post(BudgetCommand{bytes});
}

// Playback

void PlaybackHub::play() {
    if (!m_program.current() || m_program.isForeign() || m_state.playing)
        return;
    if (!m_simulation.isLoaded())
        load(); // the last load failed; if it fails again, the reason is reported again
    emit headSent();
    m_simulation.takeFrame(); // an older frame must not be mistaken for the end of this run
    if (m_simulation.target() == m_program.blockCount())
        m_simulation.seek(0);
    m_state.playing = true;
    if (!m_played.isWeighing())
        restartHoldBack();
    postParameters();
    postPlay();
    emit changed();
}

void PlaybackHub::pause() {
    m_simulation.pause();
    stopPlaying();
}

void PlaybackHub::togglePlay() {
    if (m_state.playing)
        pause();
    else
        play();
}

void PlaybackHub::step(std::ptrdiff_t blocks) {
    emit headSent();
    m_simulation.step(blocks);
    stopPlaying();
}

void PlaybackHub::seek(std::size_t block) {
    emit headSent();
    m_simulation.seek(block);
    if (m_state.playing)
        postPlay();
}

void PlaybackHub::measure() {
    emit headSent();
    pause();
    m_simulation.seek(m_program.blockCount(), true);
}

void PlaybackHub::stepToToolChange(int direction) {
    if (!m_program.current())
        return;
    const std::size_t from = m_simulation.target();
    pause();
    if (const auto block = neighbouringToolChange(*m_program.current(), from, direction))
        seek(*block);
}

void PlaybackHub::seekToLine(std::uint32_t line) {
    if (m_program.current())
        seek(m_program.current()->blocksAfterLine(line));
}

void PlaybackHub::setSpeed(double unitsPerSecond, bool everyBlock) {
    m_state.unitsPerSecond = unitsPerSecond;
    m_state.everyBlock = everyBlock;
    if (m_state.playing)
        postPlay();
    emit changed();
}

void PlaybackHub::setPlayBy(PlayBy by) {
    m_state.unitsPerSecond *= unitSpeed(by) / unitSpeed(m_state.by);
    m_state.by = by;
    if (m_state.playing)
        postPlay();
    emit changed();
}

/// Playback is by blocks until the machine time of the program is known.
void PlaybackHub::postPlay() {
    PlayCommand command{m_state.unitsPerSecond, m_state.everyBlock, {}};
    const auto& times = m_program.times();
    if (times && m_state.by != PlayBy::blocks)
        command.measure = {times, m_state.by == PlayBy::time ? &times->secondsAfter : &times->lengthAfter};
    else
        command.unitsPerSecond *= kUnitBlocksPerSecond / unitSpeed(m_state.by);
    m_simulation.post(std::move(command));
}

void PlaybackHub::stopPlaying() {
    if (!std::exchange(m_state.playing, false))
        return;
    postParameters();
    emit changed();
}

// Parameters during playback

void PlaybackHub::adoptParameters() {
    restartHoldBack();
    postParameters();
}

void PlaybackHub::restartHoldBack() {
    m_played.restart(m_document.job().parameters(), m_simulation.presentFrame());
}

void PlaybackHub::postParameters() {
    if (const auto due = m_played.due(m_document.job().parameters(), m_state.playing))
        m_simulation.post(ParametersCommand{*due});
}

// Frames

void PlaybackHub::onStarted(const FramePtr& before) {
    const Frame& frame = *m_simulation.frame();
    if (frame.block == frame.program->blockCount() && !frame.playing && !m_program.isReading())
        stopPlaying();
    if (frame.stoppedBy && (!before || before->stoppedBy != frame.stoppedBy)) {
        stopPlaying();
        emit stoppedAt(*frame.stoppedBy);
    }
}

void PlaybackHub::onTick() {
    m_simulation.takeFrame();
    if (m_state.playing && m_state.everyBlock)
        m_paperWatchdog.start();
    emit tick(m_simulation.frame());
}

void PlaybackHub::reportDrawn(std::uint64_t sequence, double uploadSeconds, double drawSeconds,
                              bool allTriangles) {
    const FramePtr& frame = m_simulation.frame();
    if (!frame || frame->sequence != sequence || !m_frameLog.add(*frame, uploadSeconds, drawSeconds))
        return;
    m_paperWatchdog.stop();
    if (!m_played.isWeighing())
        restartHoldBack();
    if (m_state.playing && allTriangles && !m_frameLog.rows().empty())
        m_played.weigh(*frame, m_frameLog.rows().back());
    postParameters();
    if (m_state.everyBlock)
        m_simulation.frameShown(sequence);
    if (!m_state.playing)
        requestTick(); // no other frame will follow to show the new row
}

void PlaybackHub::reportUploading(std::uint64_t sequence) {
    const FramePtr& frame = m_simulation.frame();
    if (m_paperWatchdog.isActive() && frame && frame->sequence == sequence)
        m_paperWatchdog.start();
}

} // namespace proveout
