// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/steep_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace proveout::test {

namespace {

using Real = long double;
using Corners = std::array<Vec3, 3>;

Real heightAt(const ZMapSnapshot& zmap, int i, int j) {
    return Real(zmap.stock().topZ()) + Real(zmap.height(i, j));
}

/// Of the full mesh: "/" joins (i, j) and (i + 1, j + 1) where i + j is even, "\" the other two otherwise.
Real fullMeshAt(const ZMapSnapshot& zmap, Real x, Real y) {
    const Grid& grid = zmap.grid();
    const Real u = std::clamp<Real>((x - grid.x0) / grid.hx, 0, grid.nx - 1);
    const Real v = std::clamp<Real>((y - grid.y0) / grid.hy, 0, grid.ny - 1);
    const int i = std::min(static_cast<int>(u), grid.nx - 2);
    const int j = std::min(static_cast<int>(v), grid.ny - 2);
    const Real p = u - i;
    const Real q = v - j;
    const Real a = heightAt(zmap, i, j);
    const Real b = heightAt(zmap, i + 1, j);
    const Real c = heightAt(zmap, i, j + 1);
    const Real d = heightAt(zmap, i + 1, j + 1);
    if ((i + j) % 2 == 0)
        return q <= p ? a + p * (b - a) + q * (d - b) : a + q * (c - a) + p * (d - c);
    return p + q <= 1 ? a + p * (b - a) + q * (c - a) : d + (1 - p) * (c - d) + (1 - q) * (b - d);
}

Real crossOf(const Vec3& a, const Vec3& b, Real x, Real y) {
    return (a.x - x) * (b.y - y) - (a.y - y) * (b.x - x);
}

/// Places within a triangle.
Real distanceWithin(const ZMapSnapshot& zmap, const Corners& at) {
    constexpr int kSteps = 6;
    Real largest = 0;
    for (int k = 0; k <= kSteps; ++k)
        for (int l = 0; k + l <= kSteps; ++l) {
            const Real a = Real(k) / kSteps;
            const Real b = Real(l) / kSteps;
            const auto mixed = [&](auto of) {
                return a * of(at[0]) + b * of(at[1]) + (1 - a - b) * of(at[2]);
            };
            const Real z = mixed([](const Vec3& corner) { return Real(corner.z); });
            largest = std::max(
                largest,
                std::abs(z - fullMeshAt(zmap, mixed([](const Vec3& corner) { return Real(corner.x); }),
                                        mixed([](const Vec3& corner) { return Real(corner.y); }))));
        }
    return largest;
}

} // namespace

ZMapSnapshot mapAt(const Vec3& corner, double width, double depth, double spacing,
                   const std::function<double(int i, int j)>& height) {
    const StockBox stock{corner, width, depth, 25};
    ZMap zmap(stock, makeGrid(stock, spacing).value());
    for (std::size_t t = 0; t < zmap.tileCount(); ++t) {
        Tile& tile = zmap.tileForWriting(t);
        const IndexRect rect = zmap.tileRect(t);
        for (int j = rect.j0; j < rect.j1; ++j)
            for (int i = rect.i0; i < rect.i1; ++i)
                tile.at(i - rect.i0, j - rect.j0) = static_cast<float>(height(i, j));
        tile.refreshMaximum();
    }
    return zmap.snapshot();
}

ZMapSnapshot waveAt(double far, double height) {
    return mapAt({far, -3.3, 1.7}, 30, 20, 0.25,
                 [height](int i, int j) { return -10 + height * std::sin(0.3 * i) * std::cos(0.1 * j); });
}

ZMapSnapshot pocketsAt(const Vec3& corner, double spacing, std::uint32_t seed) {
    constexpr int kCells = 80;
    std::mt19937 random(seed);
    const auto upTo = [&random](double size) {
        return std::uniform_real_distribution<double>(0, size)(random);
    };
    struct Pocket {
        double i, j, radius, depth;
    };
    std::vector<Pocket> pockets;
    for (int k = 0; k < 5; ++k)
        pockets.push_back({upTo(kCells), upTo(kCells), 4 + upTo(15), 0.5 + upTo(3)});
    return mapAt(corner, kCells * spacing, kCells * spacing, spacing, [&](int i, int j) {
        double z = -3 + 2 * std::sin(0.1 * i) + 0.9 * std::cos(0.07 * j);
        for (const Pocket& pocket : pockets)
            z -= std::hypot(i - pocket.i, j - pocket.j) < pocket.radius ? pocket.depth : 0;
        return z;
    });
}

double distanceFrom(const ZMapSnapshot& zmap, const TriangleMesh& file) {
    const Grid& grid = zmap.grid();
    Vec2 low(std::numeric_limits<double>::infinity());
    Vec2 high(-std::numeric_limits<double>::infinity());
    for (const Vec3& vertex : file.vertices) {
        low = glm::min(low, Vec2(vertex));
        high = glm::max(high, Vec2(vertex));
    }
    Real largest = 0;
    std::vector<bool> covered(static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny));
    for (const auto& triangle : file.triangles) {
        const Corners at{file.vertices[triangle[0]], file.vertices[triangle[1]], file.vertices[triangle[2]]};
        const Real area = crossOf(at[1], at[2], at[0].x, at[0].y);
        if (area <= 0)
            continue;
        largest = std::max(largest, distanceWithin(zmap, at));
        const auto [left, right] = std::minmax({at[0].x, at[1].x, at[2].x});
        const auto [front, back] = std::minmax({at[0].y, at[1].y, at[2].y});
        const int i1 = std::min(grid.nx - 1, static_cast<int>((right - grid.x0) / grid.hx) + 1);
        const int j1 = std::min(grid.ny - 1, static_cast<int>((back - grid.y0) / grid.hy) + 1);
        for (int j = std::max(0, static_cast<int>((front - grid.y0) / grid.hy) - 1); j <= j1; ++j)
            for (int i = std::max(0, static_cast<int>((left - grid.x0) / grid.hx) - 1); i <= i1; ++i) {
                const Real x = std::clamp(grid.x(i), low.x, high.x);
                const Real y = std::clamp(grid.y(j), low.y, high.y);
                const Real a = crossOf(at[1], at[2], x, y) / area;
                const Real b = crossOf(at[2], at[0], x, y) / area;
                const Real c = crossOf(at[0], at[1], x, y) / area;
                if (std::min({a, b, c}) < -1e-12L)
                    continue;
                covered[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nx) +
                        static_cast<std::size_t>(i)] = true;
                largest = std::max(largest,
                                   std::abs(a * at[0].z + b * at[1].z + c * at[2].z - heightAt(zmap, i, j)));
            }
    }
    return std::ranges::find(covered, false) == covered.end() ? static_cast<double>(largest)
                                                              : std::numeric_limits<double>::infinity();
}

} // namespace proveout::test
