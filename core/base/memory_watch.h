// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include "core/base/memory.h"

namespace proveout {

/// Stops long work whose memory is only known once it is done, before it takes more than it may. Looks when
/// it is constructed and then every few milliseconds, in a thread of its own, until its destruction; so the
/// work may exceed the limit by what it allocates in that time. Any thread may ask it.
class MemoryWatch {
public:
    /// Whether the work, and not another one in the same process, takes too much; asked in any thread.
    using IsCause = std::function<bool()>;

    /// `mostBytes`: the resident size that the process may reach, for which the work counts as the cause if
    /// nothing else is known; less if the machine has less available.
    explicit MemoryWatch(std::uint64_t mostBytes, MemorySources sources = {},
                         std::chrono::milliseconds between = kUsuallyBetween, IsCause isCause = {});
    MemoryWatch(std::uint64_t mostBytes, IsCause isCause)
        : MemoryWatch(mostBytes, {}, kUsuallyBetween, std::move(isCause)) {}
    ~MemoryWatch();
    MemoryWatch(const MemoryWatch&) = delete;
    MemoryWatch& operator=(const MemoryWatch&) = delete;

    /// For the work; stopped when the limit is exceeded.
    [[nodiscard]] std::stop_token stop() const { return m_work.get_token(); }
    [[nodiscard]] bool exceeded() const { return m_work.stop_requested(); }
    /// Looks now: work that is done before the next look is judged all the same.
    void look();

private:
    static constexpr std::chrono::milliseconds kUsuallyBetween{10};

    void watch(const std::stop_token& end);
    [[nodiscard]] bool isTooMuch() const;

    std::uint64_t m_most;
    MemorySources m_sources;
    std::chrono::milliseconds m_between; ///< two looks
    IsCause m_isCause;
    std::stop_source m_work;
    std::mutex m_mutex;
    std::condition_variable_any m_ended;
    std::jthread m_thread; ///< last, so that it ends before what it uses
};

} // namespace proveout
