// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/part/map_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/parallel.h"
#include "core/part/nearest_on_facet.h"

namespace proveout {

namespace {

/// As a fraction of the distance squared: places that are equally near but for rounding.
constexpr double kAsNear = 1e-12;
/// Of the height of a cell to its width: what is steeper without a rim is a step between two points.
constexpr double kSteep = 1;
/// The slope of what is level, and the reciprocal one of what is upright.
constexpr double kLevel = 0.01;

float justBelow(double value) {
    return std::nextafter(static_cast<float>(value), -std::numeric_limits<float>::infinity());
}
float justAbove(double value) {
    return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

double largestMove(const ZMapSnapshot& zmap) {
    double largest = 0;
    for (std::size_t index = 0; index < zmap.tileCount(); ++index)
        if (const WallTile* tile = zmap.walls().tile(index))
            for (const WallPoint& wall : tile->points)
                largest = std::max({largest, std::abs(double{wall.dx}), std::abs(double{wall.dy})});
    return largest;
}

} // namespace

void MapDistance::Heights::add(double lowest, double highest) {
    const bool isEmpty = high < low;
    low = isEmpty ? justBelow(lowest) : std::min(low, justBelow(lowest));
    high = isEmpty ? justAbove(highest) : std::max(high, justAbove(highest));
}

/// One search, from the nearest blocks on.
class MapDistance::Search {
public:
    Search(const MapDistance& map, const Vec3& point, double within)
        : m_map(map), m_point(point), m_least2(within * within) {}

    [[nodiscard]] std::optional<Nearest> run() {
        const std::size_t top = m_map.m_levels.size() - 1;
        descend(top, 0, 0);
        return m_best;
    }

private:
    struct Vertex {
        Vec3 at{0};
        bool isWall = false;  ///< a point that is drawn on a wall
        bool isAbove = false; ///< something of the stock is left there
    };
    struct Next {
        double distance2;
        int i;
        int j;
    };

    void descend(std::size_t level, int i, int j) {
        if (level == 0)
            return look(i, j);
        const Level& finer = m_map.m_levels[level - 1];
        std::array<Next, std::size_t{kCellsOfBlock} * kCellsOfBlock> next{};
        std::size_t count = 0;
        for (int y = kCellsOfBlock * j; y < std::min(kCellsOfBlock * (j + 1), finer.ny); ++y)
            for (int x = kCellsOfBlock * i; x < std::min(kCellsOfBlock * (i + 1), finer.nx); ++x)
                if (const double away = m_map.distance2(level - 1, x, y, m_point); away <= m_least2)
                    next[count++] = {away, x, y};
        std::sort(next.begin(), next.begin() + static_cast<std::ptrdiff_t>(count),
                  [](const Next& one, const Next& other) { return one.distance2 < other.distance2; });
        for (std::size_t k = 0; k < count && next[k].distance2 <= m_least2; ++k)
            descend(level - 1, next[k].i, next[k].j);
    }

    /// At the cells of a block.
    void look(int blockI, int blockJ) {
        const Grid& grid = m_map.m_zmap.grid();
        const int firstI = kCellsOfBlock * blockI;
        const int firstJ = kCellsOfBlock * blockJ;
        const int lastI = std::min(firstI + kCellsOfBlock, grid.nx - 1);
        const int lastJ = std::min(firstJ + kCellsOfBlock, grid.ny - 1);
        for (int j = firstJ; j <= lastJ; ++j)
            for (int i = firstI; i <= lastI; ++i)
                m_vertices[static_cast<std::size_t>(j - firstJ)][static_cast<std::size_t>(i - firstI)] =
                    vertexOf(i, j);
        for (int j = firstJ; j < lastJ; ++j)
            for (int i = firstI; i < lastI; ++i)
                lookAtCell(i, j, static_cast<std::size_t>(i - firstI), static_cast<std::size_t>(j - firstJ));
    }

    [[nodiscard]] Vertex vertexOf(int i, int j) const {
        const ZMapSnapshot& zmap = m_map.m_zmap;
        return {vertexAt(zmap, i, j), zmap.walls().find(i, j) != nullptr, zmap.height(i, j) > zmap.floor()};
    }

    void lookAtCell(int i, int j, std::size_t x, std::size_t y) {
        const Vertex& a = m_vertices[y][x];
        const Vertex& b = m_vertices[y][x + 1];
        const Vertex& c = m_vertices[y + 1][x];
        const Vertex& d = m_vertices[y + 1][x + 1];
        m_i = i;
        m_j = j;
        const Grid& grid = m_map.m_zmap.grid();
        if (isBeyond(a, b, c, d) && i > 0 && j > 0 && i < grid.nx - 2 && j < grid.ny - 2)
            return;
        // The diagonals of the canonical mesh end at points whose indices have an even sum.
        if ((i + j) % 2 == 0) {
            lookAtTriangle(a, b, d);
            lookAtTriangle(a, d, c);
        } else {
            lookAtTriangle(a, b, c);
            lookAtTriangle(b, d, c);
        }
        if (j == 0)
            lookAtSide(b, a);
        if (j == grid.ny - 2)
            lookAtSide(c, d);
        if (i == 0)
            lookAtSide(a, c);
        if (i == grid.nx - 2)
            lookAtSide(d, b);
    }

    /// Whether a box around a cell is farther away than what was found.
    [[nodiscard]] bool isBeyond(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) const {
        const Vec3 low = glm::min(glm::min(a.at, b.at), glm::min(c.at, d.at));
        const Vec3 high = glm::max(glm::max(a.at, b.at), glm::max(c.at, d.at));
        const Vec3 away = glm::max(glm::max(low - m_point, m_point - high), Vec3(0));
        return glm::dot(away, away) > m_least2 * (1 + kAsNear);
    }

    /// The side of the stock below an edge of its border; outside is on the left of it.
    void lookAtSide(const Vertex& from, const Vertex& to) {
        Vertex fromBelow = from;
        Vertex toBelow = to;
        fromBelow.at.z = toBelow.at.z = m_map.m_zmap.stock().floorZ();
        fromBelow.isWall = toBelow.isWall = true; // upright: as exact as the box
        lookAtTriangle(from, to, toBelow);
        lookAtTriangle(from, toBelow, fromBelow);
    }

    void lookAtTriangle(const Vertex& a, const Vertex& b, const Vertex& c) {
        if (!a.isAbove && !b.isAbove && !c.isAbove)
            return;
        const NearestOnFacet at = nearestOnFacet(m_point, {a.at, b.at, c.at});
        const Vec3 away = m_point - at.place;
        const double away2 = glm::dot(away, away);
        if (away2 > m_least2 * (1 + kAsNear))
            return;
        const Vec3 normal = glm::cross(b.at - a.at, c.at - a.at);
        const double length = glm::length(normal);
        const double ahead = length > 0 ? glm::dot(away, normal) / length : 0;
        // Of two triangles that are equally near, the one that the point is more in front of knows its side.
        if (m_best && away2 >= m_least2 * (1 - kAsNear) && std::abs(ahead) <= m_ahead)
            return;
        m_least2 = std::min(m_least2, away2);
        m_ahead = std::abs(ahead);
        m_best =
            Nearest{at.place, std::sqrt(away2), m_i, m_j, isExact(normal, a.isWall || b.isWall || c.isWall),
                    ahead < 0};
    }

    /// Beside a wall only what is upright or level is.
    [[nodiscard]] static bool isExact(const Vec3& normal, bool isBesideWall) {
        const double over = std::hypot(normal.x, normal.y);
        if (!isBesideWall)
            return over <= kSteep * normal.z;
        return std::abs(normal.z) <= kLevel * over || over <= kLevel * std::abs(normal.z);
    }

    const MapDistance& m_map;
    Vec3 m_point;
    double m_least2;
    double m_ahead = 0; ///< how far the point is in front of, or behind, the plane of the best triangle
    int m_i = 0;
    int m_j = 0;
    std::optional<Nearest> m_best;
    std::array<std::array<Vertex, kCellsOfBlock + 1>, kCellsOfBlock + 1> m_vertices{};
};

MapDistance::MapDistance(ZMapSnapshot zmap) : m_zmap(std::move(zmap)), m_moved(largestMove(m_zmap)) {
    const Grid& grid = m_zmap.grid();
    const auto blocksIn = [](int count) { return (count + kCellsOfBlock - 1) / kCellsOfBlock; };
    Level finest{blocksIn(grid.nx - 1), blocksIn(grid.ny - 1), {}};
    finest.blocks.resize(static_cast<std::size_t>(finest.nx) * static_cast<std::size_t>(finest.ny));
    inParallel(static_cast<std::size_t>(finest.ny), [&](std::size_t row) {
        for (int i = 0; i < finest.nx; ++i)
            finest.blocks[row * static_cast<std::size_t>(finest.nx) + static_cast<std::size_t>(i)] =
                heightsOf(i, static_cast<int>(row));
    });
    m_levels.push_back(std::move(finest));
    while (m_levels.back().blocks.size() > 1) {
        const Level& finer = m_levels.back();
        Level level{blocksIn(finer.nx), blocksIn(finer.ny), {}};
        level.blocks.resize(static_cast<std::size_t>(level.nx) * static_cast<std::size_t>(level.ny));
        for (int j = 0; j < finer.ny; ++j)
            for (int i = 0; i < finer.nx; ++i)
                if (const Heights& one = finer.at(i, j); one.low <= one.high)
                    level
                        .blocks[static_cast<std::size_t>(j / kCellsOfBlock) *
                                    static_cast<std::size_t>(level.nx) +
                                static_cast<std::size_t>(i / kCellsOfBlock)]
                        .add(double{one.low}, double{one.high});
        m_levels.push_back(std::move(level));
    }
}

MapDistance::Heights MapDistance::heightsOf(int blockI, int blockJ) const {
    const Grid& grid = m_zmap.grid();
    const int firstI = kCellsOfBlock * blockI;
    const int firstJ = kCellsOfBlock * blockJ;
    const int lastI = std::min(firstI + kCellsOfBlock, grid.nx - 1);
    const int lastJ = std::min(firstJ + kCellsOfBlock, grid.ny - 1);
    Heights heights;
    bool isAbove = false;
    for (int j = firstJ; j <= lastJ; ++j)
        for (int i = firstI; i <= lastI; ++i) {
            const double z = vertexAt(m_zmap, i, j).z;
            heights.add(z, z);
            isAbove = isAbove || m_zmap.height(i, j) > m_zmap.floor();
        }
    const bool hasSide = firstI == 0 || firstJ == 0 || lastI == grid.nx - 1 || lastJ == grid.ny - 1;
    if (hasSide)
        heights.add(m_zmap.stock().floorZ(), m_zmap.stock().floorZ());
    return isAbove ? heights : Heights();
}

double MapDistance::distance2(std::size_t level, int i, int j, const Vec3& point) const {
    const Heights& heights = m_levels[level].at(i, j);
    if (heights.high < heights.low)
        return std::numeric_limits<double>::infinity();
    const Grid& grid = m_zmap.grid();
    double cells = kCellsOfBlock;
    for (std::size_t k = 0; k < level; ++k)
        cells *= kCellsOfBlock;
    const auto away = [this](double at, double low, double high) {
        return std::max({low - m_moved - at, at - high - m_moved, 0.0});
    };
    const double x = away(point.x, grid.x0 + grid.hx * cells * i, grid.x0 + grid.hx * cells * (i + 1));
    const double y = away(point.y, grid.y0 + grid.hy * cells * j, grid.y0 + grid.hy * cells * (j + 1));
    const double z = std::max({double{heights.low} - point.z, point.z - double{heights.high}, 0.0});
    return x * x + y * y + z * z;
}

std::optional<MapDistance::Nearest> MapDistance::nearest(const Vec3& point, double within) const {
    if (m_levels.empty())
        return std::nullopt;
    return Search(*this, point, within).run();
}

} // namespace proveout
