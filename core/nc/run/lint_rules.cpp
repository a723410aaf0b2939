// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/lint_rules.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <string>

#include "core/base/figures_argument.h"
#include "core/nc/codes/canned_cycle.h"
#include "core/nc/state/active_codes.h"

namespace proveout::lint {

namespace {

constexpr double kNearlyHalf = 0.5; ///< degrees from 180; there the centre moves far with the last digit

/// The word of a code in the block; null if it has none.
const Word* find(const LintView& view, char letter, int tenths) {
    for (const Word& word : view.execution.block.codes()) {
        if (word.letter == letter && std::lround(word.value * 10) == tenths)
            return &word;
    }
    return nullptr;
}

const Word* findGroup(const LintView& view, ModalGroup group) {
    if (!view.has(group))
        return nullptr;
    for (const Word& word : view.execution.block.codes()) {
        const CodeRow* row = view.execution.codes.find(word);
        if (row != nullptr && row->group == group)
            return &word;
    }
    return nullptr;
}

void report(const LintView& view, const FindingRow& message, const Word& word,
            std::vector<Argument> arguments = {}) {
    view.execution.reporter.report(message, word, std::move(arguments));
}

/// The word that a message about the whole block points to.
Word anyWord(const LintView& view) {
    const Block& block = view.execution.block;
    if (!block.codes().empty())
        return block.codes().front();
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
        if (block.has(letter))
            return block.word(letter);
    }
    return {'%', 0, 1, 0};
}

bool moved(const LintView& view) {
    return view.execution.program.motionCount() > view.firstMotion;
}

void add(std::string& list, const std::string& name) {
    list += (list.empty() ? "" : ", ") + name;
}

/// The codes in force that should be off at a tool change or at the end of a program.
std::string codesLeftOn(const MachineState& state, const Dialect& dialect) {
    // The codes in force when these are off.
    constexpr std::array kOff{900, 170, 150, 501, 500, 690};
    constexpr std::array kGroups{ModalGroup::distance,  ModalGroup::plane,   ModalGroup::polar,
                                 ModalGroup::mirroring, ModalGroup::scaling, ModalGroup::rotation};
    std::string codes;
    for (std::size_t i = 0; i < kGroups.size(); ++i) {
        const int code = activeCode(state, kGroups[i], dialect);
        if (code != kOff[i])
            add(codes, fmt::format("G{:g}", code / 10.0));
    }
    if (state.frame.shift != Vec3(0))
        add(codes, "G52 / G92");
    if (isCycle(state.motion))
        add(codes, fmt::format("G{:g}", state.motion->tenths / 10.0));
    return codes;
}

} // namespace

void remember(const LintView& view) {
    LintMemory& memory = view.memory;
    memory.offsetChosen = memory.offsetChosen || findGroup(view, ModalGroup::workOffset) != nullptr;
    memory.lengthChosen = memory.lengthChosen || findGroup(view, ModalGroup::toolLength) != nullptr;
    const MachineState& state = view.execution.state;
    if (state.compensation.on && !view.before.compensation.on)
        memory.compensationBegins = true;
}

bool changesTool(const LintView& view) {
    constexpr int kM6 = 60;
    return view.has(ModalGroup::toolChange) && find(view, 'M', kM6) != nullptr;
}

/// Only records it: the simulation reports that a tool that moves has no cutter.
void toolNotInTable(const LintView& view, const FindingRow& /*message*/) {
    ToolOffsets& tools = view.execution.tools;
    const int tool = view.execution.state.selectedTool;
    if (tools.given() && tool > 0 && tools.find(tool) == nullptr)
        view.memory.missingTools.try_emplace(
            tool, LintMemory::Selected{view.execution.line, view.execution.block.word('T')});
}

void feedZero(const LintView& view, const FindingRow& message) {
    if (view.execution.block.value('F') == 0)
        report(view, message, view.execution.block.word('F'));
}

void lengthMissing(const LintView& view, const FindingRow& message) {
    // A machine for LinuxCNC that is zeroed with its only tool needs none.
    const int needed = view.execution.dialect.macros == MacroLanguage::macroB ? 1 : 2;
    if (view.memory.toolChanges >= needed && !view.memory.lengthChosen)
        report(view, message, anyWord(view), {std::to_string(view.execution.state.tool)});
}

void offsetNeverChosen(const LintView& view, const FindingRow& message) {
    // Programs for LinuxCNC and similar controls seldom name the offset that is in force at the start.
    if (!view.memory.offsetChosen && view.execution.dialect.macros == MacroLanguage::macroB)
        report(view, message, anyWord(view));
    view.memory.offsetChosen = true;
}

void lengthOfOtherTool(const LintView& view, const FindingRow& message) {
    const Block& block = view.execution.block;
    if (findGroup(view, ModalGroup::toolLength) == nullptr || !block.has('H'))
        return;
    const int tool = view.execution.state.tool;
    const double number = block.value('H');
    if (tool > 0 && number != 0 && number != tool)
        report(view, message, block.word('H'), {fmt::format("{:g}", number), std::to_string(tool)});
}

void diameterMissing(const LintView& view, const FindingRow& message) {
    const Word* word = findGroup(view, ModalGroup::cutterCompensation);
    constexpr double kG40 = 40;
    const bool registers = view.execution.dialect.macros == MacroLanguage::macroB;
    if (registers && word != nullptr && word->value != kG40 && !view.execution.block.has('D') &&
        !view.before.compensation.on)
        report(view, message, *word, {fmt::format("G{:g}", word->value)});
}

void compensationOnArc(const LintView& view, const FindingRow& message) {
    if (!view.memory.compensationBegins || !moved(view))
        return;
    view.memory.compensationBegins = false;
    if (view.execution.program.motion(view.firstMotion).kind == MotionKind::arc)
        report(view, message, anyWord(view));
}

void unitsMixed(const LintView& view, const FindingRow& message) {
    const Word* word = findGroup(view, ModalGroup::units);
    LintMemory& memory = view.memory;
    if (word != nullptr && view.before.inch != view.execution.state.inch && memory.cut &&
        !memory.unitsReported) {
        memory.unitsReported = true;
        report(view, message, *word, {fmt::format("G{:g}", word->value)});
    }
}

void leftOn(const LintView& view, const FindingRow& message) {
    const std::string codes = codesLeftOn(view.before, view.execution.dialect);
    if (!codes.empty())
        report(view, message, anyWord(view), {codes});
}

void changeLow(const LintView& view, const FindingRow& message) {
    const MachineState& state = view.before;
    if (!view.memory.cut || state.zAtReference || (state.known & kAxisZ) == 0)
        return;
    if (state.position.z <= view.memory.highestFeed)
        report(view, message, anyWord(view),
               {figures("{:.4g}", state.position.z), figures("{:.4g}", view.memory.highestFeed)});
}

void changeTurning(const LintView& view, const FindingRow& message) {
    if (view.before.spindleDirection != 0)
        report(view, message, anyWord(view));
}

void noPoint(const LintView& view, const FindingRow& message) {
    const Block& block = view.execution.block;
    for (const char letter : {'X', 'Y', 'Z', 'I', 'J', 'K', 'Q', 'R'}) {
        if (!block.has(letter) || view.memory.pointReported.has(letter))
            continue;
        const Word& word = block.word(letter);
        // K is the number of repeats in a cycle, and the words of a macro have their own meaning.
        const bool count = letter == 'K' && isCycle(view.execution.state.motion);
        if (word.point || word.value == 0 || count || findGroup(view, ModalGroup::macroCall) != nullptr)
            continue;
        view.memory.pointReported.add(letter);
        const MachineState& state = view.execution.state;
        const double least = state.inch ? view.execution.dialect.leastInch : view.execution.dialect.leastMm;
        const char* const unit = state.inch ? "in" : "mm";
        report(view, message, word,
               {fmt::format("{}{:g}", letter, word.value), figures("{:g} {}", word.value * least, unit),
                figures("{:g} {}", word.value, unit)});
    }
}

void nearlyHalfCircle(const LintView& view, const FindingRow& message) {
    const Program& program = view.execution.program;
    const Motion motion = program.motion(program.motionCount() - 1);
    if (motion.kind != MotionKind::arc)
        return;
    const double degrees = std::abs(motion.sweep) * 180 / std::numbers::pi;
    if (std::abs(degrees - 180) < kNearlyHalf)
        report(view, message, view.execution.block.word('R'), {figures("{:.2f}", degrees)});
}

} // namespace proveout::lint
