// SPDX-License-Identifier: GPL-3.0-or-later
// The canned cycles G73 to G89 as the motions that they stand for, and G98, G99.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

#include "core/nc/canned_cycle.h"
#include "core/nc/execution.h"
#include "core/nc/handlers.h"
#include "core/nc/motion_building.h"

namespace proveout {

namespace {

constexpr double kReturnGapMm = 0.254; ///< above the depth reached, in a program in mm
constexpr double kReturnGapInch = 0.01;
constexpr double kMostRepeats = 1e9;

/// With G98 LinuxCNC goes to the next hole at the initial level, but not behind G73 and G74.
bool staysAtInitialLevel(const CodeRow* before) {
    constexpr int kG81 = 810;
    return findCycle(before) != nullptr && before->tenths >= kG81;
}

/// One block of a canned cycle: reads its words, then drills its holes.
class CycleRun {
public:
    CycleRun(Execution& execution, const Word& word, const CannedCycle& cycle)
        : m_execution(execution), m_word(word), m_cycle(cycle), m_plane(axes(execution.state.plane)),
          m_state(execution.state.cycle), m_at(execution.state.frame.toProgram(execution.state.position)),
          m_depthKnown((execution.state.known >> static_cast<unsigned>(m_plane.normal) & 1U) != 0) {}

    void run() {
        if (!read())
            return;
        m_execution.state.cycle = m_state;
        tellMissingFeed(m_execution, m_word);
        if (m_cycle.steps.front() == CycleStep::backBore)
            m_execution.reporter.tell(nc_message::kBackBore, m_word);
        const bool toInitial = !m_execution.state.retractToR && m_initialKnown;
        if (m_depthKnown && (m_series ? m_state.initialLevel : m_at[m_plane.normal]) < m_retract)
            depthTo(MotionKind::rapid, m_retract);
        const bool above = toInitial && staysAtInitialLevel(m_execution.motionBefore);
        m_from = std::max(above ? m_state.initialLevel : m_at[m_plane.normal], m_retract);
        m_clearance = toInitial ? std::max(m_state.initialLevel, m_retract) : m_retract;
        for (long long hole = 0; hole < m_repeats && !m_execution.mustEnd(); ++hole)
            drill();
    }

private:
    static char letterOf(int axis) { return static_cast<char>('X' + axis); }
    [[nodiscard]] const Block& block() const { return m_execution.block; }

    bool refuse(const Message& message, const Word& word, std::vector<std::string> arguments = {}) {
        m_execution.reporter.tell(message, word, std::move(arguments));
        return false;
    }
    bool refuseMissing(char letter) {
        return refuse(nc_message::kCycleWord, m_word,
                      {fmt::format("G{}", m_cycle.tenths / 10), std::string(1, letter)});
    }

    bool read() {
        if (!block().letters().any(LetterSet("XYZ@^")))
            return refuse(nc_message::kCycleNoAxis, m_word);
        if (m_execution.state.feedMode == FeedMode::inverseTime)
            return refuse(nc_message::kCycleInverseTime, m_word);
        const MachineState& state = m_execution.state;
        m_series = findCycle(m_execution.motionBefore) != nullptr;
        const bool sticky = m_execution.motionBefore == state.motion;
        if (!m_series)
            m_state.initialLevel = m_at[m_plane.normal];
        m_initialKnown = m_depthKnown || m_series;
        return readLevels(sticky) && readRest(sticky) && spindleTurns();
    }

    bool readLevels(bool sticky) {
        const char depth = letterOf(m_plane.normal);
        const bool incremental = m_execution.state.incremental;
        if (!sticky && !block().has(depth))
            return refuseMissing(depth);
        if (!sticky && !block().has('R'))
            return refuseMissing('R');
        if (block().has('R'))
            m_state.retract = m_execution.length('R');
        if (block().has(depth))
            m_state.bottom = m_execution.length(depth);
        m_retract = m_state.retract + (incremental ? m_state.initialLevel : 0);
        m_bottom = m_state.bottom + (incremental ? m_retract : 0);
        if (m_retract < m_bottom)
            return refuse(nc_message::kCycleLevels, m_word);
        return true;
    }

    bool readRest(bool sticky) {
        if (m_cycle.pecks && !sticky && !block().has('Q'))
            return refuseMissing('Q');
        if (m_cycle.dwells && !sticky && !block().has('P'))
            return refuseMissing('P');
        if (block().has('Q'))
            m_state.peck = m_execution.length('Q');
        if (m_cycle.pecks && m_state.peck <= 0)
            return refuse(nc_message::kCyclePeck, block().has('Q') ? block().word('Q') : m_word);
        if (block().has('P'))
            m_state.dwell = block().value('P');
        else if (!sticky)
            m_state.dwell = 0;
        if (m_state.dwell < 0)
            return refuse(nc_message::kNegative, block().word('P'), {"P"});
        return readRepeats();
    }

    bool readRepeats() {
        if (!block().has('L'))
            return true;
        const Word& word = block().word('L');
        if (word.value < 1 || word.value > kMostRepeats || word.value != std::round(word.value))
            return refuse(nc_message::kNotInteger, word, {"L", "1", "1000000000"});
        m_repeats = static_cast<long long>(word.value);
        return true;
    }

    bool spindleTurns() {
        const int direction = m_execution.state.spindleDirection;
        switch (m_cycle.spindle) {
        case SpindleNeed::any:
            return true;
        case SpindleNeed::turning:
            return direction != 0 || refuse(nc_message::kCycleSpindle, m_word, {"M3 / M4"});
        case SpindleNeed::clockwise:
            return direction > 0 || refuse(nc_message::kCycleSpindle, m_word, {"M3"});
        case SpindleNeed::counterClockwise:
            return direction < 0 || refuse(nc_message::kCycleSpindle, m_word, {"M4"});
        }
        return true;
    }

    void drill() {
        moveOver();
        if (m_from != m_retract || !m_depthKnown)
            depthTo(MotionKind::rapid, m_retract);
        const int direction = m_execution.state.spindleDirection;
        for (const CycleStep step : m_cycle.steps)
            take(step, direction);
        m_from = m_clearance;
    }

    void take(CycleStep step, int direction) {
        switch (step) {
        case CycleStep::none:
            return;
        case CycleStep::feedToBottom:
            return depthTo(MotionKind::feed, m_bottom);
        case CycleStep::peckAndRetract:
            return pecks(true);
        case CycleStep::peckAndBreakChip:
            return pecks(false);
        case CycleStep::dwell:
            return m_execution.program.append(Dwell{m_state.dwell}, m_execution.line);
        case CycleStep::reverseSpindle:
            m_execution.state.spindleDirection = -direction;
            return;
        case CycleStep::stopSpindle:
            m_execution.state.spindleDirection = 0;
            return;
        case CycleStep::restoreSpindle:
            m_execution.state.spindleDirection = direction;
            return;
        case CycleStep::stopProgram:
            return m_execution.program.append(ProgramStop{StopKind::program}, m_execution.line);
        case CycleStep::feedToR:
            return depthTo(MotionKind::feed, m_retract);
        case CycleStep::feedToClearance:
            return depthTo(MotionKind::feed, m_clearance);
        case CycleStep::rapidToClearance:
            return depthTo(MotionKind::rapid, m_clearance);
        case CycleStep::backBore:
            return backBore(direction);
        }
    }

    void pecks(bool retract) {
        const double gap = m_execution.state.inch ? kReturnGapInch * kMmPerInch : kReturnGapMm;
        for (double depth = m_retract - m_state.peck; depth > m_bottom && !m_execution.mustEnd();
             depth -= m_state.peck) {
            depthTo(MotionKind::feed, depth);
            if (retract)
                depthTo(MotionKind::rapid, m_retract);
            depthTo(MotionKind::rapid, depth + gap);
        }
        depthTo(MotionKind::feed, m_bottom);
    }

    /// Down beside the hole with the spindle stopped, up through the bore, and out again beside it.
    void backBore(int direction) {
        const Vec3 hole = m_at;
        Vec3 aside(0);
        for (int axis = 0; axis < 3; ++axis) {
            const char letter = static_cast<char>('I' + axis);
            if (axis != m_plane.normal && block().has(letter))
                aside[axis] = m_execution.length(letter);
        }
        const char top = static_cast<char>('I' + m_plane.normal);
        const double end = block().has(top) ? m_execution.length(top) : m_bottom;
        const auto sideways = [&](const Vec3& offset) {
            Vec3 target = hole + offset;
            target[m_plane.normal] = m_at[m_plane.normal];
            moveTo(MotionKind::rapid, target, true);
        };
        sideways(aside);
        m_execution.state.spindleDirection = 0;
        depthTo(MotionKind::rapid, m_bottom);
        sideways(Vec3(0));
        m_execution.state.spindleDirection = direction;
        depthTo(MotionKind::feed, end);
        depthTo(MotionKind::feed, m_bottom);
        m_execution.state.spindleDirection = 0;
        sideways(aside);
        depthTo(MotionKind::rapid, m_clearance);
        sideways(Vec3(0));
        m_execution.state.spindleDirection = direction;
    }

    /// To the place of the next hole, at the level where the series is.
    void moveOver() {
        Vec3 target = m_at;
        for (const int axis : {m_plane.first, m_plane.second}) {
            const char letter = letterOf(axis);
            if (block().has(letter))
                target[axis] = m_execution.length(letter) + (m_execution.state.incremental ? m_at[axis] : 0);
        }
        if (const auto polar = polarTarget(m_execution, m_at, m_execution.state.known)) {
            target.x = polar->x;
            target.y = polar->y;
        }
        target[m_plane.normal] = m_depthKnown ? m_from : m_at[m_plane.normal];
        moveTo(MotionKind::rapid, target, m_depthKnown);
    }

    void depthTo(MotionKind kind, double level) {
        Vec3 target = m_at;
        target[m_plane.normal] = level;
        m_depthKnown = true;
        moveTo(kind, target, true);
    }

    void moveTo(MotionKind kind, const Vec3& program, bool depthKnown) {
        Motion motion = motionFromHere(m_execution, kind);
        motion.end = m_execution.state.frame.toMachine(program);
        for (int axis = 0; axis < 3; ++axis) {
            const bool known = axis == m_plane.normal ? depthKnown : namedOnce(axis);
            if (known)
                motion.endKnown |= static_cast<std::uint8_t>(1U << static_cast<unsigned>(axis));
            else if (motion.end[axis] != motion.start[axis])
                motion.end[axis] = motion.start[axis];
        }
        motion.endAtReference = motion.endAtReference && !depthKnown;
        if (kind == MotionKind::feed)
            tellUnknownStart(m_execution, motion, m_word);
        appendMotion(m_execution, motion);
        m_at = program;
    }

    /// Whether the block says where the axis stands, or it was known before.
    [[nodiscard]] bool namedOnce(int axis) const {
        const bool known = (m_execution.state.known >> static_cast<unsigned>(axis) & 1U) != 0;
        const bool named =
            block().has(letterOf(axis)) || (axis < 2 && block().letters().any(LetterSet("@^")));
        return known || (named && !m_execution.state.incremental);
    }

    Execution& m_execution;
    const Word& m_word;
    const CannedCycle& m_cycle;
    PlaneAxes m_plane;
    CycleState m_state;
    Vec3 m_at; ///< program coordinates
    bool m_depthKnown;
    bool m_series = false; ///< the block before was a cycle too
    bool m_initialKnown = false;
    double m_retract = 0; ///< levels in program coordinates
    double m_bottom = 0;
    double m_from = 0;      ///< level at which the next hole is reached
    double m_clearance = 0; ///< level at which a hole is left
    long long m_repeats = 1;
};

} // namespace

void runCycle(Execution& execution, const Word& word) {
    CycleRun(execution, word, *findCycle(execution.state.motion)).run();
}

void retractToInitialLevel(Execution& execution, const Word& /*word*/) {
    execution.state.retractToR = false;
}

void retractToRLevel(Execution& execution, const Word& /*word*/) {
    execution.state.retractToR = true;
}

} // namespace proveout
