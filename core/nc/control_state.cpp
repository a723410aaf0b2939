// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/control_state.h"

#include <array>
#include <fmt/format.h>

#include "core/base/text.h"
#include "core/nc/call_stack.h"
#include "core/nc/machine_state.h"
#include "core/nc/word_help.h"

namespace proveout {

namespace {

constexpr int kG80 = 800;

int motionCode(const MachineState& state) {
    return state.motion == nullptr ? kG80 : state.motion->tenths;
}

int planeCode(const MachineState& state) {
    constexpr std::array kCodes{170, 180, 190};
    return kCodes[static_cast<std::size_t>(state.plane)];
}

int feedCode(const MachineState& state) {
    constexpr std::array kCodes{940, 930, 950};
    return kCodes[static_cast<std::size_t>(state.feedMode)];
}

int compensationCode(const MachineState& state) {
    return !state.compensation.on ? 400 : state.compensation.offset >= 0 ? 410 : 420;
}

int workOffsetCode(const MachineState& state) {
    constexpr int kSixth = 6;
    return state.workOffset <= kSixth ? 530 + 10 * state.workOffset : 590 + state.workOffset - kSixth;
}

/// The code that is in force of one modal group, as tenths of its number. One row a group.
constexpr int (*kModes[])(const MachineState&) = {
    motionCode,
    planeCode,
    [](const MachineState& s) { return s.incremental ? 910 : 900; },
    [](const MachineState& s) { return s.arcCentreAbsolute ? 901 : 911; },
    feedCode,
    [](const MachineState& s) { return s.inch ? 200 : 210; },
    compensationCode,
    [](const MachineState& s) { return s.toolOffset == Vec3(0) ? 490 : 430; },
    workOffsetCode,
    [](const MachineState& s) { return s.retractToR ? 990 : 980; },
};

std::vector<ControlState::Mode> modesOf(const MachineState& state, const CodeTable& codes) {
    std::vector<ControlState::Mode> modes;
    for (const auto& code : kModes) {
        const CodeRow* row = codes.find('G', code(state));
        if (row != nullptr)
            modes.push_back({fmt::format("G{:g}", row->tenths / 10.0), row->name, nameOf(row->group)});
    }
    const int spindle = state.spindleDirection > 0 ? 30 : state.spindleDirection < 0 ? 40 : 50;
    const auto addM = [&](int tenths) {
        const CodeRow* row = codes.find('M', tenths);
        if (row != nullptr)
            modes.push_back({fmt::format("M{:g}", tenths / 10.0), row->name, nameOf(row->group)});
    };
    addM(spindle);
    if (state.mist)
        addM(70);
    if (state.flood)
        addM(80);
    if (!state.mist && !state.flood)
        addM(90);
    return modes;
}

std::vector<ControlState::Place> placesOf(const MachineState& state) {
    return {
        {PROVEOUT_TEXT("Core", "Position in the program"), state.frame.toProgram(state.position),
         state.known},
        {PROVEOUT_TEXT("Core", "Zero of the work offset"), state.frame.offset, kAllAxes},
        {PROVEOUT_TEXT("Core", "Shift by G52 and G92"), state.frame.shift, kAllAxes},
        {PROVEOUT_TEXT("Core", "Tool length offset"), state.toolOffset, kAllAxes},
    };
}

std::vector<ControlState::Quantity> quantitiesOf(const MachineState& state) {
    constexpr std::array kFeedUnits{"mm/min", "1/min", "mm/rev"};
    return {
        {PROVEOUT_TEXT("Core", "Feed rate"), state.feed,
         kFeedUnits[static_cast<std::size_t>(state.feedMode)]},
        {PROVEOUT_TEXT("Core", "Spindle speed"), state.spindleRpm, "1/min"},
        {PROVEOUT_TEXT("Core", "Tool in the spindle"), static_cast<double>(state.tool), ""},
        {PROVEOUT_TEXT("Core", "Tool selected next"), static_cast<double>(std::max(state.selectedTool, 0)),
         ""},
    };
}

} // namespace

ControlState describe(const MachineState& state, const Parameters& parameters, const CallStack& calls,
                      const CodeTable& codes) {
    ControlState result;
    result.modes = modesOf(state, codes);
    result.places = placesOf(state);
    result.quantities = quantitiesOf(state);
    for (auto& [name, value] : parameters.listed())
        result.variables.push_back({std::move(name), value});
    for (const CallStack::Level& level : calls.levels())
        result.calls.push_back({level.label, static_cast<std::uint32_t>(level.line), calls.fileOf(level)});
    return result;
}

} // namespace proveout
