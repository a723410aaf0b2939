// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/nc/codes/handlers.h"
#include "core/nc/motions/arc_words.h"
#include "core/nc/motions/corner_insertion.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/motion_target.h"
#include "core/nc/motions/turned_arc.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

constexpr LetterSet kCentreOrRadius("IJKR");

/// Whether an arc with R ends where it begins.
bool endsWhereItBegins(const Motion& motion, double samePoint) {
    const PlaneAxes plane = axes(motion.plane);
    const Vec3 way = motion.end - motion.start;
    return std::abs(way[plane.normal]) <= samePoint &&
           std::hypot(way[plane.first], way[plane.second]) <= samePoint;
}

/// Fanuc's interpretation of words that do not make an arc for LinuxCNC. False if nothing moves.
bool convertAsFanuc(Execution& execution, const Word& word, Motion& motion) {
    const Block& block = execution.block;
    if (!block.letters().any(kCentreOrRadius)) {
        execution.reporter.report(nc_message::kArcStraight, word);
        motion.kind = MotionKind::feed;
    } else if (block.has('R')) {
        if (endsWhereItBegins(motion, execution.leastLength() / 2)) {
            execution.reporter.report(nc_message::kArcStays, block.word('R'));
            return false;
        }
        if (block.letters().any(LetterSet("IJK")))
            execution.reporter.report(nc_message::kArcRadiusCounts, block.word('R'));
    }
    return true;
}

void moveArc(Execution& execution, const Word& word, bool clockwise) {
    const bool fanuc = execution.dialect.radiusWins;
    if (fanuc && onlySelectsMode(execution) && !execution.block.letters().any(kCentreOrRadius))
        return;
    Motion motion = motionToTarget(execution, MotionKind::arc);
    if (execution.state.polar.on && execution.dialect.polarAboutTool)
        execution.reporter.report(nc_message::kPolarArc, word, {clockwise ? "G2" : "G3"});
    reportMissingFeed(execution, word);
    reportUnknownStart(execution, motion, word);
    const bool leaving = execution.state.compensation.leaving();
    if (execution.dialect.straightFirst ? execution.state.straightDue : leaving) {
        execution.reporter.report(nc_message::kCompensationExitArc, word);
        skipMotion(execution, motion);
        return;
    }
    if (leaving || execution.state.strayed != Vec3(0)) {
        execution.reporter.report(nc_message::kArcFromElsewhere, word);
        skipMotion(execution, motion);
        return;
    }
    const bool turned = turnsPlane(execution.state.frame, motion.plane);
    if (turned ? !motion.known() : !planeKnown(motion)) {
        // There is no centre to refer to, so only the end point can be used.
        motion.kind = MotionKind::feed;
    } else if (fanuc && !convertAsFanuc(execution, word, motion)) {
        return;
    } else if (motion.kind == MotionKind::arc && turned) {
        if (!appendTurnedArc(execution, word, motion, clockwise))
            skipMotion(execution, motion);
        return;
    } else if (motion.kind == MotionKind::arc && !shapeArc(execution, word, motion, clockwise)) {
        skipMotion(execution, motion);
        return;
    }
    appendWithCorner(execution, word, motion);
}

} // namespace

void moveRapid(Execution& execution, const Word& word) {
    if (onlySelectsMode(execution))
        return;
    execution.state.straightDue = false;
    appendWithCorner(execution, word, motionToTarget(execution, MotionKind::rapid));
}

void moveFeed(Execution& execution, const Word& word) {
    if (onlySelectsMode(execution))
        return;
    execution.state.straightDue = false;
    const Motion motion = motionToTarget(execution, MotionKind::feed);
    reportMissingFeed(execution, word);
    reportUnknownStart(execution, motion, word);
    appendWithCorner(execution, word, motion);
}

void moveArcClockwise(Execution& execution, const Word& word) {
    moveArc(execution, word, true);
}

void moveArcCounterClockwise(Execution& execution, const Word& word) {
    moveArc(execution, word, false);
}

} // namespace proveout
