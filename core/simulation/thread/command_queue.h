// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>

#include "core/simulation/thread/simulation_thread.h"

namespace proveout {

/// Commands on their way to the simulation thread, and the request to stop its current work. A command
/// replaces the previous one if it makes that one unnecessary; every command stops the work in progress. Any
/// thread may post; one thread takes commands out.
class CommandQueue {
public:
    using Time = std::chrono::steady_clock::time_point;

    void post(SimulationCommand command);
    /// Stops the work in progress, or that which follows from the commands posted before; does nothing if the
    /// thread is idle.
    void cancel();
    /// Stops the work and ends every wait, now and later.
    void close();
    /// The frame with this number is on the screen.
    void frameShown(std::uint64_t sequence);

    [[nodiscard]] bool closed() const;
    /// The next command, if there is one.
    [[nodiscard]] std::optional<SimulationCommand> take();

    /// The stop token of work that begins now; it is stopped from the start if a command is waiting.
    /// `patient` work is not stopped by seeks and steps, so that a picture can appear even under many of
    /// them.
    [[nodiscard]] std::stop_token beginWork(bool patient);
    /// True if the work was cancelled.
    bool endWork();

    /// Call it when the thread has nothing left to do: waits until a command comes.
    void wait();
    void waitUntil(Time time);
    /// Waits until frame `sequence` was shown, or until a cancel.
    void waitForShown(std::uint64_t sequence);

private:
    [[nodiscard]] bool awake() const { return m_closed || !m_commands.empty(); }

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<SimulationCommand> m_commands;
    std::stop_source m_work;
    std::uint64_t m_shown = 0;
    bool m_busy = false; ///< from a command on until the thread has nothing left to do
    bool m_working = false;
    bool m_patient = false;
    bool m_cancelled = false;
    bool m_closed = false;
};

} // namespace proveout
