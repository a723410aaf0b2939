// SPDX-License-Identifier: GPL-3.0-or-later
#include <time.h>

#include <algorithm>
#include <cmath>

#include "tests/bench/peers/peer.h"

namespace proveout::bench {

double cpuSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<LatticeTriangle> fullMesh(const PeerMap& map) {
    const RegionGrid grid(map.nx, map.ny, std::max(map.nx, map.ny));
    return fullRegionMesh(grid, 0);
}

Vec3 pointOf(const PeerMap& map, std::uint32_t index) {
    const auto nx = static_cast<std::uint32_t>(map.nx);
    return {index % nx * map.spacing, index / nx * map.spacing, static_cast<double>(map.heights[index])};
}

std::uint32_t indexOf(const PeerMap& map, double x, double y) {
    return static_cast<std::uint32_t>(std::lround(y / map.spacing) * map.nx + std::lround(x / map.spacing));
}

} // namespace proveout::bench
