// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/checkpoints.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <limits>
#include <utility>

namespace proveout {

namespace {

/// More than this many checkpoints make neither seeking better nor thinning cheaper.
constexpr std::size_t kMostCheckpoints = 2000;

std::size_t unsharedBytes(const ZMapSnapshot& before, const ZMapSnapshot& after) {
    // The array of tile pointers is shared by chunks; counting it whole errs on the safe side.
    std::size_t bytes = after.tileCount() * sizeof(std::shared_ptr<const Tile>);
    for (std::size_t tile = 0; tile < after.tileCount(); ++tile)
        if (before.tileCount() == 0 || before.tile(tile) != after.tile(tile))
            bytes += sizeof(Tile);
    return bytes;
}

} // namespace

void Checkpoints::restart(Checkpoint first) {
    assert(first.block == 0);
    m_checkpoints.clear();
    m_bytes = 0;
    m_checkpoints.push_back(std::move(first));
    recount(0);
}

void Checkpoints::add(Checkpoint checkpoint) {
    const auto place = std::ranges::lower_bound(m_checkpoints, checkpoint.block, {}, &Checkpoint::block);
    if (place != m_checkpoints.end() && place->block == checkpoint.block)
        return;
    const auto index = static_cast<std::size_t>(std::distance(m_checkpoints.begin(), place));
    checkpoint.bytes = 0;
    m_checkpoints.insert(place, std::move(checkpoint));
    recount(index);
    recount(index + 1);
    thin();
}

void Checkpoints::truncate(std::size_t block) {
    while (m_checkpoints.size() > 1 && m_checkpoints.back().block > block) {
        m_bytes -= m_checkpoints.back().bytes;
        m_checkpoints.pop_back();
    }
}

void Checkpoints::setBudget(std::size_t bytes) {
    m_budget = bytes;
    thin();
}

const Checkpoint& Checkpoints::before(std::size_t block) const {
    const auto after = std::ranges::upper_bound(m_checkpoints, block, {}, &Checkpoint::block);
    assert(after != m_checkpoints.begin());
    return *std::prev(after);
}

void Checkpoints::recount(std::size_t index) {
    if (index >= m_checkpoints.size())
        return;
    Checkpoint& checkpoint = m_checkpoints[index];
    m_bytes -= checkpoint.bytes;
    checkpoint.bytes =
        unsharedBytes(index == 0 ? ZMapSnapshot() : m_checkpoints[index - 1].zmap, checkpoint.zmap);
    m_bytes += checkpoint.bytes;
}

void Checkpoints::thin() {
    while (m_checkpoints.size() > 1 && (m_bytes > m_budget || m_checkpoints.size() > kMostCheckpoints)) {
        std::size_t victim = m_checkpoints.size() - 1;
        double shortest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 1; k + 1 < m_checkpoints.size(); ++k) {
            const double gap = m_checkpoints[k + 1].cutSeconds - m_checkpoints[k - 1].cutSeconds;
            if (gap < shortest) {
                shortest = gap;
                victim = k;
            }
        }
        m_bytes -= m_checkpoints[victim].bytes;
        m_checkpoints.erase(m_checkpoints.begin() + static_cast<std::ptrdiff_t>(victim));
        recount(victim);
    }
}

} // namespace proveout
