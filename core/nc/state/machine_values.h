// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "core/nc/state/machine_state.h"
#include "core/nc/text/parameters.h"

namespace proveout {

/// Where M66 leaves what it has read.
inline constexpr int kInputParameter = 5399;
/// The number of the work offset in force.
inline constexpr int kActiveOffset = 5220;
/// Where LinuxCNC's probing motions leave what they have found: from X on, and at last whether they have.
inline constexpr int kProbeContact = 5061;
inline constexpr int kProbeSuccess = 5070;
/// Where G31 of Mach leaves what it has found: X, Y, Z, A, B, C.
inline constexpr int kMachProbed = 2000;
inline constexpr int kMachAxes = 6;

/// What LinuxCNC's parameters tell of the machine: #5420 to #5428, #<_x>, #<_metric> and the like. Keeps a
/// reference to the state.
class MachineValues : public SystemValues {
public:
    explicit MachineValues(const MachineState& state) : m_state(state) {}

    [[nodiscard]] std::optional<double> numbered(int number) const override;
    [[nodiscard]] bool writable(int number) const override;
    [[nodiscard]] const FindingRow* refusal(int number) const override;
    [[nodiscard]] std::optional<double> named(std::string_view name) const override;

    /// Whether the parameter of M66 was asked for since the last call of this.
    [[nodiscard]] bool consumeInputRead() { return std::exchange(m_inputRead, false); }

private:
    const MachineState& m_state;
    mutable bool m_inputRead = false;
};

/// What Mach's parameters tell of the machine: #5220. Its reference positions, and what a probe found before
/// the program, are refused, because only the machine knows them. Keeps a reference to the state.
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
