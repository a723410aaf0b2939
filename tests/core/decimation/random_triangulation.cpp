// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/decimation/random_triangulation.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <set>

namespace proveout::test {

namespace {

struct Lattice {
    int nx;
    int ny;

    [[nodiscard]] int i(std::uint32_t v) const { return static_cast<int>(v) % nx; }
    [[nodiscard]] int j(std::uint32_t v) const { return static_cast<int>(v) / nx; }
    [[nodiscard]] long twiceArea(const LatticeTriangle& t) const {
        return static_cast<long>(i(t[1]) - i(t[0])) * (j(t[2]) - j(t[0])) -
               static_cast<long>(i(t[2]) - i(t[0])) * (j(t[1]) - j(t[0]));
    }
    /// One bit for each side of the map that contains the point.
    [[nodiscard]] int sides(std::uint32_t v) const {
        return (i(v) == 0 ? 1 : 0) | (i(v) == nx - 1 ? 2 : 0) | (j(v) == 0 ? 4 : 0) |
               (j(v) == ny - 1 ? 8 : 0);
    }
};

bool has(const LatticeTriangle& triangle, std::uint32_t vertex) {
    return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end();
}

/// Merges `from` into `to`; the triangles stay unchanged if that is not allowed. It is allowed if the result
/// covers the same area with positive triangles only.
void tryCollapse(const Lattice& lattice, std::vector<LatticeTriangle>& triangles, std::uint32_t from,
                 std::uint32_t to) {
    if ((lattice.sides(from) & lattice.sides(to)) != lattice.sides(from))
        return;
    std::vector<LatticeTriangle> fan;
    long before = 0;
    long after = 0;
    for (const LatticeTriangle& triangle : triangles) {
        if (!has(triangle, from))
            continue;
        before += lattice.twiceArea(triangle);
        if (has(triangle, to))
            continue;
        LatticeTriangle moved = triangle;
        std::replace(moved.begin(), moved.end(), from, to);
        if (lattice.twiceArea(moved) <= 0)
            return;
        after += lattice.twiceArea(moved);
        fan.push_back(moved);
    }
    if (before != after)
        return;
    std::erase_if(triangles, [from](const LatticeTriangle& triangle) { return has(triangle, from); });
    triangles.insert(triangles.end(), fan.begin(), fan.end());
}

} // namespace

std::vector<LatticeTriangle> fullTriangulation(int nx, int ny) {
    std::vector<LatticeTriangle> triangles;
    const auto at = [nx](int i, int j) { return static_cast<std::uint32_t>(j * nx + i); };
    for (int j = 0; j + 1 < ny; ++j) {
        for (int i = 0; i + 1 < nx; ++i) {
            const auto sw = at(i, j);
            const auto se = at(i + 1, j);
            const auto nw = at(i, j + 1);
            const auto ne = at(i + 1, j + 1);
            if ((i + j) % 2 == 0) {
                triangles.push_back({sw, se, ne});
                triangles.push_back({sw, ne, nw});
            } else {
                triangles.push_back({sw, se, nw});
                triangles.push_back({se, ne, nw});
            }
        }
    }
    return triangles;
}

std::vector<LatticeTriangle> randomTriangulation(int nx, int ny, std::size_t collapses,
                                                 std::mt19937& random) {
    const Lattice lattice{nx, ny};
    auto triangles = fullTriangulation(nx, ny);
    for (std::size_t n = 0; n < collapses; ++n) {
        const LatticeTriangle& triangle = triangles[random() % triangles.size()];
        const auto corner = random() % 3;
        const auto from = triangle[corner];
        const auto to = triangle[(corner + 1 + random() % 2) % 3];
        tryCollapse(lattice, triangles, from, to);
    }
    return triangles;
}

} // namespace proveout::test
