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

/// How the program is played, and the tick that shows it. Thread: the UI thread.
/// Repainting: panels that show the simulation repaint in `tick` and nowhere else while it plays, because any
/// repaint in a window with a QOpenGLWidget composes the whole window again.
class PlaybackHub final : public QObject {
    Q_OBJECT

public:
    /// All outlive it.
    PlaybackHub(const DocumentHub& document, const ProgramHub& program, SimulationHub& simulation,
                BreakpointList& breakpoints);

    [[nodiscard]] const Playback& state() const { return m_state; }
    /// One row per frame that was drawn, ascending by lastBlock; rows beyond a seek back are dropped when the
    /// blocks are drawn again.
    [[nodiscard]] const std::vector<FrameStatistics>& frameStatistics() const { return m_frameLog.rows(); }
    /// Where playback shows all triangles because decimation costs more than it saves: the figures; null
    /// else. The parameters stay what the user wants, and hold again at rest.
    [[nodiscard]] const HoldBack* heldBack() const { return m_played.held(m_state.playing); }

    void play();
    void pause();
    void togglePlay();
    void step(std::ptrdiff_t blocks);     ///< pauses
    void seek(std::size_t block);         ///< continues to play where it played
    void stepToToolChange(int direction); ///< -1: the previous one, +1: the next one; pauses
    void seekToLine(std::uint32_t line);  ///< the state after source line `line`, 1-based
    void setSpeed(double unitsPerSecond, bool everyBlock = false);
    void setPlayBy(PlayBy by); ///< at the same multiple of its unit speed
    /// Bytes that the simulation may keep to go back quickly.
    void setCheckpointBudget(std::size_t bytes);

    /// A frame was drawn, in paintGL or in place of it: appends a row of frameStatistics() and, in paper
    /// mode, lets the next block be cut. Frames drawn again count once.
    void reportDrawn(std::uint64_t sequence, double uploadSeconds, double drawSeconds);
    /// Asks for a tick outside playback, e.g. after a colour was changed in a panel.
    void requestTick() { m_tick.request(); }

    /// Simulates the program as it is now. `more`: the one before was its beginning.
    void simulate(bool more);
    /// The same from the start: the setup is another.
    void load();
    /// The decimation parameters are others.
    void adoptParameters();
    /// Another document.
    void reset();

signals:
    void changed(); ///< also what NavigationHub::canReturn() says
    /// A breakpoint has stopped the run.
    void stoppedAt(const BreakpointHit& hit);
    /// The play head is sent elsewhere, or what it plays is another.
    void headSent();
    /// The one coalesced repaint: the newest frame, null where there is none. At most 30 times a second, less
    /// often where painting takes long.
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
    std::optional<std::size_t> m_checkpointBudget; ///< nothing: the simulation's own
    QTimer m_paperWatchdog; ///< lets paper mode continue while nobody draws (a minimised window)
    RepaintTick m_tick;
};

} // namespace proveout
