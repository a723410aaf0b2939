// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/decimation/lattice/vertex_removal.h"
#include "core/decimation/regions/region_decimator.h"

namespace proveout {

/// Merges the certified meshes of neighbouring regions into one: vertices that they had to keep along their
/// common borders are removed where the allowance permits it. The outline stays unchanged except at the edge
/// of the map, so neighbours are not affected. Owned by one thread; keeps its storage.
class RegionMerge {
public:
    /// `parts` are the meshes (not null) that together cover `samples.rect` once; `split` is the lattice
    /// point of the patch where their borders meet. Null if floats are too coarse for the heights of the
    /// whole, or if it was stopped.
    [[nodiscard]] RegionMeshPtr merge(const RegionGrid& grid, const RegionSamples& samples,
                                      std::span<const RegionMeshPtr> parts, std::array<int, 2> split,
                                      const DecimationParameters& parameters, const std::stop_token& stop);

private:
    void load(const RegionGrid& grid, const IndexRect& rect, std::span<const RegionMeshPtr> parts);
    std::int32_t vertexAt(std::int32_t i, std::int32_t j);

    RegionPatch m_patch;
    LatticeTriangulation m_mesh;
    VertexRemoval m_removal;
    std::vector<PatchVertex> m_vertices;
    std::vector<std::int32_t> m_vertexAt; ///< per point of the patch; -1: not a vertex
    std::vector<std::array<std::int32_t, 3>> m_triangles;
    std::vector<std::int32_t> m_seeds;
};

} // namespace proveout
