// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/playback_clock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

constexpr double kFarBlocks = 1e15;
constexpr double kFarSeconds = 60;

} // namespace

void PlaybackClock::start(std::size_t block, double blocksPerSecond, Time now) {
    m_start = now;
    m_from = static_cast<double>(block);
    m_rate = blocksPerSecond > 0 ? blocksPerSecond : 0; // not a number counts as standing still
}

std::size_t PlaybackClock::due(Time now) const {
    if (std::isinf(m_rate))
        return std::numeric_limits<std::size_t>::max();
    const double seconds = std::chrono::duration<double>(now - m_start).count();
    return static_cast<std::size_t>(std::min(m_from + std::max(seconds, 0.0) * m_rate, kFarBlocks));
}

void PlaybackClock::reached(std::size_t block, Time now) {
    // The slices in which playback works are shorter, so that it keeps its rate in the long run.
    constexpr double kOwedSeconds = 0.05;
    const double blocksLate = static_cast<double>(due(now)) - static_cast<double>(block);
    if (blocksLate > 1 && blocksLate > kOwedSeconds * m_rate)
        start(block, m_rate, now);
}

PlaybackClock::Time PlaybackClock::next(std::size_t block, Time now) const {
    const double blocks = static_cast<double>(block) + 1 - m_from;
    const double sinceNow =
        m_rate > 0 ? blocks / m_rate - std::chrono::duration<double>(now - m_start).count() : kFarSeconds;
    return now + std::chrono::duration_cast<Time::duration>(
                     std::chrono::duration<double>(std::clamp(sinceNow, 0.0, kFarSeconds)));
}

} // namespace proveout
