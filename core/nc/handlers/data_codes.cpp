// SPDX-License-Identifier: GPL-3.0-or-later
// G10 and G11 of Fanuc's dialect: data of the control that a program writes. Source: FANUC's operator's
// manuals, programmable data input, change of the workpiece coordinate system, tool compensation memory C.
#include <fmt/format.h>
#include <string>

#include "core/nc/codes/handlers.h"
#include "core/nc/state/execution.h"
#include "core/nc/state/work_systems.h"

namespace proveout {

namespace {

// Meanings of the L word.
constexpr int kOldWear = 1; ///< same as L11, for programs of older controls
constexpr int kSystem = 2;
constexpr int kToolLife = 3;
constexpr int kLength = 10;
constexpr int kRadiusWear = 13;
constexpr int kAdditionalSystem = 20;
constexpr int kParameters = 50;
constexpr int kParametersToo = 52;

/// The number of the P word; nothing, with a report, if there is none within the limits.
std::optional<int> numberOfData(Execution& execution, const Word& kind, int least, int most) {
    if (execution.block.has('P'))
        return wholeNumber(execution, execution.block.word('P'), least, most);
    execution.reporter.report(nc_message::kWordMissing, kind, {"G10", "P"});
    return {};
}

/// `system` 0 is the offset that all of them share.
void setSystem(Execution& execution, int system) {
    MachineState& state = execution.state;
    if (state.compensation.on && (system == 0 || system == state.workOffset)) {
        execution.reporter.report(nc_message::kCompensationForbids, execution.block.word('L'), {"G10"});
        return;
    }
    const int first = system == 0 ? kCommonOffset : systemVariable(system);
    for (int axis = 0; axis < 3; ++axis) {
        const char letter = static_cast<char>('X' + axis);
        if (!execution.block.has(letter))
            continue;
        const double before = state.incremental ? execution.parameters.numbered(first + axis) : 0;
        execution.parameters.setNumbered(first + axis, before + execution.length(letter));
    }
    refreshFrame(state, execution.parameters, execution.program, execution.line);
}

void setRegister(Execution& execution, const Word& kind, OffsetRegisters::Entry entry) {
    const auto number = numberOfData(execution, kind, 1, OffsetRegisters::kLargest);
    if (!number)
        return;
    if (!execution.block.has('R')) {
        execution.reporter.report(nc_message::kWordMissing, kind, {"G10", "R"});
        return;
    }
    double value = execution.length('R');
    if (execution.state.incremental) {
        const auto before = execution.registers.value(entry, *number);
        if (!before) {
            execution.reporter.report(nc_message::kRegisterUnknown, execution.block.word('P'),
                                      {fmt::format("P{}", *number)});
            return;
        }
        value += *before;
    }
    execution.registers.set(entry, *number, value);
}

} // namespace

void writeData(Execution& execution, const Word& word) {
    if (!execution.block.has('L')) {
        execution.reporter.report(nc_message::kWordMissing, word, {"G10", "L"});
        return;
    }
    const Word& kind = execution.block.word('L');
    using Entry = OffsetRegisters::Entry;
    if (kind.value == kSystem) {
        if (const auto system = numberOfData(execution, kind, 0, kStandardSystems))
            setSystem(execution, *system);
    } else if (kind.value == kAdditionalSystem) {
        if (const auto system = numberOfData(execution, kind, 1, execution.dialect.additionalSystems))
            setSystem(execution, kStandardSystems + *system);
    } else if (kind.value == kOldWear) {
        setRegister(execution, kind, Entry::lengthWear);
    } else if (kind.value >= kLength && kind.value <= kRadiusWear) {
        setRegister(execution, kind, static_cast<Entry>(static_cast<int>(kind.value) - kLength));
    } else if (kind.value == kParameters || kind.value == kParametersToo || kind.value == kToolLife) {
        execution.state.dataInput = true;
        execution.reporter.report(nc_message::kDataSkipped, kind, {fmt::format("{:g}", kind.value)});
    } else {
        execution.reporter.report(nc_message::kDataKind, kind, {fmt::format("{:g}", kind.value)});
    }
}

} // namespace proveout
