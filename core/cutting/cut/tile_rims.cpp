// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/tile_rims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/cutting/cut/falling_edges.h"
#include "core/cutting/cut/near_sweeps.h"
#include "core/cutting/cut/stock_crossing.h"
#include "core/cutting/cut/sweep.h"

namespace proveout {

namespace {

/// How far below the plateau a surface counts as beyond the wall, and the least height of a wall, as slopes
/// over the length of an edge.
constexpr double kBelowPlateau = kWallSlope / 4;
constexpr double kLeastWall = kWallSlope / 2;

constexpr int kHalvings = 20;

PlanArea areaOf(const EdgeLine& line) {
    const Vec2 end = line.at(line.length);
    return {glm::min(line.from, end), glm::max(line.from, end)};
}

/// The exact surface near one edge.
class ExactSurface {
public:
    /// `sweeps`: the lowest one first.
    ExactSurface(const ZMapSnapshot& zmap, const StockTop* uncut, std::vector<const Sweep*> sweeps)
        : m_floor(-zmap.stock().height), m_uncut(uncut), m_sweeps(std::move(sweeps)) {}

    /// Relative to the top of the stock.
    [[nodiscard]] double height(const Vec2& place) const {
        double height = m_uncut == nullptr ? 0 : std::min(0.0, m_uncut->height(place));
        for (const Sweep* sweep : m_sweeps) {
            if (!(sweep->lowest() < height))
                break;
            height = std::min(height, sweep->envelope(place.x, place.y, height));
        }
        return std::max(height, m_floor);
    }

    /// The first place where it is below a line.
    [[nodiscard]] EdgeCrossing crossing(const EdgeLine& line) const {
        EdgeCrossing first;
        if (m_uncut != nullptr)
            first = crossingWithStock(*m_uncut, line);
        for (const Sweep* sweep : m_sweeps) {
            if (!(sweep->lowest() < line.height)) // where it begins, and from there it falls
                break;
            sweep->findCrossing(line, first);
        }
        return first;
    }

private:
    double m_floor;
    const StockTop* m_uncut;
    std::vector<const Sweep*> m_sweeps;
};

/// The distance, mm, at which the surface on either side of a wall is measured: more than coordinates are
/// rounded by.
double besideWall(const EdgeLine& line) {
    const double largest = std::max(std::abs(line.from.x), std::abs(line.from.y));
    return 2e-8 + 8 * std::numeric_limits<double>::epsilon() * largest;
}

/// A crossing is never late, but may be early by some nanometres across the wall, which is more along an edge
/// that meets it at a small angle: moves it to where the surface is below the line just after it.
double settled(const ExactSurface& surface, const EdgeLine& line, double place, double beside) {
    const auto below = [&](double at) { return surface.height(line.at(at)) < line.heightAt(at); };
    const double latest = place + 1e-2 * line.length;
    double above = place;
    double after = place + beside;
    while (after < line.length && !below(after)) {
        above = after;
        after = std::min(place + 4 * (after - place), line.length);
        if (after > latest)
            return place;
    }
    if (above == place)
        return place;
    while (after - above > beside / 4) {
        const double middle = (above + after) / 2;
        (below(middle) ? after : above) = middle;
    }
    return above;
}

/// One side of a wall on a line.
struct WallSide {
    double place; ///< mm from the high end
    double height;
};

/// The wall on an edge: what is known of it.
struct WallOnEdge {
    std::optional<WallSide> high;
    std::optional<WallSide> low;
};

/// The wall where the surface jumps.
WallOnEdge jumpOn(const FallingEdge& edge, const EdgeLine& line, const ExactSurface& surface, double place,
                  RimEdges wanted) {
    const double beside = besideWall(line);
    const double top = place > beside ? surface.height(line.at(place - beside)) : edge.high;
    const auto bottom = [&](double beyond) {
        return place + beyond < line.length ? surface.height(line.at(place + beyond)) : edge.low;
    };
    const double atWall = bottom(beside);
    if (!(top - atWall > kLeastWall * line.length))
        return {};
    const double below = wanted == RimEdges::all ? atWall : bottom(kRimBeyond * line.length);
    return {WallSide{place, top}, WallSide{place, below}};
}

/// Between `above`, where the surface is above a height, and `below`, where it is not, the place where it
/// comes down to it.
double placeOfHeight(const ExactSurface& surface, const EdgeLine& line, double height, double above,
                     double below) {
    for (int k = 0; k < kHalvings; ++k) {
        const double middle = (above + below) / 2;
        (surface.height(line.at(middle)) > height ? above : below) = middle;
    }
    return (above + below) / 2;
}

/// The direction in which the slope of a wall rises, over ground, a little beyond its creases.
Vec2 uphill(const ExactSurface& surface, const EdgeLine& line, const WallOnEdge& wall) {
    const double inside = line.length / 64;
    const double step = line.length / 4096;
    const Vec2 place = line.at(wall.high ? wall.high->place + inside : wall.low->place - inside);
    const auto rise = [&](const Vec2& way) {
        return surface.height(place + way) - surface.height(place - way);
    };
    const Vec2 gradient(rise({step, 0}), rise({0, step}));
    const double size = glm::length(gradient);
    return size > 0 ? gradient / size : Vec2(0);
}

/// Adds the creases where a slope begins at a level and ends at one.
void addCreases(const FallingEdge& edge, const EdgeLine& line, const ExactSurface& surface, double below,
                WallOnEdge& wall) {
    const double near = kRimCrease * line.length;
    const bool opensAbove = !wall.high || edge.high - wall.high->height > near;
    if (opensAbove && edge.isFromLevel(line.length))
        wall.high = {placeOfHeight(surface, line, edge.high - near, 0, below), edge.high};
    const bool opensBelow = !wall.low || wall.low->height - edge.low > near;
    if (opensBelow && edge.isToLevel(line.length))
        wall.low = {
            placeOfHeight(surface, line, edge.low + near, wall.high ? wall.high->place : 0, line.length),
            edge.low};
}

/// Below an upright wall whose round foot ends at a level on the same edge, such as that of a bull-nose
/// cutter of small radius, where a straight wall has to end on that level for the same volume.
void straighten(const EdgeLine& line, const ExactSurface& surface, const WallSide& foot, WallOnEdge& wall) {
    // Gauss-Legendre from 0 to 1.
    constexpr std::array<double, 4> kPlaces{0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                                            0.93056815579702629};
    constexpr std::array<double, 4> kWeights{0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                             0.17392742256872693};
    const double width = wall.low->place - foot.place;
    const double height = wall.high->height - wall.low->height;
    if (!(width > 0) || !(height > 0))
        return;
    double area = 0;
    for (std::size_t k = 0; k < kPlaces.size(); ++k) {
        const double u = kPlaces[k];
        const double above = surface.height(line.at(foot.place + width * u * u)) - wall.low->height;
        area += kWeights[k] * 2 * u * width * above;
    }
    wall.low->place = foot.place + std::clamp(2 * area / height, 0.0, width);
}

/// Whether the surface is nearly as high at both ends of an edge as beside the wall.
bool isBetweenLevels(const FallingEdge& edge, const WallOnEdge& wall, double length) {
    constexpr double kLevel = 0.1; // of the edge
    return std::abs(wall.high->height - edge.high) <= kLevel * length &&
           std::abs(wall.low->height - edge.low) <= kLevel * length;
}

std::uint16_t inUnits(double place, const FallingEdge& edge, double length) {
    const double part = edge.reversed ? 1 - place / length : place / length;
    return static_cast<std::uint16_t>(std::clamp(std::round(part * 65536), 0.0, 65535.0));
}

std::optional<Rim> rimOn(const FallingEdge& edge, const EdgeLine& line, const ExactSurface& surface,
                         RimEdges wanted) {
    WallOnEdge wall;
    EdgeCrossing crossing;
    double below = line.length;
    if (edge.fallsMore(kWallSlope, line.length)) {
        crossing = surface.crossing(line);
        if (crossing.found()) {
            below = settled(surface, line, crossing.place, besideWall(line));
            wall = jumpOn(edge, line, surface, below, wanted);
        }
    }
    if (wanted == RimEdges::atLevels) {
        const std::optional<WallSide> foot = wall.low;
        addCreases(edge, line, surface, below, wall);
        if (foot && wall.high->place == foot->place)
            straighten(line, surface, *foot, wall);
    }
    if (!wall.high && !wall.low)
        return std::nullopt;
    if (wanted == RimEdges::betweenLevels && !isBetweenLevels(edge, wall, line.length))
        return std::nullopt;
    const WallSide& known = wall.high ? *wall.high : *wall.low;
    const Vec2 normal = crossing.found() ? crossing.outwards : uphill(surface, line, wall);
    Rim rim{};
    rim.edge = edge.edge.index();
    rim.sides = !wall.low ? RimSides::high : (wall.high ? RimSides::both : RimSides::low);
    rim.highPlace = inUnits(wall.high.value_or(known).place, edge, line.length);
    rim.lowPlace = inUnits(wall.low.value_or(known).place, edge, line.length);
    rim.top = static_cast<float>(wall.high ? wall.high->height : edge.high);
    rim.bottom = static_cast<float>(wall.low ? wall.low->height : edge.low);
    rim.normalX = inRimUnits(normal.x);
    rim.normalY = inRimUnits(normal.y);
    return rim;
}

/// The line a little below the plateau at the high end of an edge, which may fall towards the wall. A plateau
/// that rises may be as short as an edge, so that nothing rises beyond it. At the low end the surface is
/// below the line.
EdgeLine lineBelowPlateau(const FallingEdge& edge, const Grid& grid, const IndexRect& tile) {
    const bool alongY = edge.edge.alongY;
    const double length = alongY ? grid.hy : grid.hx;
    const int ahead = edge.reversed ? 1 : 0;
    const int i = tile.i0 + edge.edge.i + (alongY ? 0 : ahead);
    const int j = tile.j0 + edge.edge.j + (alongY ? ahead : 0);
    const double direction = edge.reversed ? -1 : 1;
    EdgeLine line;
    line.from = {grid.x(i), grid.y(j)};
    line.along = alongY ? Vec2(0, direction) : Vec2(direction, 0);
    line.length = length;
    line.height = edge.high - kBelowPlateau * length;
    line.fall = std::max(edge.fallBefore / length, 0.0);
    return line;
}

/// Whether nothing has been cut off the stock at a point of the map.
bool isUncut(const StockTop& uncut, const Vec2& point, double height) {
    constexpr double kRounding = 1e-5; // mm
    return uncut.height(point) - height <= kRounding;
}

/// Whether a rim is that of a wall of the stock, whose heights may have changed.
bool isOnWallOf(const Rim& own, const Rim& rim) {
    constexpr int kRounding = 1;
    return std::abs(own.highPlace - rim.highPlace) <= kRounding &&
           std::abs(own.lowPlace - rim.lowPlace) <= kRounding;
}

} // namespace

TileRimSearch::TileRimSearch(const ZMapSnapshot& zmap, std::size_t tile, RimEdges wanted)
    : m_zmap(zmap), m_index(tile), m_tile(zmap.tileRect(tile)), m_wanted(wanted),
      m_edges(fallingEdges(zmap, tile, wanted)), m_sweeps(zmap, m_tile, m_edges) {}

RimTilePtr TileRimSearch::find(const StockTop* uncut, const std::stop_token& stop) {
    if (m_edges.empty())
        return nullptr;
    RimTile rims;
    rims.areUnknown = m_sweeps.isFull();
    if (rims.areUnknown)
        return std::make_shared<const RimTile>(std::move(rims));
    m_sweeps.sort();
    m_ofStock = uncut == nullptr ? nullptr : uncut->rims(m_index);
    for (const FallingEdge& edge : m_edges) {
        if (stop.stop_requested())
            return nullptr;
        if (const std::optional<Rim> rim = rimOf(edge, uncut))
            rims.rims.push_back(*rim);
    }
    rims.areUnknown = m_missesWalls;
    return rims.empty() ? nullptr : std::make_shared<const RimTile>(std::move(rims));
}

std::optional<Rim> TileRimSearch::rimOf(const FallingEdge& edge, const StockTop* uncut) {
    const EdgeLine line = lineBelowPlateau(edge, m_zmap.grid(), m_tile);
    const Rim* own = m_ofStock == nullptr ? nullptr : m_ofStock->find(edge.edge);
    const bool isOfStock =
        uncut != nullptr && !uncut->knowsWalls() && isUncut(*uncut, line.at(line.length), edge.low);
    if (isOfStock && own == nullptr) {
        m_missesWalls = m_missesWalls || (m_ofStock != nullptr && m_ofStock->areUnknown);
        return std::nullopt;
    }
    const std::vector<const Sweep*> sweeps = m_sweeps.over(edge.edge, areaOf(line));
    const auto found = [&](std::vector<const Sweep*> cut) {
        return rimOn(edge, line, ExactSurface(m_zmap, uncut, std::move(cut)), m_wanted);
    };
    const bool isKept = own != nullptr && isOfStock && isUncut(*uncut, line.from, edge.high);
    if (isKept && sweeps.empty())
        return *own;
    std::optional<Rim> rim = found(sweeps);
    if (isKept && rim == found({})) // nothing was cut between the points either
        return *own;
    if (own != nullptr && rim && isOnWallOf(*own, *rim)) {
        rim->normalX = own->normalX; // more exact than that of a map
        rim->normalY = own->normalY;
    }
    return rim;
}

RimTilePtr rimsOfTile(const ZMapSnapshot& zmap, std::size_t tile, const StockTop* uncut,
                      std::span<const CutterMotion> motions, const std::stop_token& stop, RimEdges wanted) {
    TileRimSearch search(zmap, tile, wanted);
    for (const CutterMotion& motion : motions)
        search.add(motion);
    return search.find(uncut, stop);
}

} // namespace proveout
