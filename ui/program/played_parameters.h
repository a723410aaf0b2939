// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/simulation/run/frame.h"
#include "core/simulation/run/statistics.h"
#include "core/simulation/thread/hold_back.h"

namespace proveout {

/// What the simulation is told of the parameters: those that the user wants or, while playback holds
/// decimation back, method `none`. So the simulation's state stays a function of what it is told, and the
/// clock decides nothing inside it. Thread: the UI thread.
class PlayedParameters {
public:
    /// The simulation was loaded with these; what was measured of another map or program is forgotten.
    void loaded(const DecimationParameters& wanted);
    /// Weighing begins anew with other parameters, on the map of `frame`; null: no frame of it is there yet.
    void restart(const DecimationParameters& wanted, const Frame* frame);
    [[nodiscard]] bool isWeighing() const { return m_holdBack.has_value(); }
    /// The figures where playback holds back; null where it does not.
    [[nodiscard]] const HoldBack* held(bool playing) const;
    /// What the simulation is to be told; nothing where it was told that last.
    [[nodiscard]] std::optional<DecimationParameters> due(const DecimationParameters& wanted, bool playing);
    /// A frame was drawn in playback, at the cost of `row`. Frames made otherwise than the simulation was
    /// told last are left out.
    void weigh(const Frame& frame, const FrameStatistics& row);

private:
    std::optional<HoldBack> m_holdBack; ///< for the present map and parameters
    DecimationParameters m_reported;
};

} // namespace proveout
