// SPDX-License-Identifier: GPL-3.0-or-later
// The floor that a cutter with a flat end leaves on a motion at one height. Internal to this library.
#pragma once

#include <bitset>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/cutter/cutter.h"
#include "core/cutting/cut/plan_area.h"
#include "core/cutting/profiles/arc_path.h"
#include "core/cutting/profiles/row_points.h"
#include "core/cutting/rows/arc_sweep.h"
#include "core/cutting/rows/straight_sweep.h"
#include "core/nc/program/motion.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The flat end of a cutter, mm.
struct FlatEnd {
    double height; ///< above the tip
    double radius; ///< 0: there is none

    explicit FlatEnd(const Cutter& cutter);
};

/// A disc moved over ground along a line or circle. Program coordinates; heights relative to `topZ`.
class FlatPass {
public:
    /// The points of a row of a tile, and the next one.
    using Row = std::bitset<Tile::kSize + 1>;

    /// Of a motion that has one, level or a plunge. `end`: of its cutter.
    [[nodiscard]] static std::optional<FlatPass> of(const FlatEnd& end, const Motion& motion, double topZ);

    [[nodiscard]] double height() const { return m_height; }
    /// A line is one part, a circle several. A part, or two in turn, has no gap or hole in it.
    [[nodiscard]] std::size_t parts() const { return m_circle ? m_circleParts.size() : 1; }
    /// What a part reaches over ground.
    [[nodiscard]] PlanArea areaOf(std::size_t part) const;
    [[nodiscard]] bool covers(std::size_t part, const Vec2& place) const;
    /// The points of a row under a part.
    [[nodiscard]] Row pointsUnder(std::size_t part, const RowPoints& row) const;

private:
    FlatPass() = default;

    double m_height = 0;
    double m_radius = 0;
    Vec2 m_origin{0}; ///< of the coordinates of the paths
    StraightPath m_straight;
    std::optional<ArcPath> m_circle;
    std::vector<ArcPart> m_circleParts; ///< along it
};

} // namespace proveout
