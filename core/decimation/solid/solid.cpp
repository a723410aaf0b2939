// SPDX-License-Identifier: GPL-3.0-or-later
// Why the result is a closed 2-manifold.
//
// The stock is the volume between the floor and the surface, a graph over the rectangle of the map. Its
// triangles in plan are a triangulation of the rectangle, so problems can occur only where the surface comes
// down to the floor.
//
// Surface above the floor everywhere: the boundary of the solid is surface, floor and four walls. The
// surface's boundary runs once around the rectangle, each wall is a polygon between one side of that boundary
// and one edge of the floor, and the polygons' triangles use each of their edges once. So every edge has two
// triangles, and every vertex one fan.
//
// Surface on the floor somewhere:
// 1. Triangles entirely on the floor are holes. The plan P of the others is a part of the triangulation.
// 2. P touches itself where the triangles of P around a vertex form more than one fan (holes that meet in a
//    vertex, a hole that meets the edge of the map in one). Each fan gets a copy of the vertex, moved into
//    the fan. Now the triangles around every vertex of P form one fan, closed inside and open at the
//    boundary: P is a 2-manifold with boundary. Two triangles that share an edge are in the same fan at both
//    of its ends, so no edge is torn.
// 3. The solid is P thickened: the surface over P, the floor under P with the same triangles in the opposite
//    orientation, and a wall of two triangles on each boundary edge. A 2-manifold with boundary, thickened,
//    is bounded by a closed 2-manifold. That requires the two sheets to be apart everywhere, and they are so
//    at all vertices, hence (both are linear over the same triangles) everywhere: where the surface is on the
//    floor, the floor is lowered by the gap. So a groove that touches the floor along a line or in a point
//    keeps a skin of kPinchGap, and holes have a rim of that height. The heights of the surface are
//    unchanged. Only the copies of step 2 have moved, in plan and by the gap; the surface within the
//    triangles that meet there differs from what was certified by no more than its slope times that gap.
//
// Heights less than the gap above the floor count as on it: float32, which STL uses, could not separate them.
#include "core/decimation/solid/solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/decimation/solid/solid_above_floor.h"
#include "core/decimation/solid/solid_error.h"
#include "core/decimation/solid/solid_frame.h"
#include "core/decimation/solid/solid_on_floor.h"
#include "core/decimation/solid/wall_caps.h"
#include "core/decimation/solid/wall_simplifier.h"

namespace proveout {

namespace {

TriangleMesh closed(const SolidFrame& frame, std::vector<LatticeTriangle> surface,
                    const WorkContext& context) {
    const bool touches =
        std::any_of(surface.begin(), surface.end(), [&frame](const LatticeTriangle& triangle) {
            return frame.onFloor(triangle[0]) || frame.onFloor(triangle[1]) || frame.onFloor(triangle[2]);
        });
    if (surface.empty() || context.stopped())
        return {};
    return touches ? closeOnFloor(frame, std::move(surface), context)
                   : closeAboveFloor(frame, std::move(surface), context);
}

/// Whether every triangle keeps its side in single precision.
bool isSoundInFloat(const TriangleMesh& solid) {
    return std::ranges::all_of(solid.triangles, [&](const std::array<std::uint32_t, 3>& triangle) {
        std::array<Vec3, 3> exact;
        std::array<Vec3, 3> rounded;
        for (std::size_t k = 0; k < 3; ++k) {
            exact[k] = solid.vertices[triangle[k]];
            rounded[k] = roundedTo(CoordinateType::float32, exact[k]);
        }
        const Vec3 was = glm::cross(exact[1] - exact[0], exact[2] - exact[0]);
        const Vec3 is = glm::cross(rounded[1] - rounded[0], rounded[2] - rounded[0]);
        return glm::dot(was, is) > 0;
    });
}

} // namespace

std::optional<TriangleMesh> closeWithWalls(const ZMapSnapshot& zmap, std::vector<LatticeTriangle> surface,
                                           double allowance, const WorkContext& context) {
    const SolidFrame frame(zmap);
    flipWallCaps(frame, surface);
    if (allowance > 0)
        simplifyWalls(frame, allowance, surface, context);
    TriangleMesh solid = closed(frame, std::move(surface), context);
    const auto isNear = [&] {
        return allowance <= 0 || measureSolidError(zmap, solid, CoordinateType::float32, ErrorLevel::sample,
                                                   context.quiet()) <= allowance;
    };
    if (context.stopped() || (isSoundInFloat(solid) && isNear()))
        return solid;
    return std::nullopt;
}

TriangleMesh closeSolid(const ZMapSnapshot& zmap, std::vector<LatticeTriangle> surface,
                        const WorkContext& context) {
    if (zmap.walls().empty())
        return closed(SolidFrame(zmap), std::move(surface), context);
    ZMapSnapshot plain = zmap;
    plain.setWalls({});
    return closed(SolidFrame(plain), std::move(surface), context);
}

bool hasVerticesSetApart(const ZMapSnapshot& zmap, const TriangleMesh& solid) {
    const Grid& grid = zmap.grid();
    return std::ranges::any_of(solid.vertices, [&](const Vec3& vertex) {
        const int i = static_cast<int>(std::lround((vertex.x - grid.x0) / grid.hx));
        const int j = static_cast<int>(std::lround((vertex.y - grid.y0) / grid.hy));
        // A vertex on a wall belongs to one of the points around it.
        const int around = zmap.walls().empty() ? 0 : 1;
        for (int y = std::max(j - around, 0); y <= std::min(j + around, grid.ny - 1); ++y) {
            for (int x = std::max(i - around, 0); x <= std::min(i + around, grid.nx - 1); ++x) {
                if (Vec2(vertexAt(zmap, x, y)) == Vec2(vertex))
                    return false;
            }
        }
        return true;
    });
}

} // namespace proveout
