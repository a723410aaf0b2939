// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace proveout {

/// Ignores the wheel on every input that does not have the focus: a spin box, combo box or slider under the
/// pointer stays unchanged, and its panel scrolls instead. The wheel does not move the focus either. Applies
/// to all windows and dialogs while this object exists. Thread: UI.
class WheelFocus final : public QObject {
    Q_OBJECT

public:
    explicit WheelFocus(QObject* parent);
    /// Marks an input class of our own that the wheel changes, so that it is handled like Qt's inputs.
    static void mark(QWidget& input);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace proveout
