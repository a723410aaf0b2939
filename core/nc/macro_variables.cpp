// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/macro_variables.h"

#include <algorithm>
#include <array>

#include "core/nc/codes.h"
#include "core/nc/messages.h"
#include "core/nc/work_systems.h"

namespace proveout {

namespace {

struct ModalValue {
    int number;
    double (*value)(const MachineState&);
};

double distanceCode(const MachineState& s) {
    return s.incremental ? 91 : 90;
}

double feedCode(const MachineState& s) {
    constexpr std::array kCodes{94.0, 93.0, 95.0};
    return kCodes[static_cast<std::size_t>(s.feedMode)];
}

double planeCode(const MachineState& s) {
    constexpr std::array kCodes{17.0, 18.0, 19.0};
    return kCodes[static_cast<std::size_t>(s.plane)];
}

double compensationCode(const MachineState& s) {
    return !s.compensation.on ? 40 : s.compensation.offset >= 0 ? 41 : 42;
}

double motionCode(const MachineState& s) {
    return s.motion == nullptr || isCycle(s.motion) ? 0.0 : s.motion->tenths / 10.0;
}

double cycleCode(const MachineState& s) {
    return isCycle(s.motion) ? s.motion->tenths / 10.0 : 80.0;
}

double workOffsetCode(const MachineState& s) {
    return s.workOffset <= kStandardSystems ? 53.0 + s.workOffset : 54.1;
}

double lengthCode(const MachineState& s) {
    return s.lengthSign == 0 ? 49 : s.lengthSign > 0 ? 43 : 44;
}

// By number. Source: operator's manual, modal information.
constexpr ModalValue kModal[] = {
    {4001, motionCode},
    {4002, planeCode},
    {4003, distanceCode},
    {4004, [](const MachineState&) { return 23.0; }},
    {4005, feedCode},
    {4006, [](const MachineState& s) { return s.inch ? 20.0 : 21.0; }},
    {4007, compensationCode},
    {4008, lengthCode},
    {4009, cycleCode},
    {4010, [](const MachineState& s) { return s.retractToR ? 99.0 : 98.0; }},
    {4011, [](const MachineState& s) { return s.frame.transformation.scaled ? 51.0 : 50.0; }},
    {4013, [](const MachineState& s) { return s.surfaceSpeed ? 96.0 : 97.0; }},
    {4014, workOffsetCode},
    {4015, [](const MachineState& s) { return s.pathControl; }},
    {4016, [](const MachineState& s) { return s.frame.transformation.turned ? 68.0 : 69.0; }},
    {4017, [](const MachineState& s) { return s.polar.on ? 16.0 : 15.0; }},
    {4022, [](const MachineState& s) { return s.frame.transformation.mirrored != 0 ? 51.1 : 50.1; }},
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
constexpr int kFirstRunning = 4201; ///< of the block that runs, beside those of the block before
constexpr int kLastRunning = 4330;
constexpr int kRunningOffset = 200;

constexpr int kAxes = 3;
constexpr int kBlockEnd = 5001;      ///< end of the block before, in work coordinates
constexpr int kMachine = 5021;       ///< machine coordinates
constexpr int kWork = 5041;          ///< work coordinates, as they are shown
constexpr int kSkip = 5061;          ///< where G31 stopped
constexpr int kLengthInForce = 5081; ///< tool length offset

/// The axis of a variable in a row that begins at `first`; nothing where it stands elsewhere.
std::optional<int> axisOf(int number, int first) {
    return number >= first && number < first + kAxes ? std::optional(number - first) : std::nullopt;
}

struct Numbers {
    int first;
    int last;
};

constexpr Numbers kMachines[] = {
    {1000, 1035}, ///< inputs
    {3001, 3002}, ///< timers
    {3011, 3012}, ///< date and time
    {3901, 3902}, ///< counters of parts
};
constexpr Numbers kIgnored[] = {{1100, 1135}, {3001, 3002}, {3003, 3005}, {3901, 3902}};

bool within(std::span<const Numbers> rows, int number) {
    return std::ranges::any_of(rows, [&](const Numbers& r) { return number >= r.first && number <= r.last; });
}

constexpr int kAlarm = 3000;
constexpr int kStop = 3006;
constexpr int kFirstModal = 4001;
constexpr int kLastPosition = 5199;

} // namespace

std::optional<double> MacroVariables::ofRegister(int number) const {
    const auto place = OffsetRegisters::place(m_dialect.id, number);
    const auto value = place ? m_registers.value(place->entry, place->number) : std::nullopt;
    return value ? std::optional(m_state.fromMm(*value)) : std::nullopt;
}

std::optional<double> MacroVariables::numbered(int number) const {
    if (number >= kFirstRunning && number <= kLastRunning)
        number -= kRunningOffset;
    if (isWorkOffset(number))
        return m_state.fromMm(m_parameters.numbered(number));
    if (const auto value = ofRegister(number))
        return value;
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
    if (const auto axis = axisOf(number, kSkip))
        return m_state.fromMm(work[*axis]);
    return {};
}

const Message* MacroVariables::refusal(int number) const {
    const auto place = OffsetRegisters::place(m_dialect.id, number);
    if (place && !m_registers.certain(place->entry, place->number))
        return &nc_message::kMachineVariable;
    const bool position = axisOf(number, kMachine) && !m_state.machineZeroKnown;
    const auto axis = axisOf(number, kBlockEnd) ? axisOf(number, kBlockEnd) : axisOf(number, kWork);
    if (axis && (m_state.known >> static_cast<unsigned>(*axis) & 1U) == 0)
        return &nc_message::kPositionUnknown;
    return position || within(kMachines, number) ? &nc_message::kMachineVariable : nullptr;
}

bool MacroVariables::writable(int number) const {
    const Writing kind = writing(number);
    return kind == Writing::alarm || kind == Writing::stop || kind == Writing::ignored ||
           kind == Writing::offset;
}

std::optional<double> MacroVariables::named(std::string_view /*name*/) const {
    return {};
}

double MacroVariables::leastUnit() const {
    return m_state.inch ? m_dialect.leastInch : m_dialect.leastMm;
}

void MacroVariables::write(int number, double value, Program& program, std::uint32_t line) {
    const double mm = m_state.toMm(value);
    if (const auto place = OffsetRegisters::place(m_dialect.id, number)) {
        m_registers.set(place->entry, place->number, mm);
        return;
    }
    m_parameters.setNumbered(number, mm);
    refreshFrame(m_state, m_parameters, program, line);
}

MacroVariables::Writing MacroVariables::writing(int number) const {
    if (isWorkOffset(number) || OffsetRegisters::place(m_dialect.id, number))
        return Writing::offset;
    if (number == kAlarm)
        return Writing::alarm;
    if (number == kStop)
        return Writing::stop;
    if (within(kIgnored, number))
        return Writing::ignored;
    return number == 0 || (number >= kFirstModal && number <= kLastPosition) ? Writing::readOnly
                                                                             : Writing::stored;
}

} // namespace proveout
