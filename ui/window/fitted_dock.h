// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QDockWidget;
class QMainWindow;

namespace proveout {

/// Keeps a dock at the left of a window as wide as its content requires, if there is space, in every window
/// size. A width set by the user is kept.
class FittedDock final : public QObject {
    Q_OBJECT

public:
    FittedDock(QMainWindow& window, QDockWidget& dock);
    /// Call it after a change of the content.
    void fit();
    /// The docks were rearranged: the width that follows was not set by the user.
    void adopt();
    /// Whether the user has set the width. Stored with the layout of the window.
    [[nodiscard]] bool isChosen() const { return m_isChosen; }
    void setChosen(bool chosen) { m_isChosen = chosen; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void adoptSettled();

    QMainWindow& m_window;
    QDockWidget& m_dock;
    int m_width = 0;         ///< the fitted width of the dock
    int m_windowWidth = 0;   ///< when the dock's width was last checked
    int m_settling = 0;      ///< own changes that the layout has not applied yet
    bool m_isChosen = false; ///< by the user
};

} // namespace proveout
