// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <QObject>
#include <QTimer>

#include "core/simulation/run/frame.h"
#include "core/simulation/run/statistics.h"
#include "core/simulation/thread/breakpoints.h"
#include "ui/program/frame_log.h"
#include "ui/program/playback.h"
#include "ui/program/played_parameters.h"
#include "ui/work/repaint_tick.h"

namespace proveout {

class BreakpointList;
class DocumentHub;
class ProgramHub;
class SimulationHub;

/// How the program is played, and the tick that updates the views. Thread: the UI thread.
/// Repainting: panels that show the simulation repaint only in `tick` during playback, because any repaint in
/// a window with a QOpenGLWidget composes the whole window again.
class PlaybackHub final : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object.
    PlaybackHub(const DocumentHub& document, const ProgramHub& program, SimulationHub& simulation,
                BreakpointList& breakpoints);

    [[nodiscard]] const Playback& state() const { return m_state; }
    /// One row per drawn frame, ascending by lastBlock; rows after a seek back are dropped when the blocks
    /// are drawn again.
    [[nodiscard]] const std::vector<FrameStatistics>& frameStatistics() const { return m_frameLog.rows(); }
    /// The measurements if playback shows all triangles because decimation costs more than it saves;
    /// otherwise null. The user's parameters are unchanged, and apply again when playback pauses.
    [[nodiscard]] const HoldBack* heldBack() const { return m_played.held(m_state.playing); }

    void play();
    void pause();
    void togglePlay();
    void step(std::ptrdiff_t blocks); ///< pauses
    void seek(std::size_t block);     ///< playback continues if it was running
    void measure(); ///< executes and measures every block not played yet, to the end; pauses
    void stepToToolChange(int direction); ///< -1: the previous one, +1: the next one; pauses
    void seekToLine(std::uint32_t line);  ///< the state after source line `line`, 1-based
    void setSpeed(double unitsPerSecond, bool everyBlock = false);
    void setPlayBy(PlayBy by); ///< keeps the multiple of the unit speed
    /// The memory in bytes that the simulation may use for checkpoints, which make going back fast.
    void setCheckpointBudget(std::size_t bytes);

    /// A frame was drawn, in paintGL or in place of it: appends a row of frameStatistics() and, in paper
    /// mode, allows the next block to be cut. A frame that is drawn again counts once.
    void reportDrawn(std::uint64_t sequence, double uploadSeconds, double drawSeconds,
                     bool allTriangles = true);
    /// A part of a frame was uploaded that is drawn later: paper mode waits for it.
    void reportUploading(std::uint64_t sequence);
    /// Requests a tick outside playback, e.g. after a panel changed a colour.
    void requestTick() { m_tick.request(); }

    /// Simulates the current program. `more`: the previous one was its beginning.
    void simulate(bool more);
    /// Starts the simulation again because the setup has changed.
    void load();
    /// Call it when the decimation parameters have changed.
    void adoptParameters();
    /// Call it for another document.
    void reset();

signals:
    void changed(); ///< also for NavigationHub::canReturn()
    /// A breakpoint has stopped the run.
    void stoppedAt(const BreakpointHit& hit);
    /// Another block was requested, or another program is played.
    void headSent();
    /// One combined repaint of the newest frame, null if there is none. At most 30 times per second, less
    /// often if painting is slow.
    void tick(const FramePtr& frame);

private:
    void connectTick();
    void continueWithEdit();
    void onStarted(const FramePtr& before);
    void onTick();
    void stopPlaying();
    void restartHoldBack();
    void postParameters();
    void postPlay();

    const DocumentHub& m_document;
    const ProgramHub& m_program;
    SimulationHub& m_simulation;
    BreakpointList& m_breakpoints;
    Playback m_state;
    FrameLog m_frameLog;
    PlayedParameters m_played;
    std::optional<std::size_t> m_checkpointBudget; ///< empty: the default of the simulation
    QTimer m_paperWatchdog; ///< lets paper mode continue while nothing is drawn (minimised window)
    RepaintTick m_tick;
};

} // namespace proveout
