// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/level_folds.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "core/decimation/solid/corners.h"
#include "core/decimation/solid/plan_polygon.h"

namespace proveout {

namespace {

/// How far around a fold triangles are replaced, as steps from one to the next.
constexpr int kMostSteps = 4;

class LevelFolds {
public:
    LevelFolds(const SolidFrame& frame, std::vector<LatticeTriangle>& surface)
        : m_frame(frame), m_surface(surface) {}

    [[nodiscard]] FormerTriangles unfoldAll() {
        std::vector<std::size_t> folds;
        for (std::size_t t = 0; t < m_surface.size(); ++t) {
            if (m_frame.isBesideWall(m_surface[t]) && isFold(t))
                folds.push_back(t);
        }
        if (folds.empty())
            return {};
        m_triangleAt.reserve(3 * m_surface.size());
        for (std::size_t t = 0; t < m_surface.size(); ++t)
            link(t);
        for (const std::size_t t : folds) {
            if (isFold(t)) // another one may have taken it along
                unfold(t);
        }
        return std::move(m_former);
    }

private:
    using Edge = std::uint64_t;
    [[nodiscard]] static Edge edge(std::uint32_t from, std::uint32_t to) {
        return std::uint64_t{from} << 32U | to;
    }
    [[nodiscard]] static std::uint32_t endOf(Edge edge) { return static_cast<std::uint32_t>(edge); }

    void link(std::size_t t) {
        for (std::size_t k = 0; k < 3; ++k)
            m_triangleAt[edge(m_surface[t][k], m_surface[t][(k + 1) % 3])] = t;
    }
    [[nodiscard]] bool isFold(std::size_t t) const {
        return isLevel(t) && normalOf(m_frame.top(m_surface[t])).z < 0;
    }
    [[nodiscard]] bool isLevel(std::size_t t) const { return proveout::isLevel(m_frame.top(m_surface[t])); }

    void unfold(std::size_t fold) {
        std::vector<std::size_t> around{fold};
        for (int step = 0; step < kMostSteps; ++step) {
            const std::size_t before = around.size();
            addNeighbours(around);
            if (around.size() == before || replace(around))
                return;
        }
    }
    void addNeighbours(std::vector<std::size_t>& around) const {
        for (std::size_t n = around.size(), k = 0; k < n; ++k) {
            const LatticeTriangle& triangle = m_surface[around[k]];
            for (std::size_t side = 0; side < 3; ++side) {
                const auto beyond = m_triangleAt.find(edge(triangle[(side + 1) % 3], triangle[side]));
                if (beyond != m_triangleAt.end() && isLevel(beyond->second) &&
                    std::ranges::find(around, beyond->second) == around.end())
                    around.push_back(beyond->second);
            }
        }
    }

    [[nodiscard]] bool replace(const std::vector<std::size_t>& around) {
        std::unordered_set<Edge> edges;
        for (const std::size_t t : around)
            for (std::size_t k = 0; k < 3; ++k)
                edges.insert(edge(m_surface[t][k], m_surface[t][(k + 1) % 3]));
        const auto loop = outlineOf(edges);
        if (!loop)
            return false;
        std::vector<PlanLoop> loops{*loop};
        std::vector<std::uint32_t> points = *loop;
        for (const std::size_t t : around) {
            for (const std::uint32_t point : m_surface[t]) {
                if (std::ranges::find(points, point) == points.end()) {
                    loops.push_back({point});
                    points.push_back(point);
                }
            }
        }
        const auto triangles = triangulated(points, loops);
        if (!triangles || triangles->size() != around.size() || meetOthers(*triangles, edges))
            return false;
        exchange(around, *triangles, edges);
        return true;
    }

    /// The line around some triangles; nothing if there are several, or one that touches itself.
    [[nodiscard]] static std::optional<PlanLoop> outlineOf(const std::unordered_set<Edge>& edges) {
        std::unordered_map<std::uint32_t, std::uint32_t> next;
        std::uint32_t first = 0;
        for (const Edge one : edges) {
            const auto from = static_cast<std::uint32_t>(one >> 32U);
            if (edges.contains(edge(endOf(one), from)))
                continue;
            if (!next.try_emplace(from, endOf(one)).second)
                return std::nullopt;
            first = next.size() == 1 ? from : std::min(first, from);
        }
        PlanLoop loop;
        std::uint32_t at = first;
        do {
            loop.push_back(at);
            const auto to = next.find(at);
            if (to == next.end() || loop.size() > next.size())
                return std::nullopt;
            at = to->second;
        } while (at != first);
        return loop.size() == next.size() ? std::optional(loop) : std::nullopt;
    }

    /// Of loops of points of the map.
    [[nodiscard]] std::optional<std::vector<LatticeTriangle>>
    triangulated(const std::vector<std::uint32_t>& points, std::vector<PlanLoop> loops) const {
        std::vector<Vec2> places;
        places.reserve(points.size());
        for (const std::uint32_t point : points)
            places.push_back(m_frame.plan(point));
        std::uint32_t next = 0; // the loops have the points in their order
        for (PlanLoop& loop : loops)
            for (std::uint32_t& point : loop)
                point = next++;
        const auto triangles = triangulatePolygon(places, loops);
        if (!triangles)
            return std::nullopt;
        std::vector<LatticeTriangle> result;
        result.reserve(triangles->size());
        for (const auto& [a, b, c] : *triangles)
            result.push_back({points[a], points[b], points[c]});
        return result;
    }

    /// Whether new triangles would have edges that others have, or that a side of the solid may have.
    [[nodiscard]] bool meetOthers(const std::vector<LatticeTriangle>& triangles,
                                  const std::unordered_set<Edge>& edges) const {
        return std::ranges::any_of(triangles, [&](const LatticeTriangle& triangle) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Edge one = edge(triangle[k], triangle[(k + 1) % 3]);
                const bool isNew = !edges.contains(one) && !edges.contains(edge(endOf(one), triangle[k]));
                const bool isOfSide = m_frame.onOutline(triangle[k]) && m_frame.onOutline(endOf(one));
                if (isNew && (isOfSide || m_triangleAt.contains(one)))
                    return true;
            }
            return false;
        });
    }

    void exchange(const std::vector<std::size_t>& around, const std::vector<LatticeTriangle>& triangles,
                  const std::unordered_set<Edge>& edges) {
        for (const Edge one : edges)
            m_triangleAt.erase(one);
        for (std::size_t k = 0; k < around.size(); ++k) {
            m_former.emplace_back(around[k], m_surface[around[k]]);
            m_surface[around[k]] = triangles[k];
            link(around[k]);
        }
    }

    const SolidFrame& m_frame;
    std::vector<LatticeTriangle>& m_surface;
    std::unordered_map<Edge, std::size_t> m_triangleAt; ///< by the edge that leads around it
    FormerTriangles m_former;
};

} // namespace

FormerTriangles unfoldLevels(const SolidFrame& frame, std::vector<LatticeTriangle>& surface) {
    return LevelFolds(frame, surface).unfoldAll();
}

} // namespace proveout
