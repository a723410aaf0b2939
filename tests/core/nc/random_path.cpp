// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/random_path.h"

#include <cmath>
#include <fmt/format.h>

#include "tests/core/nc/random_arc.h"

namespace proveout::test {

namespace {

bool chance(std::mt19937& random, double probability) {
    return uniform(random, 0, 1) < probability;
}

Vec2 turned(const Vec2& v, double angle) {
    return {v.x * std::cos(angle) - v.y * std::sin(angle), v.x * std::sin(angle) + v.y * std::cos(angle)};
}

PlanePath lineFrom(const Vec2& start, const Vec2& heading, double length) {
    return {start, start + heading * length, Vec2(0), 0};
}

PlanePath arcFrom(const Vec2& start, const Vec2& heading, double radius, double sweep) {
    const Vec2 left = turned(heading, std::acos(0.0));
    const Vec2 centre = start + left * std::copysign(radius, sweep);
    return {start, centre + turned(start - centre, sweep), centre, sweep};
}

} // namespace

std::vector<PlanePath> randomPath(std::mt19937& random, const RandomPathShape& shape) {
    std::vector<PlanePath> paths{
        lineFrom(Vec2(0), turned(Vec2(1, 0), uniform(random, -3, 3)), uniform(random, 4, shape.longest))};
    while (static_cast<int>(paths.size()) < shape.paths) {
        const PlanePath& last = paths.back();
        double turn = uniform(random, shape.flattestTurn, shape.sharpestTurn);
        turn = chance(random, 0.5) ? turn : -turn;
        const Vec2 heading = turned(headingAtEnd(last), chance(random, 0.15) ? 0 : turn);
        const double length = uniform(random, shape.shortest, shape.longest);
        const double sweep = uniform(random, 0.2, shape.longestSweep) * (chance(random, 0.5) ? 1 : -1);
        paths.push_back(rounded(
            shape.lines || chance(random, 0.5)
                ? lineFrom(last.end, heading, length)
                : arcFrom(last.end, heading, uniform(random, shape.smallestRadius, shape.longest), sweep)));
    }
    return paths;
}

PlanePath rounded(PlanePath path) {
    constexpr double kDecimals = 1e9;
    path.end = glm::round(path.end * kDecimals) / kDecimals;
    return path;
}

std::string wordsOf(const PlanePath& path) {
    const std::string end = fmt::format("X{:.9f} Y{:.9f}", path.end.x, path.end.y);
    if (!path.arc())
        return "G1 " + end;
    return fmt::format("{} {} I{:.9f} J{:.9f}", path.sweep > 0 ? "G3" : "G2", end,
                       path.centre.x - path.start.x, path.centre.y - path.start.y);
}

} // namespace proveout::test
