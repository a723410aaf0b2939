// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QDockWidget;
class QMainWindow;

namespace proveout {

/// Keeps a dock at the left of a window as wide as its content wants to be, where there is room, in every
/// size of the window. A width that the user gave it stays.
class FittedDock final : public QObject {
    Q_OBJECT

public:
    FittedDock(QMainWindow& window, QDockWidget& dock);
    /// After a change of the content.
    void fit();
    /// The docks were arranged anew: the width that follows is not the user's.
    void adopt();
    /// Whether the width is the user's. Kept with the layout of the window.
    [[nodiscard]] bool isChosen() const { return m_isChosen; }
    void setChosen(bool chosen) { m_isChosen = chosen; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void adoptSettled();

    QMainWindow& m_window;
    QDockWidget& m_dock;
    int m_width = 0;         ///< of the dock, as it was fitted
    int m_windowWidth = 0;   ///< where the dock's width was looked at last
    int m_settling = 0;      ///< changes of ours that the layout has yet to carry out
    bool m_isChosen = false; ///< by the user
};

} // namespace proveout
