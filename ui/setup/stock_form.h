// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "core/simulation/setup.h"

class QDoubleSpinBox;
class QLabel;

namespace proveout {

/// Size and place of the stock, and the grid.
class StockForm final : public QWidget {
    Q_OBJECT

public:
    explicit StockForm(QWidget* parent = nullptr);
    /// Shows other values; emits nothing.
    void show(const Setup& setup);
    /// Puts the values of the form into `setup`.
    void put(Setup& setup) const;

signals:
    void edited();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    std::vector<QLabel*> m_labels;
    std::vector<QDoubleSpinBox*> m_boxes; ///< in the order of the table of fields
};

} // namespace proveout
