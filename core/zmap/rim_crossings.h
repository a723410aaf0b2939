// SPDX-License-Identifier: GPL-3.0-or-later
// Rims as the points at both ends of their edges see them. Internal to this room.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/index_rect.h"
#include "core/zmap/round_foot.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// One side of a rim as seen from one of the two points of its edge.
struct RimCrossing {
    Vec2 at; ///< from the point, mm
    Vec2 normal;
    double height; ///< of the surface beside the wall
    bool isUpright = false;
    RoundFoot foot{}; ///< by distance from the wall over ground; level if the surface there is
};

/// A place on a wall.
struct OnWall {
    Vec2 at;
    Vec2 normal; ///< 0: none, in a corner
};

/// A step from a point to one of its neighbours.
struct GridStep {
    int di;
    int dj;
    [[nodiscard]] bool isOpposite(const GridStep& other) const { return di == -other.di && dj == -other.dj; }
};
/// The place of a wall in a cell from its crossings of two edges, nearest to the point that both belong to:
/// on the curve that passes through both at a right angle to their normals.
[[nodiscard]] OnWall onWall(const RimCrossing& a, const RimCrossing& b);

/// Where the walls through two rims meet, if they turn sharply there.
[[nodiscard]] std::optional<Vec2> cornerOf(const RimCrossing& a, const RimCrossing& b);

/// Of the surface beside a wall that crosses two edges.
[[nodiscard]] inline double heightBeside(const RimCrossing& a, const RimCrossing& b) {
    return (a.height + b.height) / 2;
}

[[nodiscard]] inline RoundFoot footBeside(const RimCrossing& a, const RimCrossing& b) {
    const bool isLevel = a.foot.isLevel() && b.foot.isLevel();
    return isLevel ? RoundFoot{} : between(a.foot, b.foot);
}

/// The rims and heights of a tile and what surrounds it. Refers to the map.
class RimSurroundings {
public:
    RimSurroundings(const ZMapSnapshot& zmap, std::size_t tile);
    RimSurroundings(const RimSurroundings&) = delete;
    RimSurroundings& operator=(const RimSurroundings&) = delete;

    [[nodiscard]] bool empty() const { return m_rims.empty(); }
    [[nodiscard]] const IndexRect& rect() const { return m_rect; }
    [[nodiscard]] const Grid& grid() const { return m_zmap.grid(); }
    [[nodiscard]] float height(int i, int j) const { return m_zmap.height(i, j); }
    [[nodiscard]] bool isOnFloor(int i, int j) const { return height(i, j) <= m_zmap.floor(); }
    [[nodiscard]] Vec2 cell() const { return {grid().hx, grid().hy}; }

    /// Whether a rim is in one of the four cells around a point of the tile.
    [[nodiscard]] bool isNearRim(int i, int j) const {
        return m_isNear[static_cast<std::size_t>(j - m_rect.j0) * Tile::kSize +
                        static_cast<std::size_t>(i - m_rect.i0)];
    }

    /// Which edges of a cell, given by its first point, have such a crossing: a bit each for its south,
    /// north, west and east one.
    [[nodiscard]] unsigned edgesOf(int i, int j, bool high) const {
        const auto place = placeOf(i, j, false, high);
        return place ? m_cells[*place / 4 * 2 + (high ? 1 : 0)] : 0U;
    }

    /// Of the edge from (i, j) to one of its neighbours, on the high or low side of its wall, where the
    /// surface is level up to the wall or a round foot of it.
    [[nodiscard]] std::optional<RimCrossing> crossing(int i, int j, const GridStep& step, bool high) const;
    [[nodiscard]] bool isHigh(int i, int j, const GridStep& step) const {
        return m_zmap.height(i, j) > m_zmap.height(i + step.di, j + step.dj);
    }

    /// Whether the surface beside a wall is as high as at a point near it, which is `distance` from the wall,
    /// but for the foot of the wall: else the way to the wall is a slope, which the point must not leave.
    [[nodiscard]] bool isBeside(int i, int j, double besideWall, const RoundFoot& foot,
                                double distance) const {
        const double fall = foot.fall(distance);
        return isLevel(besideWall - fall, static_cast<double>(height(i, j)), fall / 4);
    }

private:
    static constexpr double kLevel = 0.1;
    static constexpr int kAround = 4;
    static constexpr double kApart = 1.0 / 256;  ///< of an edge: how near to its ends walls are drawn
    static constexpr double kLeastAcross = 1e-3; ///< the normal along an edge with a foot
    static constexpr int kWidth = Tile::kSize + 2 * kAround;

    struct Side {
        const Rim* rim = nullptr;
        std::uint32_t foot = 0; ///< in m_feet
    };
    /// A rim that may have one, and the first point of its edge.
    struct Foot {
        const Rim* rim;
        int i;
        int j;
    };

    void add(int ti, int tj, std::vector<Foot>& feet);
    void addFoot(const Foot& wall);
    void use(const Rim& rim, int i, int j, bool high, std::uint32_t foot);
    void markCells(int i, int j, bool alongY, bool high) {
        const auto mark = [&](int x, int y, unsigned bit) {
            if (const auto place = placeOf(x, y, false, high))
                m_cells[*place / 4 * 2 + (high ? 1 : 0)] |= static_cast<std::uint8_t>(1U << bit);
        };
        mark(i, j, alongY ? 2 : 0);
        mark(alongY ? i - 1 : i, alongY ? j : j - 1, alongY ? 3 : 1);
    }
    /// The corners of the cells on both sides of an edge, and of those at its ends.
    void markAround(int i, int j, bool alongY) {
        const IndexRect around{i - 1, j - 1, i + (alongY ? 2 : 3), j + (alongY ? 3 : 2)};
        const IndexRect inside = intersection(around, m_rect);
        for (int y = inside.j0; y < inside.j1; ++y)
            for (int x = inside.i0; x < inside.i1; ++x)
                m_isNear[static_cast<std::size_t>(y - m_rect.j0) * Tile::kSize +
                         static_cast<std::size_t>(x - m_rect.i0)] = true;
    }
    /// Below the rim of a ball the surface goes on falling: points that left that slope for the wall would
    /// cut it off.
    [[nodiscard]] bool isLevelBeside(const Rim& rim, int i, int j, bool alongY, bool high) const {
        const int toI = i + (alongY ? 0 : 1);
        const int toJ = j + (alongY ? 1 : 0);
        const bool first = (height(i, j) > height(toI, toJ)) == high;
        return isBeside(first ? i : toI, first ? j : toJ, static_cast<double>(high ? rim.top : rim.bottom),
                        {}, 0);
    }
    [[nodiscard]] bool isLevel(double a, double b, double slack = 0) const {
        return std::abs(a - b) <= kLevel * std::max(grid().hx, grid().hy) + slack;
    }
    [[nodiscard]] std::optional<std::size_t> placeOf(int i, int j, bool alongY, bool high) const {
        const int x = i - m_rect.i0 + kAround;
        const int y = j - m_rect.j0 + kAround;
        if (x < 0 || y < 0 || x >= kWidth || y >= kWidth)
            return std::nullopt;
        return ((static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)) * 2 + alongY) * 2 + high;
    }
    /// Other than a crease at which a slope ends at a level.
    [[nodiscard]] bool hasRim(int i, int j, bool alongY) const {
        const auto place = placeOf(i, j, alongY, false);
        return place && m_hasRim[*place / 2];
    }

    const ZMapSnapshot& m_zmap;
    IndexRect m_rect;
    std::vector<Side> m_rims;          ///< by edge, and by side where the surface is level or a foot
    std::vector<RoundFoot> m_feet;     ///< the first one is level
    std::vector<bool> m_hasRim;        ///< by edge
    std::vector<std::uint8_t> m_cells; ///< edgesOf() by cell and side
    std::vector<bool> m_isNear;        ///< by point of the tile
};

} // namespace proveout
