// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simulation/records/activity_log.h"
#include "ui/session/session.h"

namespace proveout {

/// Keeps a log of what the session's program does, a bounded number of blocks a tick: a million rows at once
/// would stop the window. Thread: the UI thread.
class ActivityFollower {
public:
    static constexpr std::size_t kBlocksPerTick = std::size_t{1} << 17;

    explicit ActivityFollower(Session& session) : m_session(session) {}
    [[nodiscard]] const ActivityLog& log() const { return m_log; }
    /// Takes over what is new in a frame, which may be null; asks for another tick where more is to come.
    /// Whether the log changed.
    bool follow(const Frame* frame);

private:
    Session& m_session;
    ActivityLog m_log;
    std::uint64_t m_generation = 0; ///< of the frames in the log: within one, rows of executed blocks stay
};

} // namespace proveout
