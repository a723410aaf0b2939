// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lsp_worker.h"

#include <algorithm>
#include <utility>

namespace proveout::cli {

LspWorker::LspWorker() : m_thread([this](const std::stop_token& end) { run(end); }) {}

LspWorker::~LspWorker() {
    const std::scoped_lock lock(m_mutex);
    m_waiting.clear();
    m_current.request_stop();
    m_thread.request_stop();
}

void LspWorker::submit(const std::string& key, std::chrono::milliseconds pause, Work work) {
    const std::scoped_lock lock(m_mutex);
    if (m_currentKey == key)
        m_current.request_stop();
    m_waiting[key] = {Clock::now() + pause, std::move(work)};
    m_isNew = true;
    m_changed.notify_all();
}

bool LspWorker::cancel(const std::string& key) {
    const std::scoped_lock lock(m_mutex);
    if (m_currentKey == key)
        m_current.request_stop();
    return m_waiting.erase(key) > 0;
}

void LspWorker::run(const std::stop_token& end) {
    std::unique_lock lock(m_mutex);
    while (!end.stop_requested()) {
        m_isNew = false;
        if (m_waiting.empty()) {
            m_changed.wait(lock, end, [this] { return m_isNew; });
            continue;
        }
        const auto first =
            std::ranges::min_element(m_waiting, {}, [](const auto& entry) { return entry.second.due; });
        if (const Clock::time_point due = first->second.due; Clock::now() < due) {
            m_changed.wait_until(lock, end, due, [this] { return m_isNew; });
            continue;
        }
        m_currentKey = first->first;
        m_current = std::stop_source();
        {
            const Work work = std::move(first->second.work);
            const std::stop_token stop = m_current.get_token();
            m_waiting.erase(first);
            lock.unlock();
            work(stop);
        } // what the work holds is released outside the lock
        lock.lock();
        m_currentKey.clear();
    }
}

} // namespace proveout::cli
