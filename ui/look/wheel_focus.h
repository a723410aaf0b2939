// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace proveout {

/// Keeps the wheel off every input of the application that does not have the focus: a spin box, combo box or
/// slider that only lies under the pointer stays as it is, and the panel that it is in scrolls. Nor does the
/// wheel move the focus. Holds for windows and dialogs alike, as long as this object lives. Thread: UI.
class WheelFocus final : public QObject {
    Q_OBJECT

public:
    explicit WheelFocus(QObject* parent);
    /// An input of our own that the wheel changes: it is treated like those of Qt.
    static void mark(QWidget& input);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace proveout
