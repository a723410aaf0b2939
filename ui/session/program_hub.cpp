// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/program_hub.h"

#include <new>
#include <optional>
#include <utility>

#include "core/simulation/run/interpretation.h"
#include "ui/session/document_hub.h"
#include "ui/session/problems_hub.h"
#include "ui/session/work_hub.h"

namespace proveout {

namespace {

constexpr int kEditPauseMs = 120;

} // namespace

ProgramHub::ProgramHub(const DocumentHub& document, ProblemsHub& problems, WorkHub& work)
    : m_document(document), m_problems(problems), m_work(work) {
    m_editPause.setSingleShot(true);
    m_editPause.setInterval(kEditPauseMs);
    work.setCancel(WorkKind::reading, [this] { m_source.stop(); });
    connect(&m_editPause, &QTimer::timeout, this, &ProgramHub::interpret);
    connect(&document, &DocumentHub::edited, this, [this] {
        markOutdated();
        m_editPause.start();
    });
    connect(&document, &DocumentHub::textReplaced, this, &ProgramHub::interpret);
    connect(&m_source, &ProgramSource::proposed, this,
            [this](const ToolProposals& proposals) { emit proposed(std::exchange(m_proposals, proposals)); });
    connect(&m_source, &ProgramSource::begun, this,
            [this](const auto& program, const auto& cutting) { adopt(program, cutting, false); });
    connect(&m_source, &ProgramSource::progressed, this,
            [this](double done) { m_work.set(WorkKind::reading, done); });
    connect(&m_source, &ProgramSource::ready, this, [this](const auto& program, const auto& cutting) {
        m_work.set(WorkKind::reading, {});
        adopt(program, cutting, true);
    });
    connect(&m_source, &ProgramSource::failed, this, [this](const Diagnostics& errors) {
        m_work.set(WorkKind::reading, {});
        m_begun = false; // no more signals follow
        m_problems.report(errors);
        emit failed(errors);
    });
}

void ProgramHub::markOutdated() {
    m_upToDate = false;
    emit outdated();
}

void ProgramHub::interpret() {
    m_editPause.stop();
    markOutdated();
    const JobDocument& job = m_document.job();
    InterpretOptions options = interpretOptions(*job.setup(), job.text().path);
    options.file.clear(); // messages without a file refer to the text in the editor
    if (job.wantsStock())
        options.part = {};
    m_work.set(WorkKind::reading, {});
    m_source.request(job.text().text, std::move(options), !m_program,
                     KnownTools{job.setup()->tools, m_proposals, job.setup()->startTool.has_value()});
}

void ProgramHub::adopt(const std::shared_ptr<const Program>& program, const CuttingExtent& cutting,
                       bool whole) {
    const bool more = std::exchange(m_begun, !whole);
    emit outdated();
    m_upToDate = true;
    m_program = program;
    m_cutting = cutting;
    m_problems.set(ProblemSource::program, program->diagnostics());
    emit arrived(whole, more);
}

void ProgramHub::reset() {
    m_program.reset();
    m_cutting = {};
    m_proposals = {};
    m_times.reset();
    m_timing.cancel();
    m_begun = false;
    m_problems.set(ProblemSource::program, {});
}

/// Runs on another thread, because a million blocks take some tenths of a second.
void ProgramHub::measure() {
    if (!m_times || m_times->program != m_program)
        m_times.reset();
    if (!m_program)
        return;
    m_timing.start([this, program = m_program, machine = m_document.job().machine().value_or(Machine())](
                       const NewestTask::Reply& reply) {
        try {
            auto times = machineTimes(program, machine, {reply.stop, {}});
            reply.post([this, times = std::move(times)] { measured(times); });
        } catch (const std::bad_alloc&) {
            // Playback is then by blocks and no time is shown, but the program can still be viewed.
        }
    });
}

void ProgramHub::measured(const std::shared_ptr<const MachineTimes>& times) {
    if (!times || times->program != m_program)
        return;
    m_times = times;
    emit timesChanged();
}

} // namespace proveout
