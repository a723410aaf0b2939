// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/session/session.h"

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QStackedWidget;
class QTreeWidget;
class QTreeWidgetItem;

namespace proveout {

class ChoiceBox;

/// The breakpoints of the program: a row to add one, of any kind in the core's table, and below it the list
/// of existing breakpoints, each with a check box that turns it on or off.
class BreakpointsPanel final : public QWidget {
    Q_OBJECT

public:
    explicit BreakpointsPanel(Session& session, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void retranslate();
    void colourProblem();
    void showKind();
    void showBreakpoints();
    void showRow(QTreeWidgetItem& item, const Breakpoint& breakpoint) const;
    void showHit(const BreakpointHit& hit);
    void add();
    void removeSelected();
    void changed(const QTreeWidgetItem& item);
    void goTo(const QTreeWidgetItem& item);

    Session& m_session;
    ChoiceBox* m_kind;
    QStackedWidget* m_value; ///< one page per BreakpointValue, in the same order
    QSpinBox* m_line;
    QDoubleSpinBox* m_height;
    QLineEdit* m_condition;
    QPushButton* m_add;
    QPushButton* m_remove;
    QLabel* m_problem;
    QTreeWidget* m_list;
};

} // namespace proveout
