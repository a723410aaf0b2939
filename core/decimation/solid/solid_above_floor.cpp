// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/solid_above_floor.h"

#include <cmath>
#include <utility>
#include <vector>

#include "core/decimation/lattice/lattice_numbers.h"
#include "core/decimation/solid/solid_error.h"

namespace proveout {

namespace {

/// A vertex of a wall: the distance along the wall from left to right seen from outside, and the height.
struct WallPoint {
    Vec2 exact{0};
    Vec2 inFloat{0}; ///< as STL will store it
    std::uint32_t vertex = 0;
};

/// Whether a, b, c turn to the left, by more than the rounding of these products.
bool turnsLeft(const Vec2& a, const Vec2& b, const Vec2& c) {
    constexpr double kErr = 1e-12;
    const double plus = (b.x - a.x) * (c.y - a.y);
    const double minus = (c.x - a.x) * (b.y - a.y);
    return plus - minus > kErr * (std::abs(plus) + std::abs(minus));
}

/// Whether the chain is convex at `ear`, both before and after rounding to float32: points that are collinear
/// except for their last bits may be convex in only one of them, and their triangle would face inwards in the
/// other.
bool isConvex(const WallPoint& before, const WallPoint& ear, const WallPoint& after) {
    return turnsLeft(before.exact, after.exact, ear.exact) &&
           turnsLeft(before.inFloat, after.inFloat, ear.inFloat);
}

/// Triangulates a wall: a monotone mountain, that is, a chain over one straight base from `chain.front()` to
/// `chain.back()`. A convex vertex of the chain can always be cut off, because only the base is below the
/// connection of its neighbours; and a chain above its base always has a convex vertex. Collinear vertices
/// are postponed, so that no triangle has zero area.
void triangulateMountain(const std::vector<WallPoint>& chain, TriangleMesh& mesh) {
    std::vector<WallPoint> open;
    const auto cutOff = [&](const WallPoint& next) {
        const WallPoint ear = open.back();
        open.pop_back();
        mesh.triangles.push_back({open.back().vertex, next.vertex, ear.vertex});
    };
    for (const WallPoint& point : chain) {
        while (open.size() >= 2 && isConvex(open[open.size() - 2], open.back(), point))
            cutOff(point);
        open.push_back(point);
    }
    // Something is left here only if float32 cannot represent the detail of the wall; it is closed all the
    // same.
    const WallPoint last = open.back();
    open.pop_back();
    while (open.size() >= 2)
        cutOff(last);
}

class AboveFloor {
public:
    explicit AboveFloor(const SolidFrame& frame) : m_frame(frame), m_numbers(frame.points()) {}

    TriangleMesh build(std::vector<LatticeTriangle> surface, const WorkContext& context) {
        m_mesh.triangles = std::move(surface);
        // Reserved here, where only one copy exists beside the list; a wall has at most one triangle per
        // point.
        m_mesh.triangles.reserve(m_mesh.triangles.size() + m_frame.outlinePoints() + kFloorTriangles);
        for (LatticeTriangle& triangle : m_mesh.triangles)
            for (std::uint32_t& corner : triangle)
                corner = m_numbers.number(corner);
        constexpr std::size_t kFloorCorners = 4;
        m_mesh.vertices.reserve(m_numbers.used().size() + kFloorCorners);
        for (const std::uint32_t lattice : m_numbers.used())
            m_mesh.vertices.push_back(m_frame.top(lattice));
        context.report(0.8);
        if (context.stopped())
            return {};
        const int east = m_frame.nx() - 1;
        const int north = m_frame.ny() - 1;
        const std::uint32_t floor = addFloor(east, north);
        addWall(0, 0, 1, 0, floor, floor + 1);
        addWall(east, 0, 0, 1, floor + 1, floor + 2);
        addWall(east, north, -1, 0, floor + 2, floor + 3);
        addWall(0, north, 0, -1, floor + 3, floor);
        context.report(1);
        return std::move(m_mesh);
    }

private:
    static constexpr std::size_t kFloorTriangles = 2;

    /// Adds the corners counter-clockwise from the south-west; returns the first.
    std::uint32_t addFloor(int east, int north) {
        const auto first = static_cast<std::uint32_t>(m_mesh.vertices.size());
        for (const auto& [i, j] : {std::pair{0, 0}, {east, 0}, {east, north}, {0, north}})
            m_mesh.vertices.emplace_back(m_frame.plan(m_frame.lattice(i, j)), m_frame.floorZ());
        m_mesh.triangles.push_back({first, first + 2, first + 1});
        m_mesh.triangles.push_back({first, first + 3, first + 2});
        return first;
    }

    /// The wall from grid point (i, j) in steps of (di, dj), between two vertices of the floor.
    void addWall(int i, int j, int di, int dj, std::uint32_t floorLeft, std::uint32_t floorRight) {
        const auto wallPoint = [&](std::uint32_t vertex) {
            const Vec3& at = m_mesh.vertices[vertex];
            const Vec3 rounded = roundedTo(CoordinateType::float32, at);
            return WallPoint{
                {di * at.x + dj * at.y, at.z}, {di * rounded.x + dj * rounded.y, rounded.z}, vertex};
        };
        m_chain.assign(1, wallPoint(floorLeft));
        for (; i >= 0 && i < m_frame.nx() && j >= 0 && j < m_frame.ny(); i += di, j += dj) {
            const auto vertex = m_numbers.find(m_frame.lattice(i, j));
            if (vertex != LatticeNumbers::kUnused)
                m_chain.push_back(wallPoint(vertex));
        }
        m_chain.push_back(wallPoint(floorRight));
        triangulateMountain(m_chain, m_mesh);
    }

    const SolidFrame& m_frame;
    LatticeNumbers m_numbers; ///< of the vertices on top
    std::vector<WallPoint> m_chain;
    TriangleMesh m_mesh;
};

} // namespace

TriangleMesh closeAboveFloor(const SolidFrame& frame, std::vector<LatticeTriangle> surface,
                             const WorkContext& context) {
    return AboveFloor(frame).build(std::move(surface), context);
}

} // namespace proveout
