// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDockWidget>
#include <QMainWindow>
#include <QObject>
#include <QTimer>

namespace proveout {

/// One title a dock: one that is a tab has its title there, and over it a strip to drag it by, with the
/// buttons to float and to close it; one that stands alone has the title bar of the style.
/// Thread: UI. `docks` live as long as this object.
class DockTitles final : public QObject {
    Q_OBJECT

public:
    /// Watches docks of `window`; those with a title bar of their own must not be among them.
    DockTitles(QMainWindow& window, std::vector<QDockWidget*> docks);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void update();
    [[nodiscard]] bool isTab(QDockWidget& dock) const;

    QMainWindow& m_window;
    std::vector<QDockWidget*> m_docks;
    QTimer m_soon; ///< docks tell of a change before all of them are where they go
};

} // namespace proveout
