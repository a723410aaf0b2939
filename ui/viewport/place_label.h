// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace proveout {

/// A text next to the pointer in a window of its own, so that changing it does not repaint the main window.
/// It accepts neither focus nor mouse events. Thread: UI.
class PlaceLabel : public QLabel {
    Q_OBJECT

public:
    explicit PlaceLabel(QWidget* parent);

    /// Shows the text next to a point of the screen, on a side with enough space.
    void showAt(const QPoint& pointer, const QString& text);
};

} // namespace proveout
