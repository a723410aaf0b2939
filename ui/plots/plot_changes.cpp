// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_changes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "core/base/array_difference.h"
#include "ui/program/frame_log.h"

namespace proveout {
namespace {

/// Bit for bit, because a value that was not measured, a NaN, equals itself here.
template<class Row>
bool same(const Row& a, const Row& b) {
    using Bits = std::array<std::uint32_t, sizeof(Row) / sizeof(std::uint32_t)>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

std::size_t firstDifference(const std::vector<FrameStatistics>& a, const std::vector<FrameStatistics>& b) {
    const std::size_t common = std::min(a.size(), b.size());
    std::size_t row = 0;
    while (row < common && same(a[row], b[row]))
        ++row;
    return row;
}

} // namespace

PlotHistory::Changes PlotHistory::update(const PersistentArray<BlockStatistics>& blocks,
                                         const std::vector<FrameStatistics>& frames, bool playing) {
    Changes changes;
    const auto different = difference(blocks, m_blocks, same<BlockStatistics>);
    changes.blocks = {different.first, different.end};
    changes.any = m_forgotten || !changes.blocks.empty();
    m_blocks = blocks;

    if (m_forgotten)
        changes.pictured = {0, blocks.size()};
    changes.firstFrame = std::exchange(m_forgotten, false) ? 0 : m_frames.size();
    const std::size_t known = firstDifference(frames, m_session);
    m_session.resize(known);
    m_session.insert(m_session.end(), frames.begin() + static_cast<std::ptrdiff_t>(known), frames.end());
    for (std::size_t row = known; row < frames.size(); ++row)
        add(frames[row], playing, changes);
    return changes;
}

void PlotHistory::add(const FrameStatistics& row, bool playing, Changes& changes) {
    if (!playing && !m_frames.empty() && row.lastBlock <= m_frames.back().lastBlock)
        return; // A seek to blocks that have been measured already.
    // Rows are ascending and do not overlap: a row that overlaps the new one keeps only its other blocks.
    const auto from = std::ranges::upper_bound(m_frames, row.firstBlock, {}, &FrameStatistics::lastBlock);
    auto to = from;
    while (to != m_frames.end() && to->firstBlock < row.lastBlock)
        ++to;
    changes.pictured.include({row.firstBlock, row.lastBlock});
    if (from != to)
        changes.pictured.include({from->firstBlock, (to - 1)->lastBlock});
    std::vector<FrameStatistics> instead;
    if (from != to && from->firstBlock < row.firstBlock)
        instead.push_back(partOf(*from, from->firstBlock, row.firstBlock));
    instead.push_back(row);
    if (from != to && (to - 1)->lastBlock > row.lastBlock)
        instead.push_back(partOf(*(to - 1), row.lastBlock, (to - 1)->lastBlock));
    const auto place = m_frames.insert(m_frames.erase(from, to), instead.begin(), instead.end());
    changes.firstFrame = std::min(changes.firstFrame, static_cast<std::size_t>(place - m_frames.begin()));
    changes.any = true;
}

void PlotHistory::forgetFrames() {
    m_forgotten = m_forgotten || !m_frames.empty();
    m_frames.clear();
    m_session.clear();
}

} // namespace proveout
