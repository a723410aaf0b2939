// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/compensated_path.h"

#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>

#include "core/base/figures_argument.h"
#include "core/nc/motions/arc_words.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/motion_target.h"
#include "core/nc/motions/radius_notice.h"
#include "core/nc/motions/vector_path.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

Argument shown(double length) {
    return figures("{:.6g}", length);
}

/// One programmed motion that is to be compensated.
class Joining {
public:
    Joining(Execution& execution, const Word& word, const Motion& motion)
        : m_execution(execution), m_compensation(execution.state.compensation), m_word(word),
          m_motion(motion),
          m_plane(axes(execution.state.plane)), m_programmed{inPlane(motion.start, m_plane),
                                                             inPlane(motion.end, m_plane),
                                                             inPlane(motion.centre, m_plane), motion.sweep} {}

    void append() {
        if (!planeKnown(m_motion))
            appendUnknown();
        else if (!m_compensation.entered)
            enter();
        else if (!m_programmed.arc() && glm::distance(m_programmed.start, m_programmed.end) < kNoLength)
            appendAcross();
        else
            join();
    }

    /// The motion before is final with this end. Where it would go backward, the control notices that or not;
    /// if it does, the motion stays as it was.
    bool finish(const Vec2& end, bool noticed) {
        if (!m_compensation.held)
            return true;
        m_compensation.held = false;
        const PlanePath& path = m_compensation.path;
        const Vec2 from = m_compensation.from;
        const bool shortened = from != path.start || end != path.end;
        const bool forward =
            !shortened || goesForward(path, from, end, sweepTolerance(m_execution.state.inch));
        const bool refused = !forward && noticed && !m_compensation.entry;
        if (!forward)
            tellGouge(refused ? nc_message::kCompensationGouge : nc_message::kCompensationBackward);
        if (!refused && end != path.end)
            m_execution.program.moveEnds(m_compensation.firstHeld, m_execution.state.plane, end,
                                         sweepBetween(path, from, end));
        m_execution.program.settle();
        return !refused;
    }

private:
    void tell(const FindingRow& message, std::vector<Argument> arguments = {}) {
        m_execution.reporter.tell(message, m_word, std::move(arguments));
    }

    void tellGouge(const FindingRow& message) {
        const Motion motion = m_execution.program.motion(m_compensation.firstHeld);
        tellOfRadius(m_execution, message, m_word, {shown(radius()), std::to_string(motion.line)});
    }

    [[nodiscard]] double radius() const { return std::abs(m_compensation.offset); }
    [[nodiscard]] Vec2 tip() const {
        return inPlane(m_execution.state.position + m_compensation.displacement, m_plane);
    }

    void appendUnknown() {
        if (!m_compensation.unknownTold)
            tell(nc_message::kCompensationUnknownStart);
        m_compensation.unknownTold = true;
        m_compensation.beginAnew();
        appendMotion(m_execution, m_motion);
    }

    void refuse(const FindingRow& message, std::vector<Argument> arguments) {
        tellOfRadius(m_execution, message, m_word, std::move(arguments));
        leaveOut(m_execution, m_motion);
    }

    void enter() {
        const double length = glm::distance(m_programmed.start, m_programmed.end);
        if (length <= radius())
            return refuse(nc_message::kCompensationEntryShort, {shown(length), shown(radius())});
        if (!offsetPath(m_programmed, m_compensation.offset))
            return refuseSmallArc();
        const PlanePath path = entryPath(m_programmed, m_compensation.offset);
        emit(path, m_programmed.start);
        m_compensation.entry = true;
    }

    void refuseSmallArc() {
        refuse(nc_message::kCompensationArcSmall,
               {shown(glm::distance(m_programmed.end, m_programmed.centre)), shown(radius())});
    }

    /// Along the normal of the plane, or nowhere: the tip stays beside the same point.
    void appendAcross() {
        Motion motion = m_motion;
        motion.start += m_compensation.displacement;
        motion.end += m_compensation.displacement;
        append(motion, m_motion.end);
        arrive(m_execution.state, m_motion);
    }

    void join() {
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

    void joinInside(const PlanePath& path) {
        if (!m_compensation.held) {
            tell(nc_message::kCompensationAfterStop);
            return emit(path, tip());
        }
        const auto meeting = meetingPoint(m_compensation.path, path, m_compensation.offset);
        if (!meeting)
            return refuse(nc_message::kCompensationCorner, {shown(radius())});
        emit(path, finish(*meeting, true) ? *meeting : tip());
    }

    /// A rapid motion does not roll about the corner but cuts it.
    void appendCorner(const Vec2& end, double sweep) {
        Motion motion = m_motion;
        motion.kind = m_motion.kind == MotionKind::rapid ? MotionKind::rapid : MotionKind::arc;
        motion.start = m_motion.start + m_compensation.displacement;
        motion.end = withPlane(motion.start, end, m_plane);
        motion.endKnown = motion.startKnown;
        motion.centre = m_motion.start;
        motion.sweep = sweep;
        append(motion, m_motion.start);
    }

    void emit(const PlanePath& path, const Vec2& from) {
        Motion motion = m_motion;
        motion.start = withPlane(m_motion.start, from, m_plane) + m_execution.state.strayed;
        m_execution.state.strayed = Vec3(0);
        motion.end = withPlane(m_motion.end, path.end, m_plane);
        motion.centre = withPlane(m_motion.centre, path.centre, m_plane);
        motion.sweep = from == path.start ? path.sweep : sweepBetween(path, from, path.end);
        if (motion.kind == MotionKind::arc && !fitForSize(m_execution, m_word, motion))
            return leaveOut(m_execution, m_motion);
        m_execution.program.settle();
        m_compensation.entered = m_compensation.held = true;
        m_compensation.entry = false;
        m_compensation.firstHeld = m_execution.program.motionCount();
        m_compensation.path = path;
        m_compensation.from = from;
        m_compensation.heading = headingAtEnd(m_programmed);
        m_compensation.displacement = motion.end - m_motion.end;
        append(motion, m_motion.end);
        arrive(m_execution.state, m_motion);
    }

    void append(Motion& motion, const Vec3& programmedEnd) {
        motion.unverified = m_execution.reporter.unverified();
        m_execution.program.appendCompensated(motion, programmedEnd);
    }

    Execution& m_execution;
    CutterCompensation& m_compensation;
    const Word& m_word;
    const Motion& m_motion;
    PlaneAxes m_plane;
    PlanePath m_programmed;
};

/// The path beside a programmed motion, and what joins it to the motion before; the machine arrives at the
/// programmed end.
void appendCompensated(Execution& execution, const Word& word, const Motion& motion) {
    if (execution.machineCoordinates) {
        execution.reporter.tell(nc_message::kCompensationForbids, word, {"G53"});
        return;
    }
    // Inverse time counts for the programmed length, not for the one of the path beside it.
    Motion programmed = motion;
    setInverseTimeFeed(execution, programmed);
    if (execution.dialect.vectors.used)
        appendByVectors(execution, word, programmed);
    else
        Joining(execution, word, programmed).append();
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
    const CutterCompensation& compensation = execution.state.compensation;
    if (execution.dialect.vectors.used)
        standSquare(execution);
    else if (compensation.held)
        Joining(execution, word, motionFromHere(execution, MotionKind::feed))
            .finish(compensation.path.end, true);
}

} // namespace proveout
