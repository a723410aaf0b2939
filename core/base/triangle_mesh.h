// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/geometry.h"

namespace proveout {

/// An indexed triangle mesh, mm; triangles counter-clockwise seen from outside.
struct TriangleMesh {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The number format of a coordinate in a file.
enum class CoordinateType : std::uint8_t { float32, float64 };

} // namespace proveout
