// SPDX-License-Identifier: GPL-3.0-or-later
// What depends on a probing motion, which a simulated stock has answered and not a machine.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/geometry.h"

namespace proveout {

struct Execution;
struct MachineState;
class Reporter;

/// Left by the last probing motion.
struct ProbeState {
    Vec3 place{0};          ///< where it stopped, in program coordinates, mm
    std::uint8_t axes = 0;  ///< AxisBits of the machine's position that it has left and nothing else has set
    bool simulated = false; ///< answered by the stock of the simulation
    bool asked = false;     ///< a probing motion was carried out
    bool assumedReported = false;
    bool useReported = false;
};

/// Tells once that what follows depends on it.
void reportProbeUse(MachineState& state, Reporter& reporter);

/// Behind a block: whether it went on from where the probe had stopped. `axes`: what ProbeState::axes was
/// before it; `firstMotion`: of the block.
void lookForProbeUse(Execution& execution, std::uint8_t axes, std::size_t firstMotion);

} // namespace proveout
