// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include <QWidget>

class QTableWidget;

namespace proveout {

/// The limits of rules for single tools, one row each: tool, rule, limit. Thread: UI.
class ToolLimitsEditor final : public QWidget {
    Q_OBJECT

public:
    explicit ToolLimitsEditor(QWidget* parent);

    void showLimits(const std::map<std::string, double>& limits);
    /// As edited; limits that no rule has are kept. Of two rows for the same, the later one counts.
    [[nodiscard]] std::map<std::string, double> limits() const;

private:
    void add(int tool, const std::string& rule, double value);
    void addAnother();
    /// Removes the row of a cell.
    void remove(const QWidget& cell);

    QTableWidget* m_table;
    std::map<std::string, double> m_others; ///< limits that are not shown
};

} // namespace proveout
