// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace proveout {

/// The position of the end of each block on the scale of playback: millimetres of path or seconds of the
/// machine. [n]: after n blocks; rising, at least one value.
using PlaybackMeasure = std::vector<double>;

/// How far playback should be according to the wall clock. Lost time is not made up for: a machine that
/// cannot keep up plays more slowly, and does not speed up afterwards. Value type.
class PlaybackClock {
public:
    using Time = std::chrono::steady_clock::time_point;

    /// Playback advances by blocks (null), or by a measure. Blocks after the end of the measure take as long
    /// as the mean of the others: a program that is being edited is measured a moment later.
    void setMeasure(std::shared_ptr<const PlaybackMeasure> measure) { m_measure = std::move(measure); }
    /// Playback continues from `block` at `now`; `unitsPerSecond`, in blocks or those of the measure, may be
    /// infinite.
    void start(std::size_t block, double unitsPerSecond, Time now);
    /// Whether the block after `block` is to be executed at `now`.
    [[nodiscard]] bool isDue(std::size_t block, Time now) const;
    /// Block `block` was reached at `now`. If that is noticeably late, playback continues from there: lost
    /// time is not made up for.
    void reached(std::size_t block, Time now);
    /// When the block after `block` is due; at most a minute ahead of `now`.
    [[nodiscard]] Time next(std::size_t block, Time now) const;
    [[nodiscard]] double unitsPerSecond() const { return m_rate; }
    /// The fraction of the speed that was achieved in about the last second, in (0, 1]: 1 if no time was
    /// lost.
    [[nodiscard]] double keptPart() const { return m_keptPart; }

private:
    [[nodiscard]] double at(std::size_t block) const;
    [[nodiscard]] double dueAt(Time now) const;
    void resume(std::size_t block, Time now);

    std::shared_ptr<const PlaybackMeasure> m_measure;
    Time m_start;
    double m_from = 0;
    double m_rate = 0;
    Time m_windowStart;
    double m_lost = 0; ///< seconds in the present window
    double m_keptPart = 1;
};

} // namespace proveout
