// SPDX-License-Identifier: GPL-3.0-or-later
// The surface between the points of a z-map. Internal to this library.
#pragma once

#include <cstddef>
#include <optional>

#include "core/zmap/stock_shape.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Within each cell, the mean of its corners weighted by nearness. Along an edge with a rim, and within some
/// micrometres beside it, the surface is level up to the wall of the rim and beyond it.
class MapTop final : public StockTop {
public:
    explicit MapTop(ZMapSnapshot map);

    [[nodiscard]] double height(const Vec2& place) const override;
    [[nodiscard]] double highest(const Vec2& lo, const Vec2& hi) const override;
    [[nodiscard]] bool knowsWalls() const override { return false; }
    [[nodiscard]] const RimTile* rims(std::size_t tile) const override;

private:
    /// Of the edge that begins at a point of the grid; call it if the map has rims.
    [[nodiscard]] const Rim* rimAt(int i, int j, bool alongY) const;
    /// `u`, `v`: the place in cells.
    [[nodiscard]] std::optional<double> heightNearEdge(double u, double v) const;

    ZMapSnapshot m_map;
    bool m_hasRims;
};

} // namespace proveout
