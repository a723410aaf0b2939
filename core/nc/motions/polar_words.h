// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/geometry.h"

namespace proveout {

struct Execution;

/// Writes the point that the words of the plane give into `program`; returns the AxisBits that were set.
/// `known`: AxisBits of `program`. A radius relative to an unknown position is reported.
std::uint8_t readPolarWords(Execution& execution, std::uint8_t known, Vec3& program);

} // namespace proveout
