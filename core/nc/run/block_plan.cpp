// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/block_plan.h"
#include "core/nc/motions/known_axes.h"

#include <cmath>
#include <fmt/format.h>
#include <string>

#include "core/nc/codes/handlers.h"
#include "core/nc/run/skipped_block.h"

namespace proveout {

namespace {

constexpr LetterSet kTargetWords("XYZ@^");
constexpr LetterSet kPolar("@^");
constexpr LetterSet kOtherAxes("ABCUVW");
constexpr LetterSet kArcLetters("IJKR");
constexpr LetterSet kCentreLetters("IJK");
constexpr LetterSet kOwnMeaning("FSTNO");
constexpr int kIncrementalTenths = 910; ///< G91
constexpr int kOrientation = 190;       ///< M19

class Planner {
public:
    Planner(Execution& execution, BlockPlan& plan)
        : m_execution(execution), m_block(execution.block), m_plan(plan),
          m_mWords(execution.block.ignoredCodes()), m_strange(execution.block.ignoredCodes() > 0) {}

    bool plan() {
        if (m_execution.dialect.mayRun != nullptr && !m_execution.dialect.mayRun(m_execution))
            return false;
        for (const Word& word : m_block.codes()) {
            if (!planCode(word))
                return false;
            if (m_allWords)
                return planWithArguments();
        }
        for (const Word& word : m_block.earlier())
            report(nc_message::kLastWordCounts, word, {writtenAs(word.letter)});
        for (const LetterRow& row : letters()) {
            if (row.handler != nullptr && m_block.has(row.letter))
                m_plan.add(row.step, row.handler, m_block.word(row.letter));
        }
        planRegisters();
        reportOtherAxes();
        return checkSpindle() && checkPolar() && planMotion() && checkUnused();
    }

private:
    bool planCode(const Word& word) {
        const CodeRow* row = m_execution.codes.find(word);
        if (word.letter == 'M' && ++m_mWords > m_execution.dialect.mostMWords)
            return refuse(nc_message::kTooManyM, word, {std::to_string(m_execution.dialect.mostMWords)});
        if (row == nullptr) {
            report(word.letter == 'M' ? nc_message::kUnknownMCode : nc_message::kUnknownCode, word,
                   {nameOf(word)});
            m_strange = true;
            m_unknownCode = true;
            return true;
        }
        const Word* rival = rivalOf(*row);
        const bool offTwice = row->group == ModalGroup::motionOff;
        if (rival != nullptr && !offTwice && !replaces(*row, *rival, word))
            return false;
        m_groups[static_cast<std::size_t>(row->group)] = &word;
        m_allWords = row->axisUse == AxisUse::allWords;
        if (row->group == ModalGroup::motion)
            m_motionRow = row;
        if (!row->supported())
            planUnsupported(*row, word);
        else if (row->axisUse != AxisUse::none && !m_allWords && !planAxisUse(*row, word))
            return false;
        else if (row->group != ModalGroup::motion && row->group != ModalGroup::motionOff)
            m_plan.add(row->step, row->handler, word, row->withCompensation);
        use(*row);
        return true;
    }

    /// A code that may not be in one block with this one. LinuxCNC has M70 to M73 in the group of the
    /// spindle, and M99 in that of the stops.
    [[nodiscard]] const Word* rivalOf(const CodeRow& row) const {
        if (const Word* same = groupWord(row.group))
            return same;
        if (row.group == ModalGroup::modalSave)
            return groupWord(ModalGroup::spindle);
        if (row.group == ModalGroup::spindle)
            return groupWord(ModalGroup::modalSave);
        if (row.handler == returnFromProgram)
            return groupWord(ModalGroup::stop);
        const Word* end = row.group == ModalGroup::stop ? groupWord(ModalGroup::subprogram) : nullptr;
        return end != nullptr && m_execution.codes.find(*end)->handler == returnFromProgram ? end : nullptr;
    }

    /// Whether a code replaces the earlier one of its group.
    bool replaces(const CodeRow& row, const Word& earlier, const Word& later) {
        if (!m_execution.dialect.lastWordCounts || row.group == ModalGroup::nonModal)
            return refuse(nc_message::kModalConflict, later, {nameOf(earlier), nameOf(later)});
        report(nc_message::kLastCounts, later, {nameOf(earlier), nameOf(later)});
        return true;
    }

    /// Every other word is an argument of the last code; a motion code before it takes effect.
    bool planWithArguments() {
        if (m_motionRow != nullptr && m_motionRow->supported())
            m_execution.state.motion = m_motionRow;
        return true;
    }

    /// A code that uses X and Y for the end of a motion uses polar words as well.
    void use(const CodeRow& row) {
        m_used.add(row.letters);
        if (row.step == Step::motion && row.letters.has('X'))
            m_used.add(kPolar);
    }

    void planUnsupported(const CodeRow& row, const Word& word) {
        report(nc_message::kUnsupportedCode, word, {nameOf(word), row.name});
        m_strange = true;
        if (row.axisUse == AxisUse::none)
            return;
        m_axesUsed = true;
        if (row.axisUse == AxisUse::allAxes && !m_block.letters().any(kTargetWords))
            forgetAxes(m_execution.state, kTargetWords, Forgotten::reported);
    }

    /// Plans a supported code that uses the axis words.
    bool planAxisUse(const CodeRow& row, const Word& word) {
        if (row.axisUse == AxisUse::machine) {
            m_machineWord = &word;
            m_execution.machineCoordinates = true;
        } else if (m_axisWord != nullptr) {
            return refuse(nc_message::kAxesTwice, word, {nameOf(*m_axisWord), nameOf(word)});
        } else {
            m_axisWord = &word;
        }
        if (row.group != ModalGroup::motion)
            m_plan.add(row.step, row.handler, word, row.withCompensation);
        return true;
    }

    /// H without G43 and D without G41 change the registers of the offsets in force.
    void planRegisters() {
        if (m_execution.dialect.vectors.used && m_block.has('D') && !m_used.has('D') &&
            m_groups[static_cast<std::size_t>(ModalGroup::cutterCompensation)] == nullptr) {
            m_plan.add(Step::cutterCompensation, changeRadiusRegister, m_block.word('D'));
            m_used.add(LetterSet("D"));
        }
        if (m_execution.dialect.registersNeedCode || m_execution.state.lengthSign == 0 || !m_block.has('H') ||
            m_used.has('H') || m_groups[static_cast<std::size_t>(ModalGroup::toolLength)] != nullptr)
            return;
        m_plan.add(Step::toolLength, changeRegister, m_block.word('H'));
        m_used.add(LetterSet("H"));
    }

    /// The machine has one spindle: 0, and -1 for all spindles.
    bool checkSpindle() {
        if (!m_block.has(kSpindleLetter))
            return true;
        if (m_block.has('S'))
            m_used.add(LetterSet("_"));
        const Word& word = m_block.word(kSpindleLetter);
        const double number = std::trunc(word.value);
        const bool inStep = m_motionRow != nullptr &&
                            (m_motionRow->handler == moveInStep || m_motionRow->handler == tapRigidly);
        const bool ofOne = inStep || groupWord(ModalGroup::spindleMode) != nullptr ||
                           groupIs(ModalGroup::spindle, kOrientation);
        return number == 0 || (number == -1 && !ofOne) ||
               refuse(nc_message::kSpindleNumber, word, {fmt::format("{:g}", number)});
    }

    /// The plane that was in force before the block applies.
    bool checkPolar() {
        if (!m_block.letters().any(kPolar))
            return true;
        const Word& word = m_block.word(m_block.has('@') ? '@' : '^');
        if (m_execution.state.plane != Plane::xy)
            return refuse(nc_message::kPlaneXyOnly, word, {std::string(1, word.letter)});
        return !m_block.letters().any(LetterSet("XY")) || refuse(nc_message::kPolarMixed, firstAxisWord());
    }

    void reportOtherAxes() {
        LetterSet others = kOtherAxes;
        // Fanuc's dwell time is given by any of X, U and P.
        if (m_axisWord != nullptr && m_execution.codes.find(*m_axisWord)->step == Step::dwell)
            others.remove(LetterSet("U"));
        // Mach's rotation has its centre at A and B.
        if (m_axisWord != nullptr && m_execution.codes.find(*m_axisWord)->step == Step::rotation)
            others.remove(LetterSet("AB"));
        if (!m_block.letters().any(others))
            return;
        for (const LetterRow& row : letters()) {
            if (others.has(row.letter) && m_block.has(row.letter))
                report(nc_message::kAxisUnsupported, m_block.word(row.letter), {std::string(1, row.letter)});
        }
        m_used.add(kOtherAxes);
    }

    /// The motion is that of this block, or the one in force if the block has axis words.
    bool planMotion() {
        MachineState& state = m_execution.state;
        const bool named = m_block.letters().any(kTargetWords);
        if (m_axisWord != nullptr && !m_axesUsed && !m_unknownCode)
            return planWithoutMotion(named);
        if (m_motionRow == nullptr && m_machineWord != nullptr && isLost(state.motion))
            return planMotionInForce();
        if (m_machineWord != nullptr && !checkMachineMotion())
            return false;
        if (m_motionRow != nullptr && m_motionRow->handler == nullptr)
            state.motion = m_motionRow;
        if (m_axesUsed || (m_unknownCode && m_motionRow == nullptr)) {
            forgetNamedAxes();
            // "G53 G0 Z0": G0 stays in force, but this block moves to machine coordinates.
            if (m_motionRow != nullptr)
                state.motion = m_motionRow;
            return true;
        }
        if (m_motionRow != nullptr) {
            m_plan.add(Step::motion, m_motionRow->handler, *groupWord(ModalGroup::motion),
                       m_motionRow->withCompensation);
            state.motion = m_motionRow;
            return true;
        }
        if (m_groups[static_cast<std::size_t>(ModalGroup::motionOff)] != nullptr)
            return planMotionOff(named);
        const bool arc = state.motion != nullptr && state.motion->letters.any(kArcLetters);
        const LetterSet own = m_execution.dialect.radiusWins ? kArcLetters : kCentreLetters;
        if (!named && !(arc && m_block.letters().any(own)))
            return true;
        return planMotionInForce();
    }

    /// The axis words belong to a code that is not a motion.
    bool planWithoutMotion(bool named) {
        if (m_motionRow == nullptr)
            return true;
        const Word& motion = *groupWord(ModalGroup::motion);
        // "G0 G28 Z0": if the last of two codes counts, the motion code applies to later blocks. Otherwise
        // G28 and similar codes do not permit a motion code, with or without axis words.
        const bool both = named || m_execution.codes.find(*m_axisWord)->step == Step::nonModal;
        if (both && !m_execution.dialect.lastWordCounts)
            return refuse(nc_message::kAxesTwice, motion, {nameOf(*m_axisWord), nameOf(motion)});
        m_execution.state.motion = m_motionRow;
        return true;
    }

    bool checkMachineMotion() {
        const bool named = m_block.letters().any(kTargetWords);
        // LinuxCNC considers the code in force only if there are axis words for it.
        const bool inForce = named || !m_execution.dialect.refusesIdleG53;
        const CodeRow* row = m_motionRow != nullptr ? m_motionRow
                             : inForce              ? m_execution.state.motion
                                                    : nullptr;
        const bool straight = row != nullptr && (row->handler == moveRapid || row->handler == moveFeed);
        if (!straight)
            return refuse(nc_message::kMachineMotion, *m_machineWord);
        if (m_block.letters().any(kPolar))
            return refuse(nc_message::kMachinePolar, *m_machineWord);
        const bool incremental = groupWord(ModalGroup::distance) != nullptr
                                     ? groupIs(ModalGroup::distance, kIncrementalTenths)
                                     : m_execution.state.incremental;
        if (incremental && !m_execution.dialect.machineIsAbsolute)
            return refuse(nc_message::kMachineIncremental, *m_machineWord);
        return true;
    }

    [[nodiscard]] bool groupIs(ModalGroup group, int tenths) const {
        const Word* word = m_groups[static_cast<std::size_t>(group)];
        return word != nullptr && m_execution.codes.find(*word)->tenths == tenths;
    }

    bool planMotionOff(bool named) {
        if (m_execution.dialect.rapidAfterG80)
            return planRapidAfterG80(named);
        if (named)
            return refuse(nc_message::kG80WithAxis, firstAxisWord(),
                          {std::string(1, firstAxisWord().letter)});
        m_execution.state.motion = nullptr;
        return true;
    }

    bool planRapidAfterG80(bool named) {
        constexpr int kRapid = 0;
        m_execution.state.motion = m_execution.codes.find('G', kRapid);
        if (!named)
            return true;
        report(nc_message::kRapidAfterG80, firstAxisWord(), {std::string(1, firstAxisWord().letter)});
        return planMotionInForce();
    }

    bool planMotionInForce() {
        const CodeRow* row = m_execution.state.motion;
        if (row == nullptr)
            return refuse(nc_message::kAxisWithoutMotion, firstAxisWord(),
                          {std::string(1, firstAxisWord().letter)});
        if (row->supported()) {
            m_plan.add(Step::motion, row->handler, firstMotionWord(), row->withCompensation);
            use(*row);
        } else {
            // Reported at its word; every such block moves the axes to unknown positions.
            m_strange = true;
            forgetNamedAxes();
        }
        return true;
    }

    /// LinuxCNC refuses a word that nothing in the block uses; it may be a typing error for a word that
    /// moves.
    bool checkUnused() {
        LetterSet unused = m_block.letters();
        unused.remove(m_used);
        unused.remove(kOwnMeaning);
        if (m_strange || unused.empty())
            return true;
        for (const LetterRow& row : letters()) {
            if (!unused.has(row.letter))
                continue;
            const Word& word = m_block.word(row.letter);
            if (m_execution.dialect.refusesUnused)
                return refuse(nc_message::kWordUnused, word, {writtenAs(row.letter)});
            report(nc_message::kWordIgnored, word, {writtenAs(row.letter)});
        }
        return true;
    }

    void forgetNamedAxes() { forgetAxes(m_execution.state, m_block.letters(), Forgotten::reported); }

    [[nodiscard]] const Word* groupWord(ModalGroup group) const {
        return m_groups[static_cast<std::size_t>(group)];
    }
    [[nodiscard]] const Word& firstAxisWord() const {
        for (const char letter : {'X', 'Y', 'Z', '@', '^'}) {
            if (m_block.has(letter))
                return m_block.word(letter);
        }
        return m_block.word('X');
    }
    [[nodiscard]] const Word& firstMotionWord() const {
        for (const char letter : {'X', 'Y', 'Z', '@', '^', 'I', 'J', 'K', 'R'}) {
            if (m_block.has(letter))
                return m_block.word(letter);
        }
        return m_block.word('X');
    }

    void report(const FindingRow& message, const Word& word, std::vector<Argument> arguments = {}) {
        m_execution.reporter.report(message, word, std::move(arguments));
    }
    bool refuse(const FindingRow& message, const Word& word, std::vector<Argument> arguments = {}) {
        report(message, word, std::move(arguments));
        return false;
    }

    Execution& m_execution;
    const Block& m_block;
    BlockPlan& m_plan;
    std::array<const Word*, static_cast<std::size_t>(ModalGroup::count)> m_groups{};
    const CodeRow* m_motionRow = nullptr;
    LetterSet m_used;
    int m_mWords;
    bool m_allWords = false;    ///< G65: the words after it are its arguments
    bool m_strange;             ///< something in the block is not supported, so other words may belong to it
    bool m_unknownCode = false; ///< it may use the axis words, unless a motion code does
    bool m_axesUsed = false;    ///< by a code that is not supported
    const Word* m_axisWord = nullptr;    ///< a supported code that uses the axis words itself
    const Word* m_machineWord = nullptr; ///< G53
};

bool isRefused(WithCompensation with, const CutterCompensation& compensation) {
    if (with == WithCompensation::refusedBeside && compensation.leaving())
        return true;
    return with != WithCompensation::allowed && compensation.on;
}

} // namespace

void BlockPlan::run(Execution& execution) const {
    for (std::uint64_t rest = m_present; rest != 0; rest &= rest - 1) {
        const Order& order = m_orders[static_cast<std::size_t>(std::countr_zero(rest))];
        // Checked only now, because G40 of the same block comes first.
        if (isRefused(order.withCompensation, execution.state.compensation))
            execution.reporter.report(nc_message::kCompensationForbids, *order.word, {nameOf(*order.word)});
        else
            order.handler(execution, *order.word);
    }
}

bool makePlan(Execution& execution, BlockPlan& plan) {
    return Planner(execution, plan).plan();
}

} // namespace proveout
