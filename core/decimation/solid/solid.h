// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/work_context.h"
#include "core/decimation/regions/region_mesh.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// An indexed triangle mesh in program coordinates, mm; triangles counter-clockwise seen from outside.
struct TriangleMesh {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// What a file holds a coordinate in.
enum class CoordinateType : std::uint8_t { float32, float64 };

/// Vertices and edges where two sheets of the solid would touch are set apart by this much, mm.
inline constexpr double kPinchGap = 1e-4;

/// Closes a surface by walls and a floor into a solid: closed, 2-manifold, normals outwards. Triangles that
/// lie wholly on the stock's floor are holes: they leave top and floor; vertices and edges where sheets would
/// pinch are split and set apart by kPinchGap, or by four steps of float32 where the coordinates are so large
/// that STL could not hold it. Empty where nothing of the stock is left, and where the context was stopped.
/// `surface` must cover the map without cracks (SurfaceSnapshot::triangles() of BorderRule::shared); moved
/// in, its memory becomes that of the solid. Any thread.
[[nodiscard]] TriangleMesh closeSolid(const ZMapSnapshot& zmap, std::vector<LatticeTriangle> surface,
                                      const WorkContext& context = {});

} // namespace proveout
