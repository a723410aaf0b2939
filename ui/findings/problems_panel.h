// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <set>

#include <QWidget>

#include "ui/look/command_table.h"
#include "ui/session/session.h"

class QLabel;
class QTreeView;

namespace proveout {

class ProblemColumns;
class ProblemsModel;

/// All messages about files, program and simulation; a double click goes to the line.
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
    static const std::array<Command<ProblemsPanel>, 2> kCommands;

    void showProblems();
    [[nodiscard]] QString nothingFound() const;
    void showNothingFound();
    void goTo(const Diagnostic& problem);
    void showMenu(const QPoint& position);
    void ignoreMCodes(const std::set<int>& codes);
    void retranslate();

    Session& m_session;
    ProblemsModel* m_model;
    QTreeView* m_view;
    ProblemColumns* m_columns;
    QLabel* m_empty;
    CommandActions<ProblemsPanel> m_commands;
};

} // namespace proveout
