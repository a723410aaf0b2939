// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/coarse_points.h"

#include <algorithm>

namespace proveout {

namespace {

int countOf(int points, int step) {
    return (points - 2) / step + 2;
}

} // namespace

CoarsePoints CoarsePoints::of(const Grid& grid, int step) {
    return {step, {countOf(grid.nx, step), countOf(grid.ny, step)}};
}

CoarsePoints CoarsePoints::within(const Grid& grid, std::size_t bytes, int most) {
    constexpr int kCoarsest = 1 << 20;
    CoarsePoints points = of(grid, 2);
    while (points.step < kCoarsest &&
           (points.bytes() > bytes || std::max(points.count.x, points.count.y) > most))
        points = of(grid, 2 * points.step);
    return points;
}

std::size_t CoarsePoints::bytes() const {
    return sizeof(float) * static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y);
}

std::size_t coarseTriangles(const RegionGrid& regions, int step) {
    const auto cellsAlong = [&](int points) {
        const int whole = (points - 1) / regions.cells();
        const int rest = (points - 1) % regions.cells();
        const auto cells = [&](int width) { return static_cast<std::size_t>((width + step - 1) / step); };
        return static_cast<std::size_t>(whole) * cells(regions.cells()) + cells(rest);
    };
    return 2 * cellsAlong(regions.nx()) * cellsAlong(regions.ny());
}

int stepWithin(const RegionGrid& regions, std::size_t most) {
    int step = 1;
    while (step < regions.cells() && coarseTriangles(regions, step) > most)
        step *= 2;
    return step;
}

SampledPoints sampledPoints(int from, int to, int count, int step) {
    SampledPoints sampled{(from + step - 1) / step, {}};
    for (int point = sampled.first * step; point < std::min(to, count - 1); point += step)
        sampled.points.push_back(point);
    if (to == count) {
        if (sampled.points.empty())
            sampled.first = countOf(count, step) - 1;
        sampled.points.push_back(count - 1);
    }
    return sampled;
}

} // namespace proveout
