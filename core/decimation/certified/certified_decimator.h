// SPDX-License-Identifier: GPL-3.0-or-later
// Decimation with a bound: every z-map point, or the whole surface, is within the allowance of the mesh,
// vertically. It works top-down: insertion until the bound holds, then removal of the vertices that are not
// needed for it.
#pragma once

#include <array>
#include <cstdint>

#include "core/decimation/certified/greedy_insertion.h"
#include "core/decimation/lattice/lattice_triangulation.h"
#include "core/decimation/lattice/region_patch.h"
#include "core/decimation/lattice/vertex_removal.h"
#include "core/decimation/regions/region_decimator.h"

namespace proveout {

class CertifiedDecimator final : public RegionDecimator {
public:
    /// Uses only the allowance and the level of the parameters. `largestError` of the mesh is a bound that
    /// includes all rounding: no z-map point is farther from the mesh. Where floats are too coarse for the
    /// heights of a region (their rounding may exceed half the allowance), the mesh is the full one.
    [[nodiscard]] RegionMesh decimate(const RegionGrid& grid, const RegionSamples& samples,
                                      const std::array<BorderLinePtr, 4>& borders, std::uint64_t seed,
                                      const DecimationParameters& parameters,
                                      const std::stop_token& stop = {}) override;

private:
    [[nodiscard]] BorderPoint borderPoint(std::int32_t vertex) const;

    RegionPatch m_patch;
    LatticeTriangulation m_mesh;
    GreedyInsertion m_insertion;
    VertexRemoval m_removal;
};

} // namespace proveout
