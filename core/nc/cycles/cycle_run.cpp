// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/cycles/cycle_run.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/motion_target.h"
#include "core/nc/motions/polar_words.h"

namespace proveout {

namespace {

constexpr double kSameLevel = 1e-9; ///< mm; left by converting units and offsets

/// The direction of the spindle in a hole.
int turnIn(SpindleNeed need, int before) {
    switch (need) {
    case SpindleNeed::clockwise:
        return 1;
    case SpindleNeed::counterClockwise:
        return -1;
    case SpindleNeed::any:
    case SpindleNeed::turning:
        break;
    }
    return before;
}

/// Reverses the scaling of G51 for a length along the axis: pecks, gaps and shifts are not scaled.
double unscaled(const Execution& execution, int axis) {
    const Transformation& now = execution.state.frame.transformation;
    return now.scaled ? 1 / std::abs(now.factors[axis]) : 1;
}

CycleOrder unscaled(const Execution& execution, CycleOrder order) {
    const double depth = unscaled(execution, axes(execution.state.plane).normal);
    for (double* length :
         {&order.pecks.first, &order.pecks.less, &order.pecks.least, &order.pecks.clearing, &order.remainder})
        *length *= depth;
    for (int axis = 0; axis < 3; ++axis)
        order.aside[axis] *= unscaled(execution, axis);
    return order;
}

} // namespace

CycleRun::CycleRun(Execution& execution, const Word& word, const CannedCycle& cycle, const CycleOrder& order)
    : m_execution(execution), m_word(word), m_cycle(cycle), m_order(unscaled(execution, order)),
      m_plane(axes(execution.state.plane)), m_at(execution.state.frame.toProgram(execution.state.position)),
      m_hole(m_at), m_depthKnown(depthKnown(execution)), m_level(order.travel) {}

bool CycleRun::mayDrill(double holes) const {
    constexpr double kOfPeck = 3;     // down, out, and back
    constexpr double kOfBackBore = 8; // in one step
    double motions = 1;               // to the hole
    for (const CycleStep step : m_cycle.steps)
        motions += step == CycleStep::backBore ? kOfBackBore : step == CycleStep::none ? 0 : 1;
    const double pecks = m_cycle.pecks ? m_order.pecks.count(m_order.retract - m_order.bottom) : 0;
    const bool deep = pecks > holes;
    const auto wordOf = [&](std::string_view letters) -> const Word& {
        const auto found = std::ranges::find_if(letters, [&](char letter) { return block().has(letter); });
        return found == letters.end() ? m_word : block().word(*found);
    };
    return m_execution.mayMake(holes * (motions + kOfPeck * pecks), wordOf(deep ? "QI" : "LK"));
}

void CycleRun::drillBlock() {
    if (!mayDrill(static_cast<double>(m_order.repeats)))
        return;
    lift();
    for (long long hole = 0; hole < m_order.repeats && !m_execution.mustEnd(); ++hole) {
        moveOver();
        drill();
    }
}

void CycleRun::drillAt(const Vec2& place) {
    Vec3 target = m_at;
    target[m_plane.first] = place.x;
    target[m_plane.second] = place.y;
    moveTo(MotionKind::rapid, target, m_depthKnown);
    drill();
}

void CycleRun::lift() {
    if (m_order.lifts)
        depthTo(MotionKind::rapid, m_order.retract);
}

void CycleRun::drill() {
    m_hole = m_at;
    m_turnBefore = m_execution.state.spindleDirection;
    m_turn = turnIn(m_cycle.spindle, m_turnBefore);
    for (const CycleStep step : m_cycle.steps)
        apply(step);
    m_level = m_order.clearance;
}

void CycleRun::apply(CycleStep step) {
    switch (step) {
    case CycleStep::none:
        return;
    case CycleStep::rapidToR:
        if (!m_depthKnown || std::abs(m_at[m_plane.normal] - m_order.retract) > kSameLevel)
            depthTo(MotionKind::rapid, m_order.retract);
        return;
    case CycleStep::feedToBottom:
        return depthTo(MotionKind::feed, m_order.bottom);
    case CycleStep::peckAndRetract:
        return peck(true);
    case CycleStep::peckAndBreakChip:
        return peck(false);
    case CycleStep::tapToBottom:
        return tap();
    case CycleStep::tapToR:
        return tapOut();
    case CycleStep::dwell:
        return dwell();
    case CycleStep::turnAsNeeded:
        return turn(m_turn);
    case CycleStep::reverseSpindle:
        return turn(-m_turn);
    case CycleStep::stopSpindle:
        return turn(0);
    case CycleStep::restoreSpindle:
        return turn(m_turnBefore);
    case CycleStep::stopProgram:
        return m_execution.program.append(ProgramStop{StopKind::program}, m_execution.line);
    case CycleStep::feedToR:
        return depthTo(MotionKind::feed, m_order.retract);
    case CycleStep::feedToClearance:
        return depthTo(MotionKind::feed, m_order.clearance);
    case CycleStep::rapidToClearance:
        return depthTo(MotionKind::rapid, m_order.clearance);
    case CycleStep::shiftAside:
        return shift(m_order.aside);
    case CycleStep::shiftBack:
        return shift(Vec3(0));
    case CycleStep::backBore:
        return backBore();
    case CycleStep::mixedToBottom:
        reportMixed();
        return feedMixed(m_order.bottom);
    case CycleStep::mixedToClearance:
        return feedMixed(m_order.clearance);
    case CycleStep::startedAsLeft:
        return startAsLeft();
    }
}

void CycleRun::dwell() {
    if (m_order.dwell > 0 || listsNothing())
        m_execution.program.append(Dwell{m_order.dwell}, m_execution.line);
}

/// The rounding of inches converted to millimetres must not add a peck where the depth is a whole number of
/// them.
bool CycleRun::isAbove(double depth, double bottom) const {
    constexpr double kRounding = 1e-9;
    return depth > bottom + (m_execution.state.inch ? kRounding : 0);
}

void CycleRun::peck(bool retract) {
    const Dialect& dialect = m_execution.dialect;
    const Pecks& pecks = m_order.pecks;
    const double real = unscaled(m_execution, m_plane.normal);
    const double gap = real * (retract ? dialect.peckGapMm : dialect.chipGapMm);
    double step = pecks.first;
    double sinceClear = 0;
    for (double depth = m_order.retract - step;
         step > 0 && isAbove(depth, m_order.bottom + m_order.remainder) && !m_execution.mustEnd();
         depth -= step) {
        depthTo(MotionKind::feed, depth);
        sinceClear += step;
        if (retract || (pecks.clearing > 0 && sinceClear >= pecks.clearing)) {
            depthTo(MotionKind::rapid, m_order.retract + real * dialect.peckLiftMm);
            sinceClear = 0;
        }
        depthTo(MotionKind::rapid, above(depth, gap));
        step = std::max(step - pecks.less, pecks.least);
    }
    depthTo(MotionKind::feed, m_order.bottom);
}

/// LinuxCNC moves above R if the gap is larger than the peck.
double CycleRun::above(double depth, double gap) const {
    return listsNothing() ? depth + gap : std::min(depth + gap, m_order.retract);
}

void CycleRun::tap() {
    const double step = m_order.pecks.first;
    for (double depth = m_order.retract - step;
         step > 0 && isAbove(depth, m_order.bottom + m_order.remainder) && !m_execution.mustEnd();
         depth -= step) {
        depthTo(MotionKind::feed, depth);
        turn(-m_turn);
        depthTo(MotionKind::feed,
                above(depth, unscaled(m_execution, m_plane.normal) * m_execution.dialect.chipGapMm));
        turn(m_turn);
    }
    depthTo(MotionKind::feed, m_order.bottom);
}

void CycleRun::tapOut() {
    depthTo(MotionKind::feed, m_order.retract, m_order.outRatio);
}

void CycleRun::shift(const Vec3& offset) {
    Vec3 target = m_hole + offset;
    target[m_plane.normal] = m_at[m_plane.normal];
    moveTo(MotionKind::rapid, target, m_depthKnown);
}

/// Down beside the hole with the spindle stopped, up through the bore, and out again beside the hole.
void CycleRun::backBore() {
    shift(m_order.aside);
    turn(0);
    depthTo(MotionKind::rapid, m_order.bottom);
    shift(Vec3(0));
    turn(m_turnBefore);
    depthTo(MotionKind::feed, m_order.boreTop);
    depthTo(MotionKind::feed, m_order.bottom);
    turn(0);
    shift(m_order.aside);
    depthTo(MotionKind::rapid, m_order.clearance);
    shift(Vec3(0));
    turn(m_turnBefore);
}

void CycleRun::reportMixed() {
    const Plane plane = m_execution.state.plane;
    if (plane != Plane::xy)
        m_execution.reporter.report(nc_message::kTapAxesMixed, m_word, {plane == Plane::zx ? "G18" : "G19"});
}

/// LinuxCNC 2.9 permutes the coordinates of a tap outside of G17 once more than those of the other cycles.
void CycleRun::feedMixed(double level) {
    Vec3 hole = m_hole;
    hole[m_plane.normal] = level;
    const Plane plane = m_execution.state.plane;
    if (plane == Plane::xy)
        return depthTo(MotionKind::feed, level);
    const Vec3 mixed = plane == Plane::zx ? Vec3(hole.y, hole.z, hole.x) : Vec3(hole.z, hole.x, hole.y);
    moveTo(MotionKind::feed, mixed, true);
}

void CycleRun::startAsLeft() {
    Vec3 left = m_hole;
    left[m_plane.normal] = m_order.clearance;
    if (left == m_at)
        return;
    MachineState& state = m_execution.state;
    const Vec3 tip = state.position;
    state.position = state.frame.toMachine(left);
    state.strayed = tip - state.position;
    m_at = left;
}

/// Moves over the next hole, at the present level of the series.
void CycleRun::moveOver() {
    Vec3 target = m_at;
    for (const int axis : {m_plane.first, m_plane.second}) {
        const char letter = letterOfAxis(axis);
        if (block().has(letter))
            target[axis] = m_execution.length(letter) + (m_execution.state.incremental ? m_at[axis] : 0);
    }
    if (m_execution.state.polar.on) {
        static_cast<void>(readPolarWords(m_execution, m_execution.state.known, target));
    } else if (const auto polar = polarTarget(m_execution, m_at, m_execution.state.known)) {
        target.x = polar->x;
        target.y = polar->y;
    }
    target[m_plane.normal] = m_depthKnown ? m_level : m_at[m_plane.normal];
    moveTo(MotionKind::rapid, target, m_depthKnown);
}

void CycleRun::depthTo(MotionKind kind, double level, double ratio) {
    Vec3 target = m_at;
    target[m_plane.normal] = level;
    m_depthKnown = true;
    moveTo(kind, target, true, ratio);
}

void CycleRun::moveTo(MotionKind kind, const Vec3& program, bool depthKnown, double ratio) {
    Motion motion = motionFromHere(m_execution, kind);
    motion.feedMmPerMin *= ratio;
    motion.spindleRpm *= ratio;
    motion.end = m_execution.state.frame.toMachine(program);
    for (int axis = 0; axis < 3; ++axis) {
        const bool known = axis == m_plane.normal ? depthKnown : namedOnce(axis);
        if (known)
            motion.endKnown |= axisBit(axis);
        else if (motion.end[axis] != motion.start[axis])
            motion.end[axis] = motion.start[axis];
    }
    motion.endAtReference = motion.endAtReference && !depthKnown;
    const bool stays = m_at == program && motion.startKnown == motion.endKnown;
    m_at = program;
    if (stays && !listsNothing())
        return;
    if (kind == MotionKind::feed) {
        reportMissingFeed(m_execution, m_word);
        reportUnknownStart(m_execution, motion, m_word);
    }
    appendMotion(m_execution, motion);
}

/// Whether the block gives the position of the axis, or it was known before.
bool CycleRun::namedOnce(int axis) const {
    const bool known = (m_execution.state.known >> static_cast<unsigned>(axis) & 1U) != 0;
    const bool named =
        block().has(letterOfAxis(axis)) || (axis < 2 && block().letters().any(LetterSet("@^")));
    return known || (named && !m_execution.state.incremental);
}

} // namespace proveout
