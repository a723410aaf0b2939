// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/program/played_parameters.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/run/schedule.h"

namespace proveout {

void PlayedParameters::loaded(const DecimationParameters& wanted) {
    m_holdBack.reset();
    m_reported = wanted;
}

void PlayedParameters::restart(const DecimationParameters& wanted, const Frame* frame) {
    m_holdBack.reset();
    if (frame != nullptr && Schedule(wanted).repeats())
        m_holdBack.emplace(wanted.period, frame->surface.facesFull);
}

const HoldBack* PlayedParameters::held(bool playing) const {
    return playing && m_holdBack && m_holdBack->held() ? &*m_holdBack : nullptr;
}

std::optional<DecimationParameters> PlayedParameters::due(const DecimationParameters& wanted, bool playing) {
    DecimationParameters played = wanted;
    if (held(playing) != nullptr)
        played.method = DecimationMethod::none;
    if (played == m_reported)
        return std::nullopt;
    m_reported = played;
    return played;
}

void PlayedParameters::weigh(const Frame& frame, const FrameStatistics& row) {
    if (!m_holdBack || !frame.playing || !(frame.parameters == m_reported) || row.lastBlock != frame.block)
        return;
    if (std::isnan(row.decimationSeconds))
        return; // a jump is among its blocks
    FrameCost cost{row.decimationSeconds,
                   row.uploadSeconds,
                   row.drawSeconds,
                   frame.surface.faces,
                   frame.surface.facesFull,
                   0,
                   frame.surface.grid.regionCount()};
    const std::size_t end = std::min<std::size_t>(row.lastBlock, frame.statistics.size());
    for (std::size_t block = row.firstBlock; block < end; ++block)
        cost.regionsDecimated += frame.statistics[block].regionsDecimated;
    (void)m_holdBack->add(cost); // due() queries the result
}

} // namespace proveout
