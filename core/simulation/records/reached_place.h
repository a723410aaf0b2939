// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this room.
#pragma once

#include "core/base/geometry.h"
#include "core/cutting/cut/cutting.h"

namespace proveout {

/// The possible difference of two exact cuts: 1 µm each.
inline constexpr double kOnSurface = 2e-3; // mm

/// Whether a motion cuts down to a place, or deeper.
[[nodiscard]] bool reaches(const CutterMotion& motion, const Vec3& place);

} // namespace proveout
