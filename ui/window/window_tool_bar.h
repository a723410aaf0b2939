// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolBar>

namespace proveout {

class MainWindow;

/// The tool bar of the window, with commands that have their places in its menus. It stays where it is.
/// Thread: UI.
class WindowToolBar final : public QToolBar {
    Q_OBJECT

public:
    /// Adds itself to `window`, which has its menus already.
    explicit WindowToolBar(MainWindow& window);
    void retranslate();
};

} // namespace proveout
