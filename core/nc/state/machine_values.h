// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "core/nc/state/machine_state.h"
#include "core/nc/text/parameters.h"

namespace proveout {

/// The parameter in which M66 stores its result.
inline constexpr int kInputParameter = 5399;
/// The number of the work offset in force.
inline constexpr int kActiveOffset = 5220;
/// Where LinuxCNC's probing motions store their results: from X on, and finally whether they made contact.
inline constexpr int kProbeContact = 5061;
inline constexpr int kProbeSuccess = 5070;
/// Where G31 of Mach stores its result: X, Y, Z, A, B, C.
inline constexpr int kMachProbed = 2000;
inline constexpr int kMachAxes = 6;

/// The state of the machine in LinuxCNC's parameters: #5420 to #5428, #<_x>, #<_metric> and similar ones.
/// Keeps a reference to the state.
class MachineValues : public SystemValues {
public:
    explicit MachineValues(const MachineState& state) : m_state(state) {}

    [[nodiscard]] std::optional<double> numbered(int number) const override;
    [[nodiscard]] bool writable(int number) const override;
    [[nodiscard]] const FindingRow* refusal(int number) const override;
    [[nodiscard]] std::optional<double> named(std::string_view name) const override;

    /// Whether the parameter of M66 was read since the last call of this function.
    [[nodiscard]] bool consumeInputRead() { return std::exchange(m_inputRead, false); }

private:
    const MachineState& m_state;
    mutable bool m_inputRead = false;
};

/// The state of the machine in Mach's parameters: #5220. Its reference positions, and the results of a probe
/// before the program, are refused, because only the machine knows them. Keeps a reference to the state.
class OffsetValues : public SystemValues {
public:
    explicit OffsetValues(const MachineState& state) : m_state(state) {}

    [[nodiscard]] std::optional<double> numbered(int number) const override;
    [[nodiscard]] const FindingRow* refusal(int number) const override;
    [[nodiscard]] std::optional<double> named(std::string_view name) const override;

private:
    const MachineState& m_state;
};

} // namespace proveout
