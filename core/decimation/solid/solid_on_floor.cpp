// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/solid_on_floor.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/decimation/lattice/lattice_numbers.h"
#include "core/decimation/solid/floor_sectors.h"

namespace proveout {

namespace {

/// A corner of a triangle, at one vertex of the plan.
struct CornerPlace {
    std::uint32_t vertex = 0;
    std::uint32_t triangle = 0;
    std::uint8_t place = 0; ///< which of the three

    // NOLINTNEXTLINE(modernize-use-nullptr): found in what the compiler generates
    friend auto operator<=>(const CornerPlace&, const CornerPlace&) = default;
};

/// The position in plan to which a vertex that touched others was moved.
struct MovedVertex {
    std::uint32_t vertex = 0;
    Vec2 offset{0};
};

/// A directed edge of the plan with its triangle on the left.
struct PlanEdge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;

    [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> undirected() const { return std::minmax(from, to); }
};

/// Memory limits the size of solids: the list of the surface becomes that of the plan and then of the solid,
/// and lists grow once, to the counted size.
class OnFloor {
public:
    explicit OnFloor(const SolidFrame& frame) : m_frame(frame) {}

    TriangleMesh build(std::vector<LatticeTriangle> surface, const WorkContext& context) {
        m_mesh.triangles = std::move(surface);
        omitHoles();
        context.report(0.2);
        if (m_mesh.triangles.empty() || context.stopped())
            return {};
        numberVertices();
        splitPinches();
        context.report(0.5);
        if (context.stopped())
            return {};
        const std::vector<PlanEdge> boundary = boundaryOfPlan();
        context.report(0.8);
        if (context.stopped())
            return {};
        // Memory for all triangles is reserved while few other lists exist; the triangles are added once the
        // list of moved vertices has been freed.
        m_mesh.triangles.reserve(2 * (m_mesh.triangles.size() + boundary.size()));
        addVertices();
        m_moved = {};
        addTriangles(boundary);
        context.report(1);
        return std::move(m_mesh);
    }

private:
    void omitHoles() {
        m_atHole.assign(m_frame.points(), false);
        std::erase_if(m_mesh.triangles, [this](const LatticeTriangle& triangle) {
            const bool hole = std::all_of(triangle.begin(), triangle.end(),
                                          [this](std::uint32_t lattice) { return m_frame.onFloor(lattice); });
            if (hole)
                for (const std::uint32_t lattice : triangle)
                    m_atHole[lattice] = true;
            return hole;
        });
    }

    /// Replaces lattice indices in the triangles by plan vertices.
    void numberVertices() {
        LatticeNumbers numbers(m_frame.points());
        for (LatticeTriangle& triangle : m_mesh.triangles)
            for (std::uint32_t& corner : triangle)
                corner = numbers.number(corner);
        m_plan = std::move(numbers).releaseUsed();
    }

    /// Only beside a hole can the material around a vertex split into sectors.
    void splitPinches() {
        const std::vector<CornerPlace> corners = cornersAtHoles();
        std::vector<Corner> around;
        for (auto from = corners.begin(); from != corners.end();) {
            around.clear();
            auto to = from;
            for (; to != corners.end() && to->vertex == from->vertex; ++to)
                around.push_back(cornerAt(to->triangle, to->place));
            split(from->vertex, around);
            from = to;
        }
        m_moved.shrink_to_fit();
    }

    /// Sorted by vertex, and at each vertex in the order of the triangles.
    [[nodiscard]] std::vector<CornerPlace> cornersAtHoles() const {
        const auto forEachCorner = [this](auto&& take) {
            for (std::uint32_t t = 0; t < m_mesh.triangles.size(); ++t)
                for (std::uint8_t place = 0; place < 3; ++place)
                    if (const std::uint32_t vertex = m_mesh.triangles[t][place]; m_atHole[m_plan[vertex]])
                        take(CornerPlace{vertex, t, place});
        };
        std::size_t count = 0;
        forEachCorner([&count](const CornerPlace&) { ++count; });
        std::vector<CornerPlace> corners;
        corners.reserve(count);
        forEachCorner([&corners](const CornerPlace& corner) { corners.push_back(corner); });
        std::sort(corners.begin(), corners.end());
        return corners;
    }

    [[nodiscard]] Corner cornerAt(std::size_t t, int place) const {
        const auto at = [&](int step) {
            return m_plan[m_mesh.triangles[t][static_cast<std::size_t>((place + step) % 3)]];
        };
        const Vec2 here = m_frame.plan(at(0));
        return {t, place, at(1), at(2), m_frame.plan(at(1)) - here, m_frame.plan(at(2)) - here};
    }

    /// The first sector keeps the vertex; each other sector gets its own copy.
    void split(std::uint32_t vertex, std::span<const Corner> corners) {
        const auto sectors = sectorsAround(corners, m_frame.gapXY());
        if (sectors.size() < 2)
            return;
        m_moved.push_back({vertex, sectors.front().offset});
        for (std::size_t s = 1; s < sectors.size(); ++s) {
            const auto copy = static_cast<std::uint32_t>(m_plan.size());
            m_moved.push_back({copy, sectors[s].offset});
            m_plan.push_back(std::uint32_t{m_plan[vertex]});
            for (const Corner& corner : sectors[s].corners)
                m_mesh.triangles[corner.triangle][static_cast<std::size_t>(corner.place)] = copy;
        }
    }

    /// Whether the boundary of the plan may pass through a vertex: checking only the few edges between such
    /// vertices saves sorting all edges of the mesh.
    [[nodiscard]] bool mayBeBoundary(std::uint32_t vertex) const {
        const std::uint32_t lattice = m_plan[vertex];
        return m_atHole[lattice] || m_frame.onOutline(lattice);
    }

    /// The edges with a triangle on only one side.
    [[nodiscard]] std::vector<PlanEdge> boundaryOfPlan() const {
        std::vector<PlanEdge> edges = edgesThatMayBeBoundary();
        std::sort(edges.begin(), edges.end(),
                  [](const PlanEdge& a, const PlanEdge& b) { return a.undirected() < b.undirected(); });
        std::size_t kept = 0;
        for (std::size_t e = 0; e < edges.size(); ++e) {
            // An edge between two triangles occurs twice.
            if (e + 1 < edges.size() && edges[e].undirected() == edges[e + 1].undirected())
                ++e;
            else
                edges[kept++] = edges[e];
        }
        edges.resize(kept);
        edges.shrink_to_fit();
        return edges;
    }

    [[nodiscard]] std::vector<PlanEdge> edgesThatMayBeBoundary() const {
        const auto forEachEdge = [this](auto&& take) {
            for (const LatticeTriangle& triangle : m_mesh.triangles)
                for (std::size_t k = 0; k < 3; ++k)
                    if (const PlanEdge edge{triangle[k], triangle[(k + 1) % 3]};
                        mayBeBoundary(edge.from) && mayBeBoundary(edge.to))
                        take(edge);
        };
        std::size_t count = 0;
        forEachEdge([&count](const PlanEdge&) { ++count; });
        std::vector<PlanEdge> edges;
        edges.reserve(count);
        forEachEdge([&edges](const PlanEdge& edge) { edges.push_back(edge); });
        return edges;
    }

    [[nodiscard]] std::uint32_t below(std::uint32_t vertex) const {
        return vertex + static_cast<std::uint32_t>(m_plan.size());
    }

    /// The top sheet exists already; the floor repeats it in the opposite orientation, and each boundary edge
    /// gets a wall.
    void addTriangles(const std::vector<PlanEdge>& boundary) {
        std::vector<LatticeTriangle>& triangles = m_mesh.triangles;
        const std::size_t top = triangles.size();
        for (std::size_t t = 0; t < top; ++t) {
            const auto [a, b, c] = triangles[t];
            triangles.push_back({below(a), below(c), below(b)});
        }
        for (const PlanEdge& edge : boundary) {
            triangles.push_back({below(edge.from), below(edge.to), edge.to});
            triangles.push_back({below(edge.from), edge.to, edge.from});
        }
    }

    /// The top sheet's vertices, followed by the floor's in the same order.
    void addVertices() {
        std::vector<Vec3>& vertices = m_mesh.vertices;
        vertices.reserve(2 * m_plan.size());
        for (const std::uint32_t lattice : m_plan)
            vertices.push_back(m_frame.top(lattice));
        for (const std::uint32_t lattice : m_plan) {
            const double gap = m_frame.onFloor(lattice) ? m_frame.gapZ() : 0;
            vertices.emplace_back(m_frame.plan(lattice), m_frame.floorZ() - gap);
        }
        for (const MovedVertex& moved : m_moved)
            for (const std::uint32_t vertex : {moved.vertex, below(moved.vertex)})
                vertices[vertex] += Vec3(moved.offset, 0);
    }

    const SolidFrame& m_frame;
    std::vector<bool> m_atHole;        ///< per grid point
    std::vector<std::uint32_t> m_plan; ///< the grid point of each vertex; split vertices occur more than once
    std::vector<MovedVertex> m_moved;
    TriangleMesh m_mesh; ///< its triangles are those of the plan, until the floor is added
};

} // namespace

TriangleMesh closeOnFloor(const SolidFrame& frame, std::vector<LatticeTriangle> surface,
                          const WorkContext& context) {
    return OnFloor(frame).build(std::move(surface), context);
}

} // namespace proveout
