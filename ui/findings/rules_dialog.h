// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDialog>

#include "core/simulation/setup/check_rules.h"

class QListWidget;

namespace proveout {

class NumberBox;
class ToolLimitsEditor;

/// The rules by which a program is judged: which of them are on, and their limits. Edits a copy.
class RulesDialog final : public QDialog {
    Q_OBJECT

public:
    RulesDialog(CheckRules rules, QWidget* parent);

    /// As edited; reasons, acceptances, waivers and ids that are not in the list are kept.
    [[nodiscard]] CheckRules rules() const;

private:
    void restore();
    void show(const CheckRules& rules);
    void addRow(const QString& title, const std::string& id, bool on);

    CheckRules m_rules;
    QListWidget* m_list;
    std::vector<NumberBox*> m_boxes; ///< of the limits, same order as the fields
    ToolLimitsEditor* m_ofTools;
};

} // namespace proveout
