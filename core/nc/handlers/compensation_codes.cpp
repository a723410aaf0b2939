// SPDX-License-Identifier: GPL-3.0-or-later
// Cutter compensation on and off: G40 to G42.1.
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>

#include "core/nc/codes/handlers.h"
#include "core/nc/motions/compensated_path.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

constexpr double kLeft = 1;
constexpr double kRight = -1;
constexpr int kLargestRegister = 99999;

bool mayBegin(Execution& execution, const Word& word) {
    const MachineState& state = execution.state;
    if (state.compensation.on)
        execution.reporter.report(nc_message::kCompensationOnAlready, word, {nameOf(word)});
    else if (state.plane == Plane::yz)
        execution.reporter.report(nc_message::kCompensationPlane, word);
    else if ((state.plane != Plane::xy && state.frame.rotation != 0) ||
             !state.frame.transformation.keepsPlane(state.plane))
        execution.reporter.report(nc_message::kCompensationTurned, word);
    else
        return true;
    return false;
}

void begin(Execution& execution, const Word& word, double offset, bool assumed = false) {
    CutterCompensation& compensation = execution.state.compensation;
    compensation.on = true;
    compensation.side = std::signbit(offset) ? kRight : kLeft;
    compensation.offset = offset;
    compensation.assumed = assumed;
    if (offset == 0) {
        execution.reporter.report(execution.tools.given() || execution.block.has('D')
                                      ? nc_message::kCompensationNoDiameter
                                      : nc_message::kCompensationDiameterUnknown,
                                  word, {nameOf(word)});
    }
}

/// The tool that the D word names, or the one in the spindle; null, with a report, if there is none.
const ToolOffset* toolAsked(Execution& execution, const Word& word) {
    double number = execution.state.tool;
    if (execution.block.has('D') && execution.block.value('D') != 0)
        number = execution.block.value('D');
    const Word& where = execution.block.has('D') ? execution.block.word('D') : word;
    if (number < 0 || number != std::round(number) || number > kLargestRegister) {
        execution.reporter.report(nc_message::kNotInteger, where,
                                  {"D", "0", std::to_string(kLargestRegister)});
        return nullptr;
    }
    const ToolOffset* tool = execution.tools.find(static_cast<int>(number));
    if (tool == nullptr)
        execution.reporter.report(nc_message::kOffsetUnknown, where,
                                  {std::to_string(static_cast<int>(number))});
    return tool;
}

void compensateForTool(Execution& execution, const Word& word, double side) {
    if (!mayBegin(execution, word))
        return;
    if (const ToolOffset* tool = toolAsked(execution, word))
        begin(execution, word, side * tool->diameter / 2, tool->assumed);
}

void compensateForDiameter(Execution& execution, const Word& word, double side) {
    if (!mayBegin(execution, word))
        return;
    if (execution.block.has('D'))
        begin(execution, word, side * execution.length('D') / 2);
    else
        execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "D"});
}

} // namespace

void endCompensation(Execution& execution, const Word& word) {
    finishCompensated(execution, word);
    const CutterCompensation& ended = execution.state.compensation;
    const Vec3 displacement = ended.displacement;
    execution.state.straightDue =
        execution.state.straightDue || (execution.dialect.straightFirst && ended.moves() && ended.entered);
    execution.state.compensation = {};
    execution.state.compensation.displacement = displacement;
}

void compensateLeft(Execution& execution, const Word& word) {
    compensateForTool(execution, word, kLeft);
}

void compensateRight(Execution& execution, const Word& word) {
    compensateForTool(execution, word, kRight);
}

void compensateLeftByDiameter(Execution& execution, const Word& word) {
    compensateForDiameter(execution, word, kLeft);
}

void compensateRightByDiameter(Execution& execution, const Word& word) {
    compensateForDiameter(execution, word, kRight);
}

} // namespace proveout
