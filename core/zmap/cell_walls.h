// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this room.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/zmap/rim_crossings.h"

namespace proveout {

/// Where a point stands, from its place in the grid.
struct WallPlace {
    Vec2 at; ///< mm
    double z;
    Vec2 normal{0}; ///< of the wall over ground, from its low to its high side; 0: none
    bool isUpright = false;
    bool isHigh = false; ///< on the high side of the wall
    RoundFoot foot{};    ///< of the wall
};

/// One side of the walls in a cell that cross two of its edges. Its corners are counted by rows: 0 and 1,
/// then 2 and 3.
class CellWalls {
public:
    /// `i`, `j`: its first point, which is inside the grid as are the three others. Refers to `around`.
    CellWalls(const RimSurroundings& around, int i, int j, bool high);

    /// Where a corner on this side stands that it has because two walls meet sharply in the cell: one on each
    /// side of them does, so that they form an edge of the mesh.
    [[nodiscard]] std::optional<WallPlace> sharp(int corner) const;

    /// Where a corner on this side stands that is alone on the diagonal with a corner that a wall cuts off:
    /// if the mesh has this diagonal, the wall would otherwise be a slope.
    [[nodiscard]] std::optional<WallPlace> oppositeOfCut(int corner) const;

private:
    [[nodiscard]] int column(int corner) const { return m_i + corner % 2; }
    [[nodiscard]] int row(int corner) const { return m_j + corner / 2; }
    [[nodiscard]] Vec2 offsetOf(int corner) const { return Vec2(corner % 2, corner / 2) * m_around.cell(); }
    void look(std::size_t edge);
    [[nodiscard]] bool ends(std::size_t crossing, int corner) const;
    [[nodiscard]] bool isHigh(int corner) const;
    [[nodiscard]] std::optional<int> cutOff() const;
    [[nodiscard]] bool isDiagonal(int corner) const;
    [[nodiscard]] bool isOfPair(int corner, const Vec2& meeting) const;
    [[nodiscard]] double slack() const;
    [[nodiscard]] std::optional<WallPlace> ifBeside(int corner, const WallPlace& place) const;
    [[nodiscard]] WallPlace placeOf(int corner, const OnWall& wall) const;

    const RimSurroundings& m_around;
    int m_i;
    int m_j;
    bool m_isHigh;           ///< the side
    std::size_t m_count = 0; ///< of crossings
    std::array<std::size_t, 4> m_edges{};
    std::array<int, 4> m_high{}; ///< the higher corner of each edge
    std::array<RimCrossing, 4> m_crossings{};
};

} // namespace proveout
