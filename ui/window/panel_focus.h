// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>

class QDockWidget;
class QMainWindow;
class QStackedWidget;
class QWidget;

namespace proveout {

/// Manages the keyboard focus of a window's docks and its centre. The action of a dock brings it to the front
/// and gives it the focus; if it has both already, the action closes it. Panels behind another tab or in a
/// closed dock are hidden, so they never have the focus and Tab skips them. Thread: UI.
class PanelFocus final : public QObject {
    Q_OBJECT

public:
    /// `centre` contains the pages in the middle of the window; both must outlive this object.
    PanelFocus(QMainWindow& window, QStackedWidget& centre);

    /// Takes over the toggleViewAction() of a dock; its widget must be set.
    void add(QDockWidget& dock);
    /// Brings a panel to the front and gives the focus to the widget that had it last, or to its first input.
    void activate(QDockWidget& dock);
    /// Shows another page in the middle; it gets the focus if the previous page had it.
    void showPage(QWidget& page);
    /// Gives the focus to the current page in the middle of the window.
    void activateCentre();

private:
    void actionTriggered(QDockWidget& dock);
    void visibilityChanged(QDockWidget& dock, bool visible);
    void focusMoved(QWidget* focus);
    [[nodiscard]] QDockWidget* dockOf(const QWidget* widget) const;

    QMainWindow& m_window;
    QStackedWidget& m_centre;
    QList<QDockWidget*> m_docks;
    QPointer<QWidget> m_last; ///< the last widget with the focus, except menus
};

} // namespace proveout
