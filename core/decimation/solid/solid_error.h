// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/base/work_context.h"
#include "core/decimation/regions/parameters.h"
#include "core/decimation/solid/corners.h"
#include "core/decimation/solid/solid.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// A point as a file with such coordinates holds it.
[[nodiscard]] Vec3 roundedTo(CoordinateType type, const Vec3& point);

/// Whether a triangle keeps its side in such coordinates.
[[nodiscard]] bool isSound(CoordinateType type, const Corners& exact);

/// How far the z-map is from the top of a solid, mm: the largest vertical distance of a grid point (at the
/// surface level: of any point of the canonical full mesh) to the triangles that face upwards, with
/// coordinates rounded to `type`. Points on the outline of the stock, which is rounded too, are measured at
/// the nearest point of the rounded one. Where there is no triangle, nothing of the solid is left, and the
/// floor counts as its top. Points beside walls, and cells that have such points, are left out: they may be
/// on either side of a wall that is simplified (simplifyWalls()); edges of steep triangles that end there are
/// measured at the points alone. It is independent of how the solid was
/// made. Any thread; a stopped context returns early, with the result up to that point.
[[nodiscard]] double measureSolidError(const ZMapSnapshot& zmap, const TriangleMesh& solid,
                                       CoordinateType type, ErrorLevel level,
                                       const WorkContext& context = {});

/// What a solid must keep, measured in this way.
struct ErrorBound {
    double distance; ///< mm
    ErrorLevel level;
};

/// The points of the map that are farther from the top of a solid, by their places row by row, some of them
/// several times; at the surface level, also the ends of edges that are farther somewhere. `atWallsOf`: only
/// those of triangles that meet walls of this map, which may have more of them; null: of all triangles.
[[nodiscard]] std::vector<std::uint32_t> pointsFarther(const ZMapSnapshot& zmap, const TriangleMesh& solid,
                                                       CoordinateType type, const ErrorBound& bound,
                                                       const ZMapSnapshot* atWallsOf,
                                                       const std::stop_token& stop = {});

} // namespace proveout
