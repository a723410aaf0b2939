// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <QObject>

#include "core/base/diagnostic.h"
#include "core/decimation/regions/parameters.h"
#include "core/part/part_spec.h"
#include "core/simulation/setup/check_rules.h"
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
    /// All must outlive this object.
    JobHub(DocumentHub& document, ProgramHub& program, PlaybackHub& playback);

    [[nodiscard]] const Setup& setup() const { return *m_document.job().setup(); }
    [[nodiscard]] const DecimationParameters& parameters() const { return m_document.job().parameters(); }
    /// As defined by the job or the user; empty: the values of Machine() are assumed.
    [[nodiscard]] const std::optional<Machine>& machine() const { return m_document.job().machine(); }

    /// By what the program is judged.
    [[nodiscard]] const CheckRules& check() const { return m_document.job().check(); }

    /// The part that the stock is compared with; empty: none.
    [[nodiscard]] const std::optional<PartSpec>& part() const { return m_document.job().part(); }

    /// Returns errors (stock, grid, memory) and then changes nothing. The spacing of an automatic grid is
    /// computed here, whatever `wanted` contains.
    Result<void> setSetup(const Setup& wanted);
    void setParameters(const DecimationParameters& parameters);
    void setMachine(const Machine& machine);
    void setCheck(const CheckRules& check);
    void setPart(const std::optional<PartSpec>& part);
    /// The stock that contains the program's cutting motions (fittedStock()); the current one if there are no
    /// motions.
    [[nodiscard]] StockBox stockFittedToProgram() const;

    /// The user's steps in setup, parameters and machine since the document was opened.
    [[nodiscard]] JobHistory& history() { return m_history; }
    /// Runs a command that changes setup, parameters or machine as one step of the history, after pending
    /// input of the panels was applied.
    void asOneStep(const std::function<void()>& command);
    /// Pending input of the panels is applied first.
    void undoStep();
    void redoStep();
    /// Makes panels apply input that they delay while the user is typing (inputWanted()), e.g. before saving.
    void collectChanges() { emit inputWanted(); }

    /// Replaces the setup by one that was read from its files again; this is not an undo step. Errors: those
    /// of setSetup().
    Result<void> adoptSetup(const Setup& read);
    /// The tools described in comments have changed.
    void adoptProposals(const ToolProposals& before);
    /// Fits the automatic stock to the program; `forNow`: the rest of the program is still being read.
    void fitStock(bool forNow);
    /// Computes the automatic grid for the cutters of the program.
    void fitGrid();
    /// Reports that setup and, if they differ from `before`, parameters have changed.
    void reportSetup(const DecimationParameters& before);

signals:
    /// Setup, parameters and machine come from another file: pending input of the panels is void.
    void replaced();
    void setupChanged();
    void parametersChanged();
    void machineChanged();
    void checkChanged();
    void partChanged();
    /// Panels must apply the input that they delay while the user is typing.
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
