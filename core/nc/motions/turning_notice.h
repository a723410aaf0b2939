// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace proveout {

struct Execution;

/// The first motion after a rotation names these axes: reports that controls differ for the other ones.
void reportTurning(Execution& execution, std::uint8_t named);

} // namespace proveout
