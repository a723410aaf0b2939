// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace proveout {

/// A rotation that began or ended, after which its axes have not been positioned yet.
struct Turning {
    std::uint8_t axes = 0; ///< AxisBits; 0: none
    bool ended = false;
};

} // namespace proveout
