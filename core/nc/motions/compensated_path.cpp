// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/compensated_path.h"

#include "core/nc/motions/arc_words.h"
#include "core/nc/motions/meeting_path.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/motion_target.h"
#include "core/nc/motions/vector_path.h"

namespace proveout {

namespace {

/// Look-ahead blocks that are motions: the one before a corner and the one after it.
constexpr int kBlocksOfCorner = 2;

/// Calls `step` with a compensated motion of the kind that the control uses.
template<class Step>
void withPath(Execution& execution, const Word& word, const Motion& motion, Step step) {
    if (execution.dialect.vectors.used) {
        VectorPath path(execution, word, motion);
        step(path);
    } else {
        MeetingPath path(execution, word, motion);
        step(path);
    }
}

void appendCompensated(Execution& execution, const Word& word, const Motion& motion) {
    if (execution.machineCoordinates) {
        execution.reporter.report(nc_message::kCompensationForbids, word, {"G53"});
        return;
    }
    // Inverse time applies to the programmed length, not to that of the offset path.
    Motion programmed = motion;
    setInverseTimeFeed(execution, programmed);
    withPath(execution, word, programmed, [](CompensatedMotion& path) { path.append(); });
}

} // namespace

void appendOrdered(Execution& execution, const Word& word, const Motion& motion) {
    const CutterCompensation& compensation = execution.state.compensation;
    if (compensation.moves() || (execution.dialect.vectors.used && compensation.leaving()))
        appendCompensated(execution, word, motion);
    else
        appendMotion(execution, motion);
}

void finishCompensated(Execution& execution, const Word& word) {
    withPath(execution, word, motionFromHere(execution, MotionKind::feed),
             [](CompensatedMotion& path) { path.finishHeld(); });
}

void shortenHeld(Execution& execution, const PlanePath& programmed) {
    CutterCompensation& compensation = execution.state.compensation;
    compensation.vectors.programmed = programmed;
    compensation.path = *offsetPath(programmed, compensation.vectors.offset);
    const Vec2& end = compensation.path.end;
    const double sweep = programmed.arc() ? sweepWithin(compensation.path, compensation.from, end) : 0;
    execution.program.moveEnds(compensation.firstHeld, execution.state.plane, end, sweep);
    const PlaneAxes plane = axes(execution.state.plane);
    compensation.displacement = withPlane(Vec3(0), end - inPlane(execution.state.position, plane), plane);
}

void countBlock(Execution& execution) {
    CutterCompensation& compensation = execution.state.compensation;
    VectorState& state = compensation.vectors;
    const bool moved = state.seen;
    state.seen = false;
    // A call does not count as a block of the look-ahead: the control continues reading at its target.
    if (!compensation.held || moved || execution.request.kind != FlowRequest::Kind::none)
        return;
    if (!compensation.moves() ||
        ++state.blocksWithout > execution.dialect.vectors.readAhead - kBlocksOfCorner)
        finishSquare(execution);
}

} // namespace proveout
