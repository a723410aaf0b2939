// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace proveout {

/// A line of text that takes what room there is and ends with an ellipsis where that is not enough.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    using QLabel::QLabel;

    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace proveout
