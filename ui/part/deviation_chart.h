// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QWidget>

#include "core/verification/part/part_comparison.h"

namespace proveout {

/// The histogram of a comparison: how many points deviate by how much, with the tolerance. UI thread.
class DeviationChart final : public QWidget {
    Q_OBJECT

public:
    explicit DeviationChart(QWidget* parent = nullptr);
    /// Null: nothing is shown.
    void setComparison(std::shared_ptr<const PartComparison> comparison);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] QRectF plotRect() const;
    [[nodiscard]] QString binText(int bin) const;

    std::shared_ptr<const PartComparison> m_comparison;
};

} // namespace proveout
