// SPDX-License-Identifier: GPL-3.0-or-later
// Tool lengths: G43 and similar codes. The machine does not move; the position of its tip changes.
#include <cmath>
#include <string>

#include "core/nc/codes/handlers.h"
#include "core/nc/handlers/offset_setting.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

constexpr int kLargestOffset = 99999;

/// The tool of the H word, or the one in the spindle; null, with a report, if the control does not know it.
const ToolOffset* offsetAsked(Execution& execution, const Word& word) {
    const bool given = execution.block.has('H');
    const Word& number = given ? execution.block.word('H') : word;
    // H0 means the tool in the spindle.
    const double whole = given && number.value != 0 ? number.value : execution.state.tool;
    if (whole < 0 || whole != std::round(whole) || whole > kLargestOffset) {
        execution.reporter.report(nc_message::kNotInteger, number,
                                  {"H", "0", std::to_string(kLargestOffset)});
        return nullptr;
    }
    const ToolOffset* offset = execution.tools.find(static_cast<int>(whole));
    if (offset == nullptr)
        execution.reporter.report(nc_message::kOffsetUnknown, number,
                                  {std::to_string(static_cast<int>(whole))});
    return offset;
}

/// The offsets that the axis words of the block give.
Vec3 offsetsGiven(const Execution& execution, Vec3 offset) {
    for (int axis = 0; axis < 3; ++axis) {
        const char letter = static_cast<char>('X' + axis);
        if (execution.block.has(letter))
            offset[axis] = execution.length(letter);
    }
    return offset;
}

} // namespace

void setToolOffset(Execution& execution, const Vec3& offset) {
    MachineState& state = execution.state;
    state.position -= offset - state.toolOffset;
    state.toolOffset = offset;
    execution.program.append(ToolLengthOffset{offset}, execution.line);
}

namespace {

void useLength(Execution& execution, const Word& word, int sign) {
    const ToolOffset* offset = offsetAsked(execution, word);
    if (offset == nullptr)
        return;
    setToolOffset(execution, static_cast<double>(sign) * offset->offset);
    execution.state.lengthSign = sign;
}

} // namespace

void useToolLength(Execution& execution, const Word& word) {
    useLength(execution, word, 1);
}

void subtractToolLength(Execution& execution, const Word& word) {
    useLength(execution, word, -1);
}

void useGivenLength(Execution& execution, const Word& word) {
    if (!execution.block.letters().any(kAxisWords)) {
        execution.reporter.report(nc_message::kWordMissing, word, {"G43.1", "Z"});
        return;
    }
    setToolOffset(execution, offsetsGiven(execution, execution.state.toolOffset));
    execution.state.lengthSign = 1;
}

void addToolLength(Execution& execution, const Word& word) {
    Vec3 more(0);
    const bool axes = execution.block.letters().any(kAxisWords);
    if (axes && execution.block.has('H')) {
        execution.reporter.report(nc_message::kLengthTwice, word);
        return;
    }
    if (!axes && !execution.block.has('H')) {
        execution.reporter.report(nc_message::kWordMissing, word, {"G43.2", "H"});
        return;
    }
    if (axes) {
        more = offsetsGiven(execution, more);
    } else if (const ToolOffset* offset = offsetAsked(execution, word)) {
        more = offset->offset;
    }
    setToolOffset(execution, execution.state.toolOffset + more);
    execution.state.lengthSign = 1;
}

void cancelToolLength(Execution& execution, const Word& /*word*/) {
    setToolOffset(execution, Vec3(0));
    execution.state.lengthSign = 0;
}

} // namespace proveout
