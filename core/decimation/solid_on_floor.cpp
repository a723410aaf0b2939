// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid_on_floor.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/decimation/floor_sectors.h"
#include "core/decimation/lattice_numbers.h"

namespace proveout {

namespace {

/// A vertex of the plan: a grid point, or one of the copies that a pinched one was split into.
struct PlanVertex {
    std::uint32_t lattice = 0;
    Vec2 offset{0};
};

/// A directed edge of the plan with its triangle on the left.
struct PlanEdge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;

    [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> undirected() const { return std::minmax(from, to); }
};

class OnFloor {
public:
    explicit OnFloor(const SolidFrame& frame) : m_frame(frame) {}

    TriangleMesh build(std::span<const LatticeTriangle> surface, const WorkContext& context) {
        leaveOutHoles(surface);
        context.tell(0.2);
        if (m_kept.empty() || context.stopped())
            return {};
        numberVertices();
        splitPinches();
        context.tell(0.5);
        if (context.stopped())
            return {};
        addVertices();
        addSheets();
        context.tell(0.8);
        addWalls();
        context.tell(1);
        return std::move(m_mesh);
    }

private:
    void leaveOutHoles(std::span<const LatticeTriangle> surface) {
        m_atHole.assign(m_frame.points(), false);
        for (const LatticeTriangle& triangle : surface) {
            const bool hole = std::all_of(triangle.begin(), triangle.end(),
                                          [this](std::uint32_t lattice) { return m_frame.onFloor(lattice); });
            if (!hole)
                m_kept.push_back(triangle);
            else
                for (const std::uint32_t lattice : triangle)
                    m_atHole[lattice] = true;
        }
    }

    /// From lattice indices to plan vertices: m_kept holds the latter from here on.
    void numberVertices() {
        LatticeNumbers numbers(m_frame.points());
        for (LatticeTriangle& triangle : m_kept)
            for (std::uint32_t& corner : triangle)
                corner = numbers.number(corner);
        for (const std::uint32_t lattice : numbers.used())
            m_plan.push_back({lattice, Vec2(0)});
    }

    /// Only beside a hole can the material round a vertex fall apart into sectors.
    void splitPinches() {
        std::vector<std::pair<std::uint32_t, Corner>> corners;
        for (std::size_t t = 0; t < m_kept.size(); ++t) {
            for (int place = 0; place < 3; ++place) {
                const std::uint32_t vertex = m_kept[t][static_cast<std::size_t>(place)];
                if (m_atHole[m_plan[vertex].lattice])
                    corners.emplace_back(vertex, cornerAt(t, place));
            }
        }
        std::stable_sort(corners.begin(), corners.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<Corner> around;
        for (auto from = corners.begin(); from != corners.end();) {
            around.clear();
            auto to = from;
            for (; to != corners.end() && to->first == from->first; ++to)
                around.push_back(to->second);
            split(from->first, around);
            from = to;
        }
    }

    [[nodiscard]] Corner cornerAt(std::size_t t, int place) const {
        const auto at = [&](int step) {
            return m_plan[m_kept[t][static_cast<std::size_t>((place + step) % 3)]].lattice;
        };
        const Vec2 here = m_frame.plan(at(0));
        return {t, place, at(1), at(2), m_frame.plan(at(1)) - here, m_frame.plan(at(2)) - here};
    }

    /// The first sector keeps the vertex, each other gets a copy of its own.
    void split(std::uint32_t vertex, std::span<const Corner> corners) {
        const auto sectors = sectorsAround(corners, m_frame.gapXY());
        if (sectors.size() < 2)
            return;
        const std::uint32_t lattice = m_plan[vertex].lattice;
        m_plan[vertex].offset = sectors.front().offset;
        for (std::size_t s = 1; s < sectors.size(); ++s) {
            const auto copy = static_cast<std::uint32_t>(m_plan.size());
            m_plan.push_back({lattice, sectors[s].offset});
            for (const Corner& corner : sectors[s].corners)
                m_kept[corner.triangle][static_cast<std::size_t>(corner.place)] = copy;
        }
    }

    /// The top sheet's vertices, then the floor's in the same order.
    void addVertices() {
        m_mesh.vertices.reserve(2 * m_plan.size());
        for (const PlanVertex& vertex : m_plan)
            m_mesh.vertices.push_back(m_frame.top(vertex.lattice) + Vec3(vertex.offset, 0));
        for (const PlanVertex& vertex : m_plan) {
            const double gap = m_frame.onFloor(vertex.lattice) ? m_frame.gapZ() : 0;
            m_mesh.vertices.emplace_back(m_frame.plan(vertex.lattice) + vertex.offset,
                                         m_frame.floorZ() - gap);
        }
    }

    [[nodiscard]] std::uint32_t below(std::uint32_t vertex) const {
        return vertex + static_cast<std::uint32_t>(m_plan.size());
    }

    void addSheets() {
        m_mesh.triangles.reserve(2 * m_kept.size());
        m_mesh.triangles.assign(m_kept.begin(), m_kept.end());
        for (const auto& [a, b, c] : m_kept)
            m_mesh.triangles.push_back({below(a), below(c), below(b)});
    }

    /// Whether the boundary of the plan may pass through a vertex: looking at the few edges between such
    /// vertices saves sorting all edges of the mesh.
    [[nodiscard]] bool mayBeBoundary(std::uint32_t vertex) const {
        const std::uint32_t lattice = m_plan[vertex].lattice;
        const int i = m_frame.column(lattice);
        const int j = m_frame.row(lattice);
        return m_atHole[lattice] || i == 0 || j == 0 || i == m_frame.nx() - 1 || j == m_frame.ny() - 1;
    }

    void addWalls() {
        std::vector<PlanEdge> edges;
        for (const LatticeTriangle& triangle : m_kept) {
            for (std::size_t k = 0; k < 3; ++k) {
                const PlanEdge edge{triangle[k], triangle[(k + 1) % 3]};
                if (mayBeBoundary(edge.from) && mayBeBoundary(edge.to))
                    edges.push_back(edge);
            }
        }
        std::sort(edges.begin(), edges.end(),
                  [](const PlanEdge& a, const PlanEdge& b) { return a.undirected() < b.undirected(); });
        for (std::size_t e = 0; e < edges.size(); ++e) {
            // An edge between two triangles comes twice.
            if (e + 1 < edges.size() && edges[e].undirected() == edges[e + 1].undirected())
                ++e;
            else
                addWall(edges[e]);
        }
    }

    void addWall(const PlanEdge& edge) {
        m_mesh.triangles.push_back({below(edge.from), below(edge.to), edge.to});
        m_mesh.triangles.push_back({below(edge.from), edge.to, edge.from});
    }

    const SolidFrame& m_frame;
    std::vector<bool> m_atHole; ///< per grid point
    std::vector<LatticeTriangle> m_kept;
    std::vector<PlanVertex> m_plan;
    TriangleMesh m_mesh;
};

} // namespace

TriangleMesh closeOnFloor(const SolidFrame& frame, std::span<const LatticeTriangle> surface,
                          const WorkContext& context) {
    return OnFloor(frame).build(surface, context);
}

} // namespace proveout
