// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/work/repaint_tick.h"

#include <algorithm>

#include <QCoreApplication>
#include <QEvent>

namespace proveout {

namespace {

constexpr double kShortestMs = 1000.0 / 30.0;
constexpr double kBreath = 1.25; ///< minimum interval between two ticks, relative to the painting time
constexpr double kSmoothing = 0.3;

QEvent::Type paintedEvent() {
    static const auto kType = static_cast<QEvent::Type>(QEvent::registerEventType());
    return kType;
}

} // namespace

RepaintTick::RepaintTick(QObject* parent) : QObject(parent) {
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &RepaintTick::fire);
}

void RepaintTick::request() {
    if (m_timer.isActive())
        return;
    const double interval = std::max(kShortestMs, kBreath * m_paintMs);
    const double passed = m_sinceFired.isValid() ? static_cast<double>(m_sinceFired.elapsed()) : interval;
    m_timer.start(static_cast<int>(std::max(0.0, interval - passed)));
}

void RepaintTick::fire() {
    m_sinceFired.start();
    emit fired();
    // Repaints are posted with low priority; this event follows them, when everything is painted.
    QCoreApplication::postEvent(this, new QEvent(paintedEvent()), Qt::LowEventPriority - 1);
}

bool RepaintTick::event(QEvent* event) {
    if (event->type() != paintedEvent())
        return QObject::event(event);
    m_paintMs += kSmoothing * (static_cast<double>(m_sinceFired.elapsed()) - m_paintMs);
    return true;
}

} // namespace proveout
