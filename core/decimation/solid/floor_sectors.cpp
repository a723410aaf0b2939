// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/floor_sectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace proveout {

namespace {

double cross(const Vec2& a, const Vec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// The angle from a to b, counter-clockwise, in [0, 2 pi).
double angleBetween(const Vec2& a, const Vec2& b) {
    const double angle = std::atan2(cross(a, b), glm::dot(a, b));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

/// Twice the area over the longest side: a triangle turns over only when its corners move by half of this.
double width(const Corner& corner) {
    const double longest = std::max({glm::length(corner.toNext), glm::length(corner.toPrevious),
                                     glm::length(corner.toNext - corner.toPrevious)});
    return cross(corner.toNext, corner.toPrevious) / longest;
}

/// The direction that bisects the sector.
Vec2 bisector(const Sector& sector) {
    const Vec2 from = glm::normalize(sector.corners.front().toNext);
    const double half = angleBetween(from, sector.corners.back().toPrevious) / 2;
    return {from.x * std::cos(half) - from.y * std::sin(half),
            from.x * std::sin(half) + from.y * std::cos(half)};
}

void setApart(std::vector<Sector>& sectors, double gap) {
    std::vector<Vec2> directions;
    std::transform(sectors.begin(), sectors.end(), std::back_inserter(directions), bisector);
    double nearest = 2; // the distance of the two copies that come nearest, for offsets of length 1
    for (std::size_t a = 0; a < directions.size(); ++a) {
        for (std::size_t b = a + 1; b < directions.size(); ++b)
            nearest = std::min(nearest, glm::length(directions[a] - directions[b]));
    }
    const double wanted = gap * std::max(1.0, 1 / nearest);
    for (std::size_t s = 0; s < sectors.size(); ++s) {
        double length = wanted;
        // A quarter each, because all three corners of a triangle may have to move.
        for (const Corner& corner : sectors[s].corners)
            length = std::min(length, width(corner) / 4);
        sectors[s].offset = length * directions[s];
    }
}

/// The corner that begins where `corner` ends, or null.
const Corner* after(const Corner& corner, std::span<const Corner> corners) {
    const auto found = std::find_if(corners.begin(), corners.end(),
                                    [&corner](const Corner& other) { return other.next == corner.previous; });
    return found == corners.end() ? nullptr : &*found;
}

bool isFirst(const Corner& corner, std::span<const Corner> corners) {
    return std::none_of(corners.begin(), corners.end(),
                        [&corner](const Corner& other) { return other.previous == corner.next; });
}

} // namespace

std::vector<Sector> sectorsAround(std::span<const Corner> corners, double gap) {
    std::vector<Sector> sectors;
    for (const Corner& first : corners) {
        if (!isFirst(first, corners))
            continue;
        Sector sector;
        for (const Corner* corner = &first; corner != nullptr; corner = after(*corner, corners))
            sector.corners.push_back(*corner);
        sectors.push_back(std::move(sector));
    }
    if (sectors.size() > 1)
        setApart(sectors, gap);
    return sectors;
}

} // namespace proveout
