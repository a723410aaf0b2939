// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/simulation/run/frame.h"
#include "core/simulation/run/statistics.h"
#include "core/simulation/thread/hold_back.h"

namespace proveout {

/// The parameters that are sent to the simulation: those that the user wants or, while playback suspends
/// decimation, method `none`. This keeps the simulation's state a function of its input only; no timing
/// decides anything inside it. Thread: the UI thread.
class PlayedParameters {
public:
    /// The simulation was loaded with these parameters; measurements of another z-map or program are
    /// discarded.
    void loaded(const DecimationParameters& wanted);
    /// Restarts the measurement with other parameters, on the z-map of `frame`; null: there is no frame yet.
    void restart(const DecimationParameters& wanted, const Frame* frame);
    [[nodiscard]] bool isWeighing() const { return m_holdBack.has_value(); }
    /// The measurements if playback suspends decimation, otherwise null.
    [[nodiscard]] const HoldBack* held(bool playing) const;
    /// The parameters to send to the simulation; empty if they were sent last time.
    [[nodiscard]] std::optional<DecimationParameters> due(const DecimationParameters& wanted, bool playing);
    /// A frame was drawn during playback, at the cost in `row`. Frames that were computed with other
    /// parameters than those last sent are ignored.
    void weigh(const Frame& frame, const FrameStatistics& row);

private:
    std::optional<HoldBack> m_holdBack; ///< for the current z-map and parameters
    DecimationParameters m_reported;
};

} // namespace proveout
