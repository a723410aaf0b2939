// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/control_description.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "core/base/text.h"
#include "core/nc/codes/modal_groups.h"
#include "core/nc/flow/call_stack.h"
#include "core/nc/program/control_names.h"
#include "core/nc/state/active_codes.h"
#include "core/nc/state/machine_state.h"

namespace proveout {

namespace {

std::vector<ControlState::Mode> modesOf(const MachineState& state, const CodeTable& codes,
                                        const Dialect& dialect) {
    std::vector<ControlState::Mode> modes;
    const auto add = [&](char letter, int tenths) {
        const CodeRow* row = codes.find(letter, tenths);
        // Codes that a dialect does not execute are never in force.
        if (row != nullptr && row->supported())
            modes.push_back(
                {fmt::format("{}{:g}", letter, row->tenths / 10.0), row->name, nameOf(row->group)});
    };
    for (const ModalGroupRow& row : modalGroups())
        if ((row.readers & kReadByPanel) != 0)
            add(row.letter, activeCode(state, row.group, dialect));
    // Both coolants may be on.
    if (state.mist)
        add('M', 70);
    if (state.flood)
        add('M', 80);
    if (!state.mist && !state.flood)
        add('M', 90);
    return modes;
}

std::vector<ControlState::Place> placesOf(const MachineState& state) {
    return {
        {PROVEOUT_TEXT("Core", "Program position"), state.frame.toProgram(state.position), state.known},
        {PROVEOUT_TEXT("Core", "Work offset"), state.frame.offset, kAllAxes},
        {PROVEOUT_TEXT("Core", "Shift by G52 and G92"), state.frame.shift, kAllAxes},
        {PROVEOUT_TEXT("Core", "Tool length offset"), state.toolOffset, kAllAxes},
    };
}

std::vector<ControlState::Quantity> quantitiesOf(const MachineState& state) {
    constexpr std::array kFeedUnits{"mm/min", "1/min", "mm/rev"};
    return {
        {PROVEOUT_TEXT("Core", "Feed rate"), state.feed,
         kFeedUnits[static_cast<std::size_t>(state.feedMode)]},
        {PROVEOUT_TEXT("Core", "Spindle speed"), state.spindleRpm, PROVEOUT_TEXT("Core", "rpm")},
        {control_name::kSpindleTool, static_cast<double>(state.tool), ""},
        {PROVEOUT_TEXT("Core", "Next tool"), static_cast<double>(std::max(state.selectedTool, 0)), ""},
    };
}

} // namespace

ControlState describe(const MachineState& state, const Parameters& parameters, const CallStack& calls,
                      const CodeTable& codes, const Dialect& dialect) {
    ControlState result;
    result.modes = modesOf(state, codes, dialect);
    result.places = placesOf(state);
    result.quantities = quantitiesOf(state);
    for (auto& [name, value] : parameters.listed())
        result.variables.push_back({std::move(name), value});
    for (const CallStack::Level& level : calls.levels())
        result.calls.push_back({level.label, static_cast<std::uint32_t>(level.line), calls.fileOf(level)});
    return result;
}

} // namespace proveout
