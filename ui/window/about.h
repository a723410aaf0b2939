// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenuBar>
#include <QWidget>

namespace proveout {

/// Version, licence, the paper, and what draws.
void showAbout(QWidget& window);

/// All keys of the menus, in a window of its own that does not block.
void showShortcutList(QWidget& window, const QMenuBar& menus);

} // namespace proveout
