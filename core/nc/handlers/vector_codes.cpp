// SPDX-License-Identifier: GPL-3.0-or-later
// Cutter compensation by registers: G40 to G42 and D of Fanuc's dialect.
#include <fmt/format.h>
#include <optional>

#include "core/nc/codes/handlers.h"
#include "core/nc/motions/vector_path.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

constexpr double kLeft = 1;
constexpr double kRight = -1;

/// False, with a report, if the plane is not parallel to one of the machine's.
bool mayBegin(Execution& execution, const Word& word) {
    if (execution.state.frame.transformation.keepsPlane(execution.state.plane))
        return true;
    execution.reporter.report(nc_message::kCompensationTurned, word);
    return false;
}

/// The radius in the register of the D word, or of the last one; nothing, with a report, if it is unknown.
std::optional<double> radiusInRegister(Execution& execution, const Word& word) {
    MachineState& state = execution.state;
    const bool given = execution.block.has('D');
    if (given) {
        const auto number = wholeNumber(execution, execution.block.word('D'), 0, OffsetRegisters::kLargest);
        if (!number)
            return {};
        state.radiusRegister = *number;
    }
    const auto radius = execution.registers.radius(state.radiusRegister);
    if (!radius && !execution.toolLacks(state.radiusRegister)) {
        execution.reporter.report(nc_message::kRegisterUnknown, given ? execution.block.word('D') : word,
                                  {fmt::format("D{}", state.radiusRegister)});
    }
    return radius;
}

/// A mirror image moves the tool to the other side. An offset of 0 ends compensation until another one is
/// set.
void useRadius(Execution& execution, double radius) {
    MachineState& state = execution.state;
    CutterCompensation& compensation = state.compensation;
    const double side =
        state.frame.transformation.flips(state.plane) ? -compensation.side : compensation.side;
    compensation.offset = side * radius;
    compensation.assumed = execution.registers.assumedRadius(state.radiusRegister);
    compensation.entered = compensation.entered && radius != 0;
}

void reportZero(Execution& execution, const Word& word) {
    const bool certain =
        execution.state.radiusRegister == 0 ||
        execution.registers.certain(OffsetRegisters::Entry::radius, execution.state.radiusRegister);
    execution.reporter.report(certain ? nc_message::kCompensationNoDiameter
                                      : nc_message::kCompensationDiameterUnknown,
                              word, {nameOf(word)});
}

/// Repeating the same code leaves the tool at a right angle beside the end of the block before; the opposite
/// code changes the side.
void compensateByRegister(Execution& execution, const Word& word, double side) {
    const auto radius = radiusInRegister(execution, word);
    if (!radius || !mayBegin(execution, word))
        return;
    CutterCompensation& compensation = execution.state.compensation;
    if (compensation.on && compensation.side == side)
        finishSquare(execution);
    compensation.on = true;
    compensation.side = side;
    useRadius(execution, *radius);
    if (*radius == 0)
        reportZero(execution, word);
}

} // namespace

void compensateLeftByRegister(Execution& execution, const Word& word) {
    compensateByRegister(execution, word, kLeft);
}

void compensateRightByRegister(Execution& execution, const Word& word) {
    compensateByRegister(execution, word, kRight);
}

void changeRadiusRegister(Execution& execution, const Word& word) {
    const auto radius = radiusInRegister(execution, word);
    if (radius && execution.state.compensation.on)
        useRadius(execution, *radius);
}

void endCompensationOnTheWay(Execution& execution, const Word& /*word*/) {
    CutterCompensation& compensation = execution.state.compensation;
    compensation.on = compensation.entered = false;
    const PlaneAxes plane = axes(execution.state.plane);
    const auto along = [&](int axis) {
        const char letter = static_cast<char>('I' + axis);
        return execution.block.has(letter) ? execution.length(letter) : 0.0;
    };
    compensation.vectors.exit = {along(plane.first), along(plane.second)};
}

} // namespace proveout
