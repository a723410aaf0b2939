// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/thread/playback_clock.h"

#include <algorithm>
#include <cmath>

namespace proveout {

namespace {

constexpr double kFarSeconds = 60;
/// Longer than the slices in which playback works, so that it keeps its rate in the long run.
constexpr double kOwedSeconds = 0.05;
/// Lost time is measured in windows of this length.
constexpr double kWindowSeconds = 0.7;

double secondsBetween(PlaybackClock::Time from, PlaybackClock::Time to) {
    return std::chrono::duration<double>(to - from).count();
}

} // namespace

double PlaybackClock::at(std::size_t block) const {
    const auto blocks = static_cast<double>(block);
    if (!m_measure)
        return blocks;
    const std::size_t last = m_measure->size() - 1;
    if (block <= last)
        return (*m_measure)[block];
    const double mean = last > 0 ? m_measure->back() / static_cast<double>(last) : 0;
    return m_measure->back() + mean * (blocks - static_cast<double>(last));
}

double PlaybackClock::dueAt(Time now) const {
    return m_from + std::max(secondsBetween(m_start, now), 0.0) * m_rate;
}

void PlaybackClock::start(std::size_t block, double unitsPerSecond, Time now) {
    m_rate = unitsPerSecond > 0 ? unitsPerSecond : 0; // not a number counts as zero
    m_windowStart = now;
    m_lost = 0;
    m_keptPart = 1;
    resume(block, now);
}

void PlaybackClock::resume(std::size_t block, Time now) {
    m_start = now;
    m_from = at(block);
}

bool PlaybackClock::isDue(std::size_t block, Time now) const {
    return std::isinf(m_rate) || (m_rate > 0 && at(block + 1) <= dueAt(now));
}

void PlaybackClock::reached(std::size_t block, Time now) {
    if (std::isinf(m_rate) || m_rate == 0)
        return;
    const double late = (dueAt(now) - at(block + 1)) / m_rate;
    if (late > kOwedSeconds) {
        m_lost += (dueAt(now) - at(block)) / m_rate;
        resume(block, now);
    }
    const double window = secondsBetween(m_windowStart, now);
    if (window >= kWindowSeconds) {
        m_keptPart = std::max(1 - m_lost / window, 0.001);
        m_windowStart = now;
        m_lost = 0;
    }
}

PlaybackClock::Time PlaybackClock::next(std::size_t block, Time now) const {
    double sinceNow = kFarSeconds;
    if (std::isinf(m_rate))
        sinceNow = 0;
    else if (m_rate > 0)
        sinceNow = (at(block + 1) - m_from) / m_rate - secondsBetween(m_start, now);
    return now + std::chrono::duration_cast<Time::duration>(
                     std::chrono::duration<double>(std::clamp(sinceNow, 0.0, kFarSeconds)));
}

} // namespace proveout
