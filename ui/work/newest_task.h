// SPDX-License-Identifier: GPL-3.0-or-later
// Work in the background of which only the newest counts.
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

/// A thread that carries out one task at a time; a new one takes the place of the one before, which is asked
/// to stop and of which nothing is told any more. Thread: the UI thread, except `Reply`. Nobody waits but the
/// destructor, for the task under way to see that it is to stop. What a task needs it holds itself, by value
/// or as shared immutable data: whoever has started it may be gone or changed.
class NewestTask : public QObject {
public:
    /// What a task is given; used on the thread of the task, while it runs.
    struct Reply {
        std::stop_token stop;
        /// Has something done on the UI thread, unless nobody wants to know any more.
        std::function<void(std::function<void()>)> post;
    };
    /// Throws nothing.
    using Task = std::function<void(const Reply&)>;

    explicit NewestTask(QObject* parent = nullptr);
    ~NewestTask() override;

    void start(Task task);
    /// Forgets the newest task: it is asked to stop, and nothing is told any more.
    void cancel();
    /// Asks the newest task to stop; it still tells what it has.
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
    std::stop_source m_current;       ///< of the newest task; UI thread
    std::uint64_t m_generation = 0;   ///< UI thread
    UiQueue m_replies;
    std::jthread m_thread;
};

} // namespace proveout
