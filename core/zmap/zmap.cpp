// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/zmap.h"

#include <algorithm>
#include <map>
#include <utility>

namespace proveout {

namespace {

/// Points of the tile that are in the grid are uncut; those outside hold the floor.
std::shared_ptr<const Tile> uncutTile(int width, int height, float floor) {
    auto tile = std::make_shared<Tile>();
    tile->heights.fill(floor);
    for (int j = 0; j < height; ++j)
        std::fill_n(&tile->at(0, j), width, 0.0F);
    tile->maximum = 0;
    return tile;
}

} // namespace

ZMap::ZMap(const StockBox& stock, const Grid& grid) : m_stock(stock), m_grid(grid) {
    const std::size_t count = static_cast<std::size_t>(tilesX()) * static_cast<std::size_t>(tilesY());
    m_writtenIn.assign(count, 0);
    // One tile for all that are alike, which takes memory only where it is cut.
    std::map<std::pair<int, int>, std::shared_ptr<const Tile>> uncut;
    for (std::size_t index = 0; index < count; ++index) {
        const IndexRect rect = tileRect(index);
        std::shared_ptr<const Tile>& tile = uncut[{rect.width(), rect.height()}];
        if (!tile)
            tile = uncutTile(rect.width(), rect.height(), floor());
        m_tiles.push_back(tile);
    }
}

ZMap::ZMap(const ZMapSnapshot& moment)
    : m_stock(moment.stock()), m_grid(moment.grid()), m_tiles(moment.m_tiles),
      m_writtenIn(moment.tileCount(), 0) {}

IndexRect ZMap::tileRect(std::size_t index) const {
    return tileRectOf(m_grid, index);
}

Tile* ZMap::ownedTile(std::size_t index) {
    // Every tile was created here as a mutable object, so the cast is valid; const protects what snapshots
    // share.
    return m_writtenIn[index] == m_generation ? const_cast<Tile*>(m_tiles[index].get()) : nullptr;
}

Tile& ZMap::tileForWriting(std::size_t index) {
    if (Tile* owned = ownedTile(index))
        return *owned;
    auto copy = std::make_shared<Tile>(*m_tiles[index]);
    Tile& tile = *copy;
    adoptTile(index, std::move(copy));
    return tile;
}

void ZMap::adoptTile(std::size_t index, std::shared_ptr<Tile> tile) {
    m_tiles.edit(index) = std::move(tile);
    m_writtenIn[index] = m_generation;
}

ZMapSnapshot ZMap::snapshot() const {
    ++m_generation;
    return {m_stock, m_grid, m_tiles};
}

} // namespace proveout
