// SPDX-License-Identifier: GPL-3.0-or-later
// Splines: G5, G5.1 and the NURBS block G5.2 to G5.3, as short straight motions.
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

#include "core/nc/codes/handlers.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/motion_target.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

constexpr LetterSet kPlaneWords("XY@^");

bool refuse(Execution& execution, const FindingRow& message, const Word& word,
            std::vector<Argument> arguments = {}) {
    execution.reporter.report(message, word, std::move(arguments));
    return false;
}

bool needs(Execution& execution, const Word& word, const char* letters) {
    for (const char* letter = letters; *letter != '\0'; ++letter) {
        if (!execution.block.has(*letter))
            return refuse(execution, nc_message::kWordMissing, word, {nameOf(word), {*letter}});
    }
    return true;
}

bool planeFits(Execution& execution, const Word& word) {
    return execution.state.plane == Plane::xy ||
           refuse(execution, nc_message::kSplinePlane, word, {nameOf(word)});
}

Vec2 inPlane(const Vec3& point) {
    return {point.x, point.y};
}

Vec2 lengths(const Execution& execution, char first, char second) {
    return {execution.length(first), execution.length(second)};
}

/// A spline keeps its level to the last bit.
Vec3 atLevel(Vec3 point, double z) {
    point.z = z;
    return point;
}

/// Appends the straight motions of a spline; `motion` has its start and end.
void appendSpline(Execution& execution, const Word& word, const Motion& motion, const Spline& spline) {
    MachineState& state = execution.state;
    const auto points = flattened(spline, kChordError);
    if (!points) {
        refuse(execution, nc_message::kSplineTooLong, word, {fmt::format("{}", kMostSplinePoints)});
        arrive(state, motion);
        return;
    }
    const double level = state.frame.toProgram(motion.start).z;
    std::vector<Vec3> ends;
    for (const Vec2& point : *points)
        ends.push_back(atLevel(state.frame.toMachine({point, level}), motion.end.z));
    ends.back() = motion.end;
    appendPieces(execution, motion, ends);
}

/// A control point of a spline to the target of the block, relative to its start or its end.
struct Handle {
    Vec2 offset;
    bool ofEnd = false;
};
void appendBezier(Execution& execution, const Word& word, const std::vector<Handle>& handles) {
    const Motion motion = motionToTarget(execution, MotionKind::feed);
    reportMissingFeed(execution, word);
    reportUnknownStart(execution, motion, word);
    if (!planeKnown(motion)) {
        appendMotion(execution, motion);
        return;
    }
    const Vec2 start = inPlane(execution.state.frame.toProgram(motion.start));
    const Vec2 end = inPlane(execution.state.frame.toProgram(motion.end));
    Spline spline;
    spline.points.push_back({start});
    for (const Handle& handle : handles)
        spline.points.push_back({(handle.ofEnd ? end : start) + handle.offset});
    spline.points.push_back({end});
    spline.order = static_cast<int>(spline.points.size());
    appendSpline(execution, word, motion, spline);
}

/// A spline that cannot be computed still ends at its target, for the next motion.
void skip(Execution& execution) {
    arrive(execution.state, motionToTarget(execution, MotionKind::feed));
}

bool mayBegin(Execution& execution, const Word& word) {
    // Unlike other motions, a spline does not change the motion code in force.
    execution.state.motion = execution.motionBefore;
    if (!execution.block.letters().any(kPlaneWords))
        return refuse(execution, nc_message::kWordMissing, word, {nameOf(word), "X / Y"});
    return planeFits(execution, word);
}

} // namespace

void followCubic(Execution& execution, const Word& word) {
    const Block& block = execution.block;
    SplineState& splines = execution.splines;
    const bool first = block.letters().any(LetterSet("IJ"));
    const bool handleKnown = splines.handleAt == execution.program.motionCount();
    const bool fits = mayBegin(execution, word) && needs(execution, word, "PQ") &&
                      (!first || needs(execution, word, "IJ")) &&
                      (first || handleKnown || refuse(execution, nc_message::kSplineHandle, word));
    if (!fits) {
        skip(execution);
        return;
    }
    const Vec2 begin = first ? lengths(execution, 'I', 'J') : splines.handle;
    const Vec2 end = lengths(execution, 'P', 'Q');
    appendBezier(execution, word, {{begin}, {end, true}});
    splines.handle = -end;
    splines.handleAt = execution.program.motionCount();
}

void followQuadratic(Execution& execution, const Word& word) {
    if (mayBegin(execution, word) && needs(execution, word, "IJ"))
        appendBezier(execution, word, {{lengths(execution, 'I', 'J')}});
    else
        skip(execution);
}

namespace {

bool isNurbs(const CodeRow* row) {
    return row != nullptr && row->handler == addNurbsPoint;
}

bool pointFits(Execution& execution, const Word& word) {
    const Block& block = execution.block;
    const bool named = block.letters().any(kPlaneWords);
    const bool polar = block.letters().any(LetterSet("@^"));
    if (!planeFits(execution, word))
        return false;
    if (block.has('X') != block.has('Y') && !polar)
        return refuse(execution, nc_message::kNurbsAxes, word);
    if (!named && block.has('P') && !execution.splines.nurbs.points.empty())
        return refuse(execution, nc_message::kNurbsWeightAlone, block.word('P'));
    if ((named && !block.has('P')) || (block.has('P') && block.value('P') <= 0))
        return refuse(execution, nc_message::kNurbsWeight, block.has('P') ? block.word('P') : word);
    return true;
}

void readOrder(Execution& execution, Spline& nurbs) {
    if (!execution.block.has('L'))
        return;
    const Word& order = execution.block.word('L');
    if (order.value != std::round(order.value) || order.value < 0 || order.value > kMostSplineOrder) {
        refuse(execution, nc_message::kNotInteger, order,
               {"L", std::to_string(kLeastSplineOrder), std::to_string(kMostSplineOrder)});
    } else if (order.value > kLeastSplineOrder) {
        nurbs.order = static_cast<int>(order.value);
    }
}

} // namespace

void addNurbsPoint(Execution& execution, const Word& word) {
    const Block& block = execution.block;
    Spline& nurbs = execution.splines.nurbs;
    if (!isNurbs(execution.motionBefore)) {
        if (!nurbs.points.empty())
            execution.reporter.report(nc_message::kNurbsOpen, word);
        nurbs = {};
    }
    if (!pointFits(execution, word))
        return;
    if (execution.state.feedMode == FeedMode::perMinute)
        reportMissingFeed(execution, word);
    const bool named = block.letters().any(kPlaneWords);
    const WorkFrame& frame = execution.state.frame;
    if (nurbs.points.empty()) {
        const double weight = !named && block.has('P') ? block.value('P') : 1;
        nurbs.points.push_back({inPlane(frame.toProgram(execution.state.position)), weight});
    }
    readOrder(execution, nurbs);
    if (!named)
        return;
    const Motion motion = motionToTarget(execution, MotionKind::feed);
    nurbs.points.push_back({inPlane(frame.toProgram(motion.end)), block.value('P')});
    execution.splines.nurbsEnd = motion.end;
    execution.splines.nurbsEndKnown = motion.endKnown;
}

namespace {

/// LinuxCNC has G5.3 also in the group of the non-modal codes.
void reportNonModal(Execution& execution, const Word& end) {
    for (const Word& word : execution.block.codes()) {
        const CodeRow* row = execution.codes.find(word);
        if (row != nullptr && row->group == ModalGroup::nonModal)
            refuse(execution, nc_message::kModalConflict, word, {nameOf(end), nameOf(word)});
    }
}

} // namespace

void followNurbs(Execution& execution, const Word& word) {
    execution.state.motion = nullptr;
    reportNonModal(execution, word);
    if (!isNurbs(execution.motionBefore)) {
        refuse(execution, nc_message::kNurbsNotOpen, word);
        return;
    }
    const Spline nurbs = std::exchange(execution.splines.nurbs, {});
    Motion motion = motionFromHere(execution, MotionKind::feed);
    motion.end = execution.splines.nurbsEnd;
    motion.endKnown = execution.splines.nurbsEndKnown;
    if (nurbs.points.size() < static_cast<std::size_t>(nurbs.order)) {
        refuse(execution, nc_message::kNurbsPoints, word,
               {std::to_string(nurbs.points.size()), std::to_string(nurbs.order)});
        if (nurbs.points.size() > 1)
            arrive(execution.state, motion);
        return;
    }
    reportMissingFeed(execution, word);
    reportUnknownStart(execution, motion, word);
    if (planeKnown(motion))
        appendSpline(execution, word, motion, nurbs);
    else
        appendMotion(execution, motion);
}

} // namespace proveout
