// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/lint.h"

#include <algorithm>

#include "core/nc/codes/canned_cycle.h"
#include "core/nc/run/lint_rules.h"

namespace proveout {

namespace {

using enum LintMoment;
using namespace nc_message;

constexpr LintRule kRules[] = {
    {&kNoFeed, elsewhere, nullptr},
    {&kInverseTimeFeed, elsewhere, nullptr},
    {&kCompensationAtEnd, elsewhere, nullptr},
    {&kMainReturn, elsewhere, nullptr},
    {&kAfterEnd, elsewhere, nullptr},
    {&kUnreachable, elsewhere, nullptr},
    {&kBlockTwice, elsewhere, nullptr},
    {&kToolNotInTable, toolWord, lint::toolNotInTable},
    {&kFeedZero, feedWord, lint::feedZero},
    {&kLengthMissing, firstCut, lint::lengthMissing},
    {&kOffsetNeverChosen, firstCut, lint::offsetNeverChosen},
    {&kLengthOfOtherTool, block, lint::lengthOfOtherTool},
    {&kDiameterMissing, block, lint::diameterMissing},
    {&kCompensationOnArc, block, lint::compensationOnArc},
    {&kUnitsMixed, block, lint::unitsMixed},
    {&kLeftOn, toolChange, lint::leftOn},
    {&kLeftOn, end, lint::leftOn},
    {&kChangeLow, toolChange, lint::changeLow},
    {&kChangeTurning, toolChange, lint::changeTurning},
    {&kNoPoint, lengths, lint::noPoint},
    {&kNearlyHalfCircle, arcByRadius, lint::nearlyHalfCircle},
};

void run(LintMoment moment, const LintView& view) {
    for (const LintRule& rule : kRules) {
        if (rule.moment == moment)
            rule.check(view, *rule.message);
    }
}

bool feeds(const CodeRow* row) {
    constexpr int kRapid = 0;
    return row != nullptr && row->tenths != kRapid;
}

std::uint64_t groupsOf(const Execution& execution) {
    std::uint64_t groups = 0;
    for (const Word& word : execution.block.codes()) {
        if (const CodeRow* row = execution.codes.find(word))
            groups |= std::uint64_t{1} << static_cast<unsigned>(row->group);
    }
    return groups;
}

} // namespace

std::span<const LintRule> lintRules() {
    return kRules;
}

void lintBlock(LintView view) {
    constexpr std::uint64_t kMotionAlone = std::uint64_t{1} << static_cast<unsigned>(ModalGroup::motion);
    view.groups = groupsOf(view.execution);
    const Block& block = view.execution.block;
    const MachineState& state = view.execution.state;
    LintMemory& memory = view.memory;
    const bool moved = view.execution.program.motionCount() > view.firstMotion;
    // The tool is changed before anything moves.
    if (lint::changesTool(view)) {
        run(toolChange, view);
        ++memory.toolChanges;
        memory.lengthChosen = memory.cut = false;
        memory.highestFeed = -std::numeric_limits<double>::infinity();
    }
    if (block.has('F'))
        run(feedWord, view);
    if (block.has('T'))
        run(toolWord, view);
    // Motions without a cutter are reported by the simulation.
    if (moved && !memory.missingTools.empty())
        memory.missingTools.erase(state.tool);
    if (view.execution.dialect.leastMm != 1)
        run(lengths, view);
    if ((view.groups & ~kMotionAlone) != 0 || memory.compensationBegins) {
        lint::remember(view);
        run(LintMoment::block, view);
    }
    if (moved && feeds(state.motion)) {
        memory.highestFeed = std::max(memory.highestFeed, state.position.z);
        if (!memory.cut)
            run(firstCut, view);
        memory.cut = true;
        if (block.has('R'))
            run(arcByRadius, view);
    }
}

void lintEnd(const LintView& view) {
    run(end, view);
}

} // namespace proveout
