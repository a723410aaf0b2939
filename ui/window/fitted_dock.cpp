// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/fitted_dock.h"

#include <cstdlib>

#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>

#include "ui/window/dock_layouts.h"

namespace proveout {

namespace {
constexpr int kSameWidth = 3; // px; splitters round
}

FittedDock::FittedDock(QMainWindow& window, QDockWidget& dock)
    : QObject(&window), m_window(window), m_dock(dock) {
    window.installEventFilter(this);
    dock.installEventFilter(this);
}

void FittedDock::fit() {
    if (m_dock.isFloating() || m_isChosen)
        return;
    const int width = leftDockWidth(m_window.width(), m_dock.widget()->sizeHint().width());
    m_window.resizeDocks({&m_dock}, {width}, Qt::Horizontal);
    adopt();
}

void FittedDock::adopt() {
    m_isChosen = false;
    ++m_settling;
    QMetaObject::invokeMethod(this, &FittedDock::adoptSettled, Qt::QueuedConnection);
}

/// The layout may have set another size than was requested.
void FittedDock::adoptSettled() {
    --m_settling;
    if (!m_isChosen)
        m_width = m_dock.width();
    m_windowWidth = m_window.width();
}

bool FittedDock::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Resize)
        return QObject::eventFilter(watched, event);
    if (watched == &m_window) {
        // The layout has adapted the docks to the new window size already.
        m_windowWidth = m_window.width();
        fit();
    } else if (m_settling == 0 && m_window.width() == m_windowWidth && !m_dock.isFloating()) {
        m_isChosen = std::abs(m_dock.width() - m_width) > kSameWidth;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace proveout
