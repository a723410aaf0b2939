// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/rim_crossings.h"

#include <algorithm>
#include <cmath>

namespace proveout {

namespace {

/// Where walls turn by more, two rims are those of two walls that meet in a corner; by less, of one that is
/// round.
constexpr double kCorner = 0.64; // the sine of 40°

double cross(const Vec2& a, const Vec2& b) {
    return a.x * b.y - a.y * b.x;
}

} // namespace

OnWall onWall(const RimCrossing& a, const RimCrossing& b) {
    const Vec2 chord = b.at - a.at;
    const double length2 = glm::dot(chord, chord);
    if (!(length2 > 0))
        return {a.at, a.normal};
    const Vec2 left(-chord.y, chord.x);
    // The slopes of the curve against its chord.
    const auto slope = [&](const Vec2& normal) {
        const double up = glm::dot(normal, left);
        return std::abs(up) > 0 ? -glm::dot(normal, chord) / up : 0.0;
    };
    const double t = std::clamp(-glm::dot(a.at, chord) / length2, 0.0, 1.0);
    const double beside = t * (1 - t) * ((1 - t) * slope(a.normal) - t * slope(b.normal));
    const bool isCorner = std::abs(cross(a.normal, b.normal)) > kCorner || glm::dot(a.normal, b.normal) < 0;
    return {a.at + t * chord + beside * left,
            isCorner ? Vec2(0) : glm::normalize(glm::mix(a.normal, b.normal, t))};
}

std::optional<Vec2> cornerOf(const RimCrossing& a, const RimCrossing& b) {
    const double turn = cross(a.normal, b.normal);
    if (std::abs(turn) < kCorner)
        return std::nullopt;
    const double alongA = glm::dot(a.normal, a.at);
    const double alongB = glm::dot(b.normal, b.at);
    return Vec2(alongA * b.normal.y - alongB * a.normal.y, a.normal.x * alongB - b.normal.x * alongA) / turn;
}

RimSurroundings::RimSurroundings(const ZMapSnapshot& zmap, std::size_t tile)
    : m_zmap(zmap), m_rect(zmap.tileRect(tile)) {
    const int i = m_rect.i0 / Tile::kSize;
    const int j = m_rect.j0 / Tile::kSize;
    std::vector<Foot> feet;
    for (int tj = std::max(j - 1, 0); tj <= std::min(j + 1, zmap.tilesY() - 1); ++tj) {
        for (int ti = std::max(i - 1, 0); ti <= std::min(i + 1, zmap.tilesX() - 1); ++ti)
            add(ti, tj, feet);
    }
    for (const Foot& wall : feet)
        addFoot(wall);
}

std::optional<RimCrossing> RimSurroundings::crossing(int i, int j, const GridStep& step, bool high) const {
    const auto [di, dj] = step;
    const auto edge = placeOf(std::min(i, i + di), std::min(j, j + dj), dj != 0, high);
    if (!edge || m_rims[*edge].rim == nullptr)
        return std::nullopt;
    const Rim* rim = m_rims[*edge].rim;
    const std::uint32_t foot = m_rims[*edge].foot;
    // Points on both sides of a wall through a point of the grid must not meet there.
    const double place = std::clamp(rim->fraction(high), kApart, 1 - kApart);
    const double way = di + dj > 0 ? place : 1 - place;
    const double height =
        foot != 0 ? m_feet[foot].bottom : static_cast<double>(high ? rim->top : rim->bottom);
    RimCrossing crossing{Vec2(di * grid().hx, dj * grid().hy) * way, rim->normal(), height, rim->isUpright()};
    if (foot != 0)
        crossing.foot = m_feet[foot];
    return crossing;
}

void RimSurroundings::add(int ti, int tj, std::vector<Foot>& feet) {
    const RimTilePtr& tile = m_zmap.rims()[static_cast<std::size_t>(tj * m_zmap.tilesX() + ti)];
    if (!tile)
        return;
    if (m_rims.empty()) {
        m_rims.resize(std::size_t{2} * 2 * kWidth * kWidth);
        m_hasRim.resize(std::size_t{2} * kWidth * kWidth);
        m_cells.resize(std::size_t{2} * kWidth * kWidth);
        m_isNear.resize(std::size_t{Tile::kSize} * Tile::kSize);
        m_feet.resize(1);
    }
    for (const Rim& rim : tile->rims) {
        const RimEdge edge = RimEdge::of(rim.edge);
        const int i = ti * Tile::kSize + edge.i;
        const int j = tj * Tile::kSize + edge.j;
        const auto place = placeOf(i, j, edge.alongY, false);
        if (!place)
            continue;
        m_hasRim[*place / 2] = rim.has(true);
        if (rim.isUpright())
            feet.push_back({&rim, i, j});
        for (const bool high : {false, true})
            if (rim.has(high) && isLevelBeside(rim, i, j, edge.alongY, high))
                use(rim, i, j, high, 0);
    }
}

void RimSurroundings::use(const Rim& rim, int i, int j, bool high, std::uint32_t foot) {
    const bool alongY = RimEdge::of(rim.edge).alongY;
    m_rims[*placeOf(i, j, alongY, high)] = {&rim, foot};
    markCells(i, j, alongY, high);
    markAround(i, j, alongY);
}

/// Where the next points below the wall are those of its foot.
void RimSurroundings::addFoot(const Foot& wall) {
    const auto [rim, i, j] = wall;
    const bool alongY = RimEdge::of(rim->edge).alongY;
    const auto height = [&, i = i, j = j](int steps) {
        return static_cast<double>(m_zmap.height(i + (alongY ? 0 : steps), j + (alongY ? steps : 0)));
    };
    // From the first point of the edge, in steps: its low end, and onwards.
    const bool isLastLow = height(0) > height(1);
    const int low = isLastLow ? 1 : 0;
    const int onwards = isLastLow ? 1 : -1;
    const int first = alongY ? j : i;
    const int count = alongY ? grid().ny : grid().nx;
    const auto isFree = [&, i = i, j = j](int from) { // of the edge onwards, which is in the map
        const int edge = onwards > 0 ? from : from - 1;
        return first + edge >= 0 && first + edge + 1 < count &&
               !hasRim(i + (alongY ? 0 : edge), j + (alongY ? edge : 0), alongY);
    };
    const double across = static_cast<double>(std::abs(alongY ? rim->normalY : rim->normalX)) / 32767;
    if (!isFree(low) || !(across > kLeastAcross))
        return;
    const double length = alongY ? grid().hy : grid().hx;
    const double place = isLastLow ? 1 - rim->fraction(false) : rim->fraction(false);
    const auto bottom = static_cast<double>(rim->bottom);
    const FootSample point{place * length, height(low)};
    const FootSample next{(place + 1) * length, height(low + onwards)};
    if (isLevel(bottom, next.height))
        return;
    std::optional<RoundFoot> foot;
    if (place <= kRimBeyond) { // the point is not below the wall's end
        if (isFree(low + onwards))
            foot = RoundFoot::through(next, {(place + 2) * length, height(low + 2 * onwards)}, point.height);
    } else if (!isLevel(point.height, bottom)) {
        foot = RoundFoot::through({kRimBeyond * length, bottom}, static_cast<double>(rim->top), point, next);
    }
    if (!foot)
        return;
    m_feet.push_back(foot->scaled(across));
    use(*rim, i, j, false, static_cast<std::uint32_t>(m_feet.size() - 1));
}

} // namespace proveout
