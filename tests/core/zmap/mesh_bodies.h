// SPDX-License-Identifier: GPL-3.0-or-later
// Closed meshes for tests.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/zmap/mesh_stock.h"

namespace proveout {

inline void addBox(StockMesh& mesh, const Vec3& lo, const Vec3& hi) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int k = 0; k < 8; ++k)
        mesh.vertices.push_back({k & 1 ? hi.x : lo.x, k & 2 ? hi.y : lo.y, k & 4 ? hi.z : lo.z});
    const std::array<std::array<std::uint32_t, 4>, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& s : sides) {
        mesh.triangles.push_back({first + s[0], first + s[1], first + s[2]});
        mesh.triangles.push_back({first + s[0], first + s[2], first + s[3]});
    }
}

/// A closed body around a centre; `radiusAt` is called for each vertex.
template<class RadiusAt>
StockMesh starBody(const Vec3& centre, int rings, int slices, RadiusAt&& radiusAt) {
    StockMesh mesh;
    const auto add = [&](double theta, double phi) {
        const Vec3 away(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
        mesh.vertices.push_back(centre + away * radiusAt());
    };
    add(0, 0);
    for (int r = 1; r < rings; ++r)
        for (int s = 0; s < slices; ++s)
            add(std::numbers::pi * r / rings, 2 * std::numbers::pi * s / slices);
    add(std::numbers::pi, 0);
    const auto at = [&](int r, int s) {
        return r == 0       ? 0U
               : r == rings ? static_cast<std::uint32_t>(mesh.vertices.size() - 1)
                            : static_cast<std::uint32_t>(1 + (r - 1) * slices + s % slices);
    };
    for (int r = 0; r < rings; ++r)
        for (int s = 0; s < slices; ++s) {
            if (r > 0)
                mesh.triangles.push_back({at(r, s), at(r + 1, s), at(r, s + 1)});
            if (r + 1 < rings)
                mesh.triangles.push_back({at(r, s + 1), at(r + 1, s), at(r + 1, s + 1)});
        }
    return mesh;
}

/// Single precision, as STL files have.
inline Vec3 inSingle(const Vec3& place) {
    return {static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z)};
}

/// A cylinder around the origin with its top at 0; its vertices are those of an STL file.
inline StockMesh roundBody(double radius, double height, int sides) {
    StockMesh mesh;
    mesh.vertices = {{0, 0, 0}, {0, 0, -height}};
    for (int k = 0; k < sides; ++k) {
        const double angle = 2 * std::numbers::pi * k / sides;
        const Vec3 place(radius * std::cos(angle), radius * std::sin(angle), 0);
        mesh.vertices.push_back(inSingle(place));
        mesh.vertices.push_back(inSingle(place - Vec3(0, 0, height)));
    }
    const auto at = [&](int k, int low) { return static_cast<std::uint32_t>(2 + 2 * (k % sides) + low); };
    for (int k = 0; k < sides; ++k) {
        mesh.triangles.push_back({0, at(k, 0), at(k + 1, 0)});
        mesh.triangles.push_back({1, at(k + 1, 1), at(k, 1)});
        mesh.triangles.push_back({at(k, 0), at(k, 1), at(k + 1, 1)});
        mesh.triangles.push_back({at(k, 0), at(k + 1, 1), at(k + 1, 0)});
    }
    return mesh;
}

/// About Z; the vertices become those of an STL file.
inline void turn(StockMesh& mesh, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    for (Vec3& vertex : mesh.vertices)
        vertex = inSingle({std::cos(angle) * vertex.x - std::sin(angle) * vertex.y,
                           std::sin(angle) * vertex.x + std::cos(angle) * vertex.y, vertex.z});
}

} // namespace proveout
