// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panel_focus.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QStackedWidget>

namespace proveout {

namespace {

bool isInside(const QWidget* widget, const QWidget& parent) {
    return widget != nullptr && (widget == &parent || parent.isAncestorOf(widget));
}

/// Whether a click gives it the focus, as for inputs, lists and views; buttons of tool bars get it only by
/// Tab.
bool isInput(const QWidget& widget) {
    return widget.isVisible() && widget.isEnabled() &&
           (widget.focusPolicy() & Qt::StrongFocus) == Qt::StrongFocus &&
           qobject_cast<const QScrollArea*>(&widget) == nullptr;
}

QWidget& focusTarget(QWidget& panel) {
    QWidget* last = panel.focusWidget();
    if (last != nullptr && last != &panel && isInput(*last))
        return *last;
    if (panel.focusProxy() != nullptr || isInput(panel))
        return panel;
    for (QWidget* next = panel.nextInFocusChain(); next != &panel; next = next->nextInFocusChain()) {
        if (panel.isAncestorOf(next) && isInput(*next))
            return *next;
    }
    return panel;
}

} // namespace

PanelFocus::PanelFocus(QMainWindow& window, QStackedWidget& centre)
    : QObject(&window), m_window(window), m_centre(centre) {
    connect(qApp, &QApplication::focusChanged, this,
            [this](const QWidget*, QWidget* focus) { focusMoved(focus); });
}

void PanelFocus::add(QDockWidget& dock) {
    // A panel is also hidden if its tab is behind another one.
    QWidget& panel = *dock.widget();
    QSizePolicy policy = panel.sizePolicy();
    policy.setRetainSizeWhenHidden(true); // the docks keep their sizes whichever tab is in front
    panel.setSizePolicy(policy);
    QAction& toggle = *dock.toggleViewAction();
    disconnect(&toggle, SIGNAL(triggered(bool)), &dock, nullptr); // Qt's own handler would close an open dock
    connect(&toggle, &QAction::triggered, this, [this, &dock] { actionTriggered(dock); });
    connect(&dock, &QDockWidget::visibilityChanged, this,
            [this, &dock](bool visible) { visibilityChanged(dock, visible); });
    m_docks << &dock;
}

QDockWidget* PanelFocus::dockOf(const QWidget* widget) const {
    for (QDockWidget* dock : m_docks) {
        if (isInside(widget, *dock->widget()))
            return dock;
    }
    return nullptr;
}

void PanelFocus::activate(QDockWidget& dock) {
    dock.show();
    dock.raise();
    dock.widget()->show();
    QWidget& target = focusTarget(*dock.widget());
    target.activateWindow();
    target.setFocus(Qt::ShortcutFocusReason);
}

void PanelFocus::showPage(QWidget& page) {
    const bool focused = isInside(QApplication::focusWidget(), m_centre);
    m_centre.setCurrentWidget(&page);
    if (focused)
        activateCentre();
}

void PanelFocus::activateCentre() {
    focusTarget(*m_centre.currentWidget()).setFocus(Qt::OtherFocusReason);
}

void PanelFocus::actionTriggered(QDockWidget& dock) {
    if (dock.widget()->isVisible() && isInside(m_last, *dock.widget())) {
        dock.close();
        m_window.activateWindow(); // the dock may have been floating
        activateCentre();
    } else {
        activate(dock);
    }
    dock.toggleViewAction()->setChecked(!dock.isHidden()); // the click has toggled it
}

/// The dock was closed or opened, or its tab has moved to the front or back.
void PanelFocus::visibilityChanged(QDockWidget& dock, bool visible) {
    if (m_window.isMinimized())
        return;
    QWidget& panel = *dock.widget();
    const bool losesFocus = !visible && isInside(QApplication::focusWidget(), panel);
    if (losesFocus)
        activateCentre(); // otherwise Qt would choose any input of another panel
    panel.setVisible(visible);
    if (!losesFocus || dock.isHidden())
        return;
    // The user has selected another tab, so it gets the focus.
    QMetaObject::invokeMethod(
        this,
        [this, &dock] {
            for (QDockWidget* other : m_window.tabifiedDockWidgets(&dock)) {
                if (other->widget()->isVisible() && isInside(QApplication::focusWidget(), m_centre))
                    focusTarget(*other->widget()).setFocus(Qt::OtherFocusReason);
            }
        },
        Qt::QueuedConnection);
}

void PanelFocus::focusMoved(QWidget* focus) {
    const bool ofMenu = qobject_cast<QMenuBar*>(focus) != nullptr || qobject_cast<QMenu*>(focus) != nullptr;
    if (focus == nullptr || ofMenu)
        return;
    m_last = focus;
    // A command that works in a panel, as Find does, may move the focus into a hidden panel: it is then
    // shown.
    QDockWidget* dock = dockOf(focus);
    if (dock == nullptr || dock->widget()->isVisible())
        return;
    dock->show();
    dock->raise();
    dock->widget()->show();
}

} // namespace proveout
