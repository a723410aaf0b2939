// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace proveout::cli {

/// A thread that does the newest work of each key, such as a document: new work replaces what waits under its
/// key, and stops what is in progress. Any thread may call it. Its destruction stops the work and waits for
/// it.
class LspWorker {
public:
    using Work = std::function<void(const std::stop_token& stop)>;

    /// Work must not throw.
    LspWorker();
    LspWorker(const LspWorker&) = delete;
    LspWorker& operator=(const LspWorker&) = delete;
    ~LspWorker();

    /// Begins the work after a pause, unless other work of this key comes before.
    void submit(const std::string& key, std::chrono::milliseconds pause, Work work);
    /// Drops the work of a key that waits, and stops it if it is in progress. Whether it waited.
    bool cancel(const std::string& key);

private:
    using Clock = std::chrono::steady_clock;
    struct Waiting {
        Clock::time_point due;
        Work work;
    };

    void run(const std::stop_token& end);

    std::mutex m_mutex;
    std::condition_variable_any m_changed;
    std::map<std::string, Waiting> m_waiting;
    bool m_isNew = false; ///< something was submitted since the thread looked
    std::string m_currentKey;
    std::stop_source m_current{std::nostopstate};
    std::jthread m_thread; ///< last, so that it ends before what it uses
};

} // namespace proveout::cli
