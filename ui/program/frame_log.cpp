// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/program/frame_log.h"

#include <algorithm>
#include <utility>

namespace proveout {

namespace {

/// The sums over the blocks (first, frame.block].
FrameStatistics rowOf(const Frame& frame, std::size_t first) {
    FrameStatistics row;
    row.firstBlock = static_cast<std::uint32_t>(first);
    row.lastBlock = static_cast<std::uint32_t>(frame.block);
    const std::size_t end = std::min(frame.block, frame.statistics.size());
    for (std::size_t k = first; k < end; ++k) {
        row.cutSeconds += frame.statistics[k].cutSeconds;
        row.decimationSeconds += frame.statistics[k].decimationSeconds;
    }
    return row;
}

} // namespace

FrameStatistics partOf(const FrameStatistics& row, std::uint32_t first, std::uint32_t last) {
    const float share = static_cast<float>(last - first) / static_cast<float>(row.lastBlock - row.firstBlock);
    return {first,
            last,
            share * row.cutSeconds,
            share * row.decimationSeconds,
            share * row.uploadSeconds,
            share * row.drawSeconds};
}

void FrameLog::clear() {
    m_rows.clear();
    m_drawnBlock = 0;
}

bool FrameLog::add(const Frame& frame, double uploadSeconds, double drawSeconds) {
    if (frame.sequence == m_drawnSequence)
        return false;
    m_drawnSequence = frame.sequence;
    while (!m_rows.empty() && m_rows.back().firstBlock >= frame.block)
        m_rows.pop_back();
    if (!m_rows.empty() && m_rows.back().lastBlock > frame.block)
        m_rows.back() =
            partOf(m_rows.back(), m_rows.back().firstBlock, static_cast<std::uint32_t>(frame.block));
    const std::size_t drawnBefore = std::exchange(m_drawnBlock, frame.block);
    if (frame.block <= drawnBefore)
        return true;
    FrameStatistics row = rowOf(frame, drawnBefore);
    row.uploadSeconds = static_cast<float>(uploadSeconds);
    row.drawSeconds = static_cast<float>(drawSeconds);
    m_rows.push_back(row);
    return true;
}

} // namespace proveout
