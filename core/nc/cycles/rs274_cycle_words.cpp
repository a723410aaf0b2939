// SPDX-License-Identifier: GPL-3.0-or-later
// The words of canned cycles, read as by LinuxCNC.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

#include "core/nc/codes/handlers.h"
#include "core/nc/cycles/cycle_order.h"

namespace proveout {

namespace {

constexpr double kMostRepeats = 1e9;
constexpr double kSameLevel = 1e-9; ///< mm; left by converting units and offsets

class Rs274CycleWords {
public:
    Rs274CycleWords(Execution& execution, const Word& word, const CannedCycle& cycle)
        : m_execution(execution), m_word(word), m_cycle(cycle), m_normal(axes(execution.state.plane).normal),
          m_state(execution.state.cycle),
          m_at(execution.state.frame.toProgram(execution.state.position)[m_normal]),
          m_depthKnown(depthKnown(execution)) {}

    std::optional<CycleOrder> read() {
        if (!readWords())
            return {};
        m_execution.state.cycle = m_state;
        if (m_cycle.caveat != nullptr)
            m_execution.reporter.report(*m_cycle.caveat, m_word);
        m_order.dwell = m_state.dwell;
        m_order.pecks = {m_state.peck, 0, m_state.peck, 0};
        m_order.aside = m_state.aside;
        m_order.aside[m_normal] = 0;
        m_order.boreTop = m_state.aside[m_normal] + (m_execution.state.incremental ? m_order.bottom : 0);
        readLevelsBetweenHoles();
        return m_order;
    }

private:
    [[nodiscard]] const Block& block() const { return m_execution.block; }

    /// LinuxCNC moves to the first hole at the level of a tool that is above R, otherwise at the level to
    /// which holes retract: after G98 that is the initial level, even if the hole before retracted to R.
    void readLevelsBetweenHoles() {
        const bool toInitial = !m_execution.state.retractToR && m_initialKnown;
        m_order.lifts = m_depthKnown && m_state.initialLevel < m_order.retract - kSameLevel;
        m_order.clearance = toInitial ? std::max(m_state.initialLevel, m_order.retract) : m_order.retract;
        const bool rises =
            m_execution.dialect.risesOnTheWay && (m_order.lifts || m_at <= m_order.retract + kSameLevel);
        m_order.travel = rises ? m_order.clearance : std::max(m_at, m_order.retract);
    }

    bool refuse(const FindingRow& message, const Word& word, std::vector<Argument> arguments = {}) {
        m_execution.reporter.report(message, word, std::move(arguments));
        return false;
    }
    bool refuseMissing(char letter) {
        return refuse(nc_message::kCycleWord, m_word,
                      {fmt::format("G{}", m_cycle.tenths / 10), std::string(1, letter)});
    }

    bool readWords() {
        if (!block().letters().any(LetterSet("XYZ@^")))
            return refuse(nc_message::kCycleNoAxis, m_word);
        if (m_execution.state.feedMode == FeedMode::inverseTime)
            return refuse(nc_message::kCycleInverseTime, m_word);
        const MachineState& state = m_execution.state;
        if (state.polar.on && block().letters().any(LetterSet("XY")))
            m_execution.reporter.report(nc_message::kPolarArc, m_word,
                                        {fmt::format("G{}", m_cycle.tenths / 10)});
        m_series = isCycle(m_execution.motionBefore);
        const bool sticky = m_execution.motionBefore == state.motion;
        if (!m_series)
            m_state.initialLevel = m_at;
        m_initialKnown = m_depthKnown || m_series;
        return readLevels(sticky) && readRest(sticky) && spindleTurns(m_execution, m_word, m_cycle.spindle);
    }

    bool readLevels(bool sticky) {
        const char depth = letterOfAxis(m_normal);
        const bool incremental = m_execution.state.incremental;
        if (!sticky && !block().has(depth))
            return refuseMissing(depth);
        if (!sticky && !block().has('R'))
            return refuseMissing('R');
        if (block().has('R') && m_execution.dialect.radiusNotScaled &&
            m_execution.state.frame.transformation.scaled)
            m_execution.reporter.report(nc_message::kRadiusScaled, block().word('R'), {"R"});
        if (block().has('R'))
            m_state.retract = m_execution.length('R');
        if (block().has(depth))
            m_state.bottom = m_execution.length(depth);
        m_order.retract = m_state.retract + (incremental ? m_state.initialLevel : 0);
        m_order.bottom = m_state.bottom + (incremental ? m_order.retract : 0);
        if (m_order.retract < m_order.bottom)
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
        if (block().has('P')) {
            m_state.dwell = block().value('P');
            reportDwellUnit(m_execution, block().word('P'));
        }
        if (m_state.dwell < 0)
            return refuse(nc_message::kNegative, block().word('P'), {"P"});
        return readBore(sticky) && readRepeats();
    }

    /// I, J and K of G87: two of them are the shift, the third is the top of the bore.
    bool readBore(bool sticky) {
        constexpr int kBackBore = 870;
        if (m_cycle.tenths != kBackBore)
            return true;
        for (int axis = 0; axis < 3; ++axis) {
            const char letter = static_cast<char>('I' + axis);
            if (!sticky && !block().has(letter))
                return refuseMissing(letter);
            if (block().has(letter))
                m_state.aside[axis] = m_execution.length(letter);
        }
        return true;
    }

    bool readRepeats() {
        if (!block().has('L'))
            return true;
        const Word& word = block().word('L');
        if (word.value < 1 || word.value > kMostRepeats || word.value != std::round(word.value))
            return refuse(nc_message::kNotInteger, word, {"L", "1", "1000000000"});
        m_order.repeats = static_cast<long long>(word.value);
        return true;
    }

    Execution& m_execution;
    const Word& m_word;
    const CannedCycle& m_cycle;
    int m_normal;
    CycleState m_state;
    CycleOrder m_order;
    double m_at; ///< level of the tool
    bool m_depthKnown;
    bool m_series = false; ///< whether the previous block was a cycle too
    bool m_initialKnown = false;
};

} // namespace

std::optional<CycleOrder> readRs274Cycle(Execution& execution, const Word& word, const CannedCycle& cycle) {
    return Rs274CycleWords(execution, word, cycle).read();
}

} // namespace proveout
