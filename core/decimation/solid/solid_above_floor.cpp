// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/solid_above_floor.h"

#include <utility>
#include <vector>

#include "core/decimation/lattice/lattice_numbers.h"
#include "core/decimation/solid/solid_sides.h"

namespace proveout {

namespace {

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
        m_chain.assign(1, floorLeft);
        for (; i >= 0 && i < m_frame.nx() && j >= 0 && j < m_frame.ny(); i += di, j += dj) {
            const auto vertex = m_numbers.find(m_frame.lattice(i, j));
            if (vertex != LatticeNumbers::kUnused)
                m_chain.push_back(vertex);
        }
        m_chain.push_back(floorRight);
        addSide(m_chain, Vec2(di, dj), m_mesh);
    }

    const SolidFrame& m_frame;
    LatticeNumbers m_numbers; ///< of the vertices on top
    std::vector<std::uint32_t> m_chain;
    TriangleMesh m_mesh;
};

} // namespace

TriangleMesh closeAboveFloor(const SolidFrame& frame, std::vector<LatticeTriangle> surface,
                             const WorkContext& context) {
    return AboveFloor(frame).build(std::move(surface), context);
}

} // namespace proveout
