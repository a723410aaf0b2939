// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid_above_floor.h"

#include <vector>

#include "core/decimation/lattice_numbers.h"

namespace proveout {

namespace {

/// A vertex of a wall: along the wall from left to right seen from outside, and up, as STL will have them.
struct WallPoint {
    float along = 0;
    float up = 0;
    std::uint32_t vertex = 0;
};

/// Positive where a, b, c turn to the left. Decided on the rounded coordinates, so that what is convex here
/// is convex in the file; long double holds products of differences of floats of like size without rounding.
long double turn(const WallPoint& a, const WallPoint& b, const WallPoint& c) {
    using Real = long double;
    return (Real(b.along) - Real(a.along)) * (Real(c.up) - Real(a.up)) -
           (Real(c.along) - Real(a.along)) * (Real(b.up) - Real(a.up));
}

/// Triangulates a wall: a monotone mountain, that is a chain over one straight base from `chain.front()` to
/// `chain.back()`. A convex vertex of the chain can always be cut off, for nothing of the chain lies under
/// its neighbours' connection but the base; and while the chain lies above its base it has a convex vertex.
/// Vertices in a straight line are left for later, so that no triangle is without area.
void triangulateMountain(const std::vector<WallPoint>& chain, TriangleMesh& mesh) {
    std::vector<WallPoint> open;
    const auto cutOff = [&](const WallPoint& next) {
        const WallPoint ear = open.back();
        open.pop_back();
        mesh.triangles.push_back({open.back().vertex, next.vertex, ear.vertex});
    };
    for (const WallPoint& point : chain) {
        while (open.size() >= 2 && turn(open[open.size() - 2], point, open.back()) > 0)
            cutOff(point);
        open.push_back(point);
    }
    // Only where float32 cannot hold the detail of the wall is anything left here; closed all the same.
    const WallPoint last = open.back();
    open.pop_back();
    while (open.size() >= 2)
        cutOff(last);
}

class AboveFloor {
public:
    explicit AboveFloor(const SolidFrame& frame) : m_frame(frame), m_numbers(frame.points()) {}

    TriangleMesh build(std::span<const LatticeTriangle> surface, const WorkContext& context) {
        for (const LatticeTriangle& triangle : surface)
            m_mesh.triangles.push_back({m_numbers.number(triangle[0]), m_numbers.number(triangle[1]),
                                        m_numbers.number(triangle[2])});
        constexpr std::size_t kFloorCorners = 4;
        m_mesh.vertices.reserve(m_numbers.used().size() + kFloorCorners);
        for (const std::uint32_t lattice : m_numbers.used())
            m_mesh.vertices.push_back(m_frame.top(lattice));
        context.tell(0.8);
        if (context.stopped())
            return {};
        const int east = m_frame.nx() - 1;
        const int north = m_frame.ny() - 1;
        const std::uint32_t floor = addFloor(east, north);
        addWall(0, 0, 1, 0, floor, floor + 1);
        addWall(east, 0, 0, 1, floor + 1, floor + 2);
        addWall(east, north, -1, 0, floor + 2, floor + 3);
        addWall(0, north, 0, -1, floor + 3, floor);
        context.tell(1);
        return std::move(m_mesh);
    }

private:
    /// The corners counter-clockwise from the south-west; returns the first.
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
            const double along = di * at.x + dj * at.y;
            return WallPoint{static_cast<float>(along), static_cast<float>(at.z), vertex};
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

TriangleMesh closeAboveFloor(const SolidFrame& frame, std::span<const LatticeTriangle> surface,
                             const WorkContext& context) {
    return AboveFloor(frame).build(surface, context);
}

} // namespace proveout
