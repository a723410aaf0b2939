// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/wall_simplifier.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/decimation/solid/corners.h"
#include "core/decimation/solid/creases.h"
#include "core/decimation/solid/point_distance.h"

namespace proveout {

namespace {

constexpr double kFlat = 1e-3;     ///< of a cell: flatter triangles are not made, nor changed
constexpr double kTurn = 0.9;      ///< cosine of the largest turn of a triangle
constexpr double kCoplanar = 1e-5; ///< mm
/// The vertical part of normals: up to the first, of walls; up to the second, of slopes beside creases.
constexpr double kSheet = 0.05;
constexpr double kSlope = 0.65;
/// Points of straight walls are as near to the line between their neighbours, as a part of a cell: rims are
/// known to 65 536ths.
constexpr double kStraight = 2.0 / 65536;
/// The most slack, as a part of what is allowed.
constexpr double kMostSlack = 0.05;
constexpr int kMostPoints = 4096; ///< of the map, that are looked at for one triangle

/// Vertices with more triangles around them are not removed, and none gets more.
constexpr std::size_t kMostAround = 128;

// Their places in the lists of those beside walls.
using Triangle = std::uint32_t;
using Vertex = std::uint32_t;

class WallSimplifier {
public:
    WallSimplifier(const SolidFrame& frame, double allowance, std::vector<LatticeTriangle>& surface)
        : m_frame(frame), m_zmap(frame.zmap()), m_surface(surface), m_allowance(allowance),
          m_atWalls(kWallShare * allowance), m_cell(frame.cell()), m_straight(kStraight * frame.cell()) {
        for (std::size_t t = 0; t < surface.size(); ++t)
            add(t);
    }

    void run(const WorkContext& context) {
        std::vector<Vertex> queue(m_at.size());
        std::iota(queue.begin(), queue.end(), Vertex{0});
        for (; !queue.empty() && !context.stopped(); queue = std::exchange(m_next, {}))
            runRound(queue, context);
        for (const Beside& beside : m_beside) {
            for (std::size_t k = 0; k < 3; ++k)
                m_surface[beside.index][k] = m_points[beside.corners[k]];
        }
        std::erase_if(m_surface, [](const LatticeTriangle& triangle) { return triangle[0] == triangle[1]; });
    }

private:
    struct Beside {
        std::size_t index;         ///< in the surface
        LatticeTriangle corners;   ///< as Vertex
        std::vector<Vec3> removed; ///< points that this triangle is nearest to
        double slack = 0;          ///< mm, by which others may be farther than the vertices and these
    };
    struct Steep {
        Corners at;
        std::size_t kept; ///< which of the kept ones
    };
    /// What a removal would make of the triangles around a vertex.
    struct Change {
        std::uint32_t to = 0;
        double atVertex = 0; ///< how far the vertex is from the kept ones
        std::vector<Triangle> kept;
        std::vector<LatticeTriangle> corners; ///< of the kept ones
        std::vector<Steep> steep;             ///< those of them
        std::vector<std::size_t> nearest;     ///< by removed point: of the kept ones
    };

    /// Neighbours are not removed in the same round: along a wall, one vertex would otherwise get the
    /// triangles of all those before it.
    void runRound(const std::vector<Vertex>& queue, const WorkContext& context) {
        ++m_round;
        for (const Vertex vertex : queue) {
            if (context.stopped())
                return;
            m_isQueued[vertex] = false;
            if (m_restsIn[vertex] == m_round)
                enqueue(vertex);
            else if (m_isRemovable[vertex] && m_stars[vertex].size() <= kMostAround)
                tryRemove(vertex);
        }
    }
    void enqueue(Vertex vertex) {
        if (m_isRemovable[vertex] && !m_isQueued[vertex]) {
            m_isQueued[vertex] = true;
            m_next.push_back(vertex);
        }
    }

    void add(std::size_t t) {
        if (!m_frame.isBesideWall(m_surface[t]))
            return;
        LatticeTriangle corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = vertexOf(m_surface[t][k], m_frame.isBesideWall(m_surface[t][k]));
            m_stars[corners[k]].push_back(static_cast<Triangle>(m_beside.size()));
        }
        m_beside.push_back({t, corners, {}, 0});
    }
    Vertex vertexOf(std::uint32_t point, bool isWall) {
        const auto [known, isNew] = m_vertexOf.try_emplace(point, static_cast<Vertex>(m_at.size()));
        if (isNew) {
            m_points.push_back(point);
            m_at.push_back(m_frame.top(point));
            m_uphill.push_back(m_frame.wallNormal(point));
            m_stars.emplace_back();
            m_isWall.push_back(isWall);
            m_isOutline.push_back(m_frame.onOutline(point));
            m_isRemovable.push_back(isWall && !m_isOutline.back());
            m_isQueued.push_back(true);
            m_restsIn.push_back(0);
        }
        return known->second;
    }

    [[nodiscard]] const Vec3& at(Vertex vertex) const { return m_at[vertex]; }
    [[nodiscard]] Corners at(const LatticeTriangle& triangle) const {
        return {at(triangle[0]), at(triangle[1]), at(triangle[2])};
    }
    [[nodiscard]] LatticeTriangle& corners(Triangle triangle) { return m_beside[triangle].corners; }
    [[nodiscard]] const LatticeTriangle& corners(Triangle triangle) const {
        return m_beside[triangle].corners;
    }
    [[nodiscard]] static bool has(const LatticeTriangle& triangle, std::uint32_t vertex) {
        return std::ranges::find(triangle, vertex) != triangle.end();
    }

    /// The vertices around one, ascending.
    [[nodiscard]] std::vector<std::uint32_t> ringOf(std::uint32_t vertex) const {
        std::vector<std::uint32_t> ring;
        for (const Triangle triangle : m_stars[vertex]) {
            for (const std::uint32_t corner : corners(triangle)) {
                if (corner != vertex)
                    ring.push_back(corner);
            }
        }
        std::ranges::sort(ring);
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end()); // clang 14 lacks that of ranges
        return ring;
    }

    void tryRemove(std::uint32_t vertex) {
        const std::vector<std::uint32_t> ring = ringOf(vertex);
        std::vector<Vec3> points{at(vertex)};
        double slack = 0;
        for (const Triangle triangle : m_stars[vertex]) {
            const Beside& beside = m_beside[triangle];
            points.insert(points.end(), beside.removed.begin(), beside.removed.end());
            slack = std::max(slack, beside.slack);
        }
        std::optional<Change> change = nearestChange(vertex, ring, points, m_atWalls - slack);
        if (!change)
            return;
        // Between its neighbours on a straight wall, it is no farther than they are.
        const bool isBetween =
            change->atVertex <= m_straight && slack + change->atVertex <= kMostSlack * m_atWalls;
        if (isBetween) {
            points.erase(points.begin());
            change->nearest.erase(change->nearest.begin());
        }
        apply(vertex, *change, points, ring);
        for (const Triangle triangle : change->kept)
            m_beside[triangle].slack = slack + (isBetween ? change->atVertex : 0);
    }

    /// Whether a removal would join two points of the outline, as a triangle of a side of the solid may.
    [[nodiscard]] bool joinsOutline(std::uint32_t to, const std::vector<std::uint32_t>& ring,
                                    const std::vector<std::uint32_t>& around) const {
        return m_isOutline[to] && std::ranges::any_of(ring, [&](std::uint32_t vertex) {
                   return vertex != to && m_isOutline[vertex] && !std::ranges::binary_search(around, vertex);
               });
    }

    /// The change that leaves the vertex itself nearest to the wall, if all points are within `allowed` of
    /// it, or else the next nearest.
    [[nodiscard]] std::optional<Change> nearestChange(std::uint32_t vertex,
                                                      const std::vector<std::uint32_t>& ring,
                                                      const std::vector<Vec3>& points, double allowed) const {
        std::vector<Change> possible;
        for (const std::uint32_t to : ring) {
            if (!m_isWall[to] || m_stars[to].size() > kMostAround || !isBeside(vertex, to, ring, allowed))
                continue;
            std::optional<Change> change = changeTo(vertex, to, ring);
            if (!change)
                continue;
            change->atVertex = nearestTo(at(vertex), *change).first;
            if (change->atVertex <= allowed)
                possible.push_back(std::move(*change));
        }
        std::ranges::stable_sort(possible, {}, &Change::atVertex);
        for (Change& change : possible) {
            if (areWithin(points, allowed, change))
                return std::move(change);
        }
        return std::nullopt;
    }

    /// Whether a line from `to` to another vertex of the ring passes a vertex at its edge of the wall. A
    /// quick test, which few pass.
    [[nodiscard]] bool isBeside(std::uint32_t vertex, std::uint32_t to,
                                const std::vector<std::uint32_t>& ring, double allowed) const {
        return std::ranges::any_of(ring, [&](std::uint32_t other) {
            return other != to && m_isWall[other] &&
                   distanceToSegment(at(vertex), at(to), at(other)) <= allowed;
        });
    }

    /// Nothing where it is not possible.
    [[nodiscard]] std::optional<Change> changeTo(std::uint32_t vertex, std::uint32_t to,
                                                 const std::vector<std::uint32_t>& ring) const {
        const std::vector<std::uint32_t> other = ringOf(to);
        std::vector<std::uint32_t> common;
        std::ranges::set_intersection(ring, other, std::back_inserter(common));
        if (common.size() != 2)
            return std::nullopt; // else an edge would have more than two triangles
        if (joinsOutline(to, ring, other))
            return std::nullopt;
        Change change;
        change.to = to;
        for (const Triangle triangle : m_stars[vertex]) {
            LatticeTriangle now = corners(triangle);
            if (has(now, to))
                continue;
            const LatticeTriangle was = now;
            std::ranges::replace(now, vertex, to);
            if (!mayBecome(at(was), at(now), at(vertex)) || (isAcross(now) && !isAcross(was)))
                return std::nullopt;
            if (isSteep(at(now)))
                change.steep.push_back({at(now), change.kept.size()});
            change.kept.push_back(triangle);
            change.corners.push_back(now);
        }
        return change;
    }

    /// The least distance of a point from the steep triangles of a change, and which of them is the nearest:
    /// it may be on others, but not on their edges.
    [[nodiscard]] std::pair<double, std::size_t> nearestTo(const Vec3& point, const Change& change) const {
        std::pair<double, std::size_t> nearest{std::numeric_limits<double>::infinity(), 0};
        for (const Steep& steep : change.steep) {
            const double distance = distanceToTriangle(point, steep.at[0], steep.at[1], steep.at[2]);
            if (distance < nearest.first)
                nearest = {distance, steep.kept};
        }
        return nearest;
    }

    /// Notes to which triangles the points belong then.
    [[nodiscard]] bool areWithin(const std::vector<Vec3>& points, double allowed, Change& change) const {
        for (const Vec3& point : points) {
            const auto [distance, nearest] = nearestTo(point, change);
            if (distance > allowed)
                return false;
            change.nearest.push_back(nearest);
        }
        return true;
    }

    /// Whether it is so flat that its normal says nothing.
    [[nodiscard]] bool isFlat(const Corners& corners) const { return !(flatness(corners) > kFlat * m_cell); }

    [[nodiscard]] bool mayBecome(const Corners& before, const Corners& now, const Vec3& removed) const {
        const Vec3 was = normalOf(before);
        const Vec3 is = normalOf(now);
        const double size = glm::length(is);
        if (isFlat(before) || isFlat(now) || glm::dot(was, is) < kTurn * size * glm::length(was))
            return false;
        if (isWall(now) && is.z <= 0)
            return true; // round walls overhang a little
        if (is.z < 0 || (isSteep(now) && !isSteep(before)))
            return false; // turned over, or in a tip that is narrower than cells, from one side of the wall
                          // to the other
        // On one plane, nothing changes for the points under it.
        const bool flat = std::abs(glm::dot(is, removed - now[0])) <= kCoplanar * size;
        return flat || isNearPoints(now, is);
    }

    [[nodiscard]] bool isAcross(const LatticeTriangle& triangle) const {
        return isAcrossCrease(at(triangle),
                              {m_uphill[triangle[0]], m_uphill[triangle[1]], m_uphill[triangle[2]]}, m_cell);
    }

    [[nodiscard]] static bool isWall(const Corners& corners) {
        const Vec3 normal = normalOf(corners);
        return std::abs(normal.z) < kSheet * glm::length(normal);
    }

    [[nodiscard]] static bool isSteep(const Corners& corners) {
        const Vec3 normal = normalOf(corners);
        return normal.z < kSlope * glm::length(normal);
    }

    /// Whether the points of the map under a triangle are within the allowance of it.
    [[nodiscard]] bool isNearPoints(const Corners& corners, const Vec3& normal) const {
        const Grid& grid = m_zmap.grid();
        const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
        const auto [j0, j1] = pointsBetween(low, high, grid.y0, grid.hy, grid.ny);
        int left = kMostPoints;
        for (int j = j0; j <= j1; ++j) {
            const auto [from, to] = spanAt(corners, grid.y(j));
            const auto [i0, i1] = pointsBetween(from, to, grid.x0, grid.hx, grid.nx);
            left -= 1 + std::max(i1 - i0 + 1, 0);
            if (left < 0)
                return false;
            for (int i = i0; i <= i1; ++i) {
                const Vec2 place(grid.x(i), grid.y(j));
                const Vec2 away = place - Vec2(corners[0]);
                const double z = corners[0].z - (normal.x * away.x + normal.y * away.y) / normal.z;
                const double height = m_zmap.stock().topZ() + static_cast<double>(m_zmap.height(i, j));
                if (covers(corners, place) && std::abs(z - height) > m_allowance)
                    return false;
            }
        }
        return true;
    }
    /// The first and last of `count` points of the grid along an axis that are in an interval.
    [[nodiscard]] static std::pair<int, int> pointsBetween(double low, double high, double first,
                                                           double spacing, int count) {
        return {std::max(static_cast<int>(std::ceil((low - first) / spacing)), 0),
                std::min(static_cast<int>(std::floor((high - first) / spacing)), count - 1)};
    }
    /// Where a triangle crosses a line along x, and a little more.
    [[nodiscard]] static std::pair<double, double> spanAt(const Corners& corners, double y) {
        constexpr double kSlack = 1e-9;
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& a = corners[k];
            const Vec3& b = corners[(k + 1) % 3];
            if (std::min(a.y, b.y) > y || std::max(a.y, b.y) < y)
                continue;
            const double part = a.y == b.y ? 0 : (y - a.y) / (b.y - a.y);
            const double x = a.x + part * (b.x - a.x);
            low = std::min({low, x, a.y == b.y ? b.x : x});
            high = std::max({high, x, a.y == b.y ? b.x : x});
        }
        return {low - kSlack, high + kSlack};
    }
    [[nodiscard]] static bool covers(const Corners& corners, const Vec2& place) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 side = Vec2(corners[(k + 1) % 3]) - Vec2(corners[k]);
            const Vec2 to = place - Vec2(corners[k]);
            if (side.x * to.y - side.y * to.x < 0)
                return false;
        }
        return true;
    }

    void apply(std::uint32_t vertex, const Change& change, const std::vector<Vec3>& points,
               const std::vector<std::uint32_t>& ring) {
        for (const Triangle triangle : m_stars[vertex]) {
            m_beside[triangle].removed = {};
            if (!has(corners(triangle), change.to))
                continue;
            for (const Vertex corner : corners(triangle)) {
                if (corner != vertex)
                    std::erase(m_stars[corner], triangle);
            }
            corners(triangle) = {vertex, vertex, vertex}; // it is gone
        }
        std::vector<Triangle>& star = m_stars[change.to];
        for (std::size_t k = 0; k < change.kept.size(); ++k) {
            corners(change.kept[k]) = change.corners[k];
            star.push_back(change.kept[k]);
        }
        for (std::size_t k = 0; k < points.size(); ++k)
            m_beside[change.kept[change.nearest[k]]].removed.push_back(points[k]);
        m_stars[vertex].clear();
        m_isRemovable[vertex] = false;
        for (const Vertex neighbour : ring) {
            m_restsIn[neighbour] = m_round;
            enqueue(neighbour);
        }
    }

    const SolidFrame& m_frame;
    const ZMapSnapshot& m_zmap;
    std::vector<LatticeTriangle>& m_surface;
    double m_allowance;
    double m_atWalls;
    double m_cell;
    double m_straight;
    std::vector<Beside> m_beside;
    std::unordered_map<std::uint32_t, Vertex> m_vertexOf; ///< by point
    std::vector<std::uint32_t> m_points;                  ///< by vertex, as all that follow
    std::vector<Vec3> m_at;
    std::vector<Vec2> m_uphill;
    std::vector<std::vector<Triangle>> m_stars;
    std::vector<bool> m_isWall;
    std::vector<bool> m_isOutline;
    std::vector<bool> m_isRemovable;
    std::vector<bool> m_isQueued;
    std::vector<std::uint32_t> m_restsIn; ///< the last round in which it was left alone
    std::uint32_t m_round = 0;
    std::vector<Vertex> m_next;
};

} // namespace

void simplifyWalls(const SolidFrame& frame, double allowance, std::vector<LatticeTriangle>& surface,
                   const WorkContext& context) {
    WallSimplifier(frame, allowance, surface).run(context);
}

} // namespace proveout
