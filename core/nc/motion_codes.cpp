// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/arc_words.h"
#include "core/nc/handlers.h"
#include "core/nc/motion_building.h"

namespace proveout {

namespace {

bool planeKnown(const Motion& motion) {
    const PlaneAxes plane = axes(motion.plane);
    const auto needed = static_cast<std::uint8_t>((1U << static_cast<unsigned>(plane.first)) |
                                                  (1U << static_cast<unsigned>(plane.second)));
    return (motion.startKnown & motion.endKnown & needed) == needed;
}

void moveArc(Execution& execution, const Word& word, bool clockwise) {
    Motion motion = motionToTarget(execution, MotionKind::arc);
    tellMissingFeed(execution, word);
    tellUnknownStart(execution, motion, word);
    if (!planeKnown(motion)) {
        // There is no centre to count from: what is left is where it goes.
        motion.kind = MotionKind::feed;
    } else if (!shapeArc(execution, word, motion, clockwise)) {
        // Its end is known all the same, and what follows starts there.
        arrive(execution.state, motion);
        return;
    }
    appendMotion(execution, motion);
}

} // namespace

void moveRapid(Execution& execution, const Word& /*word*/) {
    if (!onlySelectsMode(execution))
        appendMotion(execution, motionToTarget(execution, MotionKind::rapid));
}

void moveFeed(Execution& execution, const Word& word) {
    if (onlySelectsMode(execution))
        return;
    const Motion motion = motionToTarget(execution, MotionKind::feed);
    tellMissingFeed(execution, word);
    tellUnknownStart(execution, motion, word);
    appendMotion(execution, motion);
}

void moveArcClockwise(Execution& execution, const Word& word) {
    moveArc(execution, word, true);
}

void moveArcCounterClockwise(Execution& execution, const Word& word) {
    moveArc(execution, word, false);
}

} // namespace proveout
