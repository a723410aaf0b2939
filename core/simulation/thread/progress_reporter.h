// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>

namespace proveout {

/// Reports progress of long work only, not too often, and its end. The listener must outlive it; one thread.
class ProgressReporter {
public:
    explicit ProgressReporter(const std::function<void(double)>& listener) : m_listener(listener) {}
    ProgressReporter(const ProgressReporter&) = delete;
    ProgressReporter& operator=(const ProgressReporter&) = delete;
    ~ProgressReporter() {
        if (m_reported)
            m_listener(1.0);
    }
    void report(double done) {
        const auto now = Clock::now();
        if (!m_listener || now < m_next || done >= 1)
            return;
        m_listener(done);
        m_reported = true;
        m_next = now + kBetweenReports;
    }

private:
    using Clock = std::chrono::steady_clock;
    /// Shorter work needs no progress bar.
    static constexpr std::chrono::milliseconds kQuietWork{50};
    static constexpr std::chrono::milliseconds kBetweenReports{30};

    const std::function<void(double)>& m_listener;
    Clock::time_point m_next = Clock::now() + kQuietWork;
    bool m_reported = false;
};

} // namespace proveout
