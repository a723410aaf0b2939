// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/samples/height_map.h"

#include <algorithm>
#include <cmath>

namespace proveout::samples {

namespace {

struct DiscPoint {
    int di;
    int dj;
    double height; ///< of the ball above its tip
};

std::vector<DiscPoint> ballDisc(double radius, double step) {
    std::vector<DiscPoint> disc;
    const int reach = static_cast<int>(radius / step);
    for (int dj = -reach; dj <= reach; ++dj) {
        for (int di = -reach; di <= reach; ++di) {
            const double squared = step * step * (di * di + dj * dj);
            if (squared <= radius * radius)
                disc.push_back({di, dj, radius - std::sqrt(radius * radius - squared)});
        }
    }
    // Points near the tip decide nearly everywhere; with them first, the rest mostly fails one comparison.
    std::stable_sort(disc.begin(), disc.end(),
                     [](const DiscPoint& a, const DiscPoint& b) { return a.height < b.height; });
    return disc;
}

} // namespace

int HeightMap::columnAt(double px) const {
    return static_cast<int>(std::lround((px - x0) / step));
}

int HeightMap::rowAt(double py) const {
    return static_cast<int>(std::lround((py - y0) / step));
}

HeightMap sample(const Surface& surface, const Vec2& lo, const Vec2& hi, double step) {
    constexpr double kNanometresPerMm = 1e6;
    HeightMap map{lo.x, lo.y, step, 0, 0, {}};
    map.nx = map.columnAt(hi.x) + 1;
    map.ny = map.rowAt(hi.y) + 1;
    map.z.reserve(static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(map.ny));
    for (int j = 0; j < map.ny; ++j)
        for (int i = 0; i < map.nx; ++i)
            map.z.push_back(std::round(surface(map.x(i), map.y(j)) * kNanometresPerMm) / kNanometresPerMm);
    return map;
}

HeightMap dropBall(const HeightMap& surface, double radius) {
    const std::vector<DiscPoint> disc = ballDisc(radius, surface.step);
    const double highest = *std::max_element(surface.z.begin(), surface.z.end());
    HeightMap drop = surface;
    std::size_t index = 0;
    for (int j = 0; j < surface.ny; ++j) {
        for (int i = 0; i < surface.nx; ++i, ++index) {
            double tip = surface.at(i, j);
            for (const DiscPoint& point : disc) {
                if (highest - point.height <= tip)
                    break;
                const int pi = i + point.di;
                const int pj = j + point.dj;
                if (pi >= 0 && pj >= 0 && pi < surface.nx && pj < surface.ny)
                    tip = std::max(tip, surface.at(pi, pj) - point.height);
            }
            drop.z[index] = tip;
        }
    }
    return drop;
}

} // namespace proveout::samples
