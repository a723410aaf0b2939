// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/lee/vertex_error.h"

#include <cmath>

namespace proveout {

double averagePlaneDistance(const Star& star, double hx, double hy) {
    const auto position = [&](std::size_t k) {
        const OpenMesh::Vec3d& offset = star.spokes[k].offset;
        return Vec3{offset[0] * hx, offset[1] * hy, offset[2]};
    };
    // All lengths are relative to the vertex itself, so that the distance is that of the origin and no digits
    // are lost at large heights.
    Vec3 normal{0}; // Σ 2 A_i N_i
    Vec3 centre{0}; // Σ 2 A_i 3 P_i
    double area = 0;
    Vec3 a = position(0);
    for (std::size_t k = 0; k < star.faceCount(); ++k) {
        const Vec3 b = position(star.nextSpoke(k));
        const Vec3 cross = glm::cross(a, b);
        const double twice = glm::length(cross);
        normal += cross;
        centre += twice * (a + b);
        area += twice;
        a = b;
    }
    return std::abs(glm::dot(normal, centre)) / (3 * area * glm::length(normal));
}

double borderLineDistance(const Star& star, double hx, double hy) {
    const OpenMesh::Vec3d& a = star.spokes.front().offset;
    const OpenMesh::Vec3d& b = star.spokes.back().offset;
    // A border runs along x or along y, so one of the two sums is zero.
    return lineDistance({a[0] * hx + a[1] * hy, a[2]}, {b[0] * hx + b[1] * hy, b[2]});
}

double lineDistance(const Vec2& a, const Vec2& b) {
    return std::abs(a.x * b.y - a.y * b.x) / glm::length(b - a);
}

} // namespace proveout
