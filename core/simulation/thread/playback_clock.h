// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace proveout {

/// Where each block ends on the way that playback takes: millimetres of path, seconds of the machine. [n]:
/// after n blocks; rising, at least one value.
using PlaybackMeasure = std::vector<double>;

/// How far playback should be by the wall clock. It owes nothing for time lost: a machine that cannot keep up
/// plays more slowly, it does not race afterwards. Value type.
class PlaybackClock {
public:
    using Time = std::chrono::steady_clock::time_point;

    /// Playback goes by blocks (null), or by a measure. Blocks behind its end take as long as the mean of the
    /// others: a program that is being edited is measured a moment later.
    void setMeasure(std::shared_ptr<const PlaybackMeasure> measure) { m_measure = std::move(measure); }
    /// Playback goes on from `block` at `now`; `unitsPerSecond`, blocks or those of the measure, may be
    /// infinite.
    void start(std::size_t block, double unitsPerSecond, Time now);
    /// Whether the block behind `block` is to be executed at `now`.
    [[nodiscard]] bool isDue(std::size_t block, Time now) const;
    /// Block `block` was reached at `now`. Where that is late by more than the wink of an eye, playback goes
    /// on from there: what was lost is not caught up.
    void reached(std::size_t block, Time now);
    /// When the block after `block` is due; at most a minute ahead of `now`.
    [[nodiscard]] Time next(std::size_t block, Time now) const;
    [[nodiscard]] double unitsPerSecond() const { return m_rate; }
    /// Which part of the speed was kept in the last second or so, in (0, 1]: 1 where nothing was lost.
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
