// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <QString>
#include <QVariant>
#include <QWidget>

#include "core/nc/program/program.h"
#include "core/simulation/setup/setup.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace proveout {

class NumberBox;

/// The state of the machine before the first block: the tool in the spindle, and the position if it is known.
class StartForm final : public QWidget {
    Q_OBJECT

public:
    explicit StartForm(QWidget* parent = nullptr);

    /// Shows the values of the setup; emits nothing. `program` may be null; it decides which tool is assumed.
    void show(const Setup& setup, const Program* program);
    void put(Setup& setup) const;

signals:
    void edited();

protected:
    void changeEvent(QEvent* event) override;

private:
    using Item = std::pair<QString, QVariant>; ///< text and tool number

    [[nodiscard]] std::vector<Item> toolItems() const;
    void fillTools();
    void showPosition();
    void retranslate();

    QLabel* m_toolLabel;
    QComboBox* m_tool; ///< the data of an item is its tool number; invalid: not set
    QCheckBox* m_known;
    std::array<QLabel*, 3> m_axisLabels{};
    std::array<NumberBox*, 3> m_position{};
    Setup m_setup;
    std::optional<int> m_assumed;
};

} // namespace proveout
