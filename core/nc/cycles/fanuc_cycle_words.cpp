// SPDX-License-Identifier: GPL-3.0-or-later
// The words of canned cycles, read as by Fanuc and Haas: values of one block remain valid for the next ones,
// until G80 or a motion code ends the series.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

#include "core/nc/cycles/cycle_order.h"

namespace proveout {

namespace {

constexpr int kMostRepeats = 9999;
constexpr double kMillisecond = 1e-3;

class FanucCycleWords {
public:
    FanucCycleWords(Execution& execution, const Word& word, const CannedCycle& cycle)
        : m_execution(execution), m_word(word), m_cycle(cycle), m_plane(axes(execution.state.plane)),
          m_state(execution.state.cycle), m_at(execution.state.frame.toProgram(execution.state.position)) {}

    std::optional<CycleOrder> read() {
        if (!isCycle(m_execution.motionBefore))
            begin();
        if (m_execution.motionBefore != m_execution.state.motion)
            m_state.doubtsReported = false;
        const std::optional<int> repeats = readRepeats();
        const bool drills = block().letters().any(LetterSet("XYZR@^"));
        m_execution.state.cycle = m_state;
        // Values of a block that does not drill are not kept, except with K0, whose purpose that is.
        if (!repeats || (!drills && repeats != 0) || !readWords())
            return {};
        m_execution.state.cycle = m_state;
        if (repeats == 0) {
            reportPlaceOfStored();
            return {};
        }
        if (!complete() || !mayTurn())
            return {};
        reportDoubts();
        m_execution.state.cycle = m_state;
        CycleOrder order = fanucOrderInForce(m_execution, m_cycle);
        order.repeats = *repeats;
        return order;
    }

private:
    [[nodiscard]] const Block& block() const { return m_execution.block; }
    [[nodiscard]] bool shrinks() const { return m_execution.dialect.pecksShrink; }
    [[nodiscard]] std::string cycleName() const { return fmt::format("G{}", m_cycle.tenths / 10); }

    void report(const FindingRow& message, const Word& word, std::vector<Argument> arguments = {}) {
        m_execution.reporter.report(message, word, std::move(arguments));
    }
    bool refuse(const FindingRow& message, const Word& word, std::vector<Argument> arguments = {}) {
        report(message, word, std::move(arguments));
        return false;
    }

    void begin() {
        m_state = {};
        m_state.initialLevel = m_at[m_plane.normal];
        m_state.initialKnown = depthKnown(m_execution);
        m_state.rigid = m_execution.state.rigidTapping || m_execution.dialect.tapsRigidly;
        m_execution.state.rigidTapping = false;
    }

    /// K; or L on older controls and on those of Haas where K is a length.
    std::optional<int> readRepeats() {
        const char letter = !shrinks() && block().has('K') ? 'K' : 'L';
        if (!block().has(letter))
            return 1;
        const Word& word = block().word(letter);
        if (word.value >= 0 && word.value <= kMostRepeats && word.value == std::round(word.value))
            return static_cast<int>(word.value);
        report(nc_message::kNotInteger, word, {std::string(1, letter), "0", std::to_string(kMostRepeats)});
        return {};
    }

    bool readWords() {
        if (m_execution.state.feedMode == FeedMode::inverseTime)
            return refuse(nc_message::kCycleInverseTime, m_word);
        readAside();
        if (shrinks())
            readShrinking();
        if (block().has('Q'))
            m_state.peck = std::abs(m_execution.length('Q'));
        return readDwell() && readLevels();
    }

    /// Levels are kept as positions, so that a series that continues in G91 keeps its depth.
    bool readLevels() {
        const char depth = letterOfAxis(m_plane.normal);
        const bool incremental = m_execution.state.incremental;
        if (block().has('R')) {
            if (incremental && !m_state.initialKnown)
                return refuse(nc_message::kIncrementalUnknown, block().word('R'), {"R"});
            m_state.retract = m_execution.length('R') + (incremental ? m_state.initialLevel : 0);
            m_state.retractGiven = true;
        }
        if (block().has(depth)) {
            m_state.bottom = m_execution.length(depth) + (incremental ? m_state.retract : 0);
            m_state.bottomGiven = true;
        }
        return true;
    }

    bool readDwell() {
        if (!block().has('P'))
            return true;
        const Word& word = block().word('P');
        if (word.value < 0)
            return refuse(nc_message::kNegative, word, {"P"});
        m_state.dwell =
            m_execution.dialect.pointMeansSeconds && word.point ? word.value : word.value * kMillisecond;
        return true;
    }

    void readAside() {
        if (!m_cycle.shifts)
            return;
        for (const int axis : {m_plane.first, m_plane.second}) {
            const char letter = static_cast<char>('I' + axis);
            const bool repeats = letter == 'K' && !shrinks();
            if (!block().has(letter) || repeats)
                continue;
            m_state.aside = m_state.asideGiven ? m_state.aside : Vec3(0);
            m_state.aside[axis] = m_execution.length(letter);
            m_state.asideGiven = true;
        }
    }

    void readShrinking() {
        if (m_cycle.pecks && block().has('I')) {
            m_state.shrinking = {.first = std::abs(m_execution.length('I')),
                                 .less = block().has('J') ? std::abs(m_execution.length('J')) : 0,
                                 .least = block().has('K') ? std::abs(m_execution.length('K')) : 0};
        } else if (m_cycle.pecks && block().has('K')) {
            m_state.shrinking.clearing = std::abs(m_execution.length('K'));
        }
        if (tapping() && block().has('J') && block().value('J') > 0)
            m_state.outRatio = block().value('J');
    }

    [[nodiscard]] bool tapping() const {
        return m_cycle.spindle == SpindleNeed::clockwise || m_cycle.spindle == SpindleNeed::counterClockwise;
    }

    bool complete() {
        if (!m_state.bottomGiven || !m_state.retractGiven) {
            const char missing = m_state.bottomGiven ? 'R' : letterOfAxis(m_plane.normal);
            return refuse(nc_message::kCycleWord, m_word, {cycleName(), std::string(1, missing)});
        }
        if (m_cycle.upward && m_state.bottom <= m_state.retract)
            return refuse(nc_message::kBackBoreLevels, m_word);
        if (!m_cycle.upward && m_state.retract < m_state.bottom)
            return refuse(nc_message::kCycleLevels, m_word);
        if (m_cycle.upward && m_state.peck == 0 && !m_state.asideGiven)
            return refuse(nc_message::kCycleWord, m_word, {cycleName(), "Q"});
        return true;
    }

    bool mayTurn() {
        if (!tapping())
            return spindleTurns(m_execution, m_word, m_cycle.spindle);
        if (m_state.rigid)
            return true;
        if (m_execution.state.spindleDirection != 0)
            return spindleTurns(m_execution, m_word, m_cycle.spindle);
        report(nc_message::kTapSpindle, m_word);
        m_state.rigid = true;
        return true;
    }

    /// Once per cycle, not at every hole.
    void reportDoubts() {
        if (m_state.doubtsReported)
            return;
        m_state.doubtsReported = true;
        const bool inPlace = m_cycle.shifts && m_state.peck == 0 && !m_state.asideGiven;
        if (m_cycle.caveat != nullptr && !inPlace)
            report(*m_cycle.caveat, m_word);
        if (m_cycle.upward && m_execution.state.retractToR)
            report(nc_message::kBackBoreReturn, m_word, {cycleName()});
        if (!m_state.initialKnown && !m_execution.state.retractToR)
            report(nc_message::kInitialLevelUnknown, m_word);
        if (m_cycle.pecks && !tapping() && m_state.peck == 0 && m_state.shrinking.first == 0)
            report(nc_message::kPeckMissing, m_word, {cycleName()});
    }

    /// The manuals do not say whether the machine moves to the position of a block that only stores values.
    void reportPlaceOfStored() {
        for (const int axis : {m_plane.first, m_plane.second}) {
            const char letter = letterOfAxis(axis);
            if (!block().has(letter))
                continue;
            const double at = m_execution.state.incremental ? 0 : m_at[axis];
            const double difference = std::abs(m_execution.length(letter) - at);
            if (difference > m_execution.leastLength() / 2)
                return report(nc_message::kCycleStoredPlace, block().word(letter), {std::string(1, letter)});
        }
    }

    Execution& m_execution;
    const Word& m_word;
    const CannedCycle& m_cycle;
    PlaneAxes m_plane;
    CycleState m_state;
    Vec3 m_at; ///< program coordinates
};

/// The shift by Q and the direction of a machine parameter, or by I J K.
Vec3 asideOf(const CycleState& state, const PlaneAxes& plane) {
    if (state.asideGiven)
        return state.aside;
    Vec3 aside(0);
    aside[plane.first] = state.peck;
    return aside;
}

} // namespace

std::optional<CycleOrder> readFanucCycle(Execution& execution, const Word& word, const CannedCycle& cycle) {
    return FanucCycleWords(execution, word, cycle).read();
}

CycleOrder fanucOrderInForce(const Execution& execution, const CannedCycle& cycle) {
    const CycleState& state = execution.state.cycle;
    const PlaneAxes plane = axes(execution.state.plane);
    CycleOrder order;
    order.retract = state.retract;
    order.bottom = state.bottom;
    order.travel = execution.state.frame.toProgram(execution.state.position)[plane.normal];
    const bool toInitial = cycle.upward || !execution.state.retractToR;
    order.clearance = toInitial && state.initialKnown ? state.initialLevel : state.retract;
    order.dwell = cycle.dwells ? state.dwell : 0;
    if (cycle.pecks)
        order.pecks = state.shrinking.first > 0 ? state.shrinking
                                                : Pecks{state.peck, 0, state.peck, state.shrinking.clearing};
    order.remainder = execution.leastLength() / 2;
    if (cycle.shifts)
        order.aside = asideOf(state, plane);
    order.outRatio = state.outRatio;
    return order;
}

} // namespace proveout
