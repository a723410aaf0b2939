// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace proveout {

struct Execution;

/// The first motion behind a rotation names these axes: tells where controls differ about the others.
void reportTurning(Execution& execution, std::uint8_t named);

} // namespace proveout
