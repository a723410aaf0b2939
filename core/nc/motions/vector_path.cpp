// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/vector_path.h"

#include <cmath>
#include <string>

#include "core/nc/motions/arc_words.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/radius_notice.h"

namespace proveout {

VectorPath::VectorPath(Execution& execution, const Word& word, const Motion& motion)
    : CompensatedMotion(execution, word, motion), m_rules(execution.dialect.vectors),
      m_held(execution.state.compensation.vectors) {}

void VectorPath::finishHeld() {
    finishSquare(m_execution);
}

Vec2 VectorPath::tip() const {
    return inPlane(tipAt(m_execution, m_execution.state.position), m_plane);
}

void VectorPath::moveTipTo(const Vec2& place) {
    m_compensation.displacement =
        withPlane(Vec3(0), place - inPlane(m_execution.state.position, m_plane), m_plane);
}

/// Axis words that do not move anything end the look-ahead.
void VectorPath::appendAcross() {
    Motion motion = m_motion;
    motion.start = tipAt(m_execution, m_motion.start);
    motion.end = withPlane(m_motion.end, inPlane(motion.start, m_plane), m_plane);
    append(motion, m_motion.end);
    arrive(m_execution.state, m_motion);
    if (m_motion.start == m_motion.end)
        finishHeld();
}

void VectorPath::enter() {
    if (!m_compensation.moves())
        return leave();
    if (m_programmed.arc())
        return refuse(nc_message::kCompensationStartArc);
    finishHeld();
    emit(tip());
    m_compensation.entry = true;
}

void VectorPath::leave() {
    if (m_compensation.held) {
        const CornerPoints points = kept(exitPoints());
        finish(points.first());
        moveThrough(points);
    }
    m_compensation.held = false;
    appendMotion(m_execution, m_motion);
}

CornerPoints VectorPath::exitPoints() const {
    if (m_held.exit == Vec2(0))
        return cancelPoints(m_held.programmed, m_programmed, m_held.offset, m_rules.typeB);
    const PlanePath way{m_programmed.start, m_programmed.start + m_held.exit, Vec2(0), 0};
    const auto meeting = crossing(m_held.programmed, m_held.offset, way, m_held.offset);
    CornerPoints points;
    points.add(meeting.value_or(m_compensation.path.end));
    return points;
}

void VectorPath::join() {
    if (!offsetPath(m_programmed, m_compensation.offset) ||
        (m_compensation.held && !offsetPath(m_programmed, m_held.offset))) {
        return refuseSmallArc();
    }
    if (m_compensation.held && changesSide() && !m_rules.crossesAtCorner)
        finishHeld();
    if (!m_compensation.held)
        return joinSquare();
    const auto points = corner();
    if (!points)
        return refuse(nc_message::kCompensationCorner, {shownLength(std::abs(m_held.offset))});
    const CornerPoints through = kept(*points);
    if (!finish(through.first()))
        return emit(tip());
    moveThrough(through);
    emit(through.last());
    m_held.cornered = through.all().size() > 1;
}

CornerPoints VectorPath::kept(const CornerPoints& points) const {
    return withoutSmallMoves(points, m_rules.smallMoveMm, m_programmed);
}

bool VectorPath::changesSide() const {
    return (m_held.offset > 0) != (m_compensation.offset > 0);
}

/// From the position of the tool, although the paths turn.
void VectorPath::joinSquare() {
    if (!goesStraightOn(m_held.programmed, m_programmed))
        report(nc_message::kCompensationSquare);
    emit(tip());
}

std::optional<CornerPoints> VectorPath::corner() {
    if (m_compensation.entry) {
        if (changesSide())
            report(nc_message::kCompensationSideApart);
        return startUpPoints(m_held.programmed, m_programmed, m_held.offset, m_rules.typeB);
    }
    if (!changesSide())
        return cornerPoints(m_held.programmed, m_programmed, m_held.offset);
    const auto meeting = crossing(m_held.programmed, m_held.offset, m_programmed, m_compensation.offset);
    if (!meeting)
        report(nc_message::kCompensationSideApart);
    CornerPoints points;
    points.add(
        meeting.value_or(beside(m_programmed.start, headingAtStart(m_programmed), m_compensation.offset)));
    return points;
}

/// Makes the previous motion final with this end, unless it would run backward. In that case it stays
/// unchanged.
bool VectorPath::finish(const Vec2& end) {
    m_compensation.held = false;
    const PlanePath& path = m_compensation.path;
    const Vec2& from = m_compensation.from;
    if (!m_compensation.entry && !changesSide() && goesBackward(path, from, end)) {
        const Motion motion = m_execution.program.motion(m_compensation.firstHeld);
        reportOfRadius(m_execution,
                       m_held.cornered ? nc_message::kCompensationErased : nc_message::kCompensationGouge,
                       m_word, {shownLength(std::abs(m_held.offset)), std::to_string(motion.line)});
        m_execution.program.settle();
        return false;
    }
    m_execution.program.moveEnds(m_compensation.firstHeld, m_execution.state.plane, end,
                                 path.arc() ? sweepWithin(path, from, end) : 0);
    m_execution.program.settle();
    moveTipTo(end);
    return true;
}

/// The corner belongs to the block after it.
void VectorPath::moveThrough(const CornerPoints& points) {
    for (const Vec2& point : points.all().subspan(1)) {
        Motion motion = m_motion;
        motion.kind = m_motion.kind == MotionKind::rapid ? MotionKind::rapid : MotionKind::feed;
        motion.start = tipAt(m_execution, m_motion.start);
        motion.end = withPlane(motion.start, point, m_plane);
        motion.endKnown = motion.startKnown;
        append(motion, m_motion.start);
        moveTipTo(point);
    }
}

void VectorPath::emit(const Vec2& from) {
    const PlanePath path = *offsetPath(m_programmed, m_compensation.offset);
    Motion motion = m_motion;
    motion.start = withPlane(m_motion.start, from, m_plane);
    motion.end = withPlane(m_motion.end, path.end, m_plane);
    if (path.arc()) {
        reportOffCircle(path, from);
        motion.sweep = sweepWithin(path, from, path.end);
    }
    if (motion.kind == MotionKind::arc && !fitForSize(m_execution, m_word, motion))
        return skipMotion(m_execution, m_motion);
    hold(path, from);
    m_held = {m_programmed, m_compensation.offset, false, true, 0, Vec2(0)};
    append(motion, m_motion.end);
    arrive(m_execution.state, m_motion);
    moveTipTo(path.end);
}

void VectorPath::reportOffCircle(const PlanePath& path, const Vec2& from) {
    const double off = std::abs(glm::distance(from, path.centre) - glm::distance(path.start, path.centre));
    if (off > m_rules.smallMoveMm)
        report(nc_message::kCompensationOffCircle, {shownLength(off)});
}

void finishSquare(Execution& execution) {
    execution.state.compensation.held = false;
    execution.program.settle();
}

} // namespace proveout
