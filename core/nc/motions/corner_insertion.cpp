// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/corner_insertion.h"

#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>

#include "core/base/figures_argument.h"
#include "core/nc/geometry/corner_shape.h"
#include "core/nc/motions/compensated_path.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

/// Whether the next motion in the plane is compensated to the other side than the held one.
bool changesSide(const CutterCompensation& compensation) {
    return compensation.moves() && compensation.held &&
           (compensation.vectors.offset > 0) != (compensation.offset > 0);
}

bool leadsNowhere(const PlanePath& path) {
    constexpr double kNoCircle = 1; ///< rad: a full circle also ends where it begins
    return std::abs(path.sweep) < kNoCircle && glm::distance(path.start, path.end) < kNoLength;
}

/// A corner that an earlier block programmed, at the motion after it.
class Insertion {
public:
    Insertion(Execution& execution, const Word& word, Motion& motion)
        : m_execution(execution), m_corner(execution.state.corner), m_word(word), m_motion(motion),
          m_plane(axes(execution.state.plane)), m_after{inPlane(motion.start, m_plane),
                                                        inPlane(motion.end, m_plane),
                                                        inPlane(motion.centre, m_plane), motion.sweep} {}

    /// Shortens the motion to the part after the corner; false if nothing remains.
    bool insert() {
        m_corner.pending = false;
        if (!fits() || needsNoCorner(m_corner.path, m_after))
            return true;
        const auto shape = m_corner.rounded ? roundingBetween(m_corner.path, m_after, m_corner.size)
                                            : chamferBetween(m_corner.path, m_after, m_corner.size);
        const bool whole = m_corner.compensated || m_corner.path.arc();
        const bool consumed = shape && whole && leadsNowhere(upTo(m_corner.path, shape->start));
        if (!shape || consumed) {
            report(nc_message::kCornerTooLarge, {figures("{:.6g}", m_corner.size)});
            return true;
        }
        if (!m_corner.rounded && (m_corner.path.arc() || m_after.arc()))
            report(nc_message::kChamferOnArc);
        shortenBefore(*shape);
        appendBetween(*shape);
        return shortenAfter(*shape);
    }

private:
    void report(const FindingRow& message, std::vector<Argument> arguments = {}) {
        m_execution.reporter.report(message, m_word, std::move(arguments));
    }

    bool fits() {
        const CutterCompensation& compensation = m_execution.state.compensation;
        // A program stop leaves the tool at the end of the motion before.
        const bool held =
            m_corner.compensated ? compensation.held : !m_execution.program.isSettled(m_corner.motion);
        if (m_motion.kind == MotionKind::rapid)
            report(nc_message::kCornerNextBlock);
        else if (m_corner.compensated != compensation.moves() || changesSide(compensation))
            report(nc_message::kCornerCompensation);
        else if (!held || leadsNowhere(m_after))
            report(nc_message::kCornerWithoutMotion);
        else if (m_corner.across || m_corner.plane != m_execution.state.plane ||
                 m_motion.start[m_plane.normal] != m_motion.end[m_plane.normal] || !planeKnown(m_motion))
            report(nc_message::kCornerOffPlane);
        else
            return m_corner.size > 0;
        return false;
    }

    void shortenBefore(const PlanePath& shape) {
        const PlanePath before = upTo(m_corner.path, shape.start);
        MachineState& state = m_execution.state;
        if (!m_corner.compensated)
            m_execution.program.moveEnds(m_corner.motion, state.plane, shape.start, before.sweep);
        state.position = withPlane(state.position, shape.start, m_plane);
        if (m_corner.compensated)
            shortenHeld(m_execution, before);
    }

    void appendBetween(const PlanePath& shape) {
        Motion between = m_motion;
        between.kind = shape.arc() ? MotionKind::arc : MotionKind::feed;
        between.end = withPlane(m_motion.start, shape.end, m_plane);
        between.start = withPlane(m_motion.start, shape.start, m_plane);
        between.centre = withPlane(m_motion.start, shape.centre, m_plane);
        between.sweep = shape.sweep;
        between.feedMmPerMin = m_corner.feed;
        between.endKnown = m_motion.startKnown;
        const Motion before = m_execution.program.motion(m_corner.motion);
        between.tool = before.tool;
        between.spindleRpm = before.spindleRpm;
        between.orderedRpm = before.orderedRpm;
        appendOrdered(m_execution, m_word, between);
        m_execution.program.delayEvents(m_corner.events);
    }

    bool shortenAfter(const PlanePath& shape) {
        const PlanePath after = fromOn(m_after, shape.end);
        m_motion.start = withPlane(m_motion.start, shape.end, m_plane);
        m_motion.sweep = after.sweep;
        if (!leadsNowhere(after))
            return true;
        arrive(m_execution.state, m_motion);
        return false;
    }

    Execution& m_execution;
    OrderedCorner& m_corner;
    const Word& m_word;
    Motion& m_motion;
    PlaneAxes m_plane;
    PlanePath m_after;
};

/// The word that programs a corner; null if there is none, or, with a report, if there are two.
const Word* cornerWord(Execution& execution) {
    const Block& block = execution.block;
    if (!block.has(kRoundingLetter))
        return block.has(kChamferLetter) ? &block.word(kChamferLetter) : nullptr;
    if (!block.has(kChamferLetter))
        return &block.word(kRoundingLetter);
    execution.reporter.report(nc_message::kCornerTwice, block.word(kRoundingLetter));
    return nullptr;
}

/// Whether a scaling is in force that changes lengths in the plane.
bool scaledInPlane(const MachineState& state) {
    const Transformation& now = state.frame.transformation;
    const PlaneAxes plane = axes(state.plane);
    return now.scaled &&
           (std::abs(now.factors[plane.first]) != 1 || std::abs(now.factors[plane.second]) != 1);
}

/// Without cutter compensation.
void appendMovable(Execution& execution, Motion motion) {
    setInverseTimeFeed(execution, motion);
    motion.unverified = execution.reporter.unverified();
    execution.program.settle();
    execution.program.appendCompensated(motion, motion.end);
    arrive(execution.state, motion);
}

/// Appends a motion whose end the next one may move.
void appendHeld(Execution& execution, const Word& word, const Motion& motion, const Word& ordered) {
    const PlaneAxes plane = axes(execution.state.plane);
    OrderedCorner corner;
    corner.pending = corner.seen = true;
    corner.rounded = ordered.letter == kRoundingLetter;
    corner.size = execution.length(ordered.letter);
    corner.compensated = execution.state.compensation.moves();
    corner.plane = execution.state.plane;
    corner.across = motion.start[plane.normal] != motion.end[plane.normal];
    corner.feed = motion.feedMmPerMin;
    corner.path = {inPlane(motion.start, plane), inPlane(motion.end, plane), inPlane(motion.centre, plane),
                   motion.sweep};
    const CutterCompensation& compensation = execution.state.compensation;
    const bool changes =
        corner.compensated ? !compensation.entered || changesSide(compensation) : compensation.leaving();
    if (changes || !planeKnown(motion) || leadsNowhere(corner.path)) {
        execution.reporter.report(
            changes ? nc_message::kCornerCompensation : nc_message::kCornerWithoutMotion, ordered);
        appendOrdered(execution, word, motion);
        return;
    }
    if (corner.size < 0)
        execution.reporter.report(nc_message::kCornerNegative, ordered, {figures("{:.6g}", corner.size)});
    else if (scaledInPlane(execution.state))
        execution.reporter.report(nc_message::kCornerScaled, ordered);
    if (corner.compensated)
        appendOrdered(execution, word, motion);
    else
        appendMovable(execution, motion);
    corner.motion = execution.program.motionCount() - 1;
    corner.events = execution.program.events().size();
    execution.state.corner = corner;
}

} // namespace

void appendWithCorner(Execution& execution, const Word& word, const Motion& motion) {
    Motion rest = motion;
    if (execution.state.corner.pending && !Insertion(execution, word, rest).insert())
        return;
    const Word* ordered = motion.kind == MotionKind::rapid ? nullptr : cornerWord(execution);
    if (ordered == nullptr)
        appendOrdered(execution, word, rest);
    else
        appendHeld(execution, word, rest, *ordered);
}

void checkOrderedCorner(Execution& execution) {
    OrderedCorner& corner = execution.state.corner;
    const bool seen = corner.seen;
    corner.seen = false;
    if (!corner.pending || seen)
        return;
    const auto codes = execution.block.codes();
    const CodeRow* row = codes.size() == 1 ? execution.codes.find(codes.front()) : nullptr;
    if (row != nullptr && row->step == Step::dwell && !corner.dwelled) {
        corner.dwelled = true;
        return;
    }
    corner.pending = false;
    execution.reporter.report(nc_message::kCornerNextBlock, 1, 0);
}

} // namespace proveout
