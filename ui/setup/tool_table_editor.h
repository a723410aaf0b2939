// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QWidget>

#include "core/cutter/tool_table.h"

class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace proveout {

class CountBox;
class ToolDrawing;
class ToolForm;

/// The tools by number: a list, and the form of the selected tool.
class ToolTableEditor final : public QWidget {
    Q_OBJECT

public:
    explicit ToolTableEditor(QWidget* parent = nullptr);
    [[nodiscard]] const ToolTable& tools() const { return m_tools; }
    /// Shows other tools; emits nothing.
    void show(const ToolTable& tools);
    /// Adds a tool with the default sizes, assumed until they are edited or confirmed; does nothing if the
    /// number is in use.
    void add(int number);
    /// Selects a tool and its first size for typing; adds the tool if it is missing.
    void edit(int number);

signals:
    void edited();
    /// The user wants to see the comment from which a tool was read.
    void lineWanted(std::uint32_t line);

protected:
    void changeEvent(QEvent* event) override;

private:
    void fillList(int selected);
    void select();
    void applyForm();
    void renumber(int number);
    void removeSelected();
    void confirmSelected();
    void confirmAll();
    void showOrigin();
    [[nodiscard]] static QString originText(const Cutter& cutter, const ToolOrigin& origin);
    void showTool(QTreeWidgetItem& item, int number) const;
    void retranslate();
    [[nodiscard]] int selectedNumber() const; ///< -1: none
    [[nodiscard]] int freeNumber() const;

    ToolTable m_tools;
    QTreeWidget* m_list;
    QPushButton* m_add;
    QPushButton* m_remove;
    QPushButton* m_confirm;
    QPushButton* m_confirmAll;
    QLabel* m_numberLabel;
    CountBox* m_number;
    QWidget* m_details;
    ToolForm* m_form;
    ToolDrawing* m_drawing;
    QLabel* m_origin; ///< where unconfirmed sizes come from
    QLabel* m_problem;
};

} // namespace proveout
