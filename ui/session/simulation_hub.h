// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include <QObject>

#include "core/base/diagnostic.h"
#include "core/simulation/run/frame.h"
#include "core/simulation/thread/simulation_thread.h"
#include "ui/work/ui_queue.h"

namespace proveout {

class DocumentHub;
class ProblemsHub;
class ProgramHub;
class WorkHub;

/// The simulation thread with its program and setup, its newest frame, and the block that it is moving to.
/// Thread: the UI thread; no call waits for work.
class SimulationHub final : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object.
    SimulationHub(const DocumentHub& document, const ProgramHub& program, ProblemsHub& problems,
                  WorkHub& work);
    ~SimulationHub() override;

    /// The newest frame; null before the first one of a document.
    [[nodiscard]] const FramePtr& frame() const { return m_frame; }
    /// Blocks executed in the newest frame: 0 … blockCount() of the program.
    [[nodiscard]] std::size_t block() const { return m_frame ? m_frame->block : 0; }
    /// The block that was requested last, or the current one.
    [[nodiscard]] std::size_t target() const { return m_sought ? m_sought->block : block(); }
    /// Whether the simulation has a program, and whether it has this setup.
    [[nodiscard]] bool isLoaded() const { return m_loadedSetup != nullptr; }
    [[nodiscard]] bool runsOn(const std::shared_ptr<const Setup>& setup) const {
        return m_loadedSetup == setup;
    }
    /// The newest frame if it belongs to the program that was posted last, otherwise null.
    [[nodiscard]] const Frame* presentFrame() const;

    /// Loads the current program and setup; the target block stays the same.
    void load();
    /// Continues with a changed program; the part that is equal to the previous one is kept.
    void edit();
    /// The program cannot be simulated: no frame is shown.
    void unload();
    /// The stock does not match its description: like unload(), and the reasons are added to the problems.
    void refuse(const Diagnostics& errors);
    /// Call it for another document.
    void reset();
    /// Whether every block on the way to target() is measured.
    [[nodiscard]] bool isMeasuring() const { return m_sought && m_sought->measured; }
    /// `measured`: every block on the way is measured.
    void seek(std::size_t block, bool measured = false);
    /// Relative to target(); pauses.
    void step(std::ptrdiff_t blocks);
    /// Stops the simulation and clears the target.
    void pause();
    void post(SimulationCommand command);
    /// The frame with this number is on the screen.
    void frameShown(std::uint64_t sequence);
    /// Adopts the newest frame if it belongs to the current program; emits taken().
    void takeFrame();

signals:
    /// A new frame is available.
    void frameReady();
    /// frame() has changed; `before` is the previous one, null if there was none.
    void taken(const FramePtr& before);
    /// There is no simulation until the next load; the reasons are added to the problems afterwards.
    void failed();
    /// A long operation was cancelled.
    void cancelled();

private:
    void connectThread();
    void fail(const Diagnostics& errors, std::uint64_t generation);
    void dropFrame();
    [[nodiscard]] SeekCommand seekTo(std::size_t block, bool measured);

    const DocumentHub& m_document;
    const ProgramHub& m_program;
    ProblemsHub& m_problems;
    WorkHub& m_work;
    std::shared_ptr<const Setup> m_loadedSetup; ///< null: nothing loaded
    std::uint64_t m_generation = 0;
    std::uint64_t m_loadGeneration = 0; ///< of the newest load; failures of older ones are ignored
    FramePtr m_frame;
    /// The target block, and the ticket of the command that seeks it.
    struct Sought {
        std::size_t block = 0;
        std::uint64_t ticket = 0;
        bool measured = false;
    };
    std::optional<Sought> m_sought;
    std::uint64_t m_ticket = 0;
    UiQueue m_news;                             ///< messages of the simulation thread
    std::unique_ptr<SimulationThread> m_thread; ///< last member: it must end before what it posts to is
                                                ///< destroyed
};

} // namespace proveout
