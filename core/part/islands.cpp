// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/part/islands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace proveout {

namespace {

/// A point of the grid that is out of tolerance, with the steep faces beside it.
struct OutPoint {
    int i;
    int j;
    IslandKind kind;
    bool isOfWall; ///< its value is that of a steep face
    float off;     ///< the largest deviation without the allowance
    std::uint32_t wall;
    double areaMm2;
    double volumeMm3;     ///< of the column of the point
    double wallVolumeMm3; ///< beside its steep faces
};

class IslandSearch {
public:
    IslandSearch(const Deviation& deviation, const PartTolerance& tolerance)
        : m_deviation(deviation), m_tolerance(tolerance) {}

    [[nodiscard]] std::vector<Island> run() {
        addPoints();
        addWalls();
        std::ranges::stable_sort(m_points, {},
                                 [](const OutPoint& point) { return std::pair(point.j, point.i); });
        joinSamePlace();
        m_same.resize(m_points.size());
        std::iota(m_same.begin(), m_same.end(), std::size_t{0});
        joinNeighbours();
        return islands();
    }

private:
    [[nodiscard]] std::optional<IslandKind> kindOf(double off) const {
        if (off > m_tolerance.above)
            return IslandKind::excess;
        return off < -m_tolerance.below ? std::optional(IslandKind::gouge) : std::nullopt;
    }

    /// How much of the cell around a point its column counts for: a point that is nearer to the wall beside
    /// it than a cell is wide is at its rim.
    [[nodiscard]] double covered(double left, double off) const {
        constexpr double kSteep = 2.2; // the column of a slope is not much longer
        const Grid& grid = m_deviation.grid();
        if (std::abs(left) <= kSteep * std::abs(off))
            return 1;
        return std::min(std::abs(off) / std::max(grid.hx, grid.hy), 1.0);
    }

    void addPoints() {
        const Grid& grid = m_deviation.grid();
        const ZMapSnapshot& stock = m_deviation.stock();
        for (std::size_t index = 0; index < m_deviation.tileCount(); ++index) {
            const auto& tile = m_deviation.tile(index);
            if (tile == nullptr)
                continue;
            const IndexRect rect = stock.tileRect(index);
            for (int j = rect.j0; j < rect.j1; ++j)
                for (int i = rect.i0; i < rect.i1; ++i) {
                    const float value =
                        tile->values[static_cast<std::size_t>((j - rect.j0) * Tile::kSize + i - rect.i0)];
                    if (std::isnan(value))
                        continue;
                    const double off = double{value} - m_tolerance.allowance;
                    const auto kind = kindOf(off);
                    if (!kind)
                        continue;
                    const double left = double{stock.height(i, j)} - double{m_deviation.top().at(i, j)} -
                                        m_tolerance.allowance;
                    m_points.push_back({i, j, *kind, false, static_cast<float>(off), 0, grid.hx * grid.hy,
                                        std::abs(left) * covered(left, off) * grid.hx * grid.hy, 0});
                }
        }
    }

    void addWalls() {
        for (std::uint32_t k = 0; k < m_deviation.walls().size(); ++k) {
            const WallDeviation& wall = m_deviation.walls()[k];
            const double off = double{wall.value} - m_tolerance.allowance;
            if (const auto kind = kindOf(off))
                m_points.push_back({wall.i, wall.j, *kind, true, static_cast<float>(off), k,
                                    double{wall.areaMm2}, 0, std::abs(off) * double{wall.areaMm2}});
        }
    }

    /// Points and steep faces of one kind at one place become one. What is missing beside a steep face is
    /// counted by the points there, if it reaches any.
    void joinSamePlace() {
        std::vector<OutPoint> joined;
        for (const OutPoint& point : m_points) {
            const auto isSame = [&](const OutPoint& other) {
                return other.i == point.i && other.j == point.j && other.kind == point.kind;
            };
            const auto begin = joined.end() - std::min<std::ptrdiff_t>(std::ssize(joined), 2);
            const auto at = std::find_if(begin, joined.end(), isSame);
            if (at == joined.end()) {
                joined.push_back(point);
                continue;
            }
            OutPoint& into = *at;
            into.areaMm2 += point.areaMm2;
            into.volumeMm3 += point.volumeMm3;
            into.wallVolumeMm3 += point.wallVolumeMm3;
            if (std::abs(point.off) > std::abs(into.off)) {
                into.off = point.off;
                into.isOfWall = point.isOfWall;
                into.wall = point.wall;
            }
        }
        m_points = std::move(joined);
    }

    void joinNeighbours() {
        // Points are in rows: those before one are in its own row and in the one before.
        std::size_t above = 0;
        for (std::size_t k = 0; k < m_points.size(); ++k) {
            const OutPoint& point = m_points[k];
            for (std::size_t n = k; n-- > 0 && m_points[n].j == point.j && m_points[n].i >= point.i - 1;)
                join(n, k);
            const auto isBefore = [&](const OutPoint& other) {
                return std::pair(other.j, other.i) < std::pair(point.j - 1, point.i - 1);
            };
            while (above < k && isBefore(m_points[above]))
                ++above;
            for (std::size_t n = above; n < k && m_points[n].j == point.j - 1 && m_points[n].i <= point.i + 1;
                 ++n)
                join(n, k);
        }
    }

    void join(std::size_t one, std::size_t other) {
        if (m_points[one].kind != m_points[other].kind)
            return;
        const auto [low, high] = std::minmax({root(one), root(other)});
        m_same[high] = low;
    }
    [[nodiscard]] std::size_t root(std::size_t point) {
        while (m_same[point] != point) {
            m_same[point] = m_same[m_same[point]];
            point = m_same[point];
        }
        return point;
    }

    [[nodiscard]] std::vector<Island> islands() {
        const Grid& grid = m_deviation.grid();
        std::vector<Island> all;
        std::vector<std::size_t> worst; // the point of each island
        std::vector<double> beside;     // its steep faces
        std::vector<std::size_t> indices(m_points.size());
        for (std::size_t k = 0; k < m_points.size(); ++k) {
            const OutPoint& point = m_points[k];
            const Vec2 at(grid.x(point.i), grid.y(point.j));
            if (root(k) == k) {
                indices[k] = all.size();
                all.push_back({.kind = point.kind, .lo = at, .hi = at});
                worst.push_back(k);
                beside.push_back(0);
            }
            const std::size_t index = indices[root(k)];
            Island& island = all[index];
            island.areaMm2 += point.areaMm2;
            island.volumeMm3 += point.volumeMm3;
            beside[index] += point.wallVolumeMm3;
            island.lo = glm::min(island.lo, at);
            island.hi = glm::max(island.hi, at);
            if (std::abs(point.off) > std::abs(m_points[worst[index]].off))
                worst[index] = k;
        }
        for (std::size_t k = 0; k < all.size(); ++k) {
            place(all[k], m_points[worst[k]]);
            all[k].volumeMm3 = std::max(all[k].volumeMm3, beside[k]); // few points see what is thin
        }
        std::ranges::stable_sort(all, std::ranges::greater(), &Island::depthMm);
        return all;
    }

    void place(Island& island, const OutPoint& worst) const {
        island.depthMm = std::abs(double{worst.off});
        island.i = worst.i;
        island.j = worst.j;
        if (worst.isOfWall) {
            island.place = m_deviation.walls()[worst.wall].place;
            return;
        }
        const Deviation::Place at = m_deviation.placeOf(worst.i, worst.j);
        island.place = at.at;
        island.isOnPart = at.isOnPart;
    }

    const Deviation& m_deviation;
    const PartTolerance& m_tolerance;
    std::vector<OutPoint> m_points;
    std::vector<std::size_t> m_same; ///< of each point: the index of an earlier one of its island, or its own
};

} // namespace

const char* name(IslandKind kind) {
    return kind == IslandKind::gouge ? "gouge" : "excess";
}

std::vector<Island> islandsOf(const Deviation& deviation, const PartTolerance& tolerance) {
    return IslandSearch(deviation, tolerance).run();
}

} // namespace proveout
