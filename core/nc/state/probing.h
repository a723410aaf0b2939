// SPDX-License-Identifier: GPL-3.0-or-later
// Whether results depend on a probing motion that was answered by a simulated stock and not by a machine.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/geometry.h"

namespace proveout {

struct Execution;
struct MachineState;
class Reporter;

/// The result of the last probing motion.
struct ProbeState {
    Vec3 place{0};          ///< where it stopped, in program coordinates, mm
    std::uint8_t axes = 0;  ///< AxisBits of the machine's position that come from it and that nothing else
                            ///< has set
    bool simulated = false; ///< answered by the stock of the simulation
    bool asked = false;     ///< a probing motion was executed
    bool assumedReported = false;
    bool useReported = false;
};

/// Reports once that what follows depends on it.
void reportProbeUse(MachineState& state, Reporter& reporter);

/// After a block: checks whether it continued from where the probe had stopped. `axes`: ProbeState::axes
/// before the block; `firstMotion`: of the block.
void lookForProbeUse(Execution& execution, std::uint8_t axes, std::size_t firstMotion);

} // namespace proveout
