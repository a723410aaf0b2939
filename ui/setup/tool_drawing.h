// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QWidget>

#include "core/cutter/cutter.h"

namespace proveout {

/// A side view of a tool to scale: cutting part, shank and holder, with its main sizes. Sizes that are not
/// given (shank length, holder) are not drawn.
class ToolDrawing final : public QWidget {
    Q_OBJECT

public:
    explicit ToolDrawing(QWidget* parent = nullptr);

    /// Nothing clears the drawing.
    void show(std::optional<Cutter> cutter);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void describeIt();

    std::optional<Cutter> m_cutter;
};

} // namespace proveout
