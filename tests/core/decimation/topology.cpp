// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/decimation/topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace proveout::test {

namespace {

struct Point {
    long long i, j;
};

Point pointOf(std::uint32_t lattice, int nx) {
    return {lattice % static_cast<std::uint32_t>(nx), lattice / static_cast<std::uint32_t>(nx)};
}

long long twiceArea(Point a, Point b, Point c) {
    return (b.i - a.i) * (c.j - a.j) - (b.j - a.j) * (c.i - a.i);
}

} // namespace

void expectCoversMap(int nx, int ny, std::span<const LatticeTriangle> triangles) {
    long long area = 0;
    std::size_t turned = 0;
    std::vector<std::uint64_t> edges;
    edges.reserve(triangles.size() * 3);
    for (const LatticeTriangle& t : triangles) {
        const long long own = twiceArea(pointOf(t[0], nx), pointOf(t[1], nx), pointOf(t[2], nx));
        turned += own <= 0 ? 1 : 0;
        area += own;
        for (std::size_t k = 0; k < 3; ++k)
            edges.push_back(std::uint64_t{t[k]} << 32U | t[(k + 1) % 3]);
    }
    EXPECT_EQ(turned, 0U) << "flipped or degenerate faces";
    EXPECT_EQ(area, 2LL * (nx - 1) * (ny - 1)) << "twice the area of the map";

    std::sort(edges.begin(), edges.end());
    EXPECT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end()) << "an edge used twice";
    std::size_t open = 0;
    long long outline = 0;
    for (const std::uint64_t edge : edges) {
        if (std::binary_search(edges.begin(), edges.end(), edge << 32U | edge >> 32U))
            continue;
        const Point a = pointOf(static_cast<std::uint32_t>(edge >> 32U), nx);
        const Point b = pointOf(static_cast<std::uint32_t>(edge), nx);
        const bool isOutline =
            (a.i == b.i && (a.i == 0 || a.i == nx - 1)) || (a.j == b.j && (a.j == 0 || a.j == ny - 1));
        open += isOutline ? 0 : 1;
        outline += std::abs(a.i - b.i) + std::abs(a.j - b.j);
    }
    EXPECT_EQ(open, 0U) << "open edges inside the map";
    EXPECT_EQ(outline, 2LL * (nx - 1 + ny - 1)) << "length of the outline";
}

double bruteForceError(int nx, int ny, const Heights& heights, std::span<const LatticeTriangle> triangles) {
    const auto z = [&](long long i, long long j) -> long double {
        return heights[static_cast<std::size_t>(j * nx + i)];
    };
    std::vector<double> distance(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny), -1);
    for (const LatticeTriangle& t : triangles) {
        const Point a = pointOf(t[0], nx);
        const Point b = pointOf(t[1], nx);
        const Point c = pointOf(t[2], nx);
        const long double bi = b.i - a.i, bj = b.j - a.j, bz = z(b.i, b.j) - z(a.i, a.j);
        const long double ci = c.i - a.i, cj = c.j - a.j, cz = z(c.i, c.j) - z(a.i, a.j);
        const long double ni = bj * cz - bz * cj, nj = bz * ci - bi * cz, nz = bi * cj - bj * ci;
        for (long long j = std::min({a.j, b.j, c.j}); j <= std::max({a.j, b.j, c.j}); ++j) {
            for (long long i = std::min({a.i, b.i, c.i}); i <= std::max({a.i, b.i, c.i}); ++i) {
                const Point p{i, j};
                if (twiceArea(a, b, p) < 0 || twiceArea(b, c, p) < 0 || twiceArea(c, a, p) < 0)
                    continue;
                const long double above =
                    z(i, j) - z(a.i, a.j) +
                    (ni * static_cast<long double>(i - a.i) + nj * static_cast<long double>(j - a.j)) / nz;
                double& worst = distance[static_cast<std::size_t>(j * nx + i)];
                worst = std::max(worst, static_cast<double>(std::abs(above)));
            }
        }
    }
    double largest = 0;
    for (const double d : distance)
        largest = std::max(largest, d < 0 ? std::numeric_limits<double>::infinity() : d);
    return largest;
}

} // namespace proveout::test
