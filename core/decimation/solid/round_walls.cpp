// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/round_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/decimation/solid/corners.h"
#include "core/decimation/solid/solid_error.h"

namespace proveout {

namespace {

/// Walls that turn by more between two points are not taken as round.
constexpr double kMostTurn = 0.5; // the cosine of 60°
/// Longer edges, in cells, have had points between their ends, and are near them.
constexpr double kLongest = 2;
/// Edges that lead so far up or down a slope, as a part of how far the curve would be from them, are not of
/// an upright wall.
constexpr double kAcross = 0.1;
/// Of an edge: each brings it four times as near to its curve.
constexpr int kMostHalvings = 4;
/// Triangles that become part of others keep their direction by so much, as a cosine.
constexpr double kSameSide = 0.5;

class RoundWalls {
public:
    RoundWalls(const SolidFrame& frame, double tolerance, TriangleMesh& solid)
        : m_coordinates(frame.coordinates()), m_tolerance(tolerance), m_longest(kLongest * frame.cell()),
          m_solid(solid) {
        const Grid& grid = frame.zmap().grid();
        m_lo = roundedTo(m_coordinates, Vec3(grid.x(0), grid.y(0), 0));
        m_hi = roundedTo(m_coordinates, Vec3(grid.x(grid.nx - 1), grid.y(grid.ny - 1), 0));
        findNormals(frame);
        for (std::uint32_t t = 0; t < solid.triangles.size(); ++t) {
            link(t);
            for (std::size_t k = 0; k < 3; ++k)
                propose(solid.triangles[t][k], solid.triangles[t][(k + 1) % 3]);
        }
    }

    void run() {
        // The edges of walls first. Those between them are then exchanged for edges that lead straight up;
        // what is left is divided too.
        std::vector<Candidate> inside;
        eachCandidate([&](const Candidate& edge, const Middle& middle) {
            if (isCrease(edge.from, edge.to))
                tryDivide(edge.from, edge.to, middle);
            else
                inside.push_back(edge);
        });
        for (const Candidate& edge : inside)
            m_toLookAt.push(edge);
        eachCandidate([&](const Candidate& edge, const Middle& middle) {
            if (isOfWall(edge.from, edge.to) && !straighten(edge.from, edge.to, middle.away))
                tryDivide(edge.from, edge.to, middle);
        });
    }

private:
    using Edge = std::uint64_t;
    using Triangle = std::array<std::uint32_t, 3>;
    struct Middle {
        Vec3 at;
        Vec2 normal;
        double away; ///< from the edge, mm
    };
    struct Candidate {
        double away;
        std::uint32_t from;
        std::uint32_t to;
        // NOLINTNEXTLINE(modernize-use-nullptr): found in what the compiler generates
        friend auto operator<=>(const Candidate&, const Candidate&) = default;
    };
    [[nodiscard]] static Edge edge(std::uint32_t from, std::uint32_t to) {
        return std::uint64_t{from} << 32U | to;
    }
    using Place = std::array<double, 3>;
    [[nodiscard]] Place placeOf(const Vec3& at) const {
        const Vec3 rounded = roundedTo(m_coordinates, at);
        return {rounded.x, rounded.y, rounded.z};
    }

    void findNormals(const SolidFrame& frame) {
        std::map<Place, Vec2> normals;
        const auto points = frame.zmap().walls().offsetsIn({0, 0, frame.nx(), frame.ny()});
        for (const std::uint32_t point : points) {
            const Vec2 normal = frame.wallNormal(point);
            if (glm::dot(normal, normal) > 0)
                normals.emplace(placeOf(frame.top(point)), normal);
        }
        for (const Vec3& vertex : m_solid.vertices) {
            const auto found = normals.find(placeOf(vertex));
            m_normals.push_back(found == normals.end() ? Vec2(0) : glm::normalize(found->second));
        }
        m_halvings.resize(m_normals.size());
    }
    [[nodiscard]] bool hasNormal(std::uint32_t vertex) const {
        return glm::dot(m_normals[vertex], m_normals[vertex]) > 0;
    }
    void link(std::uint32_t t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = m_solid.triangles[t][k];
            const std::uint32_t b = m_solid.triangles[t][(k + 1) % 3];
            if (!hasNormal(a) && !hasNormal(b))
                continue;
            m_triangleAt[edge(a, b)] = t;
        }
    }
    void propose(std::uint32_t a, std::uint32_t b) {
        if (const auto middle = middleOf(a, b))
            m_toLookAt.push({middle->away, a, b});
    }
    [[nodiscard]] bool isThere(std::uint32_t a, std::uint32_t b) const {
        return m_triangleAt.contains(edge(a, b)) && m_triangleAt.contains(edge(b, a));
    }

    /// Where an edge is divided; nothing if it is near enough to its curve, or not an edge of a wall.
    [[nodiscard]] std::optional<Middle> middleOf(std::uint32_t a, std::uint32_t b) const {
        const Vec2 chord = Vec2(m_solid.vertices[b]) - Vec2(m_solid.vertices[a]);
        const double length = glm::length(chord);
        const bool isNear = hasNormal(a) && hasNormal(b) && length > m_tolerance && length < m_longest;
        if (!isNear || isOnSide(a, b) || std::max(m_halvings[a], m_halvings[b]) >= kMostHalvings)
            return std::nullopt;
        const auto tangent = [&](std::uint32_t vertex) {
            const Vec2 along(-m_normals[vertex].y, m_normals[vertex].x);
            return glm::dot(along, chord) < 0 ? -along : along;
        };
        const Vec2 atA = tangent(a);
        const Vec2 atB = tangent(b);
        if (glm::dot(atA, chord) < kMostTurn * length || glm::dot(atB, chord) < kMostTurn * length ||
            glm::dot(m_normals[a], m_normals[b]) < kMostTurn)
            return std::nullopt;
        // On a slope, an edge up or down is straight.
        const double climb = std::abs(m_solid.vertices[a].z - m_solid.vertices[b].z);
        const double across = std::abs(glm::dot(m_normals[a] + m_normals[b], chord)) / 2;
        if (climb > m_tolerance && across > kAcross * glm::length(atA - atB) * length)
            return std::nullopt;
        // A cubic curve with these tangents, which is in the middle of an arc if the ends are those of one.
        const double speed = 4 * length / (2 + std::sqrt(2 + 2 * glm::dot(atA, atB)));
        const Vec2 beside = speed / 8 * (atA - atB);
        if (glm::length(beside) <= m_tolerance)
            return std::nullopt;
        const Vec2 along = glm::normalize(1.5 * chord - speed / 4 * (atA + atB));
        const Vec2 normal(-along.y, along.x);
        const Vec3 at = (m_solid.vertices[a] + m_solid.vertices[b]) / 2.0 + Vec3(beside, 0);
        return Middle{at, glm::dot(normal, m_normals[a]) < 0 ? -normal : normal, glm::length(beside)};
    }
    /// Whether an edge is on a side of the stock, whose triangles are in its plane.
    [[nodiscard]] bool isOnSide(std::uint32_t a, std::uint32_t b) const {
        const Vec3 p = roundedTo(m_coordinates, m_solid.vertices[a]);
        const Vec3 q = roundedTo(m_coordinates, m_solid.vertices[b]);
        const auto both = [&](int axis, double border) { return p[axis] == border && q[axis] == border; };
        return both(0, m_lo.x) || both(0, m_hi.x) || both(1, m_lo.y) || both(1, m_hi.y);
    }

    template<class Visit>
    void eachCandidate(const Visit& visit) {
        while (!m_toLookAt.empty()) {
            const Candidate edge = m_toLookAt.top();
            m_toLookAt.pop();
            const auto middle = isThere(edge.from, edge.to) ? middleOf(edge.from, edge.to) : std::nullopt;
            if (middle)
                visit(edge, *middle);
        }
    }
    void tryDivide(std::uint32_t a, std::uint32_t b, const Middle& middle) {
        if (makeRoom(a, b, middle.at) && makeRoom(b, a, middle.at))
            divide(a, b, middle);
    }
    [[nodiscard]] bool isCrease(std::uint32_t a, std::uint32_t b) const {
        return isLevel(corners(at(a, b))) != isLevel(corners(at(b, a)));
    }
    /// Whether one of the triangles at an edge is not level.
    [[nodiscard]] bool isOfWall(std::uint32_t a, std::uint32_t b) const {
        return !isLevel(corners(at(a, b))) || !isLevel(corners(at(b, a)));
    }
    [[nodiscard]] const Triangle& at(std::uint32_t a, std::uint32_t b) const {
        return m_solid.triangles[m_triangleAt.at(edge(a, b))];
    }

    /// Whether an edge may be divided as far as the triangle on its left is concerned. One that is level and
    /// so narrow that the middle is beyond its other sides is exchanged for a wider one.
    [[nodiscard]] bool makeRoom(std::uint32_t a, std::uint32_t b, const Vec3& middle) {
        constexpr int kMostFlips = 8;
        for (int k = 0; k < kMostFlips; ++k) {
            const std::uint32_t c = thirdOf(at(a, b), a, b);
            const bool first = isSame({a, b, c}, {m_solid.vertices[a], middle, m_solid.vertices[c]});
            const bool second = isSame({a, b, c}, {middle, m_solid.vertices[b], m_solid.vertices[c]});
            if (first && second)
                return true;
            if (first == second || !(first ? flip(b, c) : flip(c, a)))
                return false;
        }
        return false;
    }
    /// The points opposite to an edge, and whether it may be exchanged for one between them.
    struct Quad {
        std::uint32_t c;
        std::uint32_t d;
        bool isSound;
    };
    [[nodiscard]] Quad quadAt(std::uint32_t a, std::uint32_t b) const {
        const Triangle left = at(a, b);
        const Triangle right = at(b, a);
        const std::uint32_t c = thirdOf(left, a, b);
        const std::uint32_t d = thirdOf(right, a, b);
        const bool isNew = !m_triangleAt.contains(edge(c, d)) && !m_triangleAt.contains(edge(d, c));
        const bool sameWay = isSame(left, corners({a, d, c})) && isSame(left, corners({d, b, c})) &&
                             isSame(right, corners({a, d, c})) && isSame(right, corners({d, b, c}));
        return {c, d, isNew && sameWay};
    }
    /// Exchanges the edge between two level triangles.
    bool flip(std::uint32_t a, std::uint32_t b) {
        if (!isThere(a, b) || isOfWall(a, b))
            return false;
        const Quad quad = quadAt(a, b);
        if (quad.isSound)
            exchange(a, b, quad);
        return quad.isSound;
    }
    /// Exchanges an edge of a wall for one that is much nearer to its curve.
    bool straighten(std::uint32_t a, std::uint32_t b, double away) {
        constexpr double kNearer = 0.7;
        if (isCrease(a, b))
            return false;
        const Quad quad = quadAt(a, b);
        if (!quad.isSound || !hasNormal(quad.c) || !hasNormal(quad.d))
            return false;
        const auto other = middleOf(quad.c, quad.d);
        if (other && other->away > kNearer * away)
            return false;
        exchange(a, b, quad);
        return true;
    }
    void exchange(std::uint32_t a, std::uint32_t b, const Quad& quad) {
        const std::uint32_t left = m_triangleAt[edge(a, b)];
        const std::uint32_t right = m_triangleAt[edge(b, a)];
        m_triangleAt.erase(edge(a, b));
        m_triangleAt.erase(edge(b, a));
        m_solid.triangles[left] = {a, quad.d, quad.c};
        m_solid.triangles[right] = {quad.d, b, quad.c};
        link(left);
        link(right);
        propose(quad.c, quad.d);
    }

    void divide(std::uint32_t a, std::uint32_t b, const Middle& middle) {
        const std::uint32_t left = m_triangleAt[edge(a, b)];
        const std::uint32_t right = m_triangleAt[edge(b, a)];
        const std::uint32_t c = thirdOf(m_solid.triangles[left], a, b);
        const std::uint32_t d = thirdOf(m_solid.triangles[right], a, b);
        const auto m = static_cast<std::uint32_t>(m_solid.vertices.size());
        m_solid.vertices.push_back(middle.at);
        m_normals.push_back(middle.normal);
        m_halvings.push_back(std::max(m_halvings[a], m_halvings[b]) + 1);
        m_triangleAt.erase(edge(a, b));
        m_triangleAt.erase(edge(b, a));
        const auto last = static_cast<std::uint32_t>(m_solid.triangles.size());
        m_solid.triangles[left] = {a, m, c};
        m_solid.triangles[right] = {b, m, d};
        m_solid.triangles.push_back({m, b, c});
        m_solid.triangles.push_back({m, a, d});
        for (const std::uint32_t t : {left, right, last, last + 1})
            link(t);
        for (const std::uint32_t around : {a, b, c, d})
            propose(m, around);
    }
    [[nodiscard]] static std::uint32_t thirdOf(const Triangle& triangle, std::uint32_t a, std::uint32_t b) {
        return *std::ranges::find_if(triangle, [&](auto vertex) { return vertex != a && vertex != b; });
    }
    [[nodiscard]] Corners corners(const Triangle& triangle) const {
        return {m_solid.vertices[triangle[0]], m_solid.vertices[triangle[1]], m_solid.vertices[triangle[2]]};
    }
    /// Whether a part of a triangle faces as it does.
    [[nodiscard]] bool isSame(const Triangle& triangle, const Corners& part) const {
        const Vec3 whole = normalOf(corners(triangle));
        const Vec3 normal = normalOf(part);
        return glm::dot(whole, normal) > kSameSide * glm::length(whole) * glm::length(normal) &&
               isSound(m_coordinates, part);
    }

    CoordinateType m_coordinates;
    double m_tolerance;
    double m_longest;
    TriangleMesh& m_solid;
    Vec3 m_lo{0}; ///< the sides of the stock
    Vec3 m_hi{0};
    std::vector<Vec2> m_normals;                          ///< of the walls, by vertex; 0: none
    std::vector<int> m_halvings;                          ///< that made a vertex
    std::unordered_map<Edge, std::uint32_t> m_triangleAt; ///< by its edges with a normal at one end
    std::priority_queue<Candidate> m_toLookAt;            ///< what is farthest from its curve first
};

} // namespace

void roundWalls(const SolidFrame& frame, double tolerance, TriangleMesh& solid) {
    RoundWalls(frame, tolerance, solid).run();
}

} // namespace proveout
