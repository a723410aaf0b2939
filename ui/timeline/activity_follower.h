// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simulation/records/activity_log.h"
#include "ui/session/session.h"

namespace proveout {

/// Keeps a log of the activity in the session's program and updates it by a limited number of blocks per
/// tick, because a million rows at once would block the window. Thread: the UI thread.
class ActivityFollower {
public:
    static constexpr std::size_t kBlocksPerTick = std::size_t{1} << 17;

    explicit ActivityFollower(Session& session) : m_session(session) {}
    [[nodiscard]] const ActivityLog& log() const { return m_log; }
    /// Adds what is new in a frame, which may be null; requests another tick if there is more to add. Returns
    /// whether the log has changed.
    bool follow(const Frame* frame);

private:
    Session& m_session;
    ActivityLog m_log;
    std::uint64_t m_generation = 0; ///< of the frames in the log: within a generation, rows of executed
                                    ///< blocks do not change
};

} // namespace proveout
