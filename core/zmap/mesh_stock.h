// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/zmap/stock_shape.h"

namespace proveout {

/// Triangles are all counter-clockwise seen from outside, or all clockwise; program coordinates, mm.
struct StockMesh {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The material inside a closed mesh, as high as its upper surface at each point of the grid (a point on the
/// rim included). Measured over the points of the grid and reported as findings: the air below that surface,
/// and where the mesh is open. Its top() is as high at any place, and has its upright walls where they are,
/// unless hundreds of its triangles are over one place. `warnings`, about the file, come first among them.
/// Errors: a mesh without height or extent in plan, or with hundreds of layers of facets above one another;
/// coordinates that are not finite or are beyond 10 km.
[[nodiscard]] Result<std::shared_ptr<const StockBody>> meshStock(StockMesh mesh, Diagnostics warnings = {});

} // namespace proveout
