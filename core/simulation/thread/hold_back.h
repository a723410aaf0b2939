// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace proveout {

/// The cost of one frame of playback, and what it showed. Value type.
struct FrameCost {
    double decimationSeconds = 0; ///< for the blocks that the frame covers
    double uploadSeconds = 0;
    double drawSeconds = 0; ///< 0: nothing is drawn
    std::size_t facesShown = 0;
    std::size_t facesFull = 0;
    std::size_t regionsDecimated = 0; ///< in those seconds
    std::size_t regions = 0;          ///< of the whole map

    [[nodiscard]] double total() const { return decimationSeconds + uploadSeconds + drawSeconds; }
};

/// Decides whether playback decimates: not while that costs more than it saves (tiny maps, fast graphics).
/// From time to time the other mode is tried for one window of frames, and adopted if it is clearly cheaper;
/// the interval doubles while nothing changes, and a trial waits until its cost is a hundredth of the time
/// played since the last one. It depends on measured figures and counts of frames, not on a clock. One
/// thread.
class HoldBack {
public:
    /// `period` of the schedule: a window of frames covers it. A map with few faces begins without
    /// decimation.
    HoldBack(int period, std::size_t facesFull);

    [[nodiscard]] bool held() const { return m_held; }
    /// Adds a frame that was made in the mode of held(); true if held() has changed afterwards.
    bool add(const FrameCost& cost);
    /// Mean seconds of a frame (decimation, upload, drawing) in one mode, as last measured, or an upper bound
    /// if decimation was given up without a trial; nothing if unknown.
    [[nodiscard]] std::optional<double> frameSeconds(bool held) const { return m_means[held ? 1 : 0]; }

private:
    /// Sums over the frames of the present window.
    struct Window {
        std::size_t frames = 0;
        FrameCost sum;
    };

    bool closeWindow();
    [[nodiscard]] bool cannotPay() const;
    [[nodiscard]] bool cheaperThan(bool other) const;
    [[nodiscard]] bool isTrialDue() const;
    void turn();

    std::size_t m_windowFrames;
    bool m_held;
    bool m_trial = false;
    bool m_turning = true; ///< the first frame after a switch pays for it, and counts for neither mode
    Window m_window;
    std::array<std::optional<double>, 2> m_means; ///< with and without decimation
    double m_secondsPerRegion = 0;                ///< of decimation, as last measured; 0: not measured yet
    double m_wholeSeconds = 0;                    ///< of decimating every region, estimated
    std::size_t m_interval;                       ///< frames between trials
    std::size_t m_framesSince = 0;                ///< since the last trial or switch
    double m_secondsSince = 0;
};

} // namespace proveout
