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
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "core/decimation/regions/region_decimator.h"
#include "core/decimation/solid/corners.h"
#include "core/decimation/solid/level_folds.h"
#include "core/decimation/solid/round_walls.h"
#include "core/decimation/solid/solid_above_floor.h"
#include "core/decimation/solid/solid_cut_through.h"
#include "core/decimation/solid/solid_error.h"
#include "core/decimation/solid/solid_frame.h"
#include "core/decimation/solid/solid_on_floor.h"
#include "core/decimation/solid/wall_caps.h"
#include "core/decimation/solid/wall_simplifier.h"

namespace proveout {

namespace {

/// How near walls come to what is round, mm, if there is no allowance.
constexpr double kRoundness = 1e-3;

bool touchesFloor(const SolidFrame& frame, const std::vector<LatticeTriangle>& surface) {
    return std::ranges::any_of(surface, [&frame](const LatticeTriangle& triangle) {
        return frame.onFloor(triangle[0]) || frame.onFloor(triangle[1]) || frame.onFloor(triangle[2]);
    });
}

TriangleMesh closed(const SolidFrame& frame, std::vector<LatticeTriangle> surface,
                    const WorkContext& context) {
    if (surface.empty() || context.stopped())
        return {};
    return touchesFloor(frame, surface) ? closeOnFloor(frame, std::move(surface), context)
                                        : closeAboveFloor(frame, std::move(surface), context);
}

/// The points of the map nearest to triangles that rounding turns over.
std::vector<std::uint32_t> pointsOfUnsound(const SolidFrame& frame, const TriangleMesh& solid) {
    const Grid& grid = frame.zmap().grid();
    const auto nearest = [](double along, int count) {
        return static_cast<int>(std::clamp(std::round(along), 0.0, count - 1.0));
    };
    std::vector<std::uint32_t> points;
    for (const auto& [a, b, c] : solid.triangles) {
        const Corners corners{solid.vertices[a], solid.vertices[b], solid.vertices[c]};
        if (isSound(frame.coordinates(), corners))
            continue;
        for (const Vec3& corner : corners)
            points.push_back(frame.lattice(nearest((corner.x - grid.x0) / grid.hx, grid.nx),
                                           nearest((corner.y - grid.y0) / grid.hy, grid.ny)));
    }
    return points;
}

bool isOnFloor(const SolidFrame& frame, const LatticeTriangle& triangle) {
    return std::ranges::all_of(triangle, [&](auto point) { return frame.onFloor(point); });
}

/// Whether the surface is folded there by more than a part of a cell.
bool isFolded(const SolidFrame& frame, const LatticeTriangle& triangle, double part) {
    const Corners corners = frame.top(triangle);
    return isTurnedOver(corners) && flatness(corners) > part * frame.cell() && !isOnFloor(frame, triangle);
}

/// The points of folds that will be there however walls are simplified.
std::vector<std::uint32_t> pointsOfFolds(const SolidFrame& frame,
                                         const std::vector<LatticeTriangle>& surface) {
    constexpr double kFold = 0.1;
    std::vector<std::uint32_t> points;
    for (const LatticeTriangle& triangle : surface) {
        if (frame.isBesideWall(triangle) && isFolded(frame, triangle, kFold))
            points.insert(points.end(), triangle.begin(), triangle.end());
    }
    return points;
}

/// A rounded vertex, and the point of the map that it is.
using VertexOfPoint = std::pair<std::array<double, 3>, std::uint32_t>;

/// Those that are at the same place.
void addEqual(std::vector<VertexOfPoint> vertices, std::vector<std::uint32_t>& points) {
    std::ranges::sort(vertices);
    for (std::size_t k = 1; k < vertices.size(); ++k) {
        if (vertices[k - 1].first == vertices[k].first && vertices[k - 1].second != vertices[k].second)
            points.push_back(vertices[k].second);
    }
}

/// The points around which a surface is folded or, in the coordinates of a file, has turned triangles or
/// equal vertices.
std::vector<std::uint32_t> unsoundPoints(const SolidFrame& frame,
                                         const std::vector<LatticeTriangle>& surface) {
    std::vector<std::uint32_t> points;
    std::vector<VertexOfPoint> vertices;
    constexpr double kFold = 0.01;
    for (const LatticeTriangle& triangle : surface) {
        if (!frame.isBesideWall(triangle) || isOnFloor(frame, triangle))
            continue;
        const Corners corners = frame.top(triangle);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 at = roundedTo(frame.coordinates(), corners[k]);
            vertices.push_back({{at.x, at.y, at.z}, triangle[k]});
        }
        if (!isSound(frame.coordinates(), corners) || isFolded(frame, triangle, kFold))
            points.insert(points.end(), triangle.begin(), triangle.end());
    }
    addEqual(std::move(vertices), points);
    return points;
}

/// `touching`: as for closeCutThrough().
std::optional<TriangleMesh> closedWithWalls(const SolidFrame& frame, std::vector<LatticeTriangle> surface,
                                            std::vector<std::uint32_t>& touching,
                                            const WorkContext& context) {
    return touchesFloor(frame, surface) ? closeCutThrough(frame, std::move(surface), touching, context)
                                        : closeAboveFloor(frame, std::move(surface), context);
}

/// Draws the walls within some cells around points as they are without rims; false if there are none.
bool removeWallsWithin(int cells, const std::vector<std::uint32_t>& points, ZMapSnapshot& zmap) {
    WallPoints walls = zmap.walls();
    for (const std::uint32_t point : points) {
        const int i = static_cast<int>(point) % zmap.grid().nx;
        const int j = static_cast<int>(point) / zmap.grid().nx;
        walls.removeIn({i - cells, j - cells, i + cells + 1, j + cells + 1});
    }
    const bool changed = walls.count() < zmap.walls().count();
    zmap.setWalls(std::move(walls));
    return changed;
}

/// Those within some cells or, if there are none, the nearest ones: a triangle may be far from its points.
bool removeNearest(ZMapSnapshot& zmap, const std::vector<std::uint32_t>& points, int cells) {
    const int all = std::max(zmap.grid().nx, zmap.grid().ny);
    bool removed = false;
    for (; !removed && cells < 2 * all; cells *= 2)
        removed = removeWallsWithin(cells, points, zmap);
    return removed;
}

/// The points that are farther than allowed; if there are none, the solid gets its error. Triangles at the
/// walls that the map had before are looked at first: the others are as they were decimated.
std::vector<std::uint32_t> measure(const ZMapSnapshot& zmap, const ZMapSnapshot& before,
                                   CoordinateType coordinates, const ErrorBound& bound,
                                   const WorkContext& context, WalledSolid& solid) {
    std::vector<std::uint32_t> farther =
        pointsFarther(zmap, solid.mesh, coordinates, bound, &before, context.stop);
    if (!farther.empty())
        return farther;
    const double error = measureSolidError(zmap, solid.mesh, coordinates, bound.level, context.quiet());
    if (context.stopped())
        return {};
    if (error > bound.distance)
        farther = pointsFarther(zmap, solid.mesh, coordinates, bound, nullptr, context.stop);
    if (farther.empty())
        solid.largestErrorMm = error;
    return farther;
}

/// Closes a surface with its walls; where that is not sound, walls are drawn at the points of the map, and it
/// is tried again.
class ClosingWithWalls {
public:
    ClosingWithWalls(ZMapSnapshot& zmap, std::vector<LatticeTriangle> surface,
                     const DecimationParameters& promised, CoordinateType coordinates,
                     const WorkContext& context)
        : m_zmap(zmap), m_before(zmap), m_surface(std::move(surface)),
          m_allowance(promised.method == DecimationMethod::none ? 0 : promised.allowance),
          m_level(errorLevel(promised)), m_coordinates(coordinates), m_context(context) {}

    std::optional<WalledSolid> run() {
        constexpr int kMostRounds = 14;
        constexpr int kNearRounds = 6; // after these, the walls farther around are removed as well
        int cells = 2;
        for (int round = 0; round < kMostRounds; ++round) {
            std::optional<WalledSolid> solid = closeOnce();
            if (m_context.stopped())
                return solid.value_or(WalledSolid{});
            if (solid || m_unsound.empty() || !removeNearest(m_zmap, m_unsound, cells))
                return solid;
            cells *= round + 1 > kNearRounds ? 2 : 1;
        }
        return std::nullopt;
    }

private:
    /// Nothing if it is not sound at the points of `m_unsound`, or not possible at all if there are none.
    std::optional<WalledSolid> closeOnce() {
        const SolidFrame frame(m_zmap, m_coordinates);
        FormerTriangles flipped = flipWallCaps(frame, m_surface);
        std::ranges::move(unfoldLevels(frame, m_surface), std::back_inserter(flipped));
        m_unsound = pointsOfFolds(frame, m_surface);
        std::optional<WalledSolid> solid;
        if (m_unsound.empty())
            solid = m_allowance > 0 ? closeSimplified(frame) : closeFull(frame);
        if (solid || m_surface.empty())
            return solid;
        for (; !flipped.empty(); flipped.pop_back()) // the last first: some were flipped several times
            m_surface[flipped.back().first] = flipped.back().second;
        return std::nullopt;
    }

    std::optional<WalledSolid> closeSimplified(const SolidFrame& frame) {
        std::vector<LatticeTriangle> simple = m_surface;
        simplifyWalls(frame, m_allowance, simple, m_context);
        m_unsound = unsoundPoints(frame, simple);
        std::optional<TriangleMesh> mesh =
            m_unsound.empty() ? rounded(frame, std::move(simple)) : std::nullopt;
        if (!mesh)
            return std::nullopt;
        WalledSolid solid{std::move(*mesh), {}};
        m_unsound = measure(m_zmap, m_before, m_coordinates, {m_allowance, m_level}, m_context, solid);
        return m_unsound.empty() ? std::optional(std::move(solid)) : std::nullopt;
    }

    /// Of all points, which may not fit into memory twice: there is one try.
    std::optional<WalledSolid> closeFull(const SolidFrame& frame) {
        m_unsound = unsoundPoints(frame, m_surface);
        if (!m_unsound.empty())
            return std::nullopt;
        std::optional<TriangleMesh> mesh = rounded(frame, std::exchange(m_surface, {}));
        m_unsound.clear();
        return mesh ? std::optional(WalledSolid{std::move(*mesh), {}}) : std::nullopt;
    }

    std::optional<TriangleMesh> rounded(const SolidFrame& frame, std::vector<LatticeTriangle> surface) {
        std::optional<TriangleMesh> mesh = closedWithWalls(frame, std::move(surface), m_unsound, m_context);
        if (!mesh || m_context.stopped())
            return mesh;
        roundWalls(frame, std::max(2 * kWallShare * m_allowance, kRoundness), *mesh);
        m_unsound = pointsOfUnsound(frame, *mesh);
        return m_unsound.empty() ? std::move(mesh) : std::nullopt;
    }

    ZMapSnapshot& m_zmap;
    ZMapSnapshot m_before; ///< with all walls
    std::vector<LatticeTriangle> m_surface;
    double m_allowance;
    ErrorLevel m_level;
    CoordinateType m_coordinates;
    const WorkContext& m_context;
    std::vector<std::uint32_t> m_unsound; ///< points of the map, of the last try
};

} // namespace

std::optional<WalledSolid> closeWithWalls(ZMapSnapshot& zmap, std::vector<LatticeTriangle> surface,
                                          const DecimationParameters& promised, CoordinateType coordinates,
                                          const WorkContext& context) {
    return ClosingWithWalls(zmap, std::move(surface), promised, coordinates, context).run();
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
