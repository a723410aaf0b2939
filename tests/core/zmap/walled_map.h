// SPDX-License-Identifier: GPL-3.0-or-later
// Maps whose walls follow a known outline, with exact rims.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/zmap/zmap.h"

namespace proveout {

inline constexpr double kWalledSize = 40; ///< mm, both ways
inline constexpr float kWalledDepth = -5;

/// A pocket or a boss in plan.
struct WalledRegion {
    std::string name;
    std::function<double(const Vec2&)> distance; ///< of a point from its outline, negative inside
    double area;                                 ///< mm²; 0: unknown
    double onOutline;                            ///< mm for a spacing of 1: how far vertices may be beside it
    double areaAllowed;                          ///< mm², the same
    bool floorInside;                            ///< a pocket, or else a boss
};
[[nodiscard]] std::vector<WalledRegion> walledRegions();

/// The map of a region cut out of a box, or left of it.
class WalledMap {
public:
    WalledMap(const WalledRegion& region, double spacing, double stockHeight = 10);

    [[nodiscard]] const ZMapSnapshot& moment() const { return m_moment; }
    [[nodiscard]] const Grid& grid() const { return m_grid; }
    [[nodiscard]] double fromOutline(const Vec3& vertex) const;
    /// Where points cannot leave the border of the map.
    [[nodiscard]] bool isAtBorder(const Vec3& vertex) const;

private:
    [[nodiscard]] Vec2 place(int i, int j) const { return {m_grid.x(i), m_grid.y(j)}; }
    [[nodiscard]] bool isLow(const Vec2& at) const;
    [[nodiscard]] RimTilePtr rimsOf(std::size_t tile) const;
    void add(const RimEdge& edge, int i, int j, RimTile& rims) const;

    WalledRegion m_region;
    Grid m_grid;
    ZMapSnapshot m_moment;
};

} // namespace proveout
