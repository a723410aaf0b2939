// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <set>
#include <string>

#include <QWidget>

#include "core/verification/check/check_report.h"
#include "ui/look/command_table.h"
#include "ui/session/session.h"

class QLabel;
class QLineEdit;
class QMenu;
class QModelIndex;
class QTreeView;

namespace proveout {

class ProblemColumns;
class ProblemsModel;
class ProblemsOrder;

/// All messages about files and program, the findings of its check, and what was not checked; a double click
/// goes to the line.
class ProblemsPanel final : public QWidget {
    Q_OBJECT

public:
    explicit ProblemsPanel(Session& session, QWidget* parent = nullptr);
    /// Selects the next (+1) or previous (-1) problem, wrapping around at the end, and goes to its line.
    void goToNeighbour(int direction);
    [[nodiscard]] const ProblemsModel& model() const { return *m_model; }

protected:
    void changeEvent(QEvent* event) override;

private:
    static const std::array<Command<ProblemsPanel>, 3> kCommands;

    void build();
    void showProblems();
    void listProblems();
    [[nodiscard]] QString changeText() const;
    [[nodiscard]] QString changeDetails() const;
    [[nodiscard]] QString nothingFound() const;
    [[nodiscard]] QString summary() const;
    void showNothingFound();
    /// `outdated`: of a check before the last change.
    void goTo(const CheckFinding& problem, bool outdated);
    /// The problem of a row of the list; null: it is of something that was not checked.
    [[nodiscard]] const CheckFinding* problemAt(const QModelIndex& index) const;
    void addProblemActions(QMenu& menu, const CheckFinding& problem, bool outdated);
    void addJudgementActions(QMenu& menu, const CheckFinding& finding);
    void addAcceptAction(QMenu& menu, const NotChecked& entry);
    void accept(const char* id, bool accepted);
    void showMenu(const QPoint& position);
    void waive(const CheckFinding& finding);
    void withdraw(const Waiver& waiver);
    void removeUnused(const Diagnostic& unused);
    void turnOff(const std::string& rule);
    void editRules();
    void ignoreMCodes(const std::set<int>& codes);
    void retranslate();

    Session& m_session;
    ProblemsModel* m_model;
    ProblemsOrder* m_order;
    QTreeView* m_view;
    ProblemColumns* m_columns;
    QLabel* m_empty;   ///< shown without problems
    QLabel* m_summary; ///< shown with them
    QLineEdit* m_filter;
    CommandActions<ProblemsPanel> m_commands;
};

} // namespace proveout
