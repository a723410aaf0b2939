// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/activity_follower.h"

#include <algorithm>
#include <utility>

namespace proveout {

bool ActivityFollower::follow(const Frame* frame) {
    const std::uint64_t revision = m_log.revision();
    const std::uint64_t generation = frame != nullptr ? frame->generation : 0;
    if (std::exchange(m_generation, generation) != generation)
        m_log.clear();
    if (frame == nullptr)
        return m_log.revision() != revision;
    const auto& times = m_session.program().times();
    m_log.setTimes(times && times->program == frame->program ? times : nullptr);
    const std::size_t before = m_log.size();
    const std::size_t rows = std::min(frame->statistics.size(), frame->program->blockCount());
    m_log.append(*frame->program, frame->statistics, std::min(rows, before + kBlocksPerTick));
    if (m_log.size() < rows)
        m_session.playback().requestTick();
    return m_log.size() != before || m_log.revision() != revision;
}

} // namespace proveout
