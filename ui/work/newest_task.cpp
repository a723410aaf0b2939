// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/work/newest_task.h"

#include <utility>

namespace proveout {

NewestTask::NewestTask(QObject* parent)
    : QObject(parent), m_thread([this](const std::stop_token& stop) { run(stop); }) {}

NewestTask::~NewestTask() {
    m_current.request_stop();
    m_thread.request_stop();
    m_thread.join();
}

void NewestTask::start(Task task) {
    cancel();
    {
        const std::scoped_lock lock(m_mutex);
        m_waiting = Request{std::move(task), m_generation, m_current.get_token()};
    }
    m_wake.notify_one();
}

void NewestTask::cancel() {
    m_current.request_stop();
    m_current = std::stop_source();
    ++m_generation;
    const std::scoped_lock lock(m_mutex);
    m_waiting.reset();
}

void NewestTask::run(const std::stop_token& stop) {
    while (true) {
        Request request;
        {
            std::unique_lock lock(m_mutex);
            if (!m_wake.wait(lock, stop, [this] { return m_waiting.has_value(); }))
                return;
            request = std::move(*m_waiting);
            m_waiting.reset();
        }
        const auto post = [this, generation = request.generation](std::function<void()> report) {
            m_replies.post([this, generation, report = std::move(report)] {
                if (generation == m_generation)
                    report();
            });
        };
        request.task({request.stop, post});
    }
}

} // namespace proveout
