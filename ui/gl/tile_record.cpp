// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/tile_record.h"

#include <algorithm>

namespace proveout {

void TileRecord::reset(std::size_t count) {
    m_tiles.assign(count, nullptr);
    m_lowest.assign(count, 0);
    m_tilesOnFloor = 0;
}

void TileRecord::set(std::size_t index, const ZMapSnapshot& moment) {
    m_tiles[index] = moment.tile(index);
    const IndexRect rect = moment.tileRect(index);
    float lowest = 0;
    for (int j = 0; j < rect.height(); ++j) {
        const float* row = m_tiles[index]->heights.data() + static_cast<std::ptrdiff_t>(j) * Tile::kSize;
        lowest = std::min(lowest, *std::min_element(row, row + rect.width()));
    }
    const float floor = moment.floor();
    m_tilesOnFloor += lowest <= floor ? 1 : 0;
    m_tilesOnFloor -= m_lowest[index] <= floor ? 1 : 0;
    m_lowest[index] = lowest;
}

} // namespace proveout
