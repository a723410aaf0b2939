// SPDX-License-Identifier: GPL-3.0-or-later
// Background work of which only the newest task counts.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include <QObject>

#include "ui/work/ui_queue.h"

namespace proveout {

/// A thread that runs one task at a time. A new task replaces the previous one, which is asked to stop and
/// whose results are dropped. Thread: the UI thread, except `Reply`. Only the destructor waits, until the
/// running task notices that it must stop. A task holds everything it needs, by value or as shared immutable
/// data, because the object that started it may have changed or been destroyed.
class NewestTask : public QObject {
public:
    /// Passed to a task; used on the task's thread while it runs.
    struct Reply {
        std::stop_token stop;
        /// Runs a function on the UI thread, unless the task was replaced or cancelled.
        std::function<void(std::function<void()>)> post;
    };
    /// Must not throw.
    using Task = std::function<void(const Reply&)>;

    explicit NewestTask(QObject* parent = nullptr);
    ~NewestTask() override;

    void start(Task task);
    /// Cancels the newest task: it is asked to stop, and its results are dropped.
    void cancel();
    /// Asks the newest task to stop; it still reports its results.
    void stop() { m_current.request_stop(); }

private:
    struct Request {
        Task task;
        std::uint64_t generation = 0;
        std::stop_token stop;
    };
    void run(const std::stop_token& stop);

    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::optional<Request> m_waiting; ///< guarded by m_mutex
    std::stop_source m_current;       ///< of the newest task; used only on the UI thread
    std::uint64_t m_generation = 0;   ///< used only on the UI thread
    UiQueue m_replies;
    std::jthread m_thread;
};

} // namespace proveout
