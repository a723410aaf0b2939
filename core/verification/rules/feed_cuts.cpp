// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/rules/feed_cuts.h"

#include <numbers>
#include <string_view>

#include "core/cutter/shapes.h"

namespace proveout {

double angleDown(const Motion& motion) {
    const double down = motion.start.z - motion.end.z;
    const double length = pathLength(motion);
    const double inPlan = std::sqrt(std::max(0.0, length * length - down * down));
    return std::atan2(down, inPlan > kSideways ? inPlan : 0) * 180 / std::numbers::pi;
}

bool isTap(const Cutter* cutter) {
    const CutterShape* shape = cutter == nullptr ? nullptr : shapeOf(cutter->spec());
    return shape != nullptr && std::string_view(shape->key) == "tap";
}

void addMotion(FeedCut& cut, const Motion& motion) {
    if (motion.kind == MotionKind::rapid || motion.probing || !motion.known())
        return;
    const double length = pathLength(motion);
    cut.feed = std::max(cut.feed, motion.feedMmPerMin);
    cut.rpm = std::max(cut.rpm, std::abs(motion.spindleRpm));
    cut.length += length;
    if (motion.feedMmPerMin > 0)
        cut.minutes += length / motion.feedMmPerMin;
    cut.steepest = std::max(cut.steepest, angleDown(motion));
    cut.sideways = cut.sideways || movesInPlan(motion);
}

} // namespace proveout
