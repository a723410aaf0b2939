// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/thread/command_queue.h"

#include <algorithm>
#include <utility>

namespace proveout {

namespace {

template<class Kind>
bool is(const SimulationCommand& command) {
    return std::holds_alternative<Kind>(command);
}

bool supersedes(const SimulationCommand& newer, const SimulationCommand& older) {
    return newer.index() == older.index() && !is<StepCommand>(newer);
}

} // namespace

void CommandQueue::post(SimulationCommand command) {
    const std::scoped_lock lock(m_mutex);
    if (!m_patient || !(is<SeekCommand>(command) || is<StepCommand>(command)))
        m_work.request_stop();
    // A cancel applies to the commands before it; work in progress still reports it at its end.
    if (!m_working)
        m_cancelled = false;
    if (is<LoadCommand>(command))
        m_commands.clear();
    if (!m_commands.empty() && supersedes(command, m_commands.back()))
        m_commands.back() = std::move(command);
    else
        m_commands.push_back(std::move(command));
    m_changed.notify_all();
}

void CommandQueue::cancel() {
    const std::scoped_lock lock(m_mutex);
    m_cancelled = m_busy || !m_commands.empty();
    m_work.request_stop();
    m_changed.notify_all();
}

void CommandQueue::close() {
    const std::scoped_lock lock(m_mutex);
    m_closed = true;
    m_work.request_stop();
    m_changed.notify_all();
}

void CommandQueue::frameShown(std::uint64_t sequence) {
    const std::scoped_lock lock(m_mutex);
    m_shown = std::max(m_shown, sequence);
    m_changed.notify_all();
}

bool CommandQueue::closed() const {
    const std::scoped_lock lock(m_mutex);
    return m_closed;
}

std::optional<SimulationCommand> CommandQueue::take() {
    std::optional<SimulationCommand> command;
    const std::scoped_lock lock(m_mutex);
    if (!m_commands.empty()) {
        command.emplace(std::move(m_commands.front()));
        m_commands.pop_front();
        m_busy = true;
    }
    return command;
}

std::stop_token CommandQueue::beginWork(bool patient) {
    const std::scoped_lock lock(m_mutex);
    m_work = std::stop_source();
    m_working = true;
    m_patient = patient;
    if (awake() || m_cancelled)
        m_work.request_stop();
    return m_work.get_token();
}

bool CommandQueue::endWork() {
    const std::scoped_lock lock(m_mutex);
    m_working = false;
    m_patient = false;
    return std::exchange(m_cancelled, false);
}

void CommandQueue::wait() {
    std::unique_lock lock(m_mutex);
    if (awake())
        return; // a command came after the thread had checked, and perhaps a cancel of it
    m_busy = false;
    m_cancelled = false;
    m_changed.wait(lock, [this] { return awake(); });
}

void CommandQueue::waitUntil(Time time) {
    std::unique_lock lock(m_mutex);
    m_changed.wait_until(lock, time, [this] { return awake() || m_cancelled; });
}

void CommandQueue::waitForShown(std::uint64_t sequence) {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [&] { return awake() || m_cancelled || m_shown >= sequence; });
}

} // namespace proveout
