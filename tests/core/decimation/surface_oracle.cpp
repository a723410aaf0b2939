// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/decimation/surface_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace proveout::test {

namespace {

struct Place {
    double x, y, z;
};

double heightAt(int nx, const Heights& heights, int i, int j) {
    return heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i)];
}

Place placeOf(int nx, const Heights& heights, std::uint32_t lattice) {
    const int i = static_cast<int>(lattice % static_cast<std::uint32_t>(nx));
    const int j = static_cast<int>(lattice / static_cast<std::uint32_t>(nx));
    return {double(i), double(j), heightAt(nx, heights, i, j)};
}

/// Visits the points where a value that changes linearly from `from` to `to` along the edge reaches a
/// multiple of `step` (counted from 0).
template<class Visit>
void crossings(double from, double to, int step, Visit&& visit) {
    if (from == to)
        return;
    const double low = std::min(from, to);
    const double high = std::max(from, to);
    for (int at = static_cast<int>(std::floor(low / step)) * step; at <= high; at += step)
        if (at > low && at < high)
            visit((at - from) / (to - from));
}

double edgeDistance(int nx, const Heights& heights, const Place& a, const Place& b) {
    double largest = 0;
    const auto look = [&](double t) {
        const double x = a.x + t * (b.x - a.x);
        const double y = a.y + t * (b.y - a.y);
        const double z = a.z + t * (b.z - a.z);
        largest = std::max(largest, std::abs(z - canonicalHeight(nx, heights, x, y)));
    };
    crossings(a.x, b.x, 1, look);
    crossings(a.y, b.y, 1, look);
    crossings(a.x - a.y, b.x - b.y, 2, look);
    crossings(a.x + a.y, b.x + b.y, 2, look);
    return largest;
}

} // namespace

double canonicalHeight(int nx, const Heights& heights, double x, double y) {
    const int ny = static_cast<int>(heights.size()) / nx;
    const int i = std::clamp(static_cast<int>(std::floor(x)), 0, nx - 2);
    const int j = std::clamp(static_cast<int>(std::floor(y)), 0, ny - 2);
    const double u = x - i;
    const double v = y - j;
    const double sw = heightAt(nx, heights, i, j);
    const double se = heightAt(nx, heights, i + 1, j);
    const double nw = heightAt(nx, heights, i, j + 1);
    const double ne = heightAt(nx, heights, i + 1, j + 1);
    if ((i + j) % 2 == 0) // "/"
        return u >= v ? sw + u * (se - sw) + v * (ne - se) : sw + v * (nw - sw) + u * (ne - nw);
    return u + v <= 1 ? sw + u * (se - sw) + v * (nw - sw) : ne + (1 - u) * (nw - ne) + (1 - v) * (se - ne);
}

SurfaceDistance surfaceDistance(int nx, int ny, const Heights& heights,
                                std::span<const LatticeTriangle> triangles) {
    std::vector<bool> covered(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny), false);
    SurfaceDistance found;
    for (const LatticeTriangle& triangle : triangles) {
        const std::array<Place, 3> p{placeOf(nx, heights, triangle[0]), placeOf(nx, heights, triangle[1]),
                                     placeOf(nx, heights, triangle[2])};
        const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
        for (double y = std::min({p[0].y, p[1].y, p[2].y}); y <= std::max({p[0].y, p[1].y, p[2].y}); ++y) {
            for (double x = std::min({p[0].x, p[1].x, p[2].x}); x <= std::max({p[0].x, p[1].x, p[2].x});
                 ++x) {
                std::array<double, 3> weight{};
                for (std::size_t k = 0; k < 3; ++k) {
                    const Place& a = p[(k + 1) % 3];
                    const Place& b = p[(k + 2) % 3];
                    weight[k] = (a.x - x) * (b.y - y) - (a.y - y) * (b.x - x);
                }
                if (weight[0] < 0 || weight[1] < 0 || weight[2] < 0)
                    continue;
                const double z = (weight[0] * p[0].z + weight[1] * p[1].z + weight[2] * p[2].z) / area;
                const auto i = static_cast<int>(x);
                const auto j = static_cast<int>(y);
                found.samples = std::max(found.samples, std::abs(z - heightAt(nx, heights, i, j)));
                covered[static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) +
                        static_cast<std::size_t>(i)] = true;
            }
        }
    }
    if (!std::all_of(covered.begin(), covered.end(), [](bool is) { return is; }))
        found.samples = std::numeric_limits<double>::infinity();
    found.surface = std::max(found.samples, edgesDistance(nx, heights, triangles));
    return found;
}

double edgesDistance(int nx, const Heights& heights, std::span<const LatticeTriangle> triangles) {
    double largest = 0;
    for (const LatticeTriangle& triangle : triangles)
        for (std::size_t k = 0; k < 3; ++k)
            largest = std::max(largest, edgeDistance(nx, heights, placeOf(nx, heights, triangle[k]),
                                                     placeOf(nx, heights, triangle[(k + 1) % 3])));
    return largest;
}

} // namespace proveout::test
