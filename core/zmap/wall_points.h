// SPDX-License-Identifier: GPL-3.0-or-later
// Points of a z-map beside walls, moved to where the walls stand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/index_rect.h"
#include "core/base/persistent_array.h"
#include "core/zmap/rims.h"

namespace proveout {

class ZMapSnapshot;

/// A point beside a wall. A mesh whose vertices are points of the grid draws it on the wall: the points above
/// and below a wall then meet in one line, so that the wall is vertical and stands where the cutter left it.
/// Beside a wall that is not vertical, the points of its levels are drawn on its creases, and the nearest
/// ones of its slope, which stay where they are, belong to them.
struct WallPoint {
    std::uint16_t point; ///< within its tile: row · 64 + column
    bool isUpright;      ///< the wall; false: one that leans, or the edge of a slope
    float dx;            ///< from the point of the grid to the wall, mm
    float dy;
    float z;              ///< of the surface there, relative to the top of the stock
    std::int16_t normalX; ///< of the wall over ground, as that of a rim; 0: none, in a corner
    std::int16_t normalY;
    friend bool operator==(const WallPoint&, const WallPoint&) = default;
};

/// Those of a tile, ascending. Immutable once published.
struct WallTile {
    std::vector<WallPoint> points;
    friend bool operator==(const WallTile&, const WallTile&) = default;
};

/// Computed from the rims of a z-map; where walls are not straight, corners are estimated from the rims on
/// both sides. No point leaves the border of the map where something is left, and none moves by more than
/// about a cell. Value type; any thread reads copies.
class WallPoints {
public:
    WallPoints() = default; ///< none, of any map
    /// `zmap` has rims, or there are no wall points. In parallel.
    explicit WallPoints(const ZMapSnapshot& zmap);
    /// The same, where tiles whose rims are those of `before`, and whose neighbours' are as well, keep what
    /// `points` has for them; others with the same points share them.
    WallPoints(const ZMapSnapshot& zmap, const RimMap& before, const WallPoints& points);

    /// Takes those away that are in a rectangle of grid points; they are drawn at their points then.
    void removeIn(const IndexRect& rect);

    [[nodiscard]] bool empty() const { return m_count == 0; }
    [[nodiscard]] std::size_t count() const { return m_count; }
    /// Null: none. Equal pointers mean equal points.
    [[nodiscard]] const WallTile* tile(std::size_t index) const {
        return m_tiles.empty() ? nullptr : m_tiles[index].get();
    }
    /// Keeps them from being replaced by others at the same address.
    [[nodiscard]] std::shared_ptr<const WallTile> share(std::size_t index) const {
        return m_tiles.empty() ? nullptr : m_tiles[index];
    }
    /// Null where point (i, j) is not beside a wall.
    [[nodiscard]] const WallPoint* find(int i, int j) const;
    /// Those in a rectangle of grid points, as offsets row by row, ascending.
    [[nodiscard]] std::vector<std::uint32_t> offsetsIn(const IndexRect& rect) const;

private:
    /// Calls `visit(tile, rect in the tile)` for the tiles with wall points that a rectangle meets.
    template<class Visit>
    void eachTileIn(const IndexRect& rect, const Visit& visit) const;

    int m_tilesX = 0;
    std::size_t m_count = 0;
    PersistentArray<std::shared_ptr<const WallTile>> m_tiles;
};

/// The wall points of one tile; null if it has none.
[[nodiscard]] std::shared_ptr<const WallTile> wallPointsOf(const ZMapSnapshot& zmap, std::size_t tile);

/// Where a mesh of the map has grid point (i, j), program coordinates.
[[nodiscard]] Vec3 vertexAt(const ZMapSnapshot& zmap, int i, int j);

} // namespace proveout
