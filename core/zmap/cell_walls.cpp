// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/cell_walls.h"

namespace proveout {

namespace {

/// Walls may meet outside of a cell by so many cells, and farther out where a point is in the tip between
/// them.
constexpr double kOutside = 0.25;
constexpr double kFar = 1;

/// The corners of each edge: south, north, west, east.
constexpr std::array<std::array<int, 2>, 4> kEdges{{{0, 1}, {2, 3}, {0, 2}, {1, 3}}};

/// Whether a place is about between two others, in each coordinate.
bool isBetween(const Vec2& place, const Vec2& from, const Vec2& to, const Vec2& slack) {
    return glm::all(glm::greaterThanEqual(place, glm::min(from, to) - slack)) &&
           glm::all(glm::lessThanEqual(place, glm::max(from, to) + slack));
}

} // namespace

CellWalls::CellWalls(const RimSurroundings& around, int i, int j, bool high)
    : m_around(around), m_i(i), m_j(j), m_isHigh(high) {
    const unsigned edges = around.edgesOf(i, j, high);
    for (std::size_t edge = 0; edge < kEdges.size(); ++edge)
        if ((edges >> edge & 1U) != 0)
            look(edge);
}

std::optional<WallPlace> CellWalls::sharp(int corner) const {
    if (m_count != 2 || isHigh(corner) != m_isHigh)
        return std::nullopt;
    const auto meeting = cornerOf(m_crossings[0], m_crossings[1]);
    if (!meeting || !isBetween(*meeting, Vec2(0), m_around.cell(), m_around.cell() * slack()) ||
        !isOfPair(corner, *meeting))
        return std::nullopt;
    return ifBeside(corner, placeOf(corner, {*meeting, Vec2(0)}));
}

std::optional<WallPlace> CellWalls::oppositeOfCut(int corner) const {
    const auto cut = cutOff();
    if (!cut || *cut + corner != 3 || !isDiagonal(*cut) || isHigh(corner) != m_isHigh)
        return std::nullopt;
    RimCrossing a = m_crossings[0];
    RimCrossing b = m_crossings[1];
    const Vec2 from = offsetOf(*cut);
    a.at -= from;
    b.at -= from;
    OnWall wall = onWall(a, b);
    wall.at += from;
    return ifBeside(corner, placeOf(corner, wall));
}

void CellWalls::look(std::size_t edge) {
    const auto [from, to] = kEdges[edge];
    const GridStep step{to % 2 - from % 2, to / 2 - from / 2};
    const auto crossing = m_around.crossing(column(from), row(from), step, m_isHigh);
    if (!crossing)
        return;
    m_high[m_count] = m_around.isHigh(column(from), row(from), step) ? from : to;
    m_edges[m_count] = edge;
    m_crossings[m_count] = *crossing;
    m_crossings[m_count++].at += offsetOf(from);
}

bool CellWalls::ends(std::size_t crossing, int corner) const {
    const auto& corners = kEdges[m_edges[crossing]];
    return corners[0] == corner || corners[1] == corner;
}

bool CellWalls::isHigh(int corner) const {
    for (std::size_t k = 0; k < m_count; ++k) {
        if (ends(k, corner))
            return m_high[k] == corner;
    }
    return !isHigh(3 - corner); // opposite of the corner that is cut off
}

/// The corner that is alone on its side of the walls; nothing if they leave two on each.
std::optional<int> CellWalls::cutOff() const {
    if (m_count != 2)
        return std::nullopt;
    for (int corner = 0; corner < 4; ++corner) {
        if (ends(0, corner) && ends(1, corner) && (m_high[0] == corner) == (m_high[1] == corner))
            return corner;
    }
    return std::nullopt;
}

/// Whether the canonical diagonal of the cell ends at a corner.
bool CellWalls::isDiagonal(int corner) const {
    return ((m_i + m_j) % 2 == 0) == (corner == 0 || corner == 3);
}

/// Whether a corner is one of the two that stand where the walls meet.
bool CellWalls::isOfPair(int corner, const Vec2& meeting) const {
    if (const auto cut = cutOff())
        return corner == *cut || corner == (isDiagonal(*cut) ? 3 - *cut : *cut ^ 1);
    if (m_edges[0] / 2 != m_edges[1] / 2)
        return false;
    const Vec2 part = meeting / m_around.cell();
    const double along = m_edges[0] / 2 == 0 ? part.y : part.x; // from the first edge to the other
    return ends(along <= 0.5 ? 0 : 1, corner);
}

double CellWalls::slack() const {
    const auto cut = cutOff();
    if (!cut)
        return kOutside;
    const auto hasBeyond = [&](const GridStep& step) {
        return m_around.crossing(column(*cut), row(*cut), step, m_isHigh).has_value();
    };
    const bool isTip = hasBeyond({*cut % 2 == 0 ? -1 : 1, 0}) || hasBeyond({0, *cut / 2 == 0 ? -1 : 1});
    return isTip ? kFar : kOutside;
}

WallPlace CellWalls::placeOf(int corner, const OnWall& wall) const {
    return {wall.at - offsetOf(corner),
            heightBeside(m_crossings[0], m_crossings[1]),
            wall.normal,
            m_crossings[0].isUpright && m_crossings[1].isUpright,
            m_isHigh,
            footBeside(m_crossings[0], m_crossings[1])};
}

/// Unless a corner is not on the surface beside the wall.
std::optional<WallPlace> CellWalls::ifBeside(int corner, const WallPlace& place) const {
    return m_around.isBeside(column(corner), row(corner), place.z, place.foot,
                             place.normal == Vec2(0) ? glm::length(place.at)
                                                     : glm::dot(place.at, place.normal))
               ? std::optional(place)
               : std::nullopt;
}

} // namespace proveout
