// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace proveout {

/// What one frame of playback has cost, and what it showed. Value type.
struct FrameCost {
    double decimationSeconds = 0; ///< of the blocks that the frame stands for
    double uploadSeconds = 0;
    double drawSeconds = 0; ///< 0: nobody draws
    std::size_t facesShown = 0;
    std::size_t facesFull = 0;
    std::size_t regionsDecimated = 0; ///< in those seconds
    std::size_t regions = 0;          ///< of the whole map

    [[nodiscard]] double total() const { return decimationSeconds + uploadSeconds + drawSeconds; }
};

/// Decides whether playback decimates: not while that costs more than it saves (tiny maps, fast graphics).
/// From time to time the other way is tried for one window of frames, and taken where it is clearly cheaper;
/// the interval doubles while nothing changes, and a trial waits until its price is a hundredth of the time
/// played since the last one. Knows figures and counts of frames, no clock. One thread.
class HoldBack {
public:
    /// `period` of the schedule: a window of frames covers it. A map of few faces begins held back.
    HoldBack(int period, std::size_t facesFull);

    [[nodiscard]] bool held() const { return m_held; }
    /// Takes a frame that was made as held() says; true where held() is another one afterwards.
    bool add(const FrameCost& cost);
    /// Mean seconds of a frame (decimation, upload, drawing) one way, as last measured, or as bounded from
    /// above where decimation was given up without a trial; none where not known.
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
    bool m_turning = true; ///< the first frame after a turn pays for it, and stands for neither way
    Window m_window;
    std::array<std::optional<double>, 2> m_means; ///< decimating, held back
    double m_secondsPerRegion = 0;                ///< of decimation, as last measured; 0: not yet
    double m_wholeSeconds = 0;                    ///< of decimating every region, estimated
    std::size_t m_interval;                       ///< frames between trials
    std::size_t m_framesSince = 0;                ///< since the last trial or turn
    double m_secondsSince = 0;
};

} // namespace proveout
