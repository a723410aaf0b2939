// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/job_hub.h"

#include <memory>
#include <utility>

#include "core/base/memory.h"
#include "core/simulation/run/interpretation.h"
#include "core/simulation/setup/automatic_grid.h"
#include "core/simulation/setup/setup_memory.h"
#include "ui/program/program_index.h"
#include "ui/session/playback_hub.h"
#include "ui/session/program_hub.h"

namespace proveout {

JobHub::JobHub(DocumentHub& document, ProgramHub& program, PlaybackHub& playback)
    : m_document(document), m_program(program), m_playback(playback),
      m_history([this](const JobValues& from, const JobValues& to) { change(from, to); }) {}

// Changes by the user

Result<void> JobHub::setSetup(const Setup& wanted) {
    const JobValues before = m_document.job().values();
    Setup setup = withGrid(wanted);
    if (setup == *before.setup)
        return {};
    if (Result<void> fits = checkMap(setup); !fits)
        return fits;
    m_document.stopOpening();
    m_document.editJob().setSetup(std::make_shared<const Setup>(std::move(setup)));
    runOn(*before.setup);
    reportSetup(before.parameters);
    emit m_document.changed();
    m_history.record(before, m_document.job().values());
    return {};
}

void JobHub::setParameters(const DecimationParameters& parameters) {
    if (parameters == this->parameters())
        return;
    m_document.stopOpening();
    const JobValues before = m_document.job().values();
    m_document.editJob().setParameters(parameters);
    m_playback.adoptParameters();
    emit parametersChanged();
    emit m_document.changed();
    m_history.record(before, m_document.job().values());
}

void JobHub::setMachine(const Machine& machine) {
    if (this->machine() == machine)
        return;
    m_document.stopOpening();
    const JobValues before = m_document.job().values();
    m_document.editJob().set(&JobValues::machine, std::optional(machine));
    m_program.measure();
    emit machineChanged();
    emit m_document.changed();
    m_history.record(before, m_document.job().values());
}

void JobHub::setCheck(const CheckRules& check) {
    if (this->check() == check)
        return;
    m_document.stopOpening();
    const JobValues before = m_document.job().values();
    m_document.editJob().set(&JobValues::check, check);
    emit checkChanged();
    emit m_document.changed();
    m_history.record(before, m_document.job().values());
}

void JobHub::setPart(const std::optional<PartSpec>& part) {
    if (this->part() == part)
        return;
    m_document.stopOpening();
    const JobValues before = m_document.job().values();
    m_document.editJob().set(&JobValues::part, part);
    emit partChanged();
    emit m_document.changed();
    m_history.record(before, m_document.job().values());
}

/// Whether the z-map for the setup can be created.
Result<void> JobHub::checkMap(const Setup& setup) const {
    return checkSetupMemory(setup, parameters(), static_cast<double>(memoryLimitBytes()), true);
}

/// Applies a setup that has changed from `before`.
void JobHub::runOn(const Setup& before) {
    const auto& program = m_program.current();
    if (m_document.job().wantsStock() || !program || !interpretedAlike(*program, setup(), before))
        m_program.interpret();
    else
        m_playback.load();
}

/// The region size may have changed with the z-map.
void JobHub::reportSetup(const DecimationParameters& before) {
    emit setupChanged();
    if (!(before == parameters()))
        emit parametersChanged();
}

// Steps

void JobHub::asOneStep(const std::function<void()>& command) {
    emit inputWanted();
    m_history.closeStep();
    command();
    m_history.closeStep();
}

void JobHub::undoStep() {
    emit inputWanted();
    m_history.undo();
}

void JobHub::redoStep() {
    emit inputWanted(); // if this records a step, there is nothing left to redo
    m_history.redo();
}

/// Undoes or redoes a step. Values that were computed automatically since that step are kept.
void JobHub::change(const JobValues& from, const JobValues& to) {
    const JobValues before = m_document.job().values();
    m_document.stopOpening();
    m_document.editJob().change(from, to);
    fitUndone();
    if (before.setup != m_document.job().setup()) {
        runOn(*before.setup);
        emit setupChanged();
    }
    if (!(before.parameters == parameters())) {
        m_playback.adoptParameters();
        emit parametersChanged();
    }
    if (before.machine != machine()) {
        m_program.measure();
        emit machineChanged();
    }
    if (before.check != check())
        emit checkChanged();
    if (before.part != part())
        emit partChanged();
    emit m_document.changed();
}

// Values that are computed automatically and do not count as unsaved changes

Setup JobHub::withGrid(Setup setup) const {
    if (const auto& program = m_program.current())
        setup.spacing = gridSpacing(setup, *program, gridLimits(parameters()));
    return setup;
}

/// Updates the tools that come from comments, and then the automatic grid.
void JobHub::fitUndone() {
    Setup fitted = setup();
    addProposals(fitted.tools, m_program.proposals(), m_program.proposals());
    fitted = withGrid(std::move(fitted));
    if (!(fitted == setup()))
        m_document.editJob().fitSetup(std::make_shared<const Setup>(std::move(fitted)), true);
}

void JobHub::adoptProposals(const ToolProposals& before) {
    Setup with = setup();
    addProposals(with.tools, m_program.proposals(), before);
    if (with.tools == setup().tools)
        return;
    const DecimationParameters parametersBefore = parameters();
    m_document.editJob().fitSetup(std::make_shared<const Setup>(std::move(with)), true);
    reportSetup(parametersBefore);
}

Result<void> JobHub::adoptSetup(const Setup& read) {
    const JobValues before = m_document.job().values();
    Setup fitted = withGrid(read);
    if (Result<void> fits = checkMap(fitted); !fits)
        return fits;
    m_document.editJob().fitSetup(std::make_shared<const Setup>(std::move(fitted)));
    runOn(*before.setup);
    reportSetup(before.parameters);
    emit m_document.changed();
    return {};
}

StockBox JobHub::stockFittedToProgram() const {
    const auto& program = m_program.current();
    return program ? fittedStock(m_program.cutting(), setup(), ToolChoice(*program, setup())) : setup().stock;
}

void JobHub::fitStock(bool forNow) {
    Setup fitted = setup();
    fitted.stock = stockFittedToProgram();
    fitted = withGrid(std::move(fitted));
    const DecimationParameters before = parameters();
    // An equal setup keeps its pointer, so that nothing is simulated again.
    const bool same = fitted == setup();
    m_document.editJob().fitSetup(
        same ? m_document.job().setup() : std::make_shared<const Setup>(std::move(fitted)), forNow);
    reportSetup(before);
}

/// The program may now use other cutters.
void JobHub::fitGrid() {
    Setup fitted = withGrid(setup());
    if (fitted == setup())
        return;
    const DecimationParameters before = parameters();
    m_document.editJob().fitSetup(std::make_shared<const Setup>(std::move(fitted)), true);
    reportSetup(before);
}

} // namespace proveout
