// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <QObject>

#include "core/base/diagnostic.h"
#include "core/decimation/regions/parameters.h"
#include "core/simulation/setup/machine.h"
#include "core/simulation/setup/setup.h"
#include "core/simulation/setup/tool_proposals.h"
#include "ui/document/job_history.h"
#include "ui/session/document_hub.h"

namespace proveout {

class PlaybackHub;
class ProgramHub;

/// Setup, parameters and machine of the document, and the user's steps in them. Thread: the UI thread.
class JobHub final : public QObject {
    Q_OBJECT

public:
    /// All outlive it.
    JobHub(DocumentHub& document, ProgramHub& program, PlaybackHub& playback);

    [[nodiscard]] const Setup& setup() const { return *m_document.job().setup(); }
    [[nodiscard]] const DecimationParameters& parameters() const { return m_document.job().parameters(); }
    /// As described by the job or the user; nothing: the values of Machine() are assumed.
    [[nodiscard]] const std::optional<Machine>& machine() const { return m_document.job().machine(); }

    /// Errors (stock, grid, memory) are those of the result, and change nothing. The spacing of an automatic
    /// grid is found here, whatever `wanted` has.
    Result<void> setSetup(const Setup& wanted);
    void setParameters(const DecimationParameters& parameters);
    void setMachine(const Machine& machine);
    /// The stock that holds the program's cutting motions (fittedStock()); the present one where there is no
    /// motion.
    [[nodiscard]] StockBox stockFittedToProgram() const;

    /// The user's steps in setup, parameters and machine since the document was opened.
    [[nodiscard]] JobHistory& history() { return m_history; }
    /// Carries out a command that changes setup, parameters or machine: a step of its own in the history,
    /// after what panels have not passed on yet.
    void asOneStep(const std::function<void()>& command);
    /// With what panels have not passed on yet.
    void undoStep();
    void redoStep();
    /// Panels that wait for a rest in typing pass on what they have now (inputWanted()), e.g. to be saved.
    void collectChanges() { emit inputWanted(); }

    /// Replaces the setup by one that was read again from its files: no step of the user. Errors as
    /// setSetup().
    Result<void> adoptSetup(const Setup& read);
    /// The tools that comments describe are others.
    void adoptProposals(const ToolProposals& before);
    /// The automatic stock for the program; `forNow`: its rest is still being read.
    void fitStock(bool forNow);
    /// The automatic grid for the cutters of the program.
    void fitGrid();
    /// Reports that setup and, where they are others than `before`, parameters have changed.
    void reportSetup(const DecimationParameters& before);

signals:
    /// Setup, parameters and machine are those of another file: what panels have not passed on is void.
    void replaced();
    void setupChanged();
    void parametersChanged();
    void machineChanged();
    /// Input that a panel keeps while the user is still typing is wanted now.
    void inputWanted();

private:
    void change(const JobValues& from, const JobValues& to);
    void fitUndone();
    [[nodiscard]] Setup withGrid(Setup setup) const;
    [[nodiscard]] Result<void> checkMap(const Setup& setup) const;
    void runOn(const Setup& before);

    DocumentHub& m_document;
    ProgramHub& m_program;
    PlaybackHub& m_playback;
    JobHistory m_history;
};

} // namespace proveout
