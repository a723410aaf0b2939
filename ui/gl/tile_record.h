// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/zmap/zmap.h"

namespace proveout {

/// The tiles of a z-map that have been uploaded.
class TileRecord {
public:
    /// None of `count` tiles is uploaded.
    void reset(std::size_t count);
    void set(std::size_t index, const ZMapSnapshot& moment);
    /// Null: not uploaded yet.
    [[nodiscard]] const std::shared_ptr<const Tile>& tile(std::size_t index) const { return m_tiles[index]; }
    /// The lowest point of a tile, and no less than the highest; relative to the stock's top.
    [[nodiscard]] float lowest(std::size_t index) const { return m_lowest[index]; }
    [[nodiscard]] float highest(std::size_t index) const { return m_tiles[index]->maximum; }
    /// Whether any point is on the floor of the stock, so that the surface may have holes.
    [[nodiscard]] bool touchesFloor() const { return m_tilesOnFloor > 0; }

private:
    std::vector<std::shared_ptr<const Tile>> m_tiles;
    std::vector<float> m_lowest; ///< per tile
    std::size_t m_tilesOnFloor = 0;
};

} // namespace proveout
