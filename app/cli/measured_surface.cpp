// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measured_surface.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/decimation/error_measure.h"

namespace proveout::cli {

namespace {

constexpr double kWorthCounting = 0.01; ///< of the error allowance

Vec3 rounding(const Vec3& point) {
    return glm::abs(point - Vec3(glm::vec<3, float>(point)));
}

/// An upper bound of the vertical distance between the surface and itself with coordinates of float32: a
/// vertex moves vertically by the rounding of z, and the surface moves under it by slope times that in plan.
double roundingError(std::span<const LatticeTriangle> triangles, const ZMapSnapshot& zmap) {
    const Grid& grid = zmap.grid();
    const auto vertex = [&](std::uint32_t lattice) {
        const int i = static_cast<int>(lattice % static_cast<std::uint32_t>(grid.nx));
        const int j = static_cast<int>(lattice / static_cast<std::uint32_t>(grid.nx));
        return Vec3(grid.x(i), grid.y(j), zmap.stock().topZ() + static_cast<double>(zmap.height(i, j)));
    };
    Vec3 moved(0);
    Vec2 steepest(0);
    for (const LatticeTriangle& triangle : triangles) {
        const Vec3 a = vertex(triangle[0]);
        const Vec3 b = vertex(triangle[1]);
        const Vec3 c = vertex(triangle[2]);
        moved = glm::max(glm::max(moved, rounding(a)), glm::max(rounding(b), rounding(c)));
        const Vec3 normal = glm::cross(b - a, c - a);
        steepest = glm::max(steepest, glm::abs(Vec2(normal) / normal.z));
    }
    return moved.z + steepest.x * moved.x + steepest.y * moved.y;
}

} // namespace

MeasuredSurface measure(const SurfaceSnapshot& surface, const ZMapSnapshot& zmap,
                        const DecimationParameters& parameters, bool stl) {
    const bool decimated = surface.dirtyRegions != surface.grid.regionCount();
    if (!decimated && !stl)
        return {};
    const std::vector<LatticeTriangle> triangles = surface.triangles();
    MeasuredSurface measured;
    if (decimated) {
        const IndexRect all{0, 0, zmap.grid().nx, zmap.grid().ny};
        measured.largestErrorMm = measureVerticalError(zmap, all, triangles, parameters.allowance).largest;
        measured.level = parameters.certify ? "sample" : "measured";
    }
    const double rounded = stl ? roundingError(triangles, zmap) : 0;
    if (rounded > kWorthCounting * parameters.allowance)
        measured.largestErrorMm += rounded;
    return measured;
}

} // namespace proveout::cli
