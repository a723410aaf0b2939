// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/arc_words.h"
#include "core/nc/handlers.h"
#include "core/nc/motion_building.h"
#include "core/nc/turned_arc.h"

namespace proveout {

namespace {

void moveArc(Execution& execution, const Word& word, bool clockwise) {
    Motion motion = motionToTarget(execution, MotionKind::arc);
    tellMissingFeed(execution, word);
    tellUnknownStart(execution, motion, word);
    if (execution.state.compensation.leaving()) {
        execution.reporter.tell(nc_message::kCompensationExitArc, word);
        arrive(execution.state, motion);
        return;
    }
    const bool turned = turnsPlane(execution.state.frame, motion.plane);
    if (turned ? !motion.known() : !planeKnown(motion)) {
        // There is no centre to count from: what is left is where it goes.
        motion.kind = MotionKind::feed;
    } else if (turned) {
        if (!appendTurnedArc(execution, word, motion, clockwise))
            arrive(execution.state, motion);
        return;
    } else if (!shapeArc(execution, word, motion, clockwise)) {
        // Its end is known all the same, and what follows starts there.
        arrive(execution.state, motion);
        return;
    }
    appendOrdered(execution, word, motion);
}

} // namespace

void moveRapid(Execution& execution, const Word& word) {
    if (!onlySelectsMode(execution))
        appendOrdered(execution, word, motionToTarget(execution, MotionKind::rapid));
}

void moveFeed(Execution& execution, const Word& word) {
    if (onlySelectsMode(execution))
        return;
    const Motion motion = motionToTarget(execution, MotionKind::feed);
    tellMissingFeed(execution, word);
    tellUnknownStart(execution, motion, word);
    appendOrdered(execution, word, motion);
}

void moveArcClockwise(Execution& execution, const Word& word) {
    moveArc(execution, word, true);
}

void moveArcCounterClockwise(Execution& execution, const Word& word) {
    moveArc(execution, word, false);
}

} // namespace proveout
