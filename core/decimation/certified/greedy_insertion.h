// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <stop_token>
#include <vector>

#include "core/decimation/lattice/edge_crossings.h"
#include "core/decimation/lattice/lattice_triangulation.h"

namespace proveout {

/// Builds a region's mesh top-down: corners and borders first, then the farthest z-map point of each triangle
/// that exceeds the limit, until none does (M. Garland and P. S. Heckbert, "Fast Polygonal Approximation of
/// Terrains and Height Fields", with a stack in place of their heap).
class GreedyInsertion {
public:
    /// `borders` are the kept offsets of the four sides in the order of kSides; `limit` is in mm. False if it
    /// was stopped.
    bool run(const RegionPatch& patch, const std::array<std::span<const std::uint32_t>, 4>& borders,
             float limit, bool surface, LatticeTriangulation& mesh, const std::stop_token& stop);

    /// Vertices on borders that the surface level needed in addition to those given.
    [[nodiscard]] std::span<const std::int32_t> extras() const { return m_extras; }

private:
    bool refineSamples(const RegionPatch& patch, float limit, LatticeTriangulation& mesh,
                       const std::stop_token& stop);
    bool refineEdges(const RegionPatch& patch, float limit, LatticeTriangulation& mesh);
    void insertAtCrossing(const RegionPatch& patch, std::int32_t t, const SurfaceCrossing& crossing,
                          float limit, LatticeTriangulation& mesh);
    void insertExtra(const RegionPatch& patch, std::int32_t t, std::int32_t i, std::int32_t j, float limit,
                     LatticeTriangulation& mesh);
    std::int32_t insertPoint(const RegionPatch& patch, std::int32_t t, std::int32_t i, std::int32_t j,
                             LatticeTriangulation& mesh);
    [[nodiscard]] std::uint8_t& occupied(std::int32_t i, std::int32_t j) {
        return m_taken[static_cast<std::size_t>(j) * m_width + static_cast<std::size_t>(i)];
    }
    void insertBorders(const RegionPatch& patch, const std::array<std::span<const std::uint32_t>, 4>& borders,
                       LatticeTriangulation& mesh);
    std::int32_t insertFrom(const RegionPatch& patch, std::int32_t before, std::int32_t i, std::int32_t j,
                            LatticeTriangulation& mesh);
    void insertWalls(const RegionPatch& patch, LatticeTriangulation& mesh);
    void pushTouched(LatticeTriangulation& mesh);

    std::vector<std::int32_t> m_touched;
    std::vector<std::int32_t> m_stack; ///< triangles to check, each once
    std::vector<std::int32_t> m_edges; ///< triangles whose edges are to be checked
    std::vector<std::uint8_t> m_taken; ///< per point: whether it is a vertex
    std::vector<std::int32_t> m_extras;
    std::size_t m_width = 0;
};

} // namespace proveout
