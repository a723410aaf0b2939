// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/solid_cut_through.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/decimation/lattice/lattice_numbers.h"
#include "core/decimation/solid/floor_sectors.h"
#include "core/decimation/solid/plan_polygon.h"
#include "core/decimation/solid/solid_error.h"
#include "core/decimation/solid/solid_sides.h"

namespace proveout {

namespace {

constexpr double kLeastPart = 0.2; ///< twice the least area of a part or hole, in cells

class CutThrough {
public:
    CutThrough(const SolidFrame& frame, std::vector<std::uint32_t>& touching)
        : m_frame(frame), m_numbers(frame.points()), m_touching(touching) {}

    std::optional<TriangleMesh> build(std::vector<LatticeTriangle> surface, const WorkContext& context) {
        m_solid.triangles = std::move(surface);
        omitHoles();
        placeVertices();
        splitVertices();
        context.report(0.4);
        if (!m_touching.empty())
            return std::nullopt;
        if (context.stopped() || m_solid.triangles.empty())
            return TriangleMesh{};
        std::vector<PlanLoop> underside;
        for (auto next = linesAroundSurface(); !next.empty();)
            underside.push_back(closeSides(takeLoop(next)));
        context.report(0.7);
        if (context.stopped())
            return TriangleMesh{};
        if (!addUnderside(underside))
            return std::nullopt;
        context.report(1);
        return std::move(m_solid);
    }

private:
    using Lines = std::unordered_map<std::uint32_t, std::uint32_t>; ///< from each vertex to the next
    [[nodiscard]] static std::uint64_t edge(std::uint32_t from, std::uint32_t to) {
        return std::uint64_t{from} << 32U | to;
    }
    template<class Visit>
    void eachEdge(const Visit& visit) const {
        for (const LatticeTriangle& triangle : m_solid.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t from = triangle[k];
                const std::uint32_t to = triangle[(k + 1) % 3];
                if (mayBeOutline(from) && mayBeOutline(to))
                    visit(from, to);
            }
        }
    }
    [[nodiscard]] bool mayBeOutline(std::uint32_t vertex) const {
        return m_isOnFloor[vertex] || m_frame.onOutline(m_points[vertex]);
    }

    /// Makes vertices of the points of the others.
    void omitHoles() {
        std::erase_if(m_solid.triangles, [&](const LatticeTriangle& triangle) {
            return std::ranges::all_of(triangle, [&](auto point) { return m_frame.onFloor(point); });
        });
        for (LatticeTriangle& triangle : m_solid.triangles)
            for (std::uint32_t& corner : triangle)
                corner = m_numbers.number(corner);
        m_points = std::move(m_numbers).releaseUsed();
        for (const std::uint32_t point : m_points)
            m_isOnFloor.push_back(m_frame.onFloor(point));
    }

    /// Those that touch the floor without a hole are raised from it.
    void placeVertices() {
        std::unordered_set<std::uint64_t> edges;
        eachEdge([&](auto from, auto to) { edges.insert(edge(from, to)); });
        std::vector<bool> isBesideHole(m_points.size());
        eachEdge([&](auto from, auto to) {
            if (!edges.contains(edge(to, from)))
                isBesideHole[from] = isBesideHole[to] = true;
        });
        for (std::uint32_t vertex = 0; vertex < m_points.size(); ++vertex) {
            Vec3 at = m_frame.top(m_points[vertex]);
            if (m_isOnFloor[vertex])
                at.z = m_frame.floorZ() + (isBesideHole[vertex] ? 0 : m_frame.gapZ());
            m_isOnFloor[vertex] = m_isOnFloor[vertex] && isBesideHole[vertex];
            m_solid.vertices.push_back(at);
        }
    }

    /// Where holes touch each other in a vertex or along an edge, each part of the surface around a vertex
    /// gets its own copy of it.
    void splitVertices() {
        std::unordered_map<std::uint32_t, std::vector<Corner>> around;
        for (std::uint32_t t = 0; t < m_solid.triangles.size(); ++t) {
            for (int place = 0; place < 3; ++place) {
                const std::uint32_t vertex = m_solid.triangles[t][static_cast<std::size_t>(place)];
                if (m_isOnFloor[vertex])
                    around[vertex].push_back(cornerAt(t, place));
            }
        }
        std::vector<std::uint32_t> vertices;
        vertices.reserve(around.size());
        for (const auto& [vertex, corners] : around)
            vertices.push_back(vertex);
        std::ranges::sort(vertices);
        for (const std::uint32_t vertex : vertices) {
            const std::vector<Sector> sectors = sectorsAround(around[vertex], m_frame.gapXY());
            if (sectors.size() > 1 && std::ranges::any_of(around[vertex], isOfWall))
                m_touching.push_back(m_points[vertex]);
            const Vec3 at = m_solid.vertices[vertex];
            for (std::size_t s = 0; s < sectors.size(); ++s) {
                const std::uint32_t copy = s == 0 ? vertex : copyOf(vertex);
                m_solid.vertices[copy] = onFloor(Vec2(at) + sectors[s].offset);
                for (const Corner& corner : sectors[s].corners)
                    m_solid.triangles[corner.triangle][static_cast<std::size_t>(corner.place)] = copy;
            }
        }
    }
    /// The surface is not connected across an edge on the floor.
    [[nodiscard]] Corner cornerAt(std::uint32_t t, int place) const {
        const auto at = [&](int step) {
            return m_solid.triangles[t][static_cast<std::size_t>((place + step) % 3)];
        };
        constexpr std::uint32_t kApart = 1U << 31U;
        const Vec2 here(m_solid.vertices[at(0)]);
        const std::uint32_t next = at(1) | (m_isOnFloor[at(1)] ? kApart : 0U);
        return {t,
                place,
                next,
                at(2),
                Vec2(m_solid.vertices[at(1)]) - here,
                Vec2(m_solid.vertices[at(2)]) - here};
    }
    /// Whether it has no area in plan.
    [[nodiscard]] static bool isOfWall(const Corner& corner) {
        constexpr double kWall = 1e-3; // of its sides
        const double area = std::abs(turn(Vec2(0), corner.toNext, corner.toPrevious));
        return !(area > kWall * std::max(glm::dot(corner.toNext, corner.toNext),
                                         glm::dot(corner.toPrevious, corner.toPrevious)));
    }
    std::uint32_t copyOf(std::uint32_t vertex) {
        m_points.push_back(std::uint32_t{m_points[vertex]});
        m_isOnFloor.push_back(true);
        m_solid.vertices.emplace_back();
        return static_cast<std::uint32_t>(m_points.size() - 1);
    }
    /// As a file holds it: triangles of the underside must not turn over in files.
    [[nodiscard]] Vec3 onFloor(const Vec2& place) const {
        const Vec3 rounded = roundedTo(m_frame.coordinates(), Vec3(place, 0));
        return {rounded.x, rounded.y, m_frame.floorZ()};
    }

    /// They have the surface on their left.
    [[nodiscard]] Lines linesAroundSurface() const {
        std::unordered_set<std::uint64_t> edges;
        eachEdge([&](auto from, auto to) { edges.insert(edge(from, to)); });
        Lines next;
        eachEdge([&](auto from, auto to) {
            if (!edges.contains(edge(to, from)))
                next[from] = to;
        });
        return next;
    }
    /// Takes one line off others. It begins on the floor, if it comes down there, or at a corner of the map,
    /// so that each side of the stock under it is one piece.
    [[nodiscard]] PlanLoop takeLoop(Lines& next) const {
        PlanLoop loop;
        for (auto found = next.begin(); found != next.end(); found = next.find(loop.back())) {
            if (loop.empty())
                loop.push_back(found->first);
            if (found->second != loop.front())
                loop.push_back(found->second);
            next.erase(found);
        }
        std::uint32_t first = std::numeric_limits<std::uint32_t>::max();
        for (const std::uint32_t vertex : loop) {
            if (m_isOnFloor[vertex] || isCorner(vertex))
                first = std::min(first, vertex);
        }
        std::rotate(loop.begin(), std::ranges::find(loop, first), loop.end());
        return loop;
    }
    [[nodiscard]] bool isCorner(std::uint32_t vertex) const {
        const int i = m_frame.column(m_points[vertex]);
        const int j = m_frame.row(m_points[vertex]);
        return (i == 0 || i == m_frame.nx() - 1) && (j == 0 || j == m_frame.ny() - 1);
    }

    /// Adds the sides of the stock under a line around the surface. Returns the line around the underside.
    [[nodiscard]] PlanLoop closeSides(const PlanLoop& loop) {
        PlanLoop below;
        std::vector<std::uint32_t> side; // its vertices, from one on the floor to the next
        for (std::size_t k = 0; k <= loop.size(); ++k) {
            const std::uint32_t vertex = loop[k % loop.size()];
            const bool isLast = k == loop.size();
            const bool isBelow = m_isOnFloor[vertex];
            if (!isBelow)
                side.push_back(vertex);
            if (!isBelow && !isCorner(vertex))
                continue;
            const std::uint32_t corner = isBelow ? vertex : (isLast ? below.front() : cornerBelow(vertex));
            side.push_back(corner);
            if (k > 0)
                closeSide(side);
            if (!isLast)
                below.push_back(corner);
            side.assign(1, corner);
            if (!isBelow)
                side.push_back(vertex);
        }
        return below;
    }
    std::uint32_t cornerBelow(std::uint32_t vertex) {
        const std::uint32_t copy = copyOf(vertex);
        m_solid.vertices[copy] = onFloor(Vec2(m_solid.vertices[vertex]));
        return copy;
    }
    void closeSide(const std::vector<std::uint32_t>& side) {
        const Vec2 way = Vec2(m_solid.vertices[side.back()]) - Vec2(m_solid.vertices[side.front()]);
        const double length = glm::length(way);
        if (side.size() > 2 && length > 0)
            addSide(side, way / length, m_solid);
    }

    struct Outline {
        const PlanLoop* loop;
        double area; // twice
    };

    /// Nothing but false if outlines cross.
    [[nodiscard]] bool addUnderside(const std::vector<PlanLoop>& loops) {
        std::vector<Vec2> plan;
        plan.reserve(m_solid.vertices.size());
        for (const Vec3& vertex : m_solid.vertices)
            plan.emplace_back(vertex);
        std::vector<Outline> parts;
        std::vector<const PlanLoop*> holes;
        const double least = kLeastPart * m_frame.cell() * m_frame.cell();
        for (const PlanLoop& loop : loops) {
            const double area = areaOf(plan, loop);
            if (std::abs(area) < least) // a rib between walls that is thinner than the grid resolves
                for (const std::uint32_t vertex : loop)
                    m_touching.push_back(m_points[vertex]);
            else if (area > 0)
                parts.push_back({&loop, area});
            else
                holes.push_back(&loop);
        }
        if (!m_touching.empty())
            return false;
        std::ranges::stable_sort(parts, {}, &Outline::area); // a hole is in the smallest that it is in
        std::vector<std::vector<PlanLoop>> polygons;
        polygons.reserve(parts.size());
        for (const Outline& part : parts)
            polygons.push_back({*part.loop});
        for (const PlanLoop* hole : holes) {
            const auto around = std::ranges::find_if(
                parts, [&](const Outline& part) { return isInside(plan, *part.loop, plan[hole->front()]); });
            if (around == parts.end())
                return false;
            polygons[static_cast<std::size_t>(around - parts.begin())].push_back(*hole);
        }
        return std::ranges::all_of(polygons, [&](const std::vector<PlanLoop>& polygon) {
            const auto triangles = triangulatePolygon(plan, polygon);
            if (!triangles)
                return false;
            for (const auto& [a, b, c] : *triangles)
                m_solid.triangles.push_back({a, c, b});
            return true;
        });
    }
    [[nodiscard]] static bool isInside(const std::vector<Vec2>& plan, const PlanLoop& loop,
                                       const Vec2& place) {
        bool inside = false;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec2& a = plan[loop[k]];
            const Vec2& b = plan[loop[(k + 1) % loop.size()]];
            if ((a.y > place.y) != (b.y > place.y) &&
                place.x < a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x))
                inside = !inside;
        }
        return inside;
    }

    const SolidFrame& m_frame;
    LatticeNumbers m_numbers;
    std::vector<std::uint32_t>& m_touching;
    std::vector<std::uint32_t> m_points; ///< of the map, by vertex
    std::vector<bool> m_isOnFloor;       ///< by vertex
    TriangleMesh m_solid;
};

} // namespace

std::optional<TriangleMesh> closeCutThrough(const SolidFrame& frame, std::vector<LatticeTriangle> surface,
                                            std::vector<std::uint32_t>& touching,
                                            const WorkContext& context) {
    return CutThrough(frame, touching).build(std::move(surface), context);
}

} // namespace proveout
