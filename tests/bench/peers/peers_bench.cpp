// SPDX-License-Identifier: GPL-3.0-or-later
// Compares ours with the installed decimators of other libraries, on the same map in one run: triangles left,
// triangles in per second of CPU time, and the true vertical error, measured by an oracle that shares no code
// with any of them. Prints a Markdown table.
//
//     peers_bench MAP.npy SPACING [CELLS [ALLOWANCE]]     the CELLS × CELLS in the middle of a map
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "core/formats/npy.h"
#include "tests/bench/peers/peer.h"
#include "tests/core/decimation/surface_oracle.h"

namespace {

using namespace proveout;
using namespace proveout::bench;

/// The middle of an array; heights are relative to the highest point.
PeerMap cropped(const NpyArray& array, double spacing, int cells) {
    PeerMap map;
    map.nx = std::min(cells + 1, array.columns);
    map.ny = std::min(cells + 1, array.rows);
    map.spacing = spacing;
    const int i0 = (array.columns - map.nx) / 2;
    const int j0 = (array.rows - map.ny) / 2;
    for (int j = 0; j < map.ny; ++j)
        for (int i = 0; i < map.nx; ++i)
            map.heights.push_back(static_cast<float>(
                array.values[static_cast<std::size_t>(j0 + j) * static_cast<std::size_t>(array.columns) +
                             static_cast<std::size_t>(i0 + i)]));
    const float top = *std::max_element(map.heights.begin(), map.heights.end());
    for (float& height : map.heights)
        height -= top;
    return map;
}

/// Twice the signed area in plan.
double area(const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Largest vertical distance of a map point from arbitrary facets; infinity if a point is not covered.
double distanceAtPoints(const PeerMap& map, const std::vector<std::array<Vec3, 3>>& facets) {
    std::vector<double> nearest(map.heights.size(), std::numeric_limits<double>::infinity());
    for (const auto& [a, b, c] : facets) {
        const double whole = area(a, b, c);
        if (whole == 0)
            continue;
        const auto first = [&](double low) {
            return std::max(0, static_cast<int>(std::floor(low / map.spacing)));
        };
        const int i1 =
            std::min(map.nx - 1, static_cast<int>(std::ceil(std::max({a.x, b.x, c.x}) / map.spacing)));
        const int j1 =
            std::min(map.ny - 1, static_cast<int>(std::ceil(std::max({a.y, b.y, c.y}) / map.spacing)));
        for (int j = first(std::min({a.y, b.y, c.y})); j <= j1; ++j)
            for (int i = first(std::min({a.x, b.x, c.x})); i <= i1; ++i) {
                const Vec3 p(i * map.spacing, j * map.spacing, 0);
                const double u = area(p, b, c) / whole;
                const double v = area(a, p, c) / whole;
                const double w = 1 - u - v;
                constexpr double kRim = -1e-9;
                if (u < kRim || v < kRim || w < kRim)
                    continue;
                const auto at = static_cast<std::size_t>(j * map.nx + i);
                const double off =
                    std::abs(u * a.z + v * b.z + w * c.z - static_cast<double>(map.heights[at]));
                nearest[at] = std::min(nearest[at], off);
            }
    }
    return *std::max_element(nearest.begin(), nearest.end());
}

void row(const PeerMap& map, const Peer& peer, double allowance, std::size_t& ours) {
    const PeerResult result = peer.run(map, allowance, ours);
    const std::size_t faces = result.triangles.size() + result.facets.size();
    if (ours == 0)
        ours = faces;
    const double in = 2.0 * (map.nx - 1) * (map.ny - 1);
    std::printf("| %s | %s | %zu | %.3g | ", peer.name, peer.asked, faces, in / result.seconds * 1e-6);
    if (result.facets.empty()) {
        const test::SurfaceDistance error =
            test::surfaceDistance(map.nx, map.ny, map.heights, result.triangles);
        std::printf("%.4f | %.4f |\n", error.samples, error.surface);
    } else {
        std::printf("%.4f | |\n", distanceAtPoints(map, result.facets));
    }
    std::fflush(stdout);
}

Peers all() {
    Peers peers = ourPeers();
    const auto add = [&](const Peers& more) { peers.insert(peers.end(), more.begin(), more.end()); };
#ifdef PROVEOUT_MESHOPTIMIZER
    add(meshoptimizerPeers());
#endif
    add(openMeshPeers());
#ifdef PROVEOUT_CGAL
    add(cgalPeers());
#endif
#ifdef PROVEOUT_VTK
    add(vtkPeers());
#endif
    return peers;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "peers_bench MAP.npy SPACING [CELLS [ALLOWANCE]]\n");
        return 1;
    }
    const auto array = readNpy(argv[1]);
    if (!array) {
        std::fprintf(stderr, "%s cannot be read.\n", argv[1]);
        return 1;
    }
    constexpr int kCells = 400;
    constexpr double kAllowance = 0.05;
    const PeerMap map = cropped(*array, std::atof(argv[2]), argc > 3 ? std::atoi(argv[3]) : kCells);
    const double allowance = argc > 4 ? std::atof(argv[4]) : kAllowance;
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    std::printf("%d × %d points at %g mm, ε = %g mm\n\n", map.nx, map.ny, map.spacing, allowance);
    std::printf("| decimator | asked for | faces | Mtri/s | at points, mm | surface, mm "
                "|\n|---|---|---|---|---|---|\n");
    std::size_t ours = 0;
    for (const Peer& peer : all())
        row(map, peer, allowance, ours);
    return 0;
}
