// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/random_arc.h"

#include <cmath>
#include <numbers>

namespace proveout::test {

double uniform(std::mt19937& random, double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
}

Motion randomArc(std::mt19937& random, double growth) {
    Motion motion;
    motion.kind = MotionKind::arc;
    motion.plane = static_cast<Plane>(random() % 3);
    const PlaneAxes plane = axes(motion.plane);
    motion.startKnown = motion.endKnown = kAllAxes;
    for (int axis = 0; axis < 3; ++axis)
        motion.centre[axis] = uniform(random, -100, 100);
    const double radius = std::exp(uniform(random, -2, 5));
    const double endRadius = radius * (1 + uniform(random, -growth, growth));
    const double angle = uniform(random, -4, 4);
    const double turns = random() % 4 == 0 ? 3 : 1;
    motion.sweep = uniform(random, 1e-3, turns * 2 * std::numbers::pi) * (random() % 2 == 0 ? 1 : -1);
    motion.start = motion.end = motion.centre;
    motion.start[plane.first] += radius * std::cos(angle);
    motion.start[plane.second] += radius * std::sin(angle);
    motion.end[plane.first] += endRadius * std::cos(angle + motion.sweep);
    motion.end[plane.second] += endRadius * std::sin(angle + motion.sweep);
    motion.end[plane.normal] += random() % 2 == 0 ? uniform(random, -20, 20) : 0;
    return motion;
}

} // namespace proveout::test
