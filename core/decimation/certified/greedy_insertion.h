// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <stop_token>
#include <vector>

#include "core/decimation/lattice/edge_crossings.h"
#include "core/decimation/lattice/lattice_triangulation.h"

namespace proveout {

/// Builds a region's mesh from above: corners and borders first, then the farthest z-map point of each
/// triangle that is beyond the limit, until none is (M. Garland and P. S. Heckbert, "Fast Polygonal
/// Approximation of Terrains and Height Fields", with a stack where they have a heap).
class GreedyInsertion {
public:
    /// `borders` are the kept offsets of the four sides in the order of kSides; `limit` is in mm. False where
    /// it was stopped.
    bool run(const RegionPatch& patch, const std::array<std::span<const std::uint32_t>, 4>& borders,
             float limit, bool surface, LatticeTriangulation& mesh, const std::stop_token& stop);

    /// Vertices on borders that the surface level needed beyond those given.
    [[nodiscard]] std::span<const std::int32_t> extras() const { return m_extras; }

private:
    bool refineSamples(const RegionPatch& patch, float limit, LatticeTriangulation& mesh,
                       const std::stop_token& stop);
    bool refineEdges(const RegionPatch& patch, float limit, LatticeTriangulation& mesh);
    void insertAtCrossing(const RegionPatch& patch, std::int32_t t, const EdgeCrossing& crossing, float limit,
                          LatticeTriangulation& mesh);
    void insertExtra(const RegionPatch& patch, std::int32_t t, std::int32_t i, std::int32_t j, float limit,
                     LatticeTriangulation& mesh);
    std::int32_t insertPoint(const RegionPatch& patch, std::int32_t t, std::int32_t i, std::int32_t j,
                             LatticeTriangulation& mesh);
    [[nodiscard]] std::uint8_t& occupied(std::int32_t i, std::int32_t j) {
        return m_taken[static_cast<std::size_t>(j) * m_width + static_cast<std::size_t>(i)];
    }
    void insertBorders(const RegionPatch& patch, const std::array<std::span<const std::uint32_t>, 4>& borders,
                       LatticeTriangulation& mesh);
    void pushTouched(LatticeTriangulation& mesh);

    std::vector<std::int32_t> m_touched;
    std::vector<std::int32_t> m_stack; ///< triangles to look at, each once
    std::vector<std::int32_t> m_edges; ///< triangles whose edges are to be looked at
    std::vector<std::uint8_t> m_taken; ///< per point: it is a vertex
    std::vector<std::int32_t> m_extras;
    std::size_t m_width = 0;
};

} // namespace proveout
