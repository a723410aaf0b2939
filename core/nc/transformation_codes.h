// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace proveout {

struct Execution;

/// A rotation that began or ended, and behind which its axes were not positioned yet.
struct Turning {
    std::uint8_t axes = 0; ///< AxisBits; 0: none
    bool ended = false;
};

/// The first motion behind a rotation names these axes: tells where controls differ about the others.
void tellTurning(Execution& execution, std::uint8_t named);

} // namespace proveout
