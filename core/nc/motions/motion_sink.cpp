// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/motion_sink.h"

#include <algorithm>
#include <cmath>

namespace proveout {

std::string namesOfAxes(std::uint8_t axes) {
    std::string names;
    for (int axis = 0; axis < 3; ++axis) {
        if ((axes & axisBit(axis)) == 0)
            continue;
        names += names.empty() ? "" : ", ";
        names += letterOfAxis(axis);
    }
    return names;
}

Vec3 tipAt(const Execution& execution, const Vec3& programmed) {
    const Vec3 displacement = execution.state.compensation.displacement + execution.state.strayed;
    if (displacement == Vec3(0))
        return programmed;
    constexpr double kRounding = 1e-9; ///< left by adding and subtracting the displacement
    const Vec3 tip = programmed + displacement;
    const std::size_t count = execution.program.motionCount();
    if (count == 0)
        return tip;
    const Vec3 last = execution.program.endOf(count - 1);
    return glm::distance(tip, last) < kRounding ? last : tip;
}

void continueFromTip(Execution& execution) {
    MachineState& state = execution.state;
    state.position = tipAt(execution, state.position);
    state.compensation.displacement = state.strayed = Vec3(0);
}

bool planeKnown(const Motion& motion) {
    const PlaneAxes plane = axes(motion.plane);
    const auto needed = static_cast<std::uint8_t>(axisBit(plane.first) | axisBit(plane.second));
    return (motion.startKnown & motion.endKnown & needed) == needed;
}

void forgetUnplaced(const Execution& execution, Motion& motion) {
    if (!execution.machineCoordinates)
        motion.endKnown &= static_cast<std::uint8_t>(~execution.state.frame.transformation.unplacedAxes());
}

void arrive(MachineState& state, const Motion& motion) {
    state.position = motion.end;
    state.known = motion.endKnown;
    state.zAtReference = motion.endAtReference;
    state.everKnown |= motion.endKnown;
    state.unknownReported &= static_cast<std::uint8_t>(~state.known);
}

void restartCompensation(CutterCompensation& compensation) {
    compensation.held = compensation.entered = false;
    compensation.displacement = Vec3(0);
}

void skipMotion(Execution& execution, const Motion& motion) {
    restartCompensation(execution.state.compensation);
    arrive(execution.state, motion);
}

namespace {

/// The feed of G93 for a path with this length in mm.
double inverseTimeFeed(const Execution& execution, double length) {
    const MachineState& state = execution.state;
    if (!execution.block.has('F'))
        return 0;
    return std::max(state.feed * length, state.toMm(execution.dialect.leastInverseFeed));
}

} // namespace

void setInverseTimeFeed(const Execution& execution, Motion& motion) {
    if (motion.kind != MotionKind::rapid && execution.state.feedMode == FeedMode::inverseTime)
        motion.feedMmPerMin = inverseTimeFeed(execution, pathLength(motion));
}

void appendMotion(Execution& execution, Motion motion) {
    const Vec3 ahead =
        execution.dialect.inverseTimeAsProgrammed ? Vec3(0) : execution.state.compensation.displacement;
    motion.start += ahead;
    setInverseTimeFeed(execution, motion);
    motion.start -= ahead;
    appendWithFeed(execution, motion);
}

namespace {

/// Scaling and repetition can make numbers larger than any that a text may contain. The position of an axis
/// that far away becomes unknown, so that later values are computed from positions in range.
void forgetTooFar(Execution& execution, Motion& motion) {
    constexpr double kFarthest = 1e14; ///< mm; squares of it, and sums of them, are far from overflowing
    std::uint8_t beyond = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(motion.end[axis]) <= kFarthest)
            continue;
        beyond |= axisBit(axis);
        motion.end[axis] = motion.start[axis];
    }
    if (beyond == 0)
        return;
    motion.endKnown &= static_cast<std::uint8_t>(~static_cast<unsigned>(beyond));
    if (motion.kind == MotionKind::arc)
        motion.kind = MotionKind::feed;
    execution.reporter.report(nc_message::kTargetTooFar, 1, 0, {"1e14", namesOfAxes(beyond)});
}

} // namespace

void appendWithFeed(Execution& execution, Motion motion) {
    motion.start = tipAt(execution, motion.start);
    execution.state.compensation.displacement = execution.state.strayed = Vec3(0);
    forgetTooFar(execution, motion);
    motion.unverified = execution.reporter.unverified();
    forgetUnplaced(execution, motion);
    execution.program.append(motion);
    arrive(execution.state, motion);
}

void appendPieces(Execution& execution, const Motion& whole, const std::vector<Vec3>& ends) {
    const MachineState& state = execution.state;
    Motion piece = whole;
    piece.kind = MotionKind::feed;
    if (state.feedMode == FeedMode::inverseTime) {
        double length = 0;
        Vec3 last = whole.start;
        for (const Vec3& end : ends) {
            length += glm::distance(last, end);
            last = end;
        }
        piece.feedMmPerMin = inverseTimeFeed(execution, length);
    }
    for (const Vec3& end : ends) {
        piece.start = state.position;
        piece.end = end;
        appendWithFeed(execution, piece);
        piece.startKnown = whole.endKnown;
        if (execution.mustEnd())
            return;
    }
}

} // namespace proveout
