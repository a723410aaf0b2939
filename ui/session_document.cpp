// SPDX-License-Identifier: GPL-3.0-or-later
// The document of the session: text, set-up and parameters.
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/memory.h"
#include "core/base/text.h"
#include "core/decimation/surface/map_memory.h"
#include "core/simulation/run/interpretation.h"
#include "core/simulation/setup/automatic_grid.h"
#include "ui/program_index.h"
#include "ui/session.h"

namespace proveout {

void Session::openFile(const QString& file) {
    m_reader.open(file, [this, file](Result<JobDocument> job) {
        if (!job)
            return refuseOpening(file, job.error());
        adopt(std::move(*job));
        tell(m_job.warnings());
        emit opened(file);
    });
}

/// Who allows the files is asked to open the job again.
void Session::refuseOpening(const QString& file, const Diagnostics& errors) {
    tell(errors);
    std::vector<std::filesystem::path> outside;
    bool otherwise = false; // it cannot be opened anyway
    for (const Diagnostic& error : errors) {
        if (std::string_view(error.id) == "job-outside")
            outside.emplace_back(error.arguments.at(1));
        else
            otherwise = otherwise || error.severity == Severity::error; // warnings of the job follow
    }
    if (!otherwise)
        emit outsideFilesNamed(file, outside);
}

void Session::newFile() {
    m_reader.cancel();
    adopt({});
}

void Session::adopt(JobDocument job) {
    m_playback.playing = false;
    m_job = std::move(job);
    m_history.clear();
    m_hasDocument = true;
    m_program.reset();
    m_cutting = {};
    m_proposals = {};
    m_times.reset();
    m_timing.cancel();
    m_begun = false;
    forgetJumps();
    m_loadedSetup.reset();
    ++m_generation;
    m_frame.reset();
    m_sought.reset();
    m_frameLog.clear();
    m_messages.clear();
    m_simulationErrors.clear();
    m_simulation->post(PauseCommand{});
    watchFiles();
    interpret();
    emit jobReplaced();
    emit textReplaced();
    emit documentChanged();
    emit setupChanged();
    emit machineChanged();
    emit timesChanged();
    emit parametersChanged();
    emit playbackChanged();
    emit programChanged();
    refreshProblems();
    requestTick();
}

/// The document is changed: what is being read would take the change away.
void Session::stopOpening() {
    if (!m_reader.isReading())
        return;
    m_reader.cancel();
    tell(failure("opening-stopped",
                 PROVEOUT_TEXT("Core", "The file was not opened, because the open program was changed "
                                       "while the file was being read."))
             .value());
}

void Session::applyEdit(std::size_t offset, std::size_t removed, std::string_view inserted) {
    stopOpening();
    m_search.cancel();
    m_isRead = false;
    m_job.edit(offset, removed, inserted);
    m_editPause.start();
}

void Session::setTextModified(bool modified) {
    if (m_job.setTextModified(modified))
        emit documentChanged();
}

void Session::setParameters(const DecimationParameters& parameters) {
    if (parameters == m_job.parameters())
        return;
    stopOpening();
    const JobValues before = m_job.values();
    m_job.setParameters(parameters);
    restartHoldBack();
    postParameters();
    emit parametersChanged();
    emit documentChanged();
    m_history.record(before, m_job.values());
}

Result<void> Session::setSetup(const Setup& wanted) {
    const JobValues before = m_job.values();
    Setup setup = wanted;
    if (m_program)
        setup.spacing = gridSpacing(setup, *m_program, gridLimits(m_job.parameters()));
    if (setup == *before.setup)
        return {};
    if (Result<void> fits = checkMap(setup); !fits)
        return fits;
    stopOpening();
    m_job.setSetup(std::make_shared<const Setup>(setup));
    runOn(*before.setup);
    tellSetup(before.parameters);
    emit documentChanged();
    m_history.record(before, m_job.values());
    return {};
}

/// Whether its z-map can be made.
Result<void> Session::checkMap(const Setup& setup) const {
    const Result<Grid> grid = makeGrid(setup.stock, setup.spacing);
    if (!grid)
        return tl::unexpected(grid.error());
    return checkMapMemory(setup.stock, *grid, m_job.parameters(), {},
                          static_cast<double>(memoryLimitBytes()));
}

/// The setup is another than `before`.
void Session::runOn(const Setup& before) {
    if (m_job.wantsStock() || !m_program || !interpretedAlike(*m_program, setup(), before))
        interpret();
    else
        load();
}

/// A step is undone or redone. What we have found out by ourselves since it was made counts on.
void Session::change(const JobValues& from, const JobValues& to) {
    const JobValues before = m_job.values();
    stopOpening();
    m_job.change(from, to);
    fitUndone();
    if (before.setup != m_job.setup()) {
        runOn(*before.setup);
        emit setupChanged();
    }
    if (!(before.parameters == parameters())) {
        restartHoldBack();
        postParameters();
        emit parametersChanged();
    }
    if (before.machine != machine()) {
        askForTimes();
        emit machineChanged();
    }
    emit documentChanged();
}

/// Tools of comments as the comments are now, and the automatic grid for them.
void Session::fitUndone() {
    Setup fitted = setup();
    addProposals(fitted.tools, m_proposals, m_proposals);
    if (m_program)
        fitted.spacing = gridSpacing(fitted, *m_program, gridLimits(parameters()));
    if (!(fitted == setup()))
        m_job.fitSetup(std::make_shared<const Setup>(std::move(fitted)), true);
}

void Session::asOneStep(const std::function<void()>& command) {
    emit inputWanted();
    m_history.closeStep();
    command();
    m_history.closeStep();
}

void Session::undoStep() {
    emit inputWanted();
    m_history.undo();
}

void Session::redoStep() {
    emit inputWanted(); // which leaves nothing to redo where it is a step itself
    m_history.redo();
}

/// The region size may have followed the map.
void Session::tellSetup(const DecimationParameters& before) {
    emit setupChanged();
    if (!(before == parameters()))
        emit parametersChanged();
}

/// Found out by us: nothing that the user would miss.
void Session::adoptProposals(const ToolProposals& proposals) {
    const ToolProposals before = std::exchange(m_proposals, proposals);
    Setup with = setup();
    addProposals(with.tools, proposals, before);
    if (with.tools == setup().tools)
        return;
    const DecimationParameters parametersBefore = parameters();
    m_job.fitSetup(std::make_shared<const Setup>(std::move(with)), true);
    tellSetup(parametersBefore);
}

StockBox Session::stockFittedToProgram() const {
    return m_program ? fittedStock(m_cutting, setup(), ToolChoice(*m_program, setup())) : setup().stock;
}

void Session::fitStock(bool forNow) {
    Setup fitted = setup();
    fitted.stock = fittedStock(m_cutting, fitted, ToolChoice(*m_program, fitted));
    fitted.spacing = gridSpacing(fitted, *m_program, gridLimits(parameters()));
    const DecimationParameters before = parameters();
    // The same again is no reason to simulate anew.
    m_job.fitSetup(fitted == setup() ? m_job.setup() : std::make_shared<const Setup>(std::move(fitted)),
                   forNow);
    tellSetup(before);
}

/// The program may use other cutters than before.
void Session::fitGrid() {
    Setup fitted = setup();
    fitted.spacing = gridSpacing(fitted, *m_program, gridLimits(parameters()));
    if (fitted == setup())
        return;
    const DecimationParameters before = parameters();
    m_job.fitSetup(std::make_shared<const Setup>(std::move(fitted)), true);
    tellSetup(before);
}

} // namespace proveout
