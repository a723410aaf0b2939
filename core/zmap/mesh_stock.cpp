// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh as stock, processed triangle by triangle over the rows of the grid, one band of tiles after the
// other. Two results per point: the upper surface with the rim included, for the map; and every crossing of
// the vertical line through the point, with each edge belonging to only one of its triangles, for what the
// map cannot represent.
#include "core/zmap/mesh_stock.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

#include "core/zmap/grid_part.h"
#include "core/zmap/stock_body_findings.h"
#include "core/zmap/stock_findings.h"
#include "core/zmap/zmap_findings.h"

namespace proveout {

namespace {

/// A point this near to a triangle in plan, in mm, counts as on its rim: coordinates of a grid are rounded.
constexpr double kOnRim = 1e-6;
constexpr double kFarthest = 1e7;
/// The largest average number of facets above one another; each facet costs time at every point of the grid
/// that it covers.
constexpr double kMostLayers = 200;
constexpr double kAbsent = -1e30;
/// Crossings are searched for slightly beside the point, by these offsets in mm, so that an edge through the
/// point cannot make the result ambiguous.
constexpr double kAsideX = 0.71e-7;
constexpr double kAsideY = 1.13e-7;

using Corners = std::array<Vec3, 3>;

/// Twice the area in plan; above 0 if the triangle faces up.
double areaInPlan(const Corners& c) {
    return (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x);
}

/// Where a horizontal line crosses the edge: the result is the same for both triangles of the edge.
double crossing(const Vec3& a, const Vec3& b, double y) {
    const bool ordered = a.y < b.y || (a.y == b.y && a.x < b.x);
    const Vec3& low = ordered ? a : b;
    const Vec3& high = ordered ? b : a;
    return std::lerp(low.x, high.x, (y - low.y) / (high.y - low.y));
}

struct Range {
    double from = std::numeric_limits<double>::infinity();
    double to = -std::numeric_limits<double>::infinity();

    void add(double x) {
        from = std::min(from, x);
        to = std::max(to, x);
    }
};

/// One triangle over the rows of the grid.
class Facet {
public:
    explicit Facet(const Corners& corners)
        : m_corners(corners), m_area(areaInPlan(corners)),
          m_lowest(std::min({corners[0].z, corners[1].z, corners[2].z})),
          m_highest(std::max({corners[0].z, corners[1].z, corners[2].z})) {
        if (m_area == 0)
            return;
        const Vec3 u = corners[1] - corners[0];
        const Vec3 v = corners[2] - corners[0];
        m_slope = {(u.z * v.y - v.z * u.y) / m_area, (v.z * u.x - u.z * v.x) / m_area};
    }

    /// Whether the triangle is vertical. Such a triangle is not part of the upper or lower surface; the
    /// triangles at its edges are.
    [[nodiscard]] bool isUpright() const { return m_area == 0; }
    [[nodiscard]] bool looksUp() const { return m_area > 0; }
    [[nodiscard]] double leastX() const { return std::min({m_corners[0].x, m_corners[1].x, m_corners[2].x}); }
    [[nodiscard]] double largestX() const {
        return std::max({m_corners[0].x, m_corners[1].x, m_corners[2].x});
    }
    [[nodiscard]] double lowestY() const {
        return std::min({m_corners[0].y, m_corners[1].y, m_corners[2].y});
    }
    [[nodiscard]] double highestY() const {
        return std::max({m_corners[0].y, m_corners[1].y, m_corners[2].y});
    }

    [[nodiscard]] double heightAt(double x, double y) const {
        const double z = m_corners[0].z + m_slope.x * (x - m_corners[0].x) + m_slope.y * (y - m_corners[0].y);
        return std::clamp(z, m_lowest, m_highest);
    }
    /// The part of a horizontal line that the triangle covers, including its rim.
    [[nodiscard]] Range covered(double y) const {
        Range range;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& a = m_corners[k];
            const Vec3& b = m_corners[(k + 1) % 3];
            if (std::abs(a.y - y) <= kOnRim)
                range.add(a.x);
            if (std::min(a.y, b.y) < y && y < std::max(a.y, b.y))
                range.add(crossing(a, b, y));
        }
        return range;
    }
    /// The part of a horizontal line that belongs to this triangle alone: from the first end on, without the
    /// second.
    [[nodiscard]] Range owned(double y) const {
        Range range;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& a = m_corners[k];
            const Vec3& b = m_corners[(k + 1) % 3];
            if (std::min(a.y, b.y) <= y && y < std::max(a.y, b.y))
                range.add(crossing(a, b, y));
        }
        return range;
    }

private:
    Corners m_corners;
    double m_area;
    double m_lowest;
    double m_highest;
    Vec2 m_slope{0};
};

/// Where the vertical line through a point crosses the surface.
struct Crossing {
    std::uint32_t point; ///< index within the band
    bool up;             ///< the outside is above
    double z;
};

/// What was found beneath the upper surface.
struct Beneath {
    Undercut undercut;
    std::size_t covered = 0; ///< points with material
    std::size_t open = 0;    ///< of these, the points over which the mesh is not closed
};

/// Tiles of one row, few enough that the memory for their points is small compared with the map.
class Band {
public:
    static constexpr int kMostColumns = 128 * Tile::kSize;

    Band(const GridPart& grid, int firstColumn, int firstRow)
        : m_grid(grid), m_firstColumn(firstColumn), m_firstRow(firstRow),
          m_columns(std::min(kMostColumns, grid.nx - firstColumn)),
          m_rows(std::min(Tile::kSize, grid.ny - firstRow)),
          m_top(static_cast<std::size_t>(m_rows) * static_cast<std::size_t>(m_columns), kAbsent) {}

    [[nodiscard]] int columns() const { return m_columns; }

    void add(const Facet& facet) {
        if (facet.largestX() + kOnRim < x(0) || facet.leastX() - kOnRim > x(m_columns - 1))
            return;
        const auto row = [&](double y) {
            return (y - m_grid.origin.y) / m_grid.hy - m_grid.firstJ - m_firstRow;
        };
        const double first = std::ceil(row(facet.lowestY() - kOnRim));
        const double last = std::floor(row(facet.highestY() + kOnRim));
        for (int j = static_cast<int>(std::max(first, 0.0)); j <= std::min(last, m_rows - 1.0); ++j)
            addRow(facet, j);
    }

    /// Both indices are counted from the first point of the band.
    [[nodiscard]] double top(int i, int j) const { return m_top[indexOf(i, j)]; }

    /// `upIsOut`: the triangles are counter-clockwise seen from outside.
    void lookBeneath(bool upIsOut, double floorZ, const Vec3& offset, Beneath& beneath) {
        std::vector<std::uint32_t> ends(m_top.size() + 1, 0);
        for (const Crossing& crossing : m_crossings)
            ++ends[crossing.point + 1];
        for (std::size_t k = 1; k < ends.size(); ++k)
            ends[k] += ends[k - 1];
        std::vector<Crossing> sorted(m_crossings.size());
        std::vector<std::uint32_t> next(ends.begin(), ends.end() - 1);
        for (const Crossing& crossing : m_crossings)
            sorted[next[crossing.point]++] = crossing;
        for (std::size_t point = 0; point + 1 < ends.size(); ++point)
            lookDown(std::span(sorted).subspan(ends[point], ends[point + 1] - ends[point]), upIsOut, floorZ,
                     offset, beneath);
    }

private:
    [[nodiscard]] std::size_t indexOf(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(m_columns) +
               static_cast<std::size_t>(i);
    }
    [[nodiscard]] double x(int i) const { return m_grid.x(m_firstColumn + i); }

    [[nodiscard]] int columnFrom(double x) const {
        const double column = std::ceil((x - m_grid.origin.x) / m_grid.hx) - m_grid.firstI - m_firstColumn;
        return static_cast<int>(std::clamp(column, 0.0, double(m_columns)));
    }

    void addRow(const Facet& facet, int j) {
        const double y = m_grid.y(m_firstRow + j);
        const Range covered = facet.covered(y);
        for (int i = columnFrom(covered.from - kOnRim - m_grid.hx);
             i < m_columns && x(i) <= covered.to + kOnRim; ++i) {
            if (x(i) < covered.from - kOnRim)
                continue;
            double& top = m_top[indexOf(i, j)];
            top = std::max(top, facet.heightAt(x(i), y));
        }
        const Range owned = facet.owned(y + kAsideY);
        for (int i = columnFrom(owned.from - m_grid.hx); i < m_columns && x(i) + kAsideX < owned.to; ++i)
            if (x(i) + kAsideX >= owned.from)
                m_crossings.push_back(
                    {static_cast<std::uint32_t>(indexOf(i, j)), facet.looksUp(), facet.heightAt(x(i), y)});
    }

    /// Follows the column from above down to the floor: there is air where the line has entered as many
    /// shells as it has left.
    void lookDown(std::span<Crossing> column, bool upIsOut, double floorZ, const Vec3& offset,
                  Beneath& beneath) const {
        if (column.empty())
            return;
        std::ranges::sort(column, [](const Crossing& a, const Crossing& b) { return a.z > b.z; });
        const auto columns = static_cast<std::uint32_t>(m_columns);
        const int i = m_firstColumn + static_cast<int>(column.front().point % columns);
        const int j = m_firstRow + static_cast<int>(column.front().point / columns);
        const double weight =
            (i == 0 || i == m_grid.nx - 1 ? 0.5 : 1.0) * (j == 0 || j == m_grid.ny - 1 ? 0.5 : 1.0);
        const auto air = [&](double from, double to) {
            if (from - to > Undercut::kLeast)
                beneath.undercut.add((from - to) * weight * m_grid.hx * m_grid.hy, from - to,
                                     Vec3(m_grid.x(i), m_grid.y(j), from) + offset);
        };
        int within = 0;
        for (std::size_t k = 0; k < column.size(); ++k) {
            within += column[k].up == upIsOut ? 1 : -1;
            if (within <= 0)
                air(column[k].z, k + 1 < column.size() ? column[k + 1].z : floorZ);
        }
        ++beneath.covered;
        beneath.open += within == 0 ? 0 : 1;
    }

    const GridPart& m_grid;
    int m_firstColumn;
    int m_firstRow;
    int m_columns;
    int m_rows;
    std::vector<double> m_top; ///< absolute
    std::vector<Crossing> m_crossings;
};

class MeshStock final : public StockBody, public PartedStock {
public:
    MeshStock(StockMesh mesh, const Box3& box, Diagnostics warnings)
        : m_mesh(std::move(mesh)), m_box(box), m_warnings(std::move(warnings)) {
        double volume = 0;
        for (std::size_t k = 0; k < m_mesh.triangles.size(); ++k) {
            const Corners c = corners(k);
            volume += glm::dot(c[0] - box.lo, glm::cross(c[1] - box.lo, c[2] - box.lo));
        }
        m_upIsOut = volume >= 0;
    }

    [[nodiscard]] StockBox box() const override {
        const Vec3 size = m_box.hi - m_box.lo;
        return {{m_box.lo.x, m_box.lo.y, m_box.hi.z}, size.x, size.y, size.z};
    }

    [[nodiscard]] UncutStock uncut(const StockBox& stock, const Grid& grid) const override {
        UncutStock uncut{ZMap(stock, grid), m_warnings};
        const Vec3 offset = stock.corner - box().corner;
        Beneath beneath;
        fill(uncut.zmap, GridPart(grid), offset,
             [&](Band& band) { band.lookBeneath(m_upIsOut, m_box.lo.z, offset, beneath); });
        report(beneath, uncut.findings);
        return uncut;
    }
    [[nodiscard]] ZMap uncutPart(const StockBox& stock, const GridPart& part) const override {
        ZMap zmap(part.stock(stock), part.grid());
        fill(zmap, part, stock.corner - box().corner, [](Band&) {});
        return zmap;
    }

private:
    /// Calls `look` with each band once it is complete.
    template<class Look>
    void fill(ZMap& zmap, GridPart grid, const Vec3& offset, const Look& look) const {
        // The mesh stays in its own coordinates, and the grid is moved to it.
        grid.origin -= Vec2(offset);
        const auto rows = rowsOf(grid);
        for (int tileRow = 0; tileRow < zmap.tilesY(); ++tileRow)
            for (int column = 0; column < grid.nx; column += Band::kMostColumns) {
                Band band(grid, column, tileRow * Tile::kSize);
                for (const std::uint32_t triangle : rows[static_cast<std::size_t>(tileRow)])
                    band.add(Facet(corners(triangle)));
                put(band, column / Tile::kSize, tileRow, zmap);
                look(band);
            }
    }

    [[nodiscard]] Corners corners(std::size_t triangle) const {
        const auto& t = m_mesh.triangles[triangle];
        return {m_mesh.vertices[t[0]], m_mesh.vertices[t[1]], m_mesh.vertices[t[2]]};
    }

    /// The triangles over each row of tiles.
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> rowsOf(const GridPart& grid) const {
        const int count = (grid.ny + Tile::kSize - 1) / Tile::kSize;
        std::vector<std::vector<std::uint32_t>> rows(static_cast<std::size_t>(count));
        const auto rowAt = [&](double y) {
            const double row = std::floor(((y - grid.origin.y) / grid.hy - grid.firstJ) / Tile::kSize);
            return static_cast<int>(std::clamp(row, 0.0, count - 1.0));
        };
        for (std::size_t k = 0; k < m_mesh.triangles.size(); ++k) {
            const Facet facet(corners(k));
            if (facet.isUpright())
                continue;
            for (int row = rowAt(facet.lowestY() - kOnRim); row <= rowAt(facet.highestY() + kOnRim); ++row)
                rows[static_cast<std::size_t>(row)].push_back(static_cast<std::uint32_t>(k));
        }
        return rows;
    }

    void put(const Band& band, int firstTile, int tileRow, ZMap& zmap) const {
        for (int ti = 0; ti * Tile::kSize < band.columns(); ++ti) {
            const auto index = static_cast<std::size_t>(tileRow * zmap.tilesX() + firstTile + ti);
            const IndexRect rect = zmap.tileRect(index);
            Tile& tile = zmap.tileForWriting(index);
            for (int j = 0; j < rect.height(); ++j)
                for (int i = 0; i < rect.width(); ++i) {
                    const double top = band.top(ti * Tile::kSize + i, j) - m_box.hi.z;
                    tile.at(i, j) = std::clamp(static_cast<float>(top), zmap.floor(), 0.0F);
                }
            tile.refreshMaximum();
        }
    }

    static void report(const Beneath& beneath, Diagnostics& findings) {
        if (beneath.open > 0)
            findings.push_back(
                diagnosticOf(stock_body_finding::kStockMeshOpen,
                             {fmt::format("{}", beneath.open), fmt::format("{}", beneath.covered)}));
        for (Diagnostic& finding : beneath.undercut.reported())
            findings.push_back(std::move(finding));
    }

    StockMesh m_mesh;
    Box3 m_box;
    Diagnostics m_warnings;
    bool m_upIsOut = true;
};

/// The average number of facets above one another.
double layersOf(const StockMesh& mesh, const Box3& box) {
    double covered = 0;
    for (const auto& t : mesh.triangles)
        covered += std::abs(areaInPlan({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]})) / 2;
    return covered / ((box.hi.x - box.lo.x) * (box.hi.y - box.lo.y));
}

} // namespace

namespace {

/// The bounding box of a mesh, or why the mesh cannot be a stock.
Result<Box3> boxOf(const StockMesh& mesh) {
    Box3 box;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) {
            const Vec3& place = mesh.vertices[vertex];
            for (int axis = 0; axis < 3; ++axis)
                if (!(std::abs(place[axis]) <= kFarthest))
                    return failure(zmap_finding::kStockMeshFar, {"10000000"});
            box.add(place);
        }
    if (box.empty() || !glm::all(glm::lessThan(box.lo, box.hi)))
        return failure(zmap_finding::kStockMeshFlat);
    if (const double layers = layersOf(mesh, box); layers > kMostLayers)
        return failure(zmap_finding::kStockMeshLayers,
                       {fmt::format("{:.0f}", layers), fmt::format("{:.0f}", kMostLayers)});
    return box;
}

} // namespace

Result<std::shared_ptr<const StockBody>> meshStock(StockMesh mesh, Diagnostics warnings) {
    Result<Box3> box = boxOf(mesh);
    if (box)
        return std::make_shared<const MeshStock>(std::move(mesh), *box, std::move(warnings));
    // The warnings may explain the error: a part in metres is flat, or has a thousand layers.
    std::ranges::move(warnings, std::back_inserter(box.error()));
    return tl::unexpected(std::move(box.error()));
}

} // namespace proveout
