// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>

#include "core/base/figures_argument.h"
#include "core/base/tool_number.h"
#include "core/nc/codes/handlers.h"
#include "core/nc/motions/compensated_path.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

bool reportNegative(Execution& execution, const Word& word) {
    if (word.value >= 0)
        return false;
    execution.reporter.report(nc_message::kNegative, word, {std::string(1, word.letter)});
    return true;
}

void switchCoolant(Execution& execution, Coolant coolant, bool on) {
    bool& state = coolant == Coolant::mist ? execution.state.mist : execution.state.flood;
    if (state == on)
        return;
    state = on;
    execution.program.append(CoolantSwitch{coolant, on}, execution.line);
}

/// A feed of one mode has no meaning in another. On LinuxCNC, G94 without F requires a new one in any case.
void setFeedMode(Execution& execution, FeedMode mode) {
    const bool again = execution.dialect.feedModeEndsFeed && mode != FeedMode::inverseTime;
    if (execution.state.feedMode == mode && !again)
        return;
    execution.state.feedMode = mode;
    execution.state.feed = 0;
    // LinuxCNC keeps the number when G93 begins.
    if (mode != FeedMode::inverseTime)
        execution.state.feedNumber = 0;
}

/// The number of a tool; nothing, with a report, if it is invalid.
std::optional<int> toolNumber(Execution& execution, const Word& word) {
    const bool whole = std::abs(word.value - std::round(word.value)) < 1e-4;
    if (whole && word.value >= 0 && word.value <= kLargestTool)
        return static_cast<int>(std::lround(word.value));
    execution.reporter.report(nc_message::kNotInteger, word,
                              {std::string(1, word.letter), "0", std::to_string(kLargestTool)});
    return {};
}

} // namespace

void reportDwellUnit(Execution& execution, const Word& time) {
    constexpr double kMillisecond = 1e-3;
    if (!execution.dialect.dwellUnitOpen || execution.state.dwellUnitReported || time.value == 0)
        return;
    execution.state.dwellUnitReported = true;
    execution.reporter.report(
        nc_message::kDwellUnit, time,
        {nameOf(time), figures("{:g}", time.value), figures("{:g}", time.value * kMillisecond)});
}

void dwell(Execution& execution, const Word& word) {
    if (!execution.block.has('P')) {
        execution.reporter.report(nc_message::kWordMissing, word, {"G4", "P"});
        return;
    }
    const Word& seconds = execution.block.word('P');
    if (reportNegative(execution, seconds))
        return;
    reportDwellUnit(execution, seconds);
    execution.program.append(Dwell{seconds.value}, execution.line);
}

void dwellByLetter(Execution& execution, const Word& /*word*/) {
    constexpr double kMillisecond = 1e-3;
    const Dialect& dialect = execution.dialect;
    for (const char letter : {'X', 'U', 'P'}) {
        if (!execution.block.has(letter))
            continue;
        const Word& time = execution.block.word(letter);
        const bool seconds = time.point && (letter != 'P' || dialect.pointMeansSeconds);
        if (!reportNegative(execution, time))
            execution.program.append(Dwell{seconds ? time.value : time.value * kMillisecond}, execution.line);
        return;
    }
}

void orderRigidTapping(Execution& execution, const Word& /*word*/) {
    execution.state.rigidTapping = true;
    execution.state.spindleDirection = 0;
}

void setFeed(Execution& execution, const Word& word) {
    if (reportNegative(execution, word))
        return;
    MachineState& state = execution.state;
    state.feedNumber = word.value;
    state.feed = state.feedMode == FeedMode::inverseTime ? word.value : state.toMm(word.value);
    state.missingFeedReported = false;
}

void feedInverseTime(Execution& execution, const Word& /*word*/) {
    setFeedMode(execution, FeedMode::inverseTime);
}

void feedPerMinute(Execution& execution, const Word& /*word*/) {
    setFeedMode(execution, FeedMode::perMinute);
}

void feedPerRevolution(Execution& execution, const Word& /*word*/) {
    setFeedMode(execution, FeedMode::perRevolution);
}

void setSpindleSpeed(Execution& execution, const Word& word) {
    if (!reportNegative(execution, word))
        execution.state.spindleRpm = word.value;
}

void keepSurfaceSpeed(Execution& execution, const Word& word) {
    const Block& block = execution.block;
    if (!block.has('S')) {
        execution.reporter.report(nc_message::kWordMissing, word, {"G96", "S"});
        return;
    }
    execution.state.surfaceSpeed = true;
    execution.state.mostRpm = block.has('D') ? std::abs(block.value('D')) : 0;
    if (execution.state.mostRpm > 0) {
        execution.reporter.report(nc_message::kSurfaceSpeedLimited, word,
                                  {figures("{:g}", execution.state.mostRpm)});
    } else {
        execution.reporter.report(nc_message::kSurfaceSpeedUnknown, word);
    }
}

void keepSpindleSpeed(Execution& execution, const Word& /*word*/) {
    execution.state.surfaceSpeed = false;
}

void selectTool(Execution& execution, const Word& word) {
    const auto number = toolNumber(execution, word);
    if (!number)
        return;
    const MachineState& state = execution.state;
    const int present = state.selectedTool < 0 ? state.tool : state.selectedTool;
    if (!execution.dialect.changesTools && *number != 0 && *number != present) // T0 does not name a tool
        execution.reporter.report(nc_message::kToolNotChanged, word, {std::to_string(*number)});
    execution.state.selectedTool = *number;
}

void setToolNumber(Execution& execution, const Word& word) {
    if (!execution.block.has('Q')) {
        execution.reporter.report(nc_message::kWordMissing, word, {"M61", "Q"});
        return;
    }
    if (const auto number = toolNumber(execution, execution.block.word('Q'))) {
        execution.state.tool = *number;
        execution.program.append(ToolChange{*number, true}, execution.line);
    }
}

void changeTool(Execution& execution, const Word& word) {
    if (execution.state.selectedTool < 0) {
        execution.reporter.report(nc_message::kNoToolSelected, word);
        return;
    }
    execution.state.tool = execution.state.selectedTool;
    // A tool change stops the spindle; M3 or M4 must follow.
    execution.state.spindleDirection = 0;
    execution.program.append(ToolChange{execution.state.tool}, execution.line);
}

void turnSpindleClockwise(Execution& execution, const Word& /*word*/) {
    execution.state.spindleDirection = 1;
}

void turnSpindleCounterClockwise(Execution& execution, const Word& /*word*/) {
    execution.state.spindleDirection = -1;
}

void stopSpindle(Execution& execution, const Word& /*word*/) {
    execution.state.spindleDirection = 0;
}

void switchMistOn(Execution& execution, const Word& /*word*/) {
    switchCoolant(execution, Coolant::mist, true);
}

void switchFloodOn(Execution& execution, const Word& /*word*/) {
    switchCoolant(execution, Coolant::flood, true);
}

void switchCoolantOff(Execution& execution, const Word& /*word*/) {
    switchCoolant(execution, Coolant::mist, false);
    switchCoolant(execution, Coolant::flood, false);
}

void stopProgram(Execution& execution, const Word& word) {
    finishCompensated(execution, word);
    execution.program.append(ProgramStop{StopKind::program}, execution.line);
}

void stopProgramOptionally(Execution& execution, const Word& word) {
    finishCompensated(execution, word);
    execution.program.append(ProgramStop{StopKind::optional}, execution.line);
}

void changePallet(Execution& execution, const Word& word) {
    finishCompensated(execution, word);
    execution.program.append(ProgramStop{StopKind::palletChange}, execution.line);
}

void endProgram(Execution& execution, const Word& word) {
    finishCompensated(execution, word);
    execution.program.append(ProgramEnd{}, execution.line);
    execution.state.ended = true;
}

} // namespace proveout
