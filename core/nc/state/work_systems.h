// SPDX-License-Identifier: GPL-3.0-or-later
// The work coordinate systems of Fanuc's dialect: 1 to 6 are G54 to G59, 7 and up are G54.1 P1 and up (Haas:
// G154). Each is stored in the system variables, in mm.
#pragma once

#include <cstdint>

#include "core/nc/program/program.h"
#include "core/nc/state/machine_state.h"
#include "core/nc/text/parameters.h"

namespace proveout {

inline constexpr int kStandardSystems = 6;
inline constexpr int kMostAdditionalSystems = 300;
/// Added to all systems: the external offset of Fanuc, G52 of Haas.
inline constexpr int kCommonOffset = 5201;

/// The variable of X of a system.
[[nodiscard]] int systemVariable(int system);
/// Whether a variable is an offset, so that its value is in the unit of the program.
[[nodiscard]] bool isWorkOffset(int variable);

/// Activates the offsets with their present values.
void refreshFrame(MachineState& state, const Parameters& parameters, Program& program, std::uint32_t line);

} // namespace proveout
