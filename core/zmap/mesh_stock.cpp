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
#include "core/zmap/mesh_top.h"
#include "core/zmap/stock_body_findings.h"
#include "core/zmap/stock_facet.h"
#include "core/zmap/stock_findings.h"
#include "core/zmap/zmap_findings.h"

namespace proveout {

namespace {

constexpr double kFarthest = 1e7;
/// The largest average number of facets above one another; each facet costs time at every point of the grid
/// that it covers.
constexpr double kMostLayers = 200;
constexpr double kAbsent = -1e30;
/// Crossings are searched for slightly beside the point, by this offset in mm, so that an edge through the
/// point cannot make the result ambiguous.
constexpr Vec2 kAside(0.71e-7, 1.13e-7);
/// Air that does not reach as far as this part of a cell beside a point is none: a wall through the point
/// that leans by rounding, or by the tolerance of a mesh, is no undercut.
constexpr double kNarrow = 0.1;

/// Where the vertical line through a point crosses the surface.
struct Crossing {
    std::uint32_t point; ///< index within the band
    bool up;             ///< the outside is above
    double z;
};

/// Air beneath the upper surface of one point, mm.
struct Air {
    double height = 0;  ///< of all gaps
    double tallest = 0; ///< gap
    double top = 0;     ///< of it
    bool isOpen = false;
};

/// A point over air, and on which sides of it there is some as well: a bit for each, in turn around it.
struct Suspect {
    std::uint32_t point; ///< index within the band
    Air air;
    unsigned sides = 0;

    /// Not only along a wall that leans.
    [[nodiscard]] bool isOverAnUndercut() const { return (sides & (sides << 1U | sides >> 3U)) != 0; }
};

/// What was found beneath the upper surface.
struct Beneath {
    Undercut undercut;
    std::size_t covered = 0; ///< points with material
    std::size_t open = 0;    ///< of these, the points over which the mesh is not closed
};

/// Calls `visit` with the crossings of each point, of which the `points` of a band have any number.
template<class Visit>
void eachColumn(const std::vector<Crossing>& crossings, std::size_t points, const Visit& visit) {
    std::vector<std::uint32_t> ends(points + 1, 0);
    for (const Crossing& crossing : crossings)
        ++ends[crossing.point + 1];
    for (std::size_t k = 1; k < ends.size(); ++k)
        ends[k] += ends[k - 1];
    std::vector<Crossing> sorted(crossings.size());
    std::vector<std::uint32_t> next(ends.begin(), ends.end() - 1);
    for (const Crossing& crossing : crossings)
        sorted[next[crossing.point]++] = crossing;
    for (std::size_t point = 0; point < points; ++point)
        if (ends[point] != ends[point + 1])
            visit(std::span(sorted).subspan(ends[point], ends[point + 1] - ends[point]));
}

/// Follows a column from above down to the floor: there is air where the line has entered as many shells as
/// it has left. `upIsOut`: the triangles are counter-clockwise seen from outside.
Air airIn(std::span<Crossing> column, bool upIsOut, double floorZ) {
    std::ranges::sort(column, [](const Crossing& a, const Crossing& b) { return a.z > b.z; });
    Air air;
    int within = 0;
    for (std::size_t k = 0; k < column.size(); ++k) {
        within += column[k].up == upIsOut ? 1 : -1;
        const double gap = column[k].z - (k + 1 < column.size() ? column[k + 1].z : floorZ);
        if (within > 0 || !(gap > Undercut::kLeast))
            continue;
        air.height += gap;
        if (gap > air.tallest)
            air.top = column[k].z;
        air.tallest = std::max(gap, air.tallest);
    }
    air.isOpen = within != 0;
    return air;
}

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
        eachRow(facet, kOnRim, [&](int j) {
            addCovered(facet, j);
            eachCrossing(facet, j, Vec2(0),
                         [&](const Crossing& crossing) { m_crossings.push_back(crossing); });
        });
    }

    /// Both indices are counted from the first point of the band.
    [[nodiscard]] double top(int i, int j) const { return m_top[indexOf(i, j)]; }

    /// `facets`: those that were added. `upIsOut`: they are counter-clockwise seen from outside.
    void lookBeneath(std::span<const Facet> facets, bool upIsOut, double floorZ, const Vec3& offset,
                     Beneath& beneath) const {
        std::vector<Suspect> suspects;
        eachColumn(m_crossings, m_top.size(), [&](std::span<Crossing> column) {
            const Air air = airIn(column, upIsOut, floorZ);
            ++beneath.covered;
            beneath.open += air.isOpen ? 1 : 0;
            if (air.height > 0)
                suspects.push_back({column.front().point, air, 0});
        });
        if (suspects.empty())
            return;
        const double aside = kNarrow * std::min(m_grid.hx, m_grid.hy);
        for (const Vec2& way : {Vec2(1, 1), Vec2(-1, 1), Vec2(-1, -1), Vec2(1, -1)})
            lookBeside(suspects, facets, aside * way, upIsOut, floorZ);
        for (const Suspect& suspect : suspects)
            if (suspect.isOverAnUndercut())
                addTo(beneath.undercut, suspect, offset);
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

    /// Calls `visit(j)` for the rows that come as near as `near` to the facet.
    template<class Visit>
    void eachRow(const Facet& facet, double near, const Visit& visit) const {
        if (facet.largestX() + near < x(0) || facet.leastX() - near > x(m_columns - 1))
            return;
        const auto row = [&](double y) {
            return (y - m_grid.origin.y) / m_grid.hy - m_grid.firstJ - m_firstRow;
        };
        const double first = std::ceil(row(facet.lowestY() - near));
        const double last = std::floor(row(facet.highestY() + near));
        for (int j = static_cast<int>(std::max(first, 0.0)); j <= std::min(last, m_rows - 1.0); ++j)
            visit(j);
    }

    void addCovered(const Facet& facet, int j) {
        const double y = m_grid.y(m_firstRow + j);
        const FacetRange covered = facet.covered(y);
        for (int i = columnFrom(covered.from - kOnRim - m_grid.hx);
             i < m_columns && x(i) <= covered.to + kOnRim; ++i) {
            if (x(i) < covered.from - kOnRim)
                continue;
            double& top = m_top[indexOf(i, j)];
            top = std::max(top, facet.heightAt(x(i), y));
        }
    }

    /// Calls `visit` with the crossings of a row, which is moved by `aside`.
    template<class Visit>
    void eachCrossing(const Facet& facet, int j, const Vec2& aside, const Visit& visit) const {
        const double y = m_grid.y(m_firstRow + j) + aside.y;
        const double moved = aside.x + kAside.x;
        const FacetRange owned = facet.owned(y + kAside.y);
        for (int i = columnFrom(owned.from - aside.x - m_grid.hx); i < m_columns && x(i) + moved < owned.to;
             ++i)
            if (x(i) + moved >= owned.from)
                visit({static_cast<std::uint32_t>(indexOf(i, j)), facet.looksUp(),
                       facet.heightAt(x(i) + aside.x, y)});
    }

    /// Adds the next side of all.
    void lookBeside(std::vector<Suspect>& suspects, std::span<const Facet> facets, const Vec2& aside,
                    bool upIsOut, double floorZ) const {
        std::vector<bool> isWanted(m_top.size());
        for (Suspect& suspect : suspects) {
            suspect.sides <<= 1U;
            isWanted[suspect.point] = true;
        }
        std::vector<Crossing> crossings;
        const double near = kOnRim + std::max(std::abs(aside.x), std::abs(aside.y));
        for (const Facet& facet : facets)
            eachRow(facet, near, [&](int j) {
                eachCrossing(facet, j, aside, [&](const Crossing& crossing) {
                    if (isWanted[crossing.point])
                        crossings.push_back(crossing);
                });
            });
        auto suspect = suspects.begin();
        eachColumn(crossings, m_top.size(), [&](std::span<Crossing> column) {
            suspect = std::ranges::find(suspect, suspects.end(), column.front().point, &Suspect::point);
            suspect->sides |= airIn(column, upIsOut, floorZ).height > 0 ? 1U : 0U;
        });
    }

    void addTo(Undercut& undercut, const Suspect& suspect, const Vec3& offset) const {
        const auto columns = static_cast<std::uint32_t>(m_columns);
        const int i = m_firstColumn + static_cast<int>(suspect.point % columns);
        const int j = m_firstRow + static_cast<int>(suspect.point / columns);
        const double weight =
            (i == 0 || i == m_grid.nx - 1 ? 0.5 : 1.0) * (j == 0 || j == m_grid.ny - 1 ? 0.5 : 1.0);
        undercut.add(suspect.air.height * weight * m_grid.hx * m_grid.hy, suspect.air.tallest,
                     Vec3(m_grid.x(i), m_grid.y(j), suspect.air.top) + offset);
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
            const FacetCorners c = corners(k);
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
        fill(uncut.zmap, GridPart(grid), offset, [&](const Band& band, std::span<const Facet> facets) {
            band.lookBeneath(facets, m_upIsOut, m_box.lo.z, offset, beneath);
        });
        report(beneath, uncut.findings);
        if (top(stock) == nullptr)
            uncut.findings.push_back(diagnosticOf(stock_body_finding::kStockMeshWalls,
                                                  {std::to_string(MeshTops::kMostOverPlace)}));
        return uncut;
    }
    [[nodiscard]] ZMap uncutPart(const StockBox& stock, const GridPart& part) const override {
        ZMap zmap(part.stock(stock), part.grid());
        fill(zmap, part, stock.corner - box().corner, [](const Band&, std::span<const Facet>) {});
        return zmap;
    }
    [[nodiscard]] std::unique_ptr<StockTop> top(const StockBox& stock) const override {
        return m_tops.top(m_mesh, m_box, Vec2(stock.corner - box().corner));
    }
    /// Those of a map that is used because there is no top.
    [[nodiscard]] RimMap rims(const StockBox& stock, const Grid& grid) const override {
        return top(stock) == nullptr ? unknownRims(tileCountOf(grid)) : RimMap();
    }
    [[nodiscard]] RimMap rimsOfPart(const StockBox& stock, const GridPart& part) const override {
        return rims(stock, part.grid());
    }

private:
    /// Calls `look` with each band once it is complete, and its facets.
    template<class Look>
    void fill(ZMap& zmap, GridPart grid, const Vec3& offset, const Look& look) const {
        // The mesh stays in its own coordinates, and the grid is moved to it.
        grid.origin -= Vec2(offset);
        const auto rows = rowsOf(grid);
        for (int tileRow = 0; tileRow < zmap.tilesY(); ++tileRow) {
            std::vector<Facet> facets;
            facets.reserve(rows[static_cast<std::size_t>(tileRow)].size());
            for (const std::uint32_t triangle : rows[static_cast<std::size_t>(tileRow)])
                facets.emplace_back(corners(triangle));
            for (int column = 0; column < grid.nx; column += Band::kMostColumns) {
                Band band(grid, column, tileRow * Tile::kSize);
                for (const Facet& facet : facets)
                    band.add(facet);
                put(band, column / Tile::kSize, tileRow, zmap);
                look(band, facets);
            }
        }
    }

    [[nodiscard]] FacetCorners corners(std::size_t triangle) const {
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
            const double near = kOnRim + kNarrow * grid.hy; // Band looks beside points as well
            for (int row = rowAt(facet.lowestY() - near); row <= rowAt(facet.highestY() + near); ++row)
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
    MeshTops m_tops;
};

/// The average number of facets above one another.
double layersOf(const StockMesh& mesh, const Box3& box) {
    double covered = 0;
    for (const auto& t : mesh.triangles)
        covered += std::abs(areaInPlan({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]})) / 2;
    return covered / ((box.hi.x - box.lo.x) * (box.hi.y - box.lo.y));
}

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
