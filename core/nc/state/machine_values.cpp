// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/state/machine_values.h"

#include "core/nc/codes/dialects.h"
#include <algorithm>
#include <array>

#include "core/nc/state/active_codes.h"
#include "core/nc/text/messages.h"

namespace proveout {

namespace {

constexpr int kToolNumber = 5400;
constexpr int kPosition = 5420; ///< X; Y and Z follow
constexpr int kPositions = 9;   ///< the number of axes that LinuxCNC knows

double position(const MachineState& state, int axis) {
    const Vec3 tip =
        state.compensation.on ? state.position + state.compensation.displacement : state.position;
    return state.fromMm(state.frame.toProgram(tip)[axis]);
}

bool isPosition(int number) {
    return number >= kPosition && number < kPosition + kPositions;
}

double truth(bool value) {
    return value ? 1.0 : 0.0;
}

/// Ten times the number of the code in force, as LinuxCNC returns it.
template<ModalGroup Group>
double codeOf(const MachineState& state) {
    return activeCode(state, Group, dialect(DialectId::linuxcnc));
}

struct NamedValue {
    std::string_view name;
    double (*value)(const MachineState&);
};

// In alphabetical order.
constexpr NamedValue kNamed[] = {
    {"_absolute", [](const MachineState& s) { return truth(!s.incremental); }},
    {"_ccomp", codeOf<ModalGroup::cutterCompensation>},
    {"_coord_system", codeOf<ModalGroup::workOffset>},
    {"_current_tool", [](const MachineState& s) { return static_cast<double>(s.tool); }},
    {"_feed", [](const MachineState& s) { return s.feedNumber; }},
    {"_flood", [](const MachineState& s) { return truth(s.flood); }},
    {"_ijk_absolute_mode", [](const MachineState& s) { return truth(s.arcCentreAbsolute); }},
    {"_imperial", [](const MachineState& s) { return truth(s.inch); }},
    {"_incremental", [](const MachineState& s) { return truth(s.incremental); }},
    {"_metric", [](const MachineState& s) { return truth(!s.inch); }},
    {"_mist", [](const MachineState& s) { return truth(s.mist); }},
    {"_motion_mode", codeOf<ModalGroup::motion>},
    {"_plane", codeOf<ModalGroup::plane>},
    {"_rpm", [](const MachineState& s) { return s.spindleRpm; }},
    {"_selected_tool",
     [](const MachineState& s) { return static_cast<double>(std::max(s.selectedTool, 0)); }},
    {"_spindle_cw", [](const MachineState& s) { return truth(s.spindleDirection > 0); }},
    {"_spindle_on", [](const MachineState& s) { return truth(s.spindleDirection != 0); }},
    {"_task", [](const MachineState&) { return 0.0; }},
    {"_vmajor", [](const MachineState&) { return 2.9; }},
    {"_vminor", [](const MachineState&) { return 0.0; }},
    {"_x", [](const MachineState& s) { return position(s, 0); }},
    {"_y", [](const MachineState& s) { return position(s, 1); }},
    {"_z", [](const MachineState& s) { return position(s, 2); }},
};

} // namespace

std::optional<double> MachineValues::numbered(int number) const {
    if (isPosition(number))
        return number < kPosition + 3 ? position(m_state, number - kPosition) : 0.0;
    if (number == kToolNumber)
        return m_state.tool;
    if (number == kActiveOffset)
        return m_state.writtenOffset.value_or(m_state.workOffset);
    m_inputRead = m_inputRead || number == kInputParameter;
    noteProbeRead(number, kProbeContact, kProbeSuccess);
    return {};
}

bool MachineValues::writable(int number) const {
    return number == kActiveOffset;
}

const FindingRow* MachineValues::refusal(int number) const {
    return m_state.compensation.on && isPosition(number) ? &nc_message::kPositionHidden : nullptr;
}

std::optional<double> OffsetValues::numbered(int number) const {
    noteProbeRead(number, kMachProbed, kMachProbed + kMachAxes - 1);
    return number == kActiveOffset ? std::optional(static_cast<double>(m_state.workOffset)) : std::nullopt;
}

const FindingRow* OffsetValues::refusal(int number) const {
    constexpr int kHome = 5161;
    constexpr int kSecondHome = 5181;
    const auto within = [number](int first) { return number >= first && number < first + kMachAxes; };
    const bool notProbed = within(kMachProbed) && !m_state.probed.asked;
    return notProbed || within(kHome) || within(kSecondHome) ? &nc_message::kMachineVariable : nullptr;
}

std::optional<double> OffsetValues::named(std::string_view /*name*/) const {
    return {};
}

std::optional<double> MachineValues::named(std::string_view name) const {
    const auto* row = std::ranges::lower_bound(kNamed, name, {}, &NamedValue::name);
    return row != std::end(kNamed) && row->name == name ? std::optional(row->value(m_state)) : std::nullopt;
}

} // namespace proveout
