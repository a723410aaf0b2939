// SPDX-License-Identifier: GPL-3.0-or-later
// Ear clipping: holes are joined to the outline by bridges, then corners without other points in them are cut
// off, the best-shaped ones first.
#include "core/decimation/solid/plan_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>

namespace proveout {

namespace {

constexpr std::size_t kMostCorners = 20000;
/// Corners whose height is a smaller part of their longest side are straight.
constexpr double kStraight = 1e-9;

using Node = std::uint32_t;

class EarClipper {
public:
    EarClipper(std::span<const Vec2> points, const std::vector<PlanLoop>& loops) : m_points(points) {
        std::size_t count = 0;
        for (const PlanLoop& loop : loops)
            count += loop.size() + 2; // a bridge repeats both of its ends
        m_next.reserve(count);
        m_previous.reserve(count);
        m_vertex.reserve(count);
        m_first = add(loops.front());
    }

    /// Joins a hole to the polygon; false if no point of it is seen from the hole.
    [[nodiscard]] bool join(const PlanLoop& hole) {
        const auto right = std::ranges::max_element(hole, {}, [&](auto point) { return m_points[point].x; });
        const auto end = bridgeFrom(m_points[*right]);
        if (!end)
            return false;
        PlanLoop turned = hole;
        std::rotate(turned.begin(), turned.begin() + (right - hole.begin()), turned.end());
        const Node first = add(turned);
        const Node last = m_previous[first];
        // … end, first, …, last, first again, end again, …
        const Node back = hole.size() == 1 ? first : copyAfter(last, m_vertex[first]);
        const Node endAgain = copyAfter(*end, m_vertex[*end]);
        link(*end, first);
        link(back, endAgain);
        return true;
    }

    [[nodiscard]] std::optional<std::vector<std::array<std::uint32_t, 3>>> clip() {
        std::size_t left = m_vertex.size();
        m_stamp.assign(m_vertex.size(), 0);
        m_isThere.assign(m_vertex.size(), true);
        bool isFresh = false;
        while (left > 3) {
            if (m_ears.empty()) {
                if (isFresh)
                    return std::nullopt;
                for (Node node = 0; node < m_vertex.size(); ++node) {
                    if (m_isThere[node])
                        look(node);
                }
                isFresh = true;
                continue;
            }
            const Ear ear = m_ears.top();
            m_ears.pop();
            if (!m_isThere[ear.node] || m_stamp[ear.node] != ear.stamp)
                continue;
            cutOff(ear.node);
            --left;
            isFresh = false;
        }
        if (!(shapeOf(m_first) > 0))
            return std::nullopt;
        m_triangles.push_back(triangleAt(m_first));
        return std::move(m_triangles);
    }

private:
    struct Ear {
        double shape;
        Node node;
        std::uint32_t stamp;
        friend bool operator<(const Ear& a, const Ear& b) {
            return std::pair(a.shape, b.node) < std::pair(b.shape, a.node);
        }
    };

    [[nodiscard]] const Vec2& at(Node node) const { return m_points[m_vertex[node]]; }
    void link(Node from, Node to) {
        m_next[from] = to;
        m_previous[to] = from;
    }
    Node add(const PlanLoop& loop) {
        const auto first = static_cast<Node>(m_vertex.size());
        for (std::size_t k = 0; k < loop.size(); ++k) {
            m_vertex.push_back(loop[k]);
            m_next.push_back(first + static_cast<Node>((k + 1) % loop.size()));
            m_previous.push_back(first + static_cast<Node>((k + loop.size() - 1) % loop.size()));
        }
        return first;
    }
    /// Adds a node after another one.
    Node copyAfter(Node node, std::uint32_t vertex) {
        const auto copy = static_cast<Node>(m_vertex.size());
        m_vertex.push_back(vertex);
        m_next.push_back(m_next[node]);
        m_previous.push_back(node);
        m_previous[m_next[copy]] = copy;
        m_next[node] = copy;
        return copy;
    }

    /// Whether a place is within the angle of the polygon at a node.
    [[nodiscard]] bool sees(Node node, const Vec2& place) const {
        const Vec2& here = at(node);
        const Vec2& last = at(m_previous[node]);
        const Vec2& next = at(m_next[node]);
        const double besideNext = turn(here, next, place);
        const double besideLast = turn(last, here, place);
        const double angle = turn(last, here, next);
        if (angle > 0)
            return besideNext > 0 && besideLast > 0;
        if (angle < 0)
            return besideNext > 0 || besideLast > 0;
        if (glm::dot(last - here, next - here) < 0)
            return besideNext > 0; // straight
        // At the end of a bridge.
        return besideNext < 0 || besideNext > 0 || glm::dot(next - here, place - here) < 0;
    }

    /// The node that a bridge from the rightmost point of a hole leads to.
    [[nodiscard]] std::optional<Node> bridgeFrom(const Vec2& from) const {
        double nearest = std::numeric_limits<double>::infinity();
        std::optional<Node> end;
        eachNode([&](Node node) { // edges that a ray to the right meets from inside
            const Vec2& a = at(node);
            const Vec2& b = at(m_next[node]);
            if (a.y > from.y || b.y < from.y || a.y == b.y)
                return;
            const double x = a.x + (from.y - a.y) / (b.y - a.y) * (b.x - a.x);
            if (x > from.x && x < nearest) {
                nearest = x;
                end = a.x > b.x ? node : m_next[node];
            }
        });
        if (!end)
            return std::nullopt;
        // Points in the triangle between the ray and that end may hide it: the one nearest to the ray's
        // direction is seen.
        const Vec2 hit(nearest, from.y);
        const Vec2 corner = at(*end);
        double flattest = std::numeric_limits<double>::infinity();
        std::optional<Node> seen;
        eachNode([&](Node node) {
            const Vec2& place = at(node);
            if (!(place.x > from.x) || !covers(from, hit, corner, place) || !sees(node, from))
                return;
            const double slope = std::abs(place.y - from.y) / (place.x - from.x);
            if (slope < flattest || (slope == flattest && place.x < at(*seen).x)) {
                flattest = slope;
                seen = node;
            }
        });
        return seen;
    }
    template<class Visit>
    void eachNode(const Visit& visit) const {
        Node node = m_first;
        do {
            visit(node);
            node = m_next[node];
        } while (node != m_first);
    }
    /// Whether a triangle of either orientation has a place in it, on its sides or, as areas, so little
    /// beside them.
    [[nodiscard]] static bool covers(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& place,
                                     double slack = 0) {
        const auto [least, most] = std::minmax({turn(a, b, place), turn(b, c, place), turn(c, a, place)});
        return least >= -slack || most <= slack;
    }

    [[nodiscard]] std::array<std::uint32_t, 3> triangleAt(Node node) const {
        return {m_vertex[m_previous[node]], m_vertex[node], m_vertex[m_next[node]]};
    }
    /// The height of a corner over its longest side, as a part of it; 0: not convex.
    [[nodiscard]] double shapeOf(Node node) const {
        const Vec2& a = at(m_previous[node]);
        const Vec2& b = at(node);
        const Vec2& c = at(m_next[node]);
        const Vec2 ab = b - a;
        const Vec2 bc = c - b;
        const Vec2 ca = a - c;
        const double longest2 = std::max({glm::dot(ab, ab), glm::dot(bc, bc), glm::dot(ca, ca)});
        const double shape = longest2 > 0 ? turn(a, b, c) / longest2 : 0;
        return shape > kStraight ? shape : 0;
    }
    [[nodiscard]] bool isFree(Node node) const {
        const auto corners = triangleAt(node);
        const Vec2& a = m_points[corners[0]];
        const Vec2& b = m_points[corners[1]];
        const Vec2& c = m_points[corners[2]];
        Vec2 lo = glm::min(a, glm::min(b, c));
        Vec2 hi = glm::max(a, glm::max(b, c));
        const double size2 = glm::dot(hi - lo, hi - lo);
        const double slack = kStraight * size2;
        lo -= kStraight * std::sqrt(size2);
        hi += kStraight * std::sqrt(size2);
        for (Node other = m_next[m_next[node]]; other != m_previous[node]; other = m_next[other]) {
            const Vec2& place = at(other);
            if (place.x < lo.x || place.x > hi.x || place.y < lo.y || place.y > hi.y)
                continue;
            const bool isCorner = std::ranges::find(corners, m_vertex[other]) != corners.end();
            if (!isCorner && covers(a, b, c, place, slack))
                return false;
        }
        return true;
    }
    void look(Node node) {
        const double shape = shapeOf(node);
        ++m_stamp[node];
        if (shape > 0 && isFree(node))
            m_ears.push({shape, node, m_stamp[node]});
    }
    void cutOff(Node node) {
        m_triangles.push_back(triangleAt(node));
        const Node last = m_previous[node];
        const Node next = m_next[node];
        link(last, next);
        m_isThere[node] = false;
        m_first = next;
        look(last);
        look(next);
    }

    std::span<const Vec2> m_points;
    std::vector<std::uint32_t> m_vertex; ///< by node
    std::vector<Node> m_next;
    std::vector<Node> m_previous;
    std::vector<std::uint32_t> m_stamp; ///< of the last look
    std::vector<bool> m_isThere;
    Node m_first = 0;
    std::priority_queue<Ear> m_ears;
    std::vector<std::array<std::uint32_t, 3>> m_triangles;
};

} // namespace

double areaOf(std::span<const Vec2> points, const PlanLoop& loop) {
    double area = 0;
    for (std::size_t k = 1; k + 1 < loop.size(); ++k)
        area += turn(points[loop[0]], points[loop[k]], points[loop[k + 1]]);
    return area;
}

std::optional<std::vector<std::array<std::uint32_t, 3>>>
triangulatePolygon(std::span<const Vec2> points, const std::vector<PlanLoop>& loops) {
    std::size_t count = 0;
    double area = 0;
    for (const PlanLoop& loop : loops) {
        count += loop.size();
        area += areaOf(points, loop);
    }
    if (loops.empty() || loops.front().size() < 3 || count > kMostCorners || !(area > 0))
        return std::nullopt;
    EarClipper clipper(points, loops);
    // From the right: what is to the right of a hole has been joined then.
    std::vector<const PlanLoop*> holes;
    for (std::size_t k = 1; k < loops.size(); ++k)
        holes.push_back(&loops[k]);
    const auto right = [&](const PlanLoop* hole) {
        double most = -std::numeric_limits<double>::infinity();
        for (const std::uint32_t point : *hole)
            most = std::max(most, points[point].x);
        return most;
    };
    std::ranges::stable_sort(holes, std::ranges::greater(), right);
    for (const PlanLoop* hole : holes) {
        if (!clipper.join(*hole))
            return std::nullopt;
    }
    auto triangles = clipper.clip();
    if (!triangles)
        return std::nullopt;
    // All are counter-clockwise: if they have the area of the polygon, they cover it once.
    constexpr double kRounding = 1e-9;
    double covered = 0;
    for (const auto& [a, b, c] : *triangles)
        covered += turn(points[a], points[b], points[c]);
    return std::abs(covered - area) <= kRounding * area ? triangles : std::nullopt;
}

} // namespace proveout
