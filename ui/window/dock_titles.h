// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDockWidget>
#include <QMainWindow>
#include <QObject>
#include <QTimer>

namespace proveout {

/// Gives each dock exactly one title: a tabbed dock has its title on the tab, and above it a handle with the
/// buttons to float and to close it; a dock that is not tabbed has the style's title bar.
/// Thread: UI. `docks` must live as long as this object.
class DockTitles final : public QObject {
    Q_OBJECT

public:
    /// Watches docks of `window`; do not include docks with a title bar of their own.
    DockTitles(QMainWindow& window, std::vector<QDockWidget*> docks);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void update();
    [[nodiscard]] bool isTab(QDockWidget& dock) const;

    QMainWindow& m_window;
    std::vector<QDockWidget*> m_docks;
    QTimer m_soon; ///< docks report a change before all of them have been moved
};

} // namespace proveout
