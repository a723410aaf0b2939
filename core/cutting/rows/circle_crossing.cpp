// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/rows/circle_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace proveout {

namespace {

/// The places, ascending, between which a line is all under the cutter or all beside it.
class Places {
public:
    explicit Places(double last) : m_last(last) {
        add(0);
        add(last);
    }

    void addCircle(const Vec2& centre, double radius) {
        const double square = radius * radius - centre.y * centre.y;
        if (square < 0)
            return;
        const double half = std::sqrt(square);
        add(centre.x - half);
        add(centre.x + half);
    }

    /// The start of the first interval whose middle is `under`; infinity if there is none up to `latest`.
    template<class Under>
    [[nodiscard]] double firstUnder(double latest, const Under& under) {
        std::sort(m_places.begin(), m_places.begin() + m_count);
        for (std::ptrdiff_t k = 0; k + 1 < m_count; ++k) {
            const double from = m_places[static_cast<std::size_t>(k)];
            const double to = m_places[static_cast<std::size_t>(k) + 1];
            if (from > latest)
                break;
            if (to > from && under((from + to) / 2))
                return from;
        }
        return std::numeric_limits<double>::infinity();
    }

private:
    void add(double place) {
        if (place >= 0 && place <= m_last)
            m_places[static_cast<std::size_t>(m_count++)] = place;
    }

    double m_last;
    std::array<double, 10> m_places{};
    std::ptrdiff_t m_count = 0;
};

} // namespace

Vec3 nearestPlace(const ArcPath& path, const Vec2& point) {
    const Vec2 to = point - Vec2(path.centre);
    constexpr double kCircle = 2 * std::numbers::pi;
    const double turn = kCircle / std::abs(path.sweep);
    const double turned =
        std::remainder(std::atan2(to.y, to.x) - path.angle - path.sweep * path.begin, kCircle) / path.sweep;
    const double first = path.begin + (turned < 0 ? turned + turn : turned);
    if (first <= path.end)
        return path.at(path.climb < 0 ? first + turn * std::floor((path.end - first) / turn) : first);
    const Vec3 start = path.at(path.begin);
    const Vec3 end = path.at(path.end);
    return glm::distance(point, Vec2(start)) < glm::distance(point, Vec2(end)) ? start : end;
}

CircleEntry entryUnderCircle(const ConvexProfile& profile, const ArcPath& path, const EdgeLine& line,
                             double beyond, double latest) {
    const double rim = profile.rim;
    const double last = line.length + beyond;
    const Vec2 centre = line.seen(Vec2(path.centre) - line.from);
    const double nearest = glm::length(centre - Vec2(std::clamp(centre.x, 0.0, last), 0));
    const double farthest = std::max(glm::length(centre), glm::length(centre - Vec2(last, 0)));
    if (nearest > path.radius + rim || farthest < path.radius - rim)
        return {};
    Places places(last);
    places.addCircle(centre, path.radius + rim);
    places.addCircle(centre, path.radius - rim);
    for (const double end : {path.begin, path.end})
        places.addCircle(line.seen(Vec2(path.at(end)) - line.from), rim);
    CircleEntry entry;
    entry.crossing.place =
        places.firstUnder(latest, [&](double place) { return path.distanceToCircle(line.at(place)) <= rim; });
    if (!entry.crossing.found())
        return {};
    const Vec2 point = line.at(entry.crossing.place);
    const Vec3 tip = nearestPlace(path, point);
    const Vec2 away = point - Vec2(tip);
    const double distance = glm::length(away);
    entry.crossing.outwards = distance > 0 ? away / distance : -line.along;
    entry.height = tip.z + profile.height(std::min(distance, rim));
    return entry;
}

} // namespace proveout
