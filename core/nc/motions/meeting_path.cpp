// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/meeting_path.h"

#include <cmath>
#include <optional>
#include <string>

#include "core/nc/motions/arc_words.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/radius_notice.h"

namespace proveout {

double MeetingPath::radius() const {
    return std::abs(m_compensation.offset);
}

Vec2 MeetingPath::tip() const {
    return inPlane(m_execution.state.position + m_compensation.displacement, m_plane);
}

void MeetingPath::finishHeld() {
    finish(m_compensation.path.end, true);
}

/// Makes the previous motion final with this end. If it would run backward, the control may or may not
/// notice; if it does, the motion stays unchanged.
bool MeetingPath::finish(const Vec2& end, bool noticed) {
    if (!m_compensation.held)
        return true;
    m_compensation.held = false;
    const PlanePath& path = m_compensation.path;
    const Vec2 from = m_compensation.from;
    const bool shortened = from != path.start || end != path.end;
    const bool forward = !shortened || goesForward(path, from, end, sweepTolerance(m_execution.state.inch));
    const bool refused = !forward && noticed && !m_compensation.entry;
    if (!forward)
        reportGouge(refused ? nc_message::kCompensationGouge : nc_message::kCompensationBackward);
    if (!refused && end != path.end)
        m_execution.program.moveEnds(m_compensation.firstHeld, m_execution.state.plane, end,
                                     sweepBetween(path, from, end));
    m_execution.program.settle();
    return !refused;
}

void MeetingPath::reportGouge(const FindingRow& message) {
    const Motion motion = m_execution.program.motion(m_compensation.firstHeld);
    reportOfRadius(m_execution, message, m_word, {shownLength(radius()), std::to_string(motion.line)});
}

void MeetingPath::enter() {
    const double length = glm::distance(m_programmed.start, m_programmed.end);
    if (length <= radius())
        return refuse(nc_message::kCompensationEntryShort, {shownLength(length), shownLength(radius())});
    if (!offsetPath(m_programmed, m_compensation.offset))
        return refuseSmallArc();
    emit(entryPath(m_programmed, m_compensation.offset), m_programmed.start);
    m_compensation.entry = true;
}

void MeetingPath::appendAcross() {
    if (!m_compensation.entered)
        return enter();
    Motion motion = m_motion;
    motion.start += m_compensation.displacement;
    motion.end += m_compensation.displacement;
    append(motion, m_motion.end);
    arrive(m_execution.state, m_motion);
}

void MeetingPath::join() {
    const std::optional<PlanePath> path = offsetPath(m_programmed, m_compensation.offset);
    if (!path)
        return refuseSmallArc();
    const Corner corner =
        cornerBetween(m_compensation.path, m_compensation.heading, *path, m_compensation.offset);
    if (corner.kind == CornerKind::inside)
        return joinInside(*path);
    if (corner.kind == CornerKind::outside) {
        finish(m_compensation.path.end, !path->arc());
        appendCorner(path->start, corner.sweep);
        return emit(*path, path->start);
    }
    finish(m_compensation.path.end, false);
    emit(*path, tip());
}

void MeetingPath::joinInside(const PlanePath& path) {
    if (!m_compensation.held) {
        report(nc_message::kCompensationAfterStop);
        return emit(path, tip());
    }
    const auto meeting = meetingPoint(m_compensation.path, path, m_compensation.offset);
    if (!meeting)
        return refuse(nc_message::kCompensationCorner, {shownLength(radius())});
    emit(path, finish(*meeting, true) ? *meeting : tip());
}

/// A rapid motion does not roll around the corner but cuts it.
void MeetingPath::appendCorner(const Vec2& end, double sweep) {
    Motion motion = m_motion;
    motion.kind = m_motion.kind == MotionKind::rapid ? MotionKind::rapid : MotionKind::arc;
    motion.start = m_motion.start + m_compensation.displacement;
    motion.end = withPlane(motion.start, end, m_plane);
    motion.endKnown = motion.startKnown;
    motion.centre = m_motion.start;
    motion.sweep = sweep;
    append(motion, m_motion.start);
}

void MeetingPath::emit(const PlanePath& path, const Vec2& from) {
    Motion motion = m_motion;
    motion.start = withPlane(m_motion.start, from, m_plane) + m_execution.state.strayed;
    m_execution.state.strayed = Vec3(0);
    motion.end = withPlane(m_motion.end, path.end, m_plane);
    motion.centre = withPlane(m_motion.centre, path.centre, m_plane);
    motion.sweep = from == path.start ? path.sweep : sweepBetween(path, from, path.end);
    if (motion.kind == MotionKind::arc && !fitForSize(m_execution, m_word, motion))
        return skipMotion(m_execution, m_motion);
    m_execution.program.settle();
    hold(path, from);
    m_compensation.heading = headingAtEnd(m_programmed);
    m_compensation.displacement = motion.end - m_motion.end;
    append(motion, m_motion.end);
    arrive(m_execution.state, m_motion);
}

} // namespace proveout
