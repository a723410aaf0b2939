// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolBar>

namespace proveout {

class MainWindow;

/// The tool bar of the window, with commands that are also in its menus, and the verdict. It cannot be moved.
/// Thread: UI.
class WindowToolBar final : public QToolBar {
    Q_OBJECT

public:
    /// Adds itself to `window`, whose menus must exist already.
    explicit WindowToolBar(MainWindow& window);
    void retranslate();

signals:
    /// A click on the verdict.
    void findingsWanted();

private:
    void addVerdict(MainWindow& window);
};

} // namespace proveout
