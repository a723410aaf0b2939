// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace proveout {

/// A text beside the pointer, in a window of its own: changing it paints nothing of the main window. It takes
/// neither focus nor mouse. Thread: UI.
class PlaceLabel : public QLabel {
    Q_OBJECT

public:
    explicit PlaceLabel(QWidget* parent);

    /// Beside a point of the screen, on the side where there is room.
    void showAt(const QPoint& pointer, const QString& text);
};

} // namespace proveout
