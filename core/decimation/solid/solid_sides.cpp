// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/solid_sides.h"

#include <cmath>
#include <vector>

#include "core/decimation/solid/solid_error.h"

namespace proveout {

namespace {

/// A vertex of a side: the distance along it from left to right seen from outside, and the height.
struct SidePoint {
    Vec2 exact{0};
    Vec2 inFloat{0}; ///< as STL will store it
    std::uint32_t vertex = 0;
};

/// Whether a, b, c turn to the left, by more than the rounding of these products.
bool turnsLeft(const Vec2& a, const Vec2& b, const Vec2& c) {
    constexpr double kErr = 1e-12;
    const double plus = (b.x - a.x) * (c.y - a.y);
    const double minus = (c.x - a.x) * (b.y - a.y);
    return plus - minus > kErr * (std::abs(plus) + std::abs(minus));
}

/// Whether the chain is convex at `ear`, both before and after rounding to float32: points that are collinear
/// except for their last bits may be convex in only one of them, and their triangle would face inwards in the
/// other.
bool isConvex(const SidePoint& before, const SidePoint& ear, const SidePoint& after) {
    return turnsLeft(before.exact, after.exact, ear.exact) &&
           turnsLeft(before.inFloat, after.inFloat, ear.inFloat);
}

/// Triangulates a monotone mountain, that is, a chain over one straight base from `chain.front()` to
/// `chain.back()`. A convex vertex of the chain can always be cut off, because only the base is below the
/// connection of its neighbours; and a chain above its base always has a convex vertex. Collinear vertices
/// are postponed, so that no triangle has zero area.
void triangulateMountain(const std::vector<SidePoint>& chain, TriangleMesh& mesh) {
    std::vector<SidePoint> open;
    const auto cutOff = [&](const SidePoint& next) {
        const SidePoint ear = open.back();
        open.pop_back();
        mesh.triangles.push_back({open.back().vertex, next.vertex, ear.vertex});
    };
    for (const SidePoint& point : chain) {
        while (open.size() >= 2 && isConvex(open[open.size() - 2], open.back(), point))
            cutOff(point);
        open.push_back(point);
    }
    // Something is left here only if float32 cannot represent the detail of the wall; it is closed all the
    // same.
    const SidePoint last = open.back();
    open.pop_back();
    while (open.size() >= 2)
        cutOff(last);
}

} // namespace

void addSide(std::span<const std::uint32_t> vertices, const Vec2& along, TriangleMesh& solid) {
    std::vector<SidePoint> chain;
    chain.reserve(vertices.size());
    for (const std::uint32_t vertex : vertices) {
        const Vec3& at = solid.vertices[vertex];
        const Vec3 rounded = roundedTo(CoordinateType::float32, at);
        chain.push_back(
            {{glm::dot(along, Vec2(at)), at.z}, {glm::dot(along, Vec2(rounded)), rounded.z}, vertex});
    }
    triangulateMountain(chain, solid);
}

} // namespace proveout
