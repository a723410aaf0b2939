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

void addMotion(FeedBlock& block, const Motion& motion) {
    if (motion.probing || !motion.known())
        return;
    block.lowest = std::min(block.lowest, bounds(motion).lo.z);
    if (motion.kind == MotionKind::rapid)
        return;
    const double length = pathLength(motion);
    block.feed = std::max(block.feed, motion.feedMmPerMin);
    block.rpm = std::max(block.rpm, std::abs(motion.spindleRpm));
    block.length += length;
    if (motion.feedMmPerMin > 0)
        block.minutes += length / motion.feedMmPerMin;
    block.steepest = std::max(block.steepest, angleDown(motion));
    block.sideways = block.sideways || movesInPlan(motion);
}

} // namespace proveout
