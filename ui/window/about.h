// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenuBar>
#include <QWidget>

namespace proveout {

/// Version, licence, the paper, and the graphics driver.
void showAbout(QWidget& window);

/// Lists all shortcuts of the menus in a separate, non-modal window.
void showShortcutList(QWidget& window, const QMenuBar& menus);

} // namespace proveout
