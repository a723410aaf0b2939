// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <mutex>

#include <QObject>

namespace proveout {

/// Passes calls from background threads to the UI thread, in sequence. The data of a call is protected by a
/// mutex of our own, so that ThreadSanitizer recognises the handover (Qt's own queue is not instrumented).
/// Calls that are pending when the queue is destroyed are dropped. It lives on the UI thread, owned by the
/// object that starts the threads, which must end before it.
class UiQueue final : public QObject {
    Q_OBJECT

public:
    explicit UiQueue(QObject* parent = nullptr);

    /// Any thread; returns immediately. The event loop of the UI thread makes the call.
    void post(std::function<void()> call);

protected:
    bool event(QEvent* event) override;

private:
    std::mutex m_mutex;
    std::deque<std::function<void()>> m_calls; ///< guarded by m_mutex
};

} // namespace proveout
