// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace proveout {

/// A single line of text that is elided if it does not fit the available width.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    using QLabel::QLabel;

    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace proveout
