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
#include "core/cutting/profiles/convex_profile.h"
#include "core/cutting/profiles/row_points.h"
#include "core/cutting/rows/arc_sweep.h"
#include "core/cutting/rows/straight_sweep.h"
#include "core/nc/program/motion.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The end of a cutter, mm.
class CutterEnd {
public:
    explicit CutterEnd(const Cutter& cutter);

    /// Its lowest height above the tip.
    [[nodiscard]] double lowest() const { return m_lowest; }
    /// The largest radius within which it is nowhere above a height over the tip; 0: none.
    [[nodiscard]] double radiusUpTo(double height) const;

private:
    std::vector<ConvexProfile> m_profiles;
    double m_lowest;
};

/// A disc moved over ground along a line or circle. Program coordinates; heights relative to `topZ`.
class FlatPass {
public:
    /// The points of a row of a tile, and the next one.
    using Row = std::bitset<Tile::kSize + 1>;

    /// Of a level motion or a plunge, if its cutter is flat where it is lowest, or goes below the floor of
    /// the stock. `end`: of its cutter; `stockFloor`: relative to `topZ`.
    [[nodiscard]] static std::optional<FlatPass> of(const CutterEnd& end, const Motion& motion, double topZ,
                                                    double stockFloor);

    [[nodiscard]] double height() const { return m_height; }
    /// Whether it leaves a pillar inside a circle, of which two points less than `edge` apart may be on
    /// opposite sides.
    [[nodiscard]] bool mayLeavePillar(double edge) const;
    /// A line is one part, a circle several. A part has no gaps, and two in turn have none between them.
    [[nodiscard]] std::size_t parts() const { return m_circle ? m_circleParts.size() : 1; }
    /// What a part reaches over ground.
    [[nodiscard]] PlanArea areaOf(std::size_t part) const;
    [[nodiscard]] bool covers(std::size_t part, const Vec2& place) const;
    /// What a part covers of the line from `from` along X or Y, as distances from there; empty (lo > hi):
    /// nothing.
    [[nodiscard]] Span spanOn(std::size_t part, const Vec2& from, bool alongY) const;
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
