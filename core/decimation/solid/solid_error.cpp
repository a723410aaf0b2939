// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/solid_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/decimation/regions/canonical_surface.h"
#include "core/decimation/regions/row_bands.h"
#include "core/decimation/solid/corners.h"
#include "core/decimation/surface/tally.h"

namespace proveout {

namespace {

constexpr std::size_t kTrianglesOfTask = 256;

using Weights = std::array<double, 3>;

/// Stored in memory on purpose: g++ 12 at -O2 drops a pair of vectorised conversions to float and back.
double inFloat(double value) {
    const volatile float rounded = static_cast<float>(value);
    return static_cast<double>(rounded);
}

/// Twice the area of the triangle (p, a, b) in plan; nothing if p is on the wrong side of the edge by more
/// than the error of this sum. So no point falls between two triangles.
std::optional<double> weightOpposite(const Vec2& p, const Vec3& a, const Vec3& b) {
    constexpr double kErr = 4 * std::numeric_limits<double>::epsilon();
    const double plus = (a.x - p.x) * (b.y - p.y);
    const double minus = (a.y - p.y) * (b.x - p.x);
    const double weight = plus - minus;
    if (weight < -kErr * (std::abs(plus) + std::abs(minus)))
        return std::nullopt;
    return weight;
}

std::optional<Weights> weightsAt(const Vec2& p, const Corners& at) {
    const auto a = weightOpposite(p, at[1], at[2]);
    const auto b = a ? weightOpposite(p, at[2], at[0]) : std::nullopt;
    const auto c = b ? weightOpposite(p, at[0], at[1]) : std::nullopt;
    if (!c)
        return std::nullopt;
    return Weights{*a, *b, *c};
}

/// The positions of the grid points along one axis, and which of them an interval of it may contain.
class Axis {
public:
    /// `outline`: the ends as the file holds them. Points beyond the ends are moved to them.
    Axis(int count, double start, double spacing, const Vec2& outline)
        : m_start(start), m_spacing(spacing), m_positions(static_cast<std::size_t>(count)) {
        for (std::size_t i = 0; i < m_positions.size(); ++i)
            m_positions[i] = std::clamp(start + spacing * static_cast<double>(i), outline.x,
                                        std::max(outline.x, outline.y));
    }

    [[nodiscard]] double operator[](std::size_t i) const { return m_positions[i]; }
    [[nodiscard]] std::size_t size() const { return m_positions.size(); }
    /// One more than needed on each side: rounding has moved ends and points by less than a step.
    [[nodiscard]] std::size_t firstFrom(double position) const {
        return index(std::floor(cells(position)) - 1);
    }
    [[nodiscard]] std::size_t lastTo(double position) const { return index(std::ceil(cells(position)) + 1); }

private:
    [[nodiscard]] double cells(double position) const { return (position - m_start) / m_spacing; }
    [[nodiscard]] std::size_t index(double at) const {
        return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(m_positions.size() - 1)));
    }

    double m_start;
    double m_spacing;
    std::vector<double> m_positions;
};

/// The part of the line at `y` that a triangle covers in plan; empty (x > y) if there is none.
Vec2 stretchAt(double y, const Corners& at) {
    Vec2 stretch(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < at.size(); ++k) {
        const Vec3& a = at[k];
        const Vec3& b = at[(k + 1) % at.size()];
        if (y < std::min(a.y, b.y) || y > std::max(a.y, b.y))
            continue;
        const double x = a.y == b.y ? a.x : a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
        stretch = {std::min(stretch.x, x), std::max(stretch.y, x)};
    }
    return stretch;
}

/// The cells that have points beside walls.
class WallCells {
public:
    explicit WallCells(const ZMapSnapshot& zmap) : m_nx(zmap.grid().nx), m_ny(zmap.grid().ny) {
        if (zmap.walls().empty())
            return;
        m_cells.resize(static_cast<std::size_t>(m_nx) * static_cast<std::size_t>(m_ny));
        const IndexRect all{0, 0, m_nx, m_ny};
        for (const std::uint32_t point : zmap.walls().offsetsIn(all)) {
            const int i = static_cast<int>(point) % m_nx;
            const int j = static_cast<int>(point) / m_nx;
            for (int y = std::max(j - 1, 0); y <= j; ++y)
                for (int x = std::max(i - 1, 0); x <= i; ++x)
                    m_cells[index(x, y)] = true;
        }
    }

    /// Whether one of the cells at a place, in cells, is such a cell.
    [[nodiscard]] bool contain(const Vec3& place) const {
        if (m_cells.empty())
            return false;
        // Rounding may have moved the outline outwards.
        const double atX = std::clamp(place.x, 0.0, m_nx - 1.0);
        const double atY = std::clamp(place.y, 0.0, m_ny - 1.0);
        for (int y = first(atY); y <= last(atY, m_ny); ++y)
            for (int x = first(atX); x <= last(atX, m_nx); ++x)
                if (m_cells[index(x, y)])
                    return true;
        return false;
    }

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_nx) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] static int first(double at) { return std::max(static_cast<int>(std::ceil(at)) - 1, 0); }
    [[nodiscard]] static int last(double at, int count) {
        return std::min(static_cast<int>(std::floor(at)), count - 1);
    }

    int m_nx;
    int m_ny;
    std::vector<bool> m_cells; ///< by their points with the least coordinates; empty: none
};

/// The top of a solid with rounded coordinates, over the grid points of a map. Any thread.
class SolidTop {
public:
    SolidTop(const ZMapSnapshot& zmap, const TriangleMesh& solid, CoordinateType type)
        : m_zmap(zmap), m_solid(solid), m_full(zmap), m_wallCells(zmap), m_type(type),
          m_columns(zmap.grid().nx, zmap.grid().x0, zmap.grid().hx, ends().first),
          m_rows(zmap.grid().ny, zmap.grid().y0, zmap.grid().hy, ends().second) {}

    [[nodiscard]] std::size_t rows() const { return m_rows.size(); }
    [[nodiscard]] std::size_t columns() const { return m_columns.size(); }

    /// The corners of a triangle that faces upwards; nothing for a wall, or the floor.
    [[nodiscard]] std::optional<Corners> cornersOf(std::size_t triangle) const {
        Corners at;
        std::ranges::transform(m_solid.triangles[triangle], at.begin(), [&](std::uint32_t vertex) {
            return roundedTo(m_type, m_solid.vertices[vertex]);
        });
        const Vec2 one = at[1] - at[0];
        const Vec2 other = at[2] - at[0];
        if (one.x * other.y <= one.y * other.x)
            return std::nullopt;
        return at;
    }

    [[nodiscard]] RowBands::Rows rowsOf(std::size_t triangle) const {
        const auto at = cornersOf(triangle);
        if (!at)
            return {1, 0};
        const auto [low, high] = std::minmax({(*at)[0].y, (*at)[1].y, (*at)[2].y});
        return {m_rows.firstFrom(low), m_rows.lastTo(high)};
    }

    /// The largest distance of the canonical full mesh from an edge of a triangle, away from walls.
    [[nodiscard]] double alongEdge(const Corners& at, std::size_t k) const {
        return m_full.distanceAlong(inCells(at[k]), inCells(at[(k + 1) % 3]),
                                    [&](const Vec3& place) { return !m_wallCells.contain(place); });
    }
    /// The same, of all edges of a triangle that is no part of a wall.
    [[nodiscard]] double alongEdges(std::size_t triangle) const {
        const auto at = cornersOf(triangle);
        return at && !isOfWall(*at) ? std::max({alongEdge(*at, 0), alongEdge(*at, 1), alongEdge(*at, 2)}) : 0;
    }
    /// Whether a corner of a triangle is beside a wall.
    [[nodiscard]] bool meetsWall(const Corners& at) const {
        return std::ranges::any_of(at,
                                   [&](const Vec3& corner) { return m_wallCells.contain(inCells(corner)); });
    }
    /// Whether a triangle that faces upwards has a corner in some cells.
    [[nodiscard]] bool meets(const WallCells& cells, std::size_t triangle) const {
        const auto at = cornersOf(triangle);
        return at &&
               std::ranges::any_of(*at, [&](const Vec3& corner) { return cells.contain(inCells(corner)); });
    }
    /// Whether it is one of a wall that is steep, but not upright.
    [[nodiscard]] bool isOfWall(const Corners& at) const {
        constexpr double kLeastRise = 1.5;
        const Vec3 normal = normalOf(at);
        return glm::length(Vec2(normal)) > kLeastRise * normal.z && meetsWall(at);
    }
    /// The point of the map that is nearest to a place in plan.
    [[nodiscard]] std::uint32_t pointNear(const Vec3& at) const {
        const Vec3 place = inCells(at);
        const auto near = [](double along, std::size_t count) {
            return static_cast<std::size_t>(
                std::clamp(std::round(along), 0.0, static_cast<double>(count - 1)));
        };
        return static_cast<std::uint32_t>(near(place.y, rows()) * columns() + near(place.x, columns()));
    }

    /// Calls `visit(column)` for each point in row `j` that a triangle may cover.
    template<class Visit>
    void eachColumn(const Corners& at, std::size_t j, const Visit& visit) const {
        const Vec2 stretch = stretchAt(m_rows[j], at);
        if (stretch.x > stretch.y)
            return;
        const std::size_t last = m_columns.lastTo(stretch.y);
        for (std::size_t i = m_columns.firstFrom(stretch.x); i <= last; ++i)
            visit(i);
    }

    /// The distance of a point from a triangle; nothing if it is beside it.
    [[nodiscard]] std::optional<double> distance(std::size_t i, std::size_t j, const Corners& at) const {
        const auto weights = weightsAt({m_columns[i], m_rows[j]}, at);
        if (!weights)
            return std::nullopt;
        const auto& [a, b, c] = *weights;
        const double area = a + b + c;
        if (area <= 0)
            return std::nullopt;
        // Divided first: at a corner one share is exactly 1, so that the surface is exactly its height.
        const double surface = a / area * at[0].z + b / area * at[1].z + c / area * at[2].z;
        return std::abs(surface - height(i, j));
    }

    [[nodiscard]] bool isBesideWall(std::size_t i, std::size_t j) const {
        return m_zmap.walls().find(static_cast<int>(i), static_cast<int>(j)) != nullptr;
    }

    /// The distance of a point that no triangle covers.
    [[nodiscard]] double aboveFloor(std::size_t i, std::size_t j) const {
        return height(i, j) - (m_zmap.stock().topZ() + static_cast<double>(m_zmap.floor()));
    }

private:
    /// The ends of both axes.
    [[nodiscard]] std::pair<Vec2, Vec2> ends() const {
        const Grid& grid = m_zmap.grid();
        const Vec3 low = roundedTo(m_type, {grid.x(0), grid.y(0), 0});
        const Vec3 high = roundedTo(m_type, {grid.x(grid.nx - 1), grid.y(grid.ny - 1), 0});
        return {{low.x, high.x}, {low.y, high.y}};
    }

    [[nodiscard]] double height(std::size_t i, std::size_t j) const {
        return m_zmap.stock().topZ() +
               static_cast<double>(m_zmap.height(static_cast<int>(i), static_cast<int>(j)));
    }

    /// In the coordinates of CanonicalSurface.
    [[nodiscard]] Vec3 inCells(const Vec3& at) const {
        const Grid& grid = m_zmap.grid();
        return {(at.x - grid.x0) / grid.hx, (at.y - grid.y0) / grid.hy, at.z - m_zmap.stock().topZ()};
    }

    const ZMapSnapshot& m_zmap;
    const TriangleMesh& m_solid;
    CanonicalSurface m_full;
    WallCells m_wallCells;
    CoordinateType m_type;
    Axis m_columns;
    Axis m_rows;
};

/// Calls `visit(i, j, distance)` for the points in a band of rows under each of its triangles. A stop is
/// looked for in every row, because two triangles may cover the whole map.
template<class Visit>
void eachDistanceUnder(const SolidTop& top, const RowBands& bands, std::size_t band,
                       const std::stop_token& stop, const Visit& visit) {
    const auto [first, last] = bands.rows(band);
    for (const std::uint32_t triangle : bands.trianglesOf(band)) {
        const Corners at = *top.cornersOf(triangle);
        const auto reached = top.rowsOf(triangle);
        for (std::size_t j = std::max(first, reached.first);
             j <= std::min(last, reached.last) && !stop.stop_requested(); ++j)
            top.eachColumn(at, j, [&](std::size_t i) {
                if (const auto distance = top.distance(i, j, at))
                    visit(i, j, *distance);
            });
    }
}

/// The same, and for points that no triangle covers with their distance from the floor.
template<class Visit>
void eachDistance(const SolidTop& top, const RowBands& bands, std::size_t band, const std::stop_token& stop,
                  const Visit& visit) {
    const RowBands::Rows rows = bands.rows(band);
    const std::size_t first = rows.first; // Clang 14 captures no structured bindings
    const std::size_t last = rows.last;
    std::vector<bool> covered((last + 1 - first) * top.columns());
    eachDistanceUnder(top, bands, band, stop, [&](std::size_t i, std::size_t j, double distance) {
        covered[(j - first) * top.columns() + i] = true;
        visit(i, j, distance);
    });
    for (std::size_t j = first; j <= last && !stop.stop_requested(); ++j)
        for (std::size_t i = 0; i < top.columns(); ++i)
            if (!covered[(j - first) * top.columns() + i])
                visit(i, j, top.aboveFloor(i, j));
}

/// Adds the ends of the edges of a triangle which are farther than a distance somewhere away from walls.
void addEndsOfEdges(const SolidTop& top, std::size_t triangle, double distance,
                    std::vector<std::uint32_t>& points) {
    const auto at = top.cornersOf(triangle);
    if (!at || top.isOfWall(*at))
        return;
    for (std::size_t k = 0; k < at->size(); ++k) {
        if (top.alongEdge(*at, k) > distance) {
            points.push_back(top.pointNear((*at)[k]));
            points.push_back(top.pointNear((*at)[(k + 1) % 3]));
        }
    }
}

/// Those of several lists, in their order.
std::vector<std::uint32_t> joined(const std::vector<std::vector<std::uint32_t>>& lists) {
    std::vector<std::uint32_t> all;
    for (const std::vector<std::uint32_t>& list : lists)
        all.insert(all.end(), list.begin(), list.end());
    return all;
}

} // namespace

Vec3 roundedTo(CoordinateType type, const Vec3& point) {
    return type == CoordinateType::float64 ? point
                                           : Vec3(inFloat(point.x), inFloat(point.y), inFloat(point.z));
}

bool isSound(CoordinateType type, const Corners& exact) {
    Corners rounded;
    std::ranges::transform(exact, rounded.begin(),
                           [type](const Vec3& corner) { return roundedTo(type, corner); });
    return glm::dot(normalOf(exact), normalOf(rounded)) > 0;
}

double measureSolidError(const ZMapSnapshot& zmap, const TriangleMesh& solid, CoordinateType type,
                         ErrorLevel level, const WorkContext& context) {
    const SolidTop top(zmap, solid, type);
    const std::size_t triangles = solid.triangles.size();
    double largest = 0;
    if (level == ErrorLevel::surface)
        largest = largestInParallel(triangles, kTrianglesOfTask,
                                    [&](std::size_t t) { return context.stopped() ? 0 : top.alongEdges(t); });
    const RowBands bands(top.rows(), triangles, [&](std::size_t t) { return top.rowsOf(t); });
    Tally tally(context, bands.count());
    const double atPoints = largestInParallel(bands.count(), 1, [&](std::size_t band) {
        double error = 0;
        eachDistance(top, bands, band, context.stop, [&](std::size_t i, std::size_t j, double distance) {
            if (distance > error && !top.isBesideWall(i, j))
                error = distance;
        });
        if (!context.stopped())
            tally.finished();
        return error;
    });
    return std::max(largest, atPoints);
}

std::vector<std::uint32_t> pointsFarther(const ZMapSnapshot& zmap, const TriangleMesh& solid,
                                         CoordinateType type, const ErrorBound& bound,
                                         const ZMapSnapshot* atWallsOf, const std::stop_token& stop) {
    const SolidTop top(zmap, solid, type);
    const WallCells cells(atWallsOf != nullptr ? *atWallsOf : zmap);
    const auto isLookedAt = [&](std::size_t triangle) {
        return atWallsOf == nullptr || top.meets(cells, triangle);
    };
    const std::size_t triangles = solid.triangles.size();
    const RowBands bands(top.rows(), triangles, [&](std::size_t t) {
        return isLookedAt(t) ? top.rowsOf(t) : RowBands::Rows{1, 0};
    });
    std::vector<std::vector<std::uint32_t>> ofBands(bands.count());
    inParallel(bands.count(), [&](std::size_t band) {
        const auto look = [&](std::size_t i, std::size_t j, double isAway) {
            if (isAway > bound.distance && !top.isBesideWall(i, j))
                ofBands[band].push_back(static_cast<std::uint32_t>(j * top.columns() + i));
        };
        if (atWallsOf == nullptr)
            eachDistance(top, bands, band, stop, look);
        else
            eachDistanceUnder(top, bands, band, stop, look);
    });
    std::vector<std::uint32_t> points = joined(ofBands);
    if (bound.level != ErrorLevel::surface)
        return points;
    std::vector<std::vector<std::uint32_t>> ofParts(triangles / kTrianglesOfTask + 1);
    inParallel(ofParts.size(), [&](std::size_t k) {
        const std::size_t first = k * kTrianglesOfTask;
        for (std::size_t t = first; t < std::min(first + kTrianglesOfTask, triangles); ++t)
            if (!stop.stop_requested() && isLookedAt(t))
                addEndsOfEdges(top, t, bound.distance, ofParts[k]);
    });
    const std::vector<std::uint32_t> ends = joined(ofParts);
    points.insert(points.end(), ends.begin(), ends.end());
    return points;
}

} // namespace proveout
