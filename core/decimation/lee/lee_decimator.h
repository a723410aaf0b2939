// SPDX-License-Identifier: GPL-3.0-or-later
// The decimation of one region as in section 4 of S. H. Lee and K.-S. Lee, "Local Mesh Decimation for
// View-Independent Three-Axis NC Milling Simulation".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/decimation/lattice/lattice_scan.h"
#include "core/decimation/lee/region_half_edges.h"
#include "core/decimation/regions/region_decimator.h"

namespace proveout {

class LeeDecimator final : public RegionDecimator {
public:
    [[nodiscard]] RegionMesh decimate(const RegionGrid& grid, const RegionSamples& samples,
                                      const std::array<BorderLinePtr, 4>& borders, std::uint64_t seed,
                                      const DecimationParameters& parameters,
                                      const std::stop_token& stop = {}) override;

private:
    void build(const RegionSamples& samples, const std::array<BorderLinePtr, 4>& borders,
               const DecimationParameters& parameters);
    void orderVertices(const std::array<BorderLinePtr, 4>& borders, std::uint64_t seed,
                       const DecimationParameters& parameters);
    void tryRemove(OpenMesh::VertexHandle vertex);
    [[nodiscard]] double localError(const Star& star) const;
    [[nodiscard]] bool staysWithin(const Star& star, std::size_t target) const;
    [[nodiscard]] RegionMesh result(const RegionGrid& grid, const RegionSamples& samples) const;
    [[nodiscard]] LatticeCorner corner(OpenMesh::VertexHandle vertex) const;

    RegionHalfEdges m_mesh;
    std::vector<double> m_error;        ///< accumulated error e of each vertex, mm
    std::vector<std::uint32_t> m_order; ///< vertices to be tested
    std::vector<double> m_lengths;      ///< squared, of the current candidates; infinite once refused
    LatticeHeights m_heights{};
    double m_hx = 1;
    double m_hy = 1;
    double m_allowance = 0;
    double m_limit = 0; ///< vertical distance that `certify` allows
    bool m_certify = true;
};

} // namespace proveout
