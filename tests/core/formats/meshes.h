// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes for the tests of mesh files.
#pragma once

#include <random>

#include "core/decimation/solid/solid.h"

namespace proveout::test {

inline TriangleMesh tetrahedron(double size = 1, const Vec3& corner = Vec3(0)) {
    return {{corner, corner + Vec3(size, 0, 0), corner + Vec3(0, size, 0), corner + Vec3(0, 0, size)},
            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// `count` unconnected triangles on few vertices with arbitrary coordinates.
inline TriangleMesh randomSoup(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-300, 300);
    TriangleMesh mesh;
    for (std::size_t i = 0; i < count / 2 + 3; ++i)
        mesh.vertices.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    while (mesh.triangles.size() < count) {
        const auto pick = [&] { return static_cast<std::uint32_t>(random() % mesh.vertices.size()); };
        const std::array<std::uint32_t, 3> triangle{pick(), pick(), pick()};
        if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
            mesh.triangles.push_back(triangle);
    }
    return mesh;
}

} // namespace proveout::test
