// SPDX-License-Identifier: GPL-3.0-or-later
// How large the window is at its first start, before it has a geometry of its own to return to.
#pragma once

#include <QRect>
#include <QSize>

class QWidget;

namespace proveout {

/// For a screen with this much room, panels of the desktop left out; nothing where the screen is too small
/// for anything but a maximised window. Frames of window managers are not part of a window's size, so room is
/// left for one.
[[nodiscard]] QSize firstWindowSize(QSize available);

/// Gives a window that was never shown its first size, or maximises it.
void applyFirstGeometry(QWidget& window);

} // namespace proveout
