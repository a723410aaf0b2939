// SPDX-License-Identifier: GPL-3.0-or-later
// Which axes of the machine have a known position.
#pragma once

#include <cstdint>

#include "core/nc/state/machine_state.h"
#include "core/nc/text/block.h"

namespace proveout {

/// Why the place of an axis is no longer known.
enum class Forgotten : std::uint8_t {
    silently, ///< the first motion from there reports it
    reported, ///< by an error after which everything is unverified; to report it again would be noise
};

/// From now on the position of these axes is unknown: X, Y, Z, and the letters of polar coordinates for X and
/// Y.
void forgetAxes(MachineState& state, LetterSet axes, Forgotten why = Forgotten::silently);

} // namespace proveout
