// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>

#include "core/base/work_context.h"

namespace proveout {

/// Counts jobs that any thread finishes and reports progress on the thread that made the tally, which does a
/// share of the jobs itself. The context must outlive it.
class Tally {
public:
    Tally(const WorkContext& context, std::size_t jobs) : m_context(context), m_jobs(jobs) {}
    void finished() {
        const std::size_t done = ++m_done;
        if (std::this_thread::get_id() == m_reporter)
            m_context.report(static_cast<double>(done) / static_cast<double>(m_jobs));
    }

private:
    const WorkContext& m_context;
    std::size_t m_jobs;
    std::atomic<std::size_t> m_done = 0;
    std::thread::id m_reporter = std::this_thread::get_id();
};

} // namespace proveout
