// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>

namespace proveout {

/// How far playback should be by the wall clock. It owes nothing for time lost: a machine that cannot keep up
/// plays more slowly, it does not race afterwards. Value type.
class PlaybackClock {
public:
    using Time = std::chrono::steady_clock::time_point;

    /// Playback goes on from `block` at `now`; `blocksPerSecond` may be infinite.
    void start(std::size_t block, double blocksPerSecond, Time now);
    /// The block to be reached at `now`.
    [[nodiscard]] std::size_t due(Time now) const;
    /// Block `block` was reached at `now`. Where that is late by more than the wink of an eye, playback goes
    /// on from there: what was lost is not caught up.
    void reached(std::size_t block, Time now);
    /// When the block after `block` is due; at most a minute ahead of `now`.
    [[nodiscard]] Time next(std::size_t block, Time now) const;
    [[nodiscard]] double blocksPerSecond() const { return m_rate; }

private:
    Time m_start;
    double m_from = 0;
    double m_rate = 0;
};

} // namespace proveout
