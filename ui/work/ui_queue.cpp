// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/work/ui_queue.h"

#include <utility>

#include <QCoreApplication>
#include <QEvent>

namespace proveout {

namespace {

QEvent::Type callEvent() {
    static const auto kType = static_cast<QEvent::Type>(QEvent::registerEventType());
    return kType;
}

} // namespace

UiQueue::UiQueue(QObject* parent) : QObject(parent) {}

void UiQueue::post(std::function<void()> call) {
    {
        const std::scoped_lock lock(m_mutex);
        m_calls.push_back(std::move(call));
    }
    QCoreApplication::postEvent(this, new QEvent(callEvent()));
}

/// One call per event: a call may destroy the queue together with its owner, and Qt then drops the remaining
/// events.
bool UiQueue::event(QEvent* event) {
    if (event->type() != callEvent())
        return QObject::event(event);
    std::function<void()> call;
    {
        const std::scoped_lock lock(m_mutex);
        call = std::move(m_calls.front());
        m_calls.pop_front();
    }
    call();
    return true;
}

} // namespace proveout
