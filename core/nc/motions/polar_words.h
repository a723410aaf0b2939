// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/geometry.h"

namespace proveout {

struct Execution;

/// Puts the point that the words of the plane give into `program`; the AxisBits of what they set. `known`:
/// AxisBits of `program`. A radius that counts from an unknown place is told.
std::uint8_t readPolarWords(Execution& execution, std::uint8_t known, Vec3& program);

} // namespace proveout
