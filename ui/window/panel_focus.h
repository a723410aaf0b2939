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

/// Leads the keyboard focus between the docks of a window and its centre. The action of a dock brings it
/// forward and gives it the focus; only where it has both already, it is closed. What lies behind another tab
/// or is closed is hidden, so that it never has the focus, nor gets it by Tab. Thread: UI.
class PanelFocus final : public QObject {
    Q_OBJECT

public:
    /// `centre` has the pages in the middle of the window; both outlive this object.
    PanelFocus(QMainWindow& window, QStackedWidget& centre);

    /// Takes over the toggleViewAction() of a dock that has its widget.
    void add(QDockWidget& dock);
    /// Shows a panel in front of others and gives it the focus: to what had it last, or its first input.
    void activate(QDockWidget& dock);
    /// Shows another page in the middle; it gets the focus where the one before had it.
    void showPage(QWidget& page);
    /// Gives the focus to the page in the middle of the window.
    void activateCentre();

private:
    void actionTriggered(QDockWidget& dock);
    void visibilityChanged(QDockWidget& dock, bool visible);
    void focusMoved(QWidget* focus);
    [[nodiscard]] QDockWidget* dockOf(const QWidget* widget) const;

    QMainWindow& m_window;
    QStackedWidget& m_centre;
    QList<QDockWidget*> m_docks;
    QPointer<QWidget> m_last; ///< had the focus last, menus apart
};

} // namespace proveout
