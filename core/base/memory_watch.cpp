// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/memory_watch.h"

#include <new>
#include <utility>

namespace proveout {

namespace {

/// What must stay available, for what the work allocates between two looks.
constexpr std::uint64_t kReserve = 32'000'000;

} // namespace

MemoryWatch::MemoryWatch(std::uint64_t mostBytes, MemorySources sources, std::chrono::milliseconds between,
                         IsCause isCause)
    : m_most(mostBytes), m_sources(std::move(sources)), m_between(between), m_isCause(std::move(isCause)),
      m_thread([this](const std::stop_token& end) { watch(end); }) {
    look();
}

MemoryWatch::~MemoryWatch() = default;

void MemoryWatch::watch(const std::stop_token& end) {
    std::unique_lock lock(m_mutex);
    while (!end.stop_requested() && !exceeded()) {
        m_ended.wait_for(lock, end, m_between, [] { return false; });
        if (!end.stop_requested() && isTooMuch())
            m_work.request_stop();
    }
}

void MemoryWatch::look() {
    if (isTooMuch())
        m_work.request_stop();
}

bool MemoryWatch::isTooMuch() const {
    try {
        if (residentMemoryBytes(m_sources) > m_most && (!m_isCause || m_isCause()))
            return true;
        return machineMemoryBytes(m_sources) < kReserve;
    } catch (const std::bad_alloc&) {
        return true;
    }
}

} // namespace proveout
