// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/lattice/patch_mesh.h"

#include <algorithm>
#include <cmath>

#include "core/decimation/lattice/edge_crossings.h"

namespace proveout {

namespace {

/// The largest distance along an edge. Only one of the two triangles at the edge counts it; the result for
/// the other is 0.
float edgeDistance(const LatticeTriangulation& mesh, const RegionPatch& patch, std::int32_t edge,
                   ErrorLevel level) {
    const PatchVertex& a = mesh.vertex(mesh.origin(edge));
    const PatchVertex& b = mesh.vertex(mesh.origin(LatticeTriangulation::next(edge)));
    const std::int32_t twin = mesh.twin(edge);
    if (twin == LatticeTriangulation::kNone) // on a line of the canonical mesh: only points count
        return farthestBorderPoint(patch, a, b).distance;
    return level == ErrorLevel::surface && edge < twin ? farthestCrossing(patch, a, b).distance : 0;
}

} // namespace

RegionMesh regionMeshOf(const LatticeTriangulation& mesh, const RegionPatch& patch, const RegionGrid& grid,
                        const IndexRect& rect, const DecimationParameters& parameters) {
    const auto slots = static_cast<std::int32_t>(mesh.triangleSlots());
    std::size_t count = 0;
    for (std::int32_t t = 0; t < slots; ++t)
        count += mesh.isAlive(t) ? 1 : 0;
    RegionMesh made;
    made.triangles.reserve(count);
    const auto lattice = [&](std::int32_t v) {
        const PatchVertex& p = mesh.vertex(v);
        return grid.lattice(rect.i0 + p.i, rect.j0 + p.j);
    };
    float largest = 0;
    for (std::int32_t t = 0; t < slots; ++t) {
        if (!mesh.isAlive(t))
            continue;
        const LatticeTriangulation::Triangle& triangle = mesh.triangle(t);
        made.triangles.push_back(
            {lattice(triangle.vertex[0]), lattice(triangle.vertex[1]), lattice(triangle.vertex[2])});
        largest = std::max(largest, triangle.distance);
        for (std::int32_t k = 0; k < 3; ++k)
            largest = std::max(largest, edgeDistance(mesh, patch, 4 * t + k, parameters.level));
    }
    // Borders are certified in doubles; the rounding of floats here may exceed the allowance.
    made.largestError = std::min(double{largest}, parameters.allowance);
    return made;
}

float floatNotAbove(double number) {
    const auto nearest = static_cast<float>(number);
    return double{nearest} > number ? std::nextafter(nearest, 0.0F) : nearest;
}

} // namespace proveout
