// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/records/reached_place.h"

#include <algorithm>

namespace proveout {

namespace {

/// Whether a motion may reach a place over ground with a cutter of that radius.
bool passesNear(const Motion& motion, double radius, const Vec2& place) {
    if (motion.kind == MotionKind::arc)
        return glm::distance(Vec2(motion.centre), place) <=
               radius + std::max(glm::distance(motion.centre, motion.start),
                                 glm::distance(motion.centre, motion.end));
    const auto within = [&](int axis) {
        const auto [lo, hi] = std::minmax(motion.start[axis], motion.end[axis]);
        return place[axis] >= lo - radius && place[axis] <= hi + radius;
    };
    return within(0) && within(1);
}

} // namespace

bool reaches(const CutterMotion& one, const Vec3& place) {
    return one.cutter != nullptr && passesNear(one.motion, one.cutter->radius(), Vec2(place)) &&
           envelope(*one.cutter, one.motion, place.x, place.y) <= place.z + kOnSurface;
}

} // namespace proveout
