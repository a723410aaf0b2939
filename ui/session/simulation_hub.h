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

/// The simulation thread with the program and setup that it runs on, its newest frame, and where the play
/// head is on its way to. Thread: the UI thread; no call waits for work.
class SimulationHub final : public QObject {
    Q_OBJECT

public:
    /// All outlive it.
    SimulationHub(const DocumentHub& document, const ProgramHub& program, ProblemsHub& problems,
                  WorkHub& work);
    ~SimulationHub() override;

    /// The newest frame; null before the first one of a document.
    [[nodiscard]] const FramePtr& frame() const { return m_frame; }
    /// Blocks executed in the newest frame: 0 … blockCount() of the program.
    [[nodiscard]] std::size_t block() const { return m_frame ? m_frame->block : 0; }
    /// Where the play head is or is on its way to.
    [[nodiscard]] std::size_t target() const { return m_sought ? m_sought->block : block(); }
    /// Whether the simulation runs on a program, and on this setup.
    [[nodiscard]] bool isLoaded() const { return m_loadedSetup != nullptr; }
    [[nodiscard]] bool runsOn(const std::shared_ptr<const Setup>& setup) const {
        return m_loadedSetup == setup;
    }
    /// The newest frame where it is of the program that was posted last, else null.
    [[nodiscard]] const Frame* presentFrame() const;

    /// Loads program and setup as they are now; the play head stays where it is sought.
    void load();
    /// The program is another; what it has in common with the one before is kept.
    void edit();
    /// There is no simulation of the program: nothing is shown in its place.
    void unload();
    /// The stock is not what it is called: as unload(), with the reasons among the problems.
    void refuse(const Diagnostics& errors);
    /// Another document.
    void reset();
    void seek(std::size_t block);
    /// Relative to target(); pauses.
    void step(std::ptrdiff_t blocks);
    /// The simulation rests, and is no longer on its way.
    void pause();
    void post(SimulationCommand command);
    /// The frame with this number is on the screen.
    void frameShown(std::uint64_t sequence);
    /// Takes the newest frame, if there is one of the present program: taken().
    void takeFrame();

signals:
    /// A frame can be taken.
    void frameReady();
    /// frame() is another; the one before is given, null where there was none.
    void taken(const FramePtr& before);
    /// The simulation is gone until the next load; the reasons are among the problems next.
    void failed();
    /// Long work was cancelled.
    void cancelled();

private:
    void connectThread();
    void fail(const Diagnostics& errors, std::uint64_t generation);
    void dropFrame();
    [[nodiscard]] SeekCommand seekTo(std::size_t block);

    const DocumentHub& m_document;
    const ProgramHub& m_program;
    ProblemsHub& m_problems;
    WorkHub& m_work;
    std::shared_ptr<const Setup> m_loadedSetup; ///< null: nothing loaded
    std::uint64_t m_generation = 0;
    std::uint64_t m_loadGeneration = 0; ///< of the newest load; failures of older ones concern nothing
    FramePtr m_frame;
    /// Where the play head is on its way to, and the ticket of the command that sends it there.
    struct Sought {
        std::size_t block = 0;
        std::uint64_t ticket = 0;
    };
    std::optional<Sought> m_sought;
    std::uint64_t m_ticket = 0;
    UiQueue m_news;                             ///< of the simulation thread
    std::unique_ptr<SimulationThread> m_thread; ///< last: it ends before what it posts to
};

} // namespace proveout
