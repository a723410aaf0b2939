// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/macro_variables.h"

#include <algorithm>
#include <array>

#include "core/nc/codes/codes.h"
#include "core/nc/flow/haas_variables.h"
#include "core/nc/flow/number_ranges.h"
#include "core/nc/state/active_codes.h"
#include "core/nc/state/work_systems.h"
#include "core/nc/text/messages.h"

namespace proveout {

namespace {

struct ModalValue {
    int number;
    double (*value)(const MachineState&);
};

double motionCode(const MachineState& s) {
    return s.motion == nullptr || isCycle(s.motion) ? 0.0 : s.motion->tenths / 10.0;
}

double cycleCode(const MachineState& s) {
    return isCycle(s.motion) ? s.motion->tenths / 10.0 : 80.0;
}

/// The modal groups of the control and the matching ones of this program, by number.
struct GroupVariable {
    int number;
    ModalGroup group;
};
constexpr GroupVariable kGroups[] = {
    {4002, ModalGroup::plane},
    {4003, ModalGroup::distance},
    {4005, ModalGroup::feedMode},
    {4006, ModalGroup::units},
    {4007, ModalGroup::cutterCompensation},
    {4008, ModalGroup::toolLength},
    {4010, ModalGroup::retract},
    {4011, ModalGroup::scaling},
    {4012, ModalGroup::macroCall},
    {4013, ModalGroup::spindleMode},
    {4014, ModalGroup::workOffset},
    {4016, ModalGroup::rotation},
    {4017, ModalGroup::polar},
    {4022, ModalGroup::mirroring},
};

// By number. Source: operator's manual, modal information.
constexpr ModalValue kModal[] = {
    {4001, motionCode},
    {4004, [](const MachineState&) { return 23.0; }},
    {4009, cycleCode},
    {4015, [](const MachineState& s) { return s.pathControl; }},
    // Codes of these groups are not executed, so the codes that cancel them are in force: normal direction
    // control, in-feed control, polar coordinate interpolation.
    {4019, [](const MachineState&) { return 40.1; }},
    {4020, [](const MachineState&) { return 160.0; }},
    {4021, [](const MachineState&) { return 13.1; }},
    {4102, [](const MachineState& s) { return s.lastB; }},
    {4107, [](const MachineState& s) { return static_cast<double>(s.radiusRegister); }},
    {4109,
     [](const MachineState& s) { return s.feedMode == FeedMode::inverseTime ? s.feed : s.fromMm(s.feed); }},
    {4111, [](const MachineState& s) { return static_cast<double>(s.lengthRegister); }},
    {4113, [](const MachineState& s) { return s.lastM; }},
    {4114, [](const MachineState& s) { return s.blockNumber; }},
    {4115, [](const MachineState& s) { return s.programNumber; }},
    {4119, [](const MachineState& s) { return s.spindleRpm; }},
    {4120, [](const MachineState& s) { return static_cast<double>(std::max(s.selectedTool, s.tool)); }},
    {4130,
     [](const MachineState& s) {
         return std::max(0.0, static_cast<double>(s.workOffset - kStandardSystems));
     }},
};
constexpr int kFirstRunning = 4201; ///< the first number for the current block, besides those for the block
                                    ///< before
constexpr int kLastRunning = 4330;
constexpr int kRunningOffset = 200;

constexpr int kAxes = 3;
constexpr int kBlockEnd = 5001;      ///< end position of the previous block, in work coordinates
constexpr int kMachine = 5021;       ///< machine coordinates
constexpr int kWork = 5041;          ///< work coordinates, as displayed
constexpr int kSkip = 5061;          ///< where G31 stopped
constexpr int kLengthInForce = 5081; ///< tool length offset

/// The axis of a variable in a range that begins at `first`; nothing if it is outside the range.
std::optional<int> axisOf(int number, int first) {
    return number >= first && number < first + kAxes ? std::optional(number - first) : std::nullopt;
}

constexpr NumberRange kMachines[] = {
    {1000, 1035}, ///< inputs
    {3001, 3002}, ///< timers
    {3011, 3012}, ///< date and time
    {3901, 3902}, ///< counters of parts
};
constexpr NumberRange kIgnored[] = {{1100, 1135}, {3001, 3002}, {3003, 3005}, {3901, 3902}};

constexpr int kWithoutGroup = 4018;
constexpr int kAlarm = 3000;
constexpr int kStop = 3006;
constexpr int kFirstModal = 4001;
constexpr int kLastPosition = 5199;

} // namespace

std::optional<double> MacroVariables::ofRegister(int number) const {
    const auto place = OffsetRegisters::place(m_dialect, number);
    const auto value = place ? m_registers.value(place->entry, place->number) : std::nullopt;
    return value ? std::optional(m_state.fromMm(*value)) : std::nullopt;
}

/// Variables that only Haas's controls have.
std::optional<double> MacroVariables::ofHaas(int number) const {
    constexpr int kTool = 3026;
    constexpr int kSpindle = 3027;
    if (!m_dialect.hasMonitors)
        return {};
    if (number == kTool)
        return m_state.tool;
    if (number == kSpindle)
        return m_state.spindleDirection == 0 ? 0 : m_state.rpm();
    if (const auto legacy = legacyNumberOfHaas(number))
        return m_parameters.numbered(*legacy);
    if (!isMonitorOfHaas(number))
        return {};
    noteAssumedRead(number);
    return 0;
}

std::optional<double> MacroVariables::numbered(int number) const {
    if (const auto value = ofHaas(number))
        return value;
    if (number >= kFirstRunning && number <= kLastRunning)
        number -= kRunningOffset;
    if (isWorkOffset(number))
        return m_state.fromMm(m_parameters.numbered(number));
    if (const auto value = ofRegister(number))
        return value;
    if (const auto* row = std::ranges::find(kGroups, number, &GroupVariable::number);
        row != std::end(kGroups))
        return activeCode(m_state, row->group, m_dialect) / 10.0;
    const auto* modal = std::ranges::lower_bound(kModal, number, {}, &ModalValue::number);
    if (modal != std::end(kModal) && modal->number == number)
        return modal->value(m_state);
    const Vec3 work = m_state.frame.toProgram(m_state.position);
    if (const auto axis = axisOf(number, kBlockEnd))
        return m_state.fromMm(work[*axis]);
    if (const auto axis = axisOf(number, kWork)) {
        const Vec3 tip = m_state.position + m_state.compensation.displacement;
        return m_state.fromMm(m_state.frame.toWork(tip)[*axis] + m_state.toolOffset[*axis]);
    }
    if (const auto axis = axisOf(number, kMachine); axis && m_state.machineZeroKnown)
        return m_state.fromMm(m_state.position[*axis] + m_state.toolOffset[*axis]);
    if (const auto axis = axisOf(number, kLengthInForce))
        return m_state.fromMm(m_state.toolOffset[*axis]);
    if (const auto axis = axisOf(number, kSkip)) {
        noteProbeRead(number, kSkip, kSkip + kAxes - 1);
        return m_state.fromMm(m_state.probed.place[*axis]);
    }
    return {};
}

const FindingRow* MacroVariables::refusal(int number) const {
    if (number == kWithoutGroup || number == kWithoutGroup + kRunningOffset)
        return &nc_message::kVariableWithoutGroup;
    const auto place = OffsetRegisters::place(m_dialect, number);
    if (place && !m_registers.certain(place->entry, place->number))
        return &nc_message::kMachineVariable;
    if (m_dialect.hasMonitors && isSettingOfHaas(number))
        return &nc_message::kMachineVariable;
    const bool position = axisOf(number, kMachine) && !m_state.machineZeroKnown;
    const auto axis = axisOf(number, kBlockEnd) ? axisOf(number, kBlockEnd) : axisOf(number, kWork);
    if (axis && (m_state.known >> static_cast<unsigned>(*axis) & 1U) == 0)
        return &nc_message::kPositionUnknown;
    return position || anyContains(kMachines, number) ? &nc_message::kMachineVariable : nullptr;
}

bool MacroVariables::writable(int number) const {
    const Writing kind = writing(number);
    return kind == Writing::alarm || kind == Writing::stop || kind == Writing::ignored ||
           kind == Writing::offset || (m_dialect.hasMonitors && legacyNumberOfHaas(number));
}

std::optional<double> MacroVariables::named(std::string_view /*name*/) const {
    return {};
}

int MacroVariables::storedAs(int number) const {
    return m_dialect.hasMonitors ? legacyNumberOfHaas(number).value_or(number) : number;
}

double MacroVariables::leastUnit() const {
    return m_state.inch ? m_dialect.leastInch : m_dialect.leastMm;
}

void MacroVariables::write(int number, double value, Program& program, std::uint32_t line) {
    const double mm = m_state.toMm(value);
    if (const auto place = OffsetRegisters::place(m_dialect, number)) {
        m_registers.set(place->entry, place->number, mm);
        return;
    }
    m_parameters.setNumbered(number, mm);
    refreshFrame(m_state, m_parameters, program, line);
}

MacroVariables::Writing MacroVariables::writing(int number) const {
    // Some of Haas's pallet variables have numbers that are work offsets on other controls.
    if (m_dialect.hasMonitors && (isMonitorOfHaas(number) || isSettingOfHaas(number)))
        return Writing::ignored;
    if (isWorkOffset(number) || OffsetRegisters::place(m_dialect, number))
        return Writing::offset;
    if (number == kAlarm)
        return Writing::alarm;
    if (number == kStop)
        return Writing::stop;
    if (anyContains(kIgnored, number))
        return Writing::ignored;
    return number == 0 || (number >= kFirstModal && number <= kLastPosition) ? Writing::readOnly
                                                                             : Writing::stored;
}

} // namespace proveout
