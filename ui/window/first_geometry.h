// SPDX-License-Identifier: GPL-3.0-or-later
// The size of the window at its first start, before a geometry was stored.
#pragma once

#include <QRect>
#include <QSize>

class QWidget;

namespace proveout {

/// The first size for a screen with this available size, without the desktop's panels; empty if the screen
/// only fits a maximised window. Space is reserved for the window manager's frame, which is not part of a
/// window's size.
[[nodiscard]] QSize firstWindowSize(QSize available);

/// Gives a window that was never shown its first size, or maximises it.
void applyFirstGeometry(QWidget& window);

} // namespace proveout
