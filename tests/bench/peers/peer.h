// SPDX-License-Identifier: GPL-3.0-or-later
// Decimators of a height field, ours and those of other libraries, with a common interface.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/geometry.h"
#include "core/decimation/regions/region_mesh.h"
#include "tests/core/decimation/maps.h"

namespace proveout::bench {

struct PeerMap {
    int nx = 0;
    int ny = 0;
    double spacing = 0.1; ///< mm
    test::Heights heights;
};

struct PeerResult {
    std::vector<LatticeTriangle> triangles;  ///< if the vertices are points of the map
    std::vector<std::array<Vec3, 3>> facets; ///< if the vertices have moved, mm
    double seconds = 0;                      ///< CPU time of the decimation, without preparing its input
};

/// A decimator in one of its modes. `faces` is the result of ours at the surface level.
struct Peer {
    const char* name;
    const char* asked;
    PeerResult (*run)(const PeerMap& map, double allowance, std::size_t faces);
};

using Peers = std::vector<Peer>;

[[nodiscard]] Peers ourPeers();
[[nodiscard]] Peers meshoptimizerPeers();
[[nodiscard]] Peers openMeshPeers();
[[nodiscard]] Peers cgalPeers();
[[nodiscard]] Peers vtkPeers();

/// CPU time of this thread.
[[nodiscard]] double cpuSeconds();

/// The canonical full mesh of the whole map.
[[nodiscard]] std::vector<LatticeTriangle> fullMesh(const PeerMap& map);
[[nodiscard]] Vec3 pointOf(const PeerMap& map, std::uint32_t index);
/// The index of the map point nearest to a position.
[[nodiscard]] std::uint32_t indexOf(const PeerMap& map, double x, double y);

} // namespace proveout::bench
