// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/map_top.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace proveout {

namespace {

/// How near to an edge its wall is known, which is searched for at places as near as that (stock_crossing.h,
/// tile_rims.h): in mm, and in lengths of the edge.
constexpr double kNearEdge = 1.5e-3;
constexpr double kNearEdgePart = 1.0 / 2048;
/// Places are rounded by less than this, in lengths of the edge.
constexpr double kAtPoint = 1e-9;
/// Where a wall is so nearly along its edge, its direction counts no more.
constexpr double kAcross = 1e-2;

struct Point {
    double place; ///< from the high end, in lengths of the edge
    double height;
};

/// Between two points of a profile.
double between(const Point& a, const Point& b, double place) {
    const double length = b.place - a.place;
    return length > 0 ? std::lerp(a.height, b.height, std::clamp((place - a.place) / length, 0.0, 1.0))
                      : a.height;
}

/// The surface along an edge with heights `first` and `second` at its ends.
double besideRim(const Rim& rim, double first, double second, double place) {
    const bool reversed = first < second;
    const auto fromHigh = [&](double part) { return reversed ? 1 - part : part; };
    const double at = fromHigh(place);
    const Point high{0, std::max(first, second)};
    const Point low{1, std::min(first, second)};
    if (at <= kAtPoint)
        return high.height;
    if (at >= 1 - kAtPoint)
        return low.height;
    const Point wallHigh = rim.has(true) ? Point{fromHigh(rim.fraction(true)), double{rim.top}} : high;
    Point wallLow = rim.has(false) ? Point{fromHigh(rim.fraction(false)), double{rim.bottom}} : low;
    wallLow.place = std::max(wallLow.place, wallHigh.place);
    if (at <= wallHigh.place)
        return between(high, wallHigh, at);
    return at <= wallLow.place ? between(wallHigh, wallLow, at) : between(wallLow, low, at);
}

int firstPoint(double at, double from, double step, int count) {
    return static_cast<int>(std::clamp(std::floor((at - from) / step), 0.0, count - 1.0));
}
int lastPoint(double at, double from, double step, int count) {
    return static_cast<int>(std::clamp(std::ceil((at - from) / step), 0.0, count - 1.0));
}

} // namespace

MapTop::MapTop(ZMapSnapshot map) : m_map(std::move(map)), m_hasRims(countOf(m_map.rims()) > 0) {}

double MapTop::height(const Vec2& place) const {
    const Grid& grid = m_map.grid();
    const double u = (place.x - grid.x0) / grid.hx;
    const double v = (place.y - grid.y0) / grid.hy;
    if (!(u >= 0 && v >= 0 && u <= grid.nx - 1 && v <= grid.ny - 1))
        return kAbsent;
    if (m_hasRims)
        if (const std::optional<double> height = heightNearEdge(u, v))
            return *height;
    const int i = std::min(static_cast<int>(u), grid.nx - 2);
    const int j = std::min(static_cast<int>(v), grid.ny - 2);
    const auto at = [&](int di, int dj) { return double{m_map.height(i + di, j + dj)}; };
    return std::lerp(std::lerp(at(0, 0), at(1, 0), u - i), std::lerp(at(0, 1), at(1, 1), u - i), v - j);
}

std::optional<double> MapTop::heightNearEdge(double u, double v) const {
    const Grid& grid = m_map.grid();
    const double fromRow = (v - std::round(v)) * grid.hy;
    const double fromColumn = (u - std::round(u)) * grid.hx;
    const bool alongY = std::abs(fromColumn) < std::abs(fromRow);
    const double length = alongY ? grid.hy : grid.hx;
    const double aside = alongY ? fromColumn : fromRow;
    if (std::abs(aside) > kNearEdge + kNearEdgePart * length)
        return std::nullopt;
    const int i = alongY ? static_cast<int>(std::round(u)) : std::min(static_cast<int>(u), grid.nx - 2);
    const int j = alongY ? std::min(static_cast<int>(v), grid.ny - 2) : static_cast<int>(std::round(v));
    const Rim* rim = rimAt(i, j, alongY);
    if (rim == nullptr)
        return std::nullopt;
    const double first = m_map.height(i, j);
    const double second = m_map.height(i + (alongY ? 0 : 1), j + (alongY ? 1 : 0));
    const Vec2 normal = rim->normal();
    const double along = std::max(std::abs(alongY ? normal.y : normal.x), kAcross);
    const double across = alongY ? normal.x : normal.y;
    const double place = alongY ? v - j : u - i;
    // The place on the edge that is as far from the wall; the normal is towards the high end.
    const double towardsEnd = first < second ? 1 : -1;
    return besideRim(*rim, first, second,
                     std::clamp(place + towardsEnd * aside * across / (along * length), 0.0, 1.0));
}

double MapTop::highest(const Vec2& lo, const Vec2& hi) const {
    const Grid& grid = m_map.grid();
    double highest = kAbsent;
    for (int j = firstPoint(lo.y, grid.y0, grid.hy, grid.ny); j <= lastPoint(hi.y, grid.y0, grid.hy, grid.ny);
         ++j)
        for (int i = firstPoint(lo.x, grid.x0, grid.hx, grid.nx);
             i <= lastPoint(hi.x, grid.x0, grid.hx, grid.nx); ++i) {
            highest = std::max(highest, double{m_map.height(i, j)});
            for (const bool alongY : {false, true})
                if (const Rim* rim = m_hasRims ? rimAt(i, j, alongY) : nullptr)
                    highest = std::max({highest, double{rim->top}, double{rim->bottom}});
        }
    return highest;
}

const Rim* MapTop::rimAt(int i, int j, bool alongY) const {
    const auto tile = static_cast<std::size_t>((j / Tile::kSize) * m_map.tilesX() + i / Tile::kSize);
    const RimTilePtr& rims = m_map.rims()[tile];
    return rims == nullptr ? nullptr : rims->find({i % Tile::kSize, j % Tile::kSize, alongY});
}

const RimTile* MapTop::rims(std::size_t tile) const {
    return m_map.rims().empty() ? nullptr : m_map.rims()[tile].get();
}

} // namespace proveout
