// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/simulation_hub.h"

#include <algorithm>
#include <utility>

#include "ui/session/document_hub.h"
#include "ui/session/problems_hub.h"
#include "ui/session/program_hub.h"
#include "ui/session/work_hub.h"

namespace proveout {

SimulationHub::SimulationHub(const DocumentHub& document, const ProgramHub& program, ProblemsHub& problems,
                             WorkHub& work)
    : m_document(document), m_program(program), m_problems(problems), m_work(work) {
    work.setCancel(WorkKind::simulating, [this] {
        m_thread->cancel();
        m_sought.reset();
        emit cancelled();
    });
    connectThread();
}

SimulationHub::~SimulationHub() = default;

void SimulationHub::connectThread() {
    SimulationListener listener;
    listener.frameReady = [this] { m_news.post([this] { emit frameReady(); }); };
    listener.progress = [this](double done) {
        m_news.post([this, done] {
            m_work.set(WorkKind::simulating, done < 1 ? std::optional(done) : std::nullopt);
        });
    };
    listener.failed = [this](Diagnostics errors, std::uint64_t generation) {
        m_news.post([this, errors = std::move(errors), generation] { fail(errors, generation); });
    };
    m_thread = std::make_unique<SimulationThread>(std::move(listener));
}

const Frame* SimulationHub::presentFrame() const {
    return m_frame && m_frame->generation == m_generation ? m_frame.get() : nullptr;
}

void SimulationHub::load() {
    m_problems.set(ProblemSource::simulation, {});
    m_loadedSetup = m_document.job().setup();
    m_loadGeneration = ++m_generation;
    post(LoadCommand{m_program.current(), m_loadedSetup, m_document.job().parameters(), m_generation});
    // A seek from before the load was dropped, so it is sent again; otherwise its target would never be
    // reached.
    if (m_sought || block() > 0)
        seek(target(), isMeasuring());
}

void SimulationHub::edit() {
    post(EditCommand{m_program.current(), ++m_generation});
}

void SimulationHub::unload() {
    m_problems.set(ProblemSource::simulation, {});
    m_loadedSetup.reset();
    dropFrame();
}

void SimulationHub::refuse(const Diagnostics& errors) {
    dropFrame();
    fail(errors, m_generation);
}

void SimulationHub::dropFrame() {
    post(PauseCommand{});
    m_loadGeneration = ++m_generation; // frames on their way belong to the previous simulation
    m_frame.reset();
    m_sought.reset();
    m_problems.set(ProblemSource::findings, {});
}

void SimulationHub::reset() {
    m_loadedSetup.reset();
    ++m_generation;
    m_frame.reset();
    m_sought.reset();
    m_problems.set(ProblemSource::simulation, {});
    m_problems.set(ProblemSource::findings, {});
    post(PauseCommand{});
}

void SimulationHub::fail(const Diagnostics& errors, std::uint64_t generation) {
    if (generation < m_loadGeneration)
        return;
    m_loadedSetup.reset();
    m_sought.reset();
    emit failed();
    m_problems.set(ProblemSource::simulation, errors);
    m_problems.refresh();
    emit m_problems.troubled();
}

void SimulationHub::seek(std::size_t block, bool measured) {
    post(seekTo(block, measured));
}

/// A load clears the target of the simulation, so it is stored here until it is reached.
SeekCommand SimulationHub::seekTo(std::size_t block, bool measured) {
    m_sought = {std::min(block, m_program.blockCount()), ++m_ticket, measured};
    return {m_sought->block, m_ticket, measured};
}

void SimulationHub::step(std::ptrdiff_t blocks) {
    const auto last = static_cast<std::ptrdiff_t>(m_program.blockCount());
    const auto from = std::min(static_cast<std::ptrdiff_t>(target()), last);
    m_sought = {static_cast<std::size_t>(from + std::clamp(blocks, -from, last - from)), ++m_ticket, false};
    // The command pauses by itself; a PauseCommand before it would drop pending steps.
    post(StepCommand{blocks, m_ticket});
}

void SimulationHub::pause() {
    m_sought.reset();
    post(PauseCommand{});
}

void SimulationHub::post(SimulationCommand command) {
    m_thread->post(std::move(command));
}

void SimulationHub::frameShown(std::uint64_t sequence) {
    m_thread->frameShown(sequence);
}

void SimulationHub::takeFrame() {
    FramePtr frame = m_thread->takeFrame();
    if (!frame || frame->generation != m_generation)
        return;
    const FramePtr before = std::exchange(m_frame, std::move(frame));
    if (m_sought && m_frame->seekOver >= m_sought->ticket)
        m_sought.reset();
    if (!before || before->findings != m_frame->findings) {
        m_problems.set(ProblemSource::findings, m_frame->findings);
        m_problems.refresh();
    }
    emit taken(before);
}

} // namespace proveout
