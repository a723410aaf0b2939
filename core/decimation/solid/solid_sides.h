// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this library.
#pragma once

#include <cstdint>
#include <span>

#include "core/decimation/solid/solid.h"

namespace proveout {

/// Adds the triangles of a side of a solid: a polygon whose lower edge leads straight from the first to the
/// last of its vertices, the others being above it. `along`: a unit vector over ground, from left to right as
/// seen from outside.
void addSide(std::span<const std::uint32_t> vertices, const Vec2& along, TriangleMesh& solid);

} // namespace proveout
