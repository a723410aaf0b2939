// SPDX-License-Identifier: GPL-3.0-or-later
// Work offsets, shifts and tool lengths: the difference between program and machine coordinates. A change
// does not move the machine; its program coordinates change.
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>

#include "core/base/tool_number.h"
#include "core/nc/codes/handlers.h"
#include "core/nc/handlers/offset_setting.h"
#include "core/nc/state/execution.h"
#include "core/nc/state/offset_parameters.h"

namespace proveout {

namespace {

constexpr int kG54 = 540;
constexpr int kG59 = 590;
constexpr int kSixth = 6; ///< G59; G59.1 to G59.3 follow

// Meanings of the L word of G10.
constexpr int kToolItself = 1;
constexpr int kOffsetItself = 2;
constexpr int kToolHere = 10;      ///< as if the tool touched these coordinates now
constexpr int kToolInFixture = 11; ///< the same in the coordinates of G59.3
constexpr int kOffsetHere = 20;

void setFrame(Execution& execution, const WorkFrame& frame) {
    MachineState& state = execution.state;
    if (frame == state.frame)
        return;
    state.frame = frame;
    execution.program.append(WorkOffset{state.workOffset, frame.zero()}, execution.line);
}

WorkFrame frameOf(const Execution& execution, int system) {
    WorkFrame frame = execution.state.frame;
    frame.offset = vectorAt(execution.parameters, offsetParameter(system));
    frame.rotation = execution.parameters.numbered(offsetParameter(system) + kRotationParameter);
    return frame;
}

/// G10 L2: the offsets themselves, in G91 too.
Vec3 offsetsGiven(const Execution& execution, const WorkFrame& frame) {
    Vec3 offset = frame.offset;
    for (int axis = 0; axis < 3; ++axis) {
        const char letter = letterOfAxis(axis);
        if (execution.block.has(letter))
            offset[axis] = execution.length(letter);
    }
    return offset;
}

/// G10 L20: offsets for which the present position has these coordinates.
Vec3 offsetsHere(const Execution& execution, const WorkFrame& frame) {
    WorkFrame without = frame;
    without.offset = Vec3(0);
    Vec3 program = frame.toProgram(execution.state.position);
    for (int axis = 0; axis < 3; ++axis) {
        if (execution.block.has(letterOfAxis(axis)))
            program[axis] = execution.length(letterOfAxis(axis));
    }
    return execution.state.position - without.toMachine(program);
}

/// LinuxCNC computes the tool position again with the shift of G92 as it was rotated before.
void leaveShiftAsTurned(Execution& execution, double rotationBefore) {
    MachineState& state = execution.state;
    const WorkFrame& frame = state.frame;
    if (!execution.dialect.shiftIsNotTurned || frame.rotation == rotationBefore ||
        (frame.shift.x == 0 && frame.shift.y == 0))
        return;
    WorkFrame by;
    by.rotation = rotationBefore - frame.rotation;
    const Vec3 tip = state.position;
    state.position = frame.toMachine(frame.toProgram(tip) + frame.shift - by.turned(frame.shift));
    state.strayed += tip - state.position;
    execution.reporter.report(nc_message::kShiftNotTurned, execution.block.word('L'), {"G10"});
}

void setWorkOffset(Execution& execution, bool here) {
    if (!execution.block.has('P')) {
        execution.reporter.report(nc_message::kWordMissing, execution.block.word('L'), {"G10", "P"});
        return;
    }
    const auto chosen =
        wholeNumber(execution, execution.block.word('P'), 0, kSixth + execution.dialect.additionalSystems);
    if (!chosen)
        return;
    const int system = *chosen == 0 ? execution.state.workOffset : *chosen;
    if (system == execution.state.workOffset && execution.state.compensation.on) {
        execution.reporter.report(nc_message::kCompensationForbids, execution.block.word('L'), {"G10"});
        return;
    }
    if (here && execution.block.has('R')) {
        execution.reporter.report(nc_message::kWordUnused, execution.block.word('R'), {"R"});
        return;
    }
    WorkFrame frame = frameOf(execution, system);
    if (execution.block.has('R'))
        frame.rotation = execution.block.value('R');
    frame.offset = here ? offsetsHere(execution, frame) : offsetsGiven(execution, frame);
    setVectorAt(execution.parameters, offsetParameter(system), frame.offset);
    execution.parameters.setNumbered(offsetParameter(system) + kRotationParameter, frame.rotation);
    if (system != execution.state.workOffset)
        return;
    const double rotationBefore = execution.state.frame.rotation;
    setFrame(execution, frame);
    leaveShiftAsTurned(execution, rotationBefore);
}

/// The position of the machine in the coordinates of a work offset, without a tool length offset.
Vec3 positionWithoutTool(const Execution& execution, const WorkFrame& frame) {
    return frame.toProgram(execution.state.position) + execution.state.toolOffset;
}

/// G10 L1, L10, L11: the entry of the tool table.
void setTool(Execution& execution, int kind) {
    if (!execution.block.has('P')) {
        execution.reporter.report(nc_message::kWordMissing, execution.block.word('L'), {"G10", "P"});
        return;
    }
    const auto number = wholeNumber(execution, execution.block.word('P'), 1, kLargestTool);
    if (!number)
        return;
    const ToolOffset* known = execution.tools.find(*number);
    if (known == nullptr) {
        execution.reporter.report(nc_message::kOffsetUnknown, execution.block.word('P'),
                                  {std::to_string(*number)});
        return;
    }
    ToolOffset tool = *known;
    WorkFrame frame = execution.state.frame;
    if (kind == kToolInFixture) {
        frame = frameOf(execution, kOffsetCount);
        frame.shift = Vec3(0);
    }
    const Vec3 current = positionWithoutTool(execution, frame);
    for (int axis = 0; axis < 3; ++axis) {
        if (!execution.block.has(letterOfAxis(axis)))
            continue;
        const double value = execution.length(letterOfAxis(axis));
        tool.offset[axis] = kind == kToolItself ? value : current[axis] - value;
    }
    if (execution.block.has('R'))
        tool.diameter = 2 * execution.length('R');
    execution.tools.set(*number, tool);
}

void setShift(Execution& execution, const Vec3& shift, bool on) {
    execution.state.shifted = on;
    if (execution.dialect.shiftHasParameter)
        execution.parameters.setNumbered(kShiftOnParameter, on ? 1 : 0);
    WorkFrame frame = execution.state.frame;
    frame.shift = shift;
    setFrame(execution, frame);
}

/// Determines what must be known before coordinates can be set relative to the position of the machine.
void setPosition(Execution& execution, const Vec3& program) {
    MachineState& state = execution.state;
    for (int axis = 0; axis < 3; ++axis) {
        const auto bit = axisBit(axis);
        if (!execution.block.has(letterOfAxis(axis)) || (state.known & bit) != 0)
            continue;
        // The machine position is unknown, so the program defines it here.
        state.position[axis] = state.frame.toMachine(program)[axis];
        state.known |= bit;
        state.everKnown |= bit;
        state.unknownReported &= static_cast<std::uint8_t>(~bit);
    }
}

} // namespace

void selectSystem(Execution& execution, int system) {
    if (system == execution.state.workOffset)
        return;
    execution.state.workOffset = system;
    execution.state.writtenOffset.reset();
    const WorkFrame frame = frameOf(execution, system);
    if (frame == execution.state.frame) // its name changes nevertheless
        execution.program.append(WorkOffset{system, frame.zero()}, execution.line);
    setFrame(execution, frame);
}

void selectWorkOffset(Execution& execution, const Word& word) {
    const int tenths = static_cast<int>(std::lround(word.value * 10));
    selectSystem(execution, tenths <= kG59 ? (tenths - kG54) / 10 + 1 : kSixth + (tenths - kG59));
}

void setOffsets(Execution& execution, const Word& word) {
    if (!execution.block.has('L')) {
        execution.reporter.report(nc_message::kWordMissing, word, {"G10", "L"});
        return;
    }
    const Word& kind = execution.block.word('L');
    if (kind.value == kOffsetItself || kind.value == kOffsetHere)
        setWorkOffset(execution, kind.value == kOffsetHere);
    else if (kind.value == kToolItself || kind.value == kToolHere || kind.value == kToolInFixture)
        setTool(execution, static_cast<int>(kind.value));
    else
        execution.reporter.report(nc_message::kOffsetKind, kind, {fmt::format("{:g}", kind.value)});
}

namespace {

bool namesAxis(Execution& execution, const Word& word) {
    if (execution.block.letters().any(LetterSet("XYZABCUVW")))
        return true;
    execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "X / Y / Z"});
    return false;
}

} // namespace

void shiftCoordinates(Execution& execution, const Word& word) {
    if (!namesAxis(execution, word))
        return;
    MachineState& state = execution.state;
    Vec3 program = state.frame.toProgram(state.position);
    Vec3 shift = state.frame.shift;
    Vec3 wanted = program;
    for (int axis = 0; axis < 3; ++axis) {
        if (execution.block.has(letterOfAxis(axis)))
            wanted[axis] = execution.length(letterOfAxis(axis));
    }
    setPosition(execution, wanted);
    program = state.frame.toProgram(state.position);
    for (int axis = 0; axis < 3; ++axis) {
        if (execution.block.has(letterOfAxis(axis)))
            shift[axis] += program[axis] - wanted[axis];
    }
    setVectorAt(execution.parameters, kShiftParameter, shift);
    setShift(execution, shift, true);
}

void shiftLocally(Execution& execution, const Word& word) {
    if (!namesAxis(execution, word))
        return;
    Vec3 shift = execution.state.frame.shift;
    for (int axis = 0; axis < 3; ++axis) {
        if (execution.block.has(letterOfAxis(axis)))
            shift[axis] = execution.length(letterOfAxis(axis));
    }
    setVectorAt(execution.parameters, kShiftParameter, shift);
    setShift(execution, shift, true);
}

void clearShift(Execution& execution, const Word& /*word*/) {
    setVectorAt(execution.parameters, kShiftParameter, Vec3(0));
    setShift(execution, Vec3(0), false);
}

void suspendShift(Execution& execution, const Word& /*word*/) {
    setShift(execution, Vec3(0), false);
}

void restoreShift(Execution& execution, const Word& /*word*/) {
    setShift(execution, vectorAt(execution.parameters, kShiftParameter), true);
}

} // namespace proveout
