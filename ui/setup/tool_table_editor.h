// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/cutter/tool_table.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace proveout {

class CountBox;
class ToolForm;

/// The tools by number: a list, and the form of the selected one.
class ToolTableEditor final : public QWidget {
    Q_OBJECT

public:
    explicit ToolTableEditor(QWidget* parent = nullptr);
    [[nodiscard]] const ToolTable& tools() const { return m_tools; }
    /// Shows other tools; emits nothing.
    void show(const ToolTable& tools);
    /// Adds a tool with the standard sizes, to be edited; nothing where the number is taken.
    void add(int number);

signals:
    void edited();

protected:
    void changeEvent(QEvent* event) override;

private:
    void fillList(int selected);
    void select();
    void applyForm();
    void renumber(int number);
    void removeSelected();
    void retranslate();
    [[nodiscard]] int selectedNumber() const; ///< -1: none
    [[nodiscard]] int freeNumber() const;

    ToolTable m_tools;
    QTreeWidget* m_list;
    QPushButton* m_add;
    QPushButton* m_remove;
    QLabel* m_numberLabel;
    CountBox* m_number;
    QWidget* m_details;
    ToolForm* m_form;
    QLabel* m_problem;
};

} // namespace proveout
