// SPDX-License-Identifier: GPL-3.0-or-later
// Closed meshes in closed form.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "core/part/part_distance.h"
#include "tests/random_seed.h"

namespace proveout::test {

using Random = std::mt19937;

struct Mesh {
    std::vector<Vec3> vertices;
    std::vector<PartDistance::Facet> facets;
};

[[nodiscard]] inline double uniform(Random& random, double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
}

[[nodiscard]] inline Vec3 randomDirection(Random& random) {
    const double z = uniform(random, -1, 1);
    const double angle = uniform(random, 0, 2 * std::numbers::pi);
    const double round = std::sqrt(1 - z * z);
    return {round * std::cos(angle), round * std::sin(angle), z};
}

[[nodiscard]] inline Mesh boxMesh(const Vec3& lo, const Vec3& hi) {
    Mesh box;
    for (int k = 0; k < 8; ++k)
        box.vertices.emplace_back((k & 1) != 0 ? hi.x : lo.x, (k & 2) != 0 ? hi.y : lo.y,
                                  (k & 4) != 0 ? hi.z : lo.z);
    box.facets = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                  {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return box;
}

/// Around the origin, with `count` meridians and half as many rings: chords of π / (count / 2).
[[nodiscard]] inline Mesh sphereMesh(double radius, std::uint32_t count) {
    Mesh sphere;
    const std::uint32_t rings = count / 2;
    sphere.vertices.emplace_back(0, 0, radius);
    for (std::uint32_t ring = 1; ring < rings; ++ring) {
        const double polar = std::numbers::pi * ring / rings;
        for (std::uint32_t k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * k / count;
            sphere.vertices.push_back(radius * Vec3(std::sin(polar) * std::cos(angle),
                                                    std::sin(polar) * std::sin(angle), std::cos(polar)));
        }
    }
    sphere.vertices.emplace_back(0, 0, -radius);
    const auto at = [&](std::uint32_t ring, std::uint32_t k) { return 1 + (ring - 1) * count + k % count; };
    const auto south = static_cast<std::uint32_t>(sphere.vertices.size() - 1);
    for (std::uint32_t k = 0; k < count; ++k) {
        sphere.facets.push_back({0, at(1, k), at(1, k + 1)});
        for (std::uint32_t ring = 1; ring + 1 < rings; ++ring) {
            sphere.facets.push_back({at(ring, k), at(ring + 1, k), at(ring + 1, k + 1)});
            sphere.facets.push_back({at(ring, k), at(ring + 1, k + 1), at(ring, k + 1)});
        }
        sphere.facets.push_back({south, at(rings - 1, k + 1), at(rings - 1, k)});
    }
    return sphere;
}

} // namespace proveout::test
