// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/geometry.h"

namespace proveout {

/// The distance of a point from a line between two others, and from a triangle.
[[nodiscard]] double distanceToSegment(const Vec3& point, const Vec3& a, const Vec3& b);
[[nodiscard]] double distanceToTriangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c);

} // namespace proveout
