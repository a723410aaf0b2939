// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <mutex>

#include <QObject>

namespace proveout {

/// Hands calls from threads in the background over to the UI thread, in their order. What a call holds
/// crosses under a mutex of our own, so ThreadSanitizer sees the handover (Qt's own queue is not
/// instrumented). Calls that have not been made when the queue is destroyed are dropped. Owned on the UI
/// thread by whoever starts the threads, which must end before it.
class UiQueue final : public QObject {
    Q_OBJECT

public:
    explicit UiQueue(QObject* parent = nullptr);

    /// Any thread; returns at once. The call is made by the event loop of the UI thread.
    void post(std::function<void()> call);

protected:
    bool event(QEvent* event) override;

private:
    std::mutex m_mutex;
    std::deque<std::function<void()>> m_calls; ///< guarded by m_mutex
};

} // namespace proveout
