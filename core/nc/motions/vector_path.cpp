// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/vector_path.h"

#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>

#include "core/base/figures_argument.h"
#include "core/nc/geometry/corner_vectors.h"
#include "core/nc/motions/arc_words.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/radius_notice.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

/// Blocks of the look-ahead that are motions: the one before a corner and the one behind it.
constexpr int kBlocksOfCorner = 2;

Argument shown(double length) {
    return figures("{:.6g}", length);
}

/// One programmed motion that is to be compensated.
class VectorPath {
public:
    VectorPath(Execution& execution, const Word& word, const Motion& motion)
        : m_execution(execution), m_rules(execution.dialect.vectors),
          m_compensation(execution.state.compensation), m_held(m_compensation.vectors), m_word(word),
          m_motion(motion),
          m_plane(axes(execution.state.plane)), m_programmed{inPlane(motion.start, m_plane),
                                                             inPlane(motion.end, m_plane),
                                                             inPlane(motion.centre, m_plane), motion.sweep} {}

    void append() {
        if (!planeKnown(m_motion))
            appendUnknown();
        else if (!m_programmed.arc() && glm::distance(m_programmed.start, m_programmed.end) < kNoLength)
            appendAcross();
        else if (!m_compensation.moves())
            cancel();
        else if (!m_compensation.entered)
            startUp();
        else
            join();
    }

private:
    void tell(const FindingRow& message, std::vector<Argument> arguments = {}) {
        m_execution.reporter.tell(message, m_word, std::move(arguments));
    }
    void refuse(const FindingRow& message, std::vector<Argument> arguments = {}) {
        tellOfRadius(m_execution, message, m_word, std::move(arguments));
        leaveOut(m_execution, m_motion);
    }

    [[nodiscard]] Vec2 tip() const {
        return inPlane(tipAt(m_execution, m_execution.state.position), m_plane);
    }
    void standAt(const Vec2& place) {
        m_compensation.displacement =
            withPlane(Vec3(0), place - inPlane(m_execution.state.position, m_plane), m_plane);
    }

    void appendUnknown() {
        if (!m_compensation.unknownTold)
            tell(nc_message::kCompensationUnknownStart);
        m_compensation.unknownTold = true;
        m_compensation.beginAnew();
        appendMotion(m_execution, m_motion);
    }

    /// Along the normal of the plane, or nowhere: the tip stays beside the same point. Axis words that move
    /// nothing at all keep the control from reading on.
    void appendAcross() {
        Motion motion = m_motion;
        motion.start = tipAt(m_execution, m_motion.start);
        motion.end = withPlane(m_motion.end, inPlane(motion.start, m_plane), m_plane);
        append(motion, m_motion.end);
        arrive(m_execution.state, m_motion);
        if (m_motion.start == m_motion.end)
            standSquare(m_execution);
    }

    void startUp() {
        if (m_programmed.arc())
            return refuse(nc_message::kCompensationStartArc);
        standSquare(m_execution);
        emit(tip());
        m_compensation.entry = true;
    }

    void cancel() {
        if (m_compensation.held) {
            const CornerPoints points = kept(exitPoints());
            finish(points.first());
            moveThrough(points);
        }
        m_compensation.held = false;
        appendMotion(m_execution, m_motion);
    }

    CornerPoints exitPoints() {
        if (m_held.exit == Vec2(0))
            return cancelPoints(m_held.programmed, m_programmed, m_held.offset, m_rules.typeB);
        const PlanePath way{m_programmed.start, m_programmed.start + m_held.exit, Vec2(0), 0};
        const auto meeting = crossing(m_held.programmed, m_held.offset, way, m_held.offset);
        CornerPoints points;
        points.add(meeting.value_or(m_compensation.path.end));
        return points;
    }

    void join() {
        if (!offsetPath(m_programmed, m_compensation.offset) ||
            (m_compensation.held && !offsetPath(m_programmed, m_held.offset))) {
            return refuse(nc_message::kCompensationArcSmall,
                          {shown(glm::distance(m_programmed.end, m_programmed.centre)),
                           shown(std::abs(m_compensation.offset))});
        }
        if (m_compensation.held && changesSide() && !m_rules.crossesAtCorner)
            standSquare(m_execution);
        if (!m_compensation.held)
            return joinSquare();
        const auto points = corner();
        if (!points)
            return refuse(nc_message::kCompensationCorner, {shown(std::abs(m_held.offset))});
        const CornerPoints through = kept(*points);
        if (!finish(through.first()))
            return emit(tip());
        moveThrough(through);
        emit(through.last());
        m_held.cornered = through.all().size() > 1;
    }

    [[nodiscard]] CornerPoints kept(const CornerPoints& points) const {
        return withoutSmallMoves(points, m_rules.smallMoveMm, m_programmed);
    }
    [[nodiscard]] bool changesSide() const { return (m_held.offset > 0) != (m_compensation.offset > 0); }

    /// From where the tool stands, though the paths turn.
    void joinSquare() {
        if (!goesStraightOn(m_held.programmed, m_programmed))
            tell(nc_message::kCompensationSquare);
        emit(tip());
    }

    std::optional<CornerPoints> corner() {
        if (m_compensation.entry) {
            if (changesSide())
                tell(nc_message::kCompensationSideApart);
            return startUpPoints(m_held.programmed, m_programmed, m_held.offset, m_rules.typeB);
        }
        if (!changesSide())
            return cornerPoints(m_held.programmed, m_programmed, m_held.offset);
        const auto meeting = crossing(m_held.programmed, m_held.offset, m_programmed, m_compensation.offset);
        if (!meeting)
            tell(nc_message::kCompensationSideApart);
        CornerPoints points;
        points.add(meeting.value_or(
            beside(m_programmed.start, headingAtStart(m_programmed), m_compensation.offset)));
        return points;
    }

    /// The motion before is final with this end, unless it would go backward. Then it stays as it was.
    bool finish(const Vec2& end) {
        m_compensation.held = false;
        const PlanePath& path = m_compensation.path;
        const Vec2& from = m_compensation.from;
        if (!m_compensation.entry && !changesSide() && goesBackward(path, from, end)) {
            const Motion motion = m_execution.program.motion(m_compensation.firstHeld);
            tellOfRadius(m_execution,
                         m_held.cornered ? nc_message::kCompensationErased : nc_message::kCompensationGouge,
                         m_word, {shown(std::abs(m_held.offset)), std::to_string(motion.line)});
            m_execution.program.settle();
            return false;
        }
        m_execution.program.moveEnds(m_compensation.firstHeld, m_execution.state.plane, end,
                                     path.arc() ? sweepWithin(path, from, end) : 0);
        m_execution.program.settle();
        standAt(end);
        return true;
    }

    /// The corner belongs to the block behind it.
    void moveThrough(const CornerPoints& points) {
        for (const Vec2& point : points.all().subspan(1)) {
            Motion motion = m_motion;
            motion.kind = m_motion.kind == MotionKind::rapid ? MotionKind::rapid : MotionKind::feed;
            motion.start = tipAt(m_execution, m_motion.start);
            motion.end = withPlane(motion.start, point, m_plane);
            motion.endKnown = motion.startKnown;
            append(motion, m_motion.start);
            standAt(point);
        }
    }

    void emit(const Vec2& from) {
        const PlanePath path = *offsetPath(m_programmed, m_compensation.offset);
        Motion motion = m_motion;
        motion.start = withPlane(m_motion.start, from, m_plane);
        motion.end = withPlane(m_motion.end, path.end, m_plane);
        if (path.arc()) {
            tellOffCircle(path, from);
            motion.sweep = sweepWithin(path, from, path.end);
        }
        if (motion.kind == MotionKind::arc && !fitForSize(m_execution, m_word, motion))
            return leaveOut(m_execution, m_motion);
        m_compensation.entered = m_compensation.held = true;
        m_compensation.entry = false;
        m_compensation.firstHeld = m_execution.program.motionCount();
        m_compensation.path = path;
        m_compensation.from = from;
        m_held = {m_programmed, m_compensation.offset, false, true, 0, Vec2(0)};
        append(motion, m_motion.end);
        arrive(m_execution.state, m_motion);
        standAt(path.end);
    }

    void tellOffCircle(const PlanePath& path, const Vec2& from) {
        const double off =
            std::abs(glm::distance(from, path.centre) - glm::distance(path.start, path.centre));
        if (off > m_rules.smallMoveMm)
            tell(nc_message::kCompensationOffCircle, {shown(off)});
    }

    void append(Motion& motion, const Vec3& programmedEnd) {
        motion.unverified = m_execution.reporter.unverified();
        m_execution.program.appendCompensated(motion, programmedEnd);
    }

    Execution& m_execution;
    const VectorRules& m_rules;
    CutterCompensation& m_compensation;
    VectorState& m_held;
    const Word& m_word;
    const Motion& m_motion;
    PlaneAxes m_plane;
    PlanePath m_programmed;
};

} // namespace

void appendByVectors(Execution& execution, const Word& word, const Motion& motion) {
    VectorPath(execution, word, motion).append();
}

void standSquare(Execution& execution) {
    execution.state.compensation.held = false;
    execution.program.settle();
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
    // A call is no block of the look-ahead: the control goes on reading where it leads.
    if (!compensation.held || moved || execution.request.kind != FlowRequest::Kind::none)
        return;
    if (!compensation.moves() ||
        ++state.blocksWithout > execution.dialect.vectors.readAhead - kBlocksOfCorner)
        standSquare(execution);
}

} // namespace proveout
