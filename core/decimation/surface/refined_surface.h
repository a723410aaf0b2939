// SPDX-License-Identifier: GPL-3.0-or-later
// The best surface of a z-map that is not being cut: within the allowance everywhere, and with neighbouring
// regions merged.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/decimation/surface/surface.h"

namespace proveout {

/// A surface of the certified method, at the level of its parameters, in which four neighbouring regions
/// become one mesh, four of these again, and so on up to a number of cells along a side. It is a function of
/// z-map and parameters, independent of the snapshots that it followed before: meshes are kept only where
/// nothing changed. Owned by one thread.
class RefinedSurface {
public:
    /// Up to here floats hold the products of coordinates and the rows of the row scan exactly.
    static constexpr int kMostCells = 1024;
    /// Blocks with more triangles stay in parts: there is little to gain, and a stop request would have to
    /// wait for their loading.
    static constexpr std::size_t kMostTriangles = 200'000;

    RefinedSurface() = default;
    RefinedSurface(int nx, int ny, const DecimationParameters& parameters, int mostCells = kMostCells);

    /// See Surface::followView(). Only regions of the same allowance are merged.
    void followView(std::span<const double> allowances) { (void)m_surface.followView(allowances); }

    [[nodiscard]] const RegionGrid& grid() const { return m_surface.grid(); }

    /// Updates to a snapshot that differs from the previous one at most in the regions `changed`. False if it
    /// was stopped: call it again with the regions changed since; there is no snapshot until it succeeds.
    [[nodiscard]] bool follow(const ZMapSnapshot& moment, std::span<const std::size_t> changed,
                              const WorkContext& context = {});

    /// The result for the last snapshot followed. The mesh of a merged block is stored at its first region;
    /// the meshes of its other regions have no triangles.
    [[nodiscard]] const SurfaceSnapshot& snapshot() const { return m_merged; }

private:
    /// A block of up to 2 × 2 blocks of the layer below.
    struct Block {
        std::array<RegionMeshPtr, 4> parts; ///< the meshes that were merged
        RegionMeshPtr mesh;                 ///< null: stays in parts
    };
    struct Layer {
        int regions = 1; ///< along a side of a block
        int blocksX = 1;
        int blocksY = 1;
        std::vector<Block> blocks;
    };

    struct Worker;

    [[nodiscard]] bool redecimate(const ZMapSnapshot& moment, const WorkContext& context);
    void spreadAlongExtras(const SurfaceSnapshot& shown);
    [[nodiscard]] bool mergeLayer(std::size_t layer, const ZMapSnapshot& moment, const WorkContext& context);
    [[nodiscard]] RegionMeshPtr meshBelow(std::size_t layer, int bx, int by) const;
    [[nodiscard]] RegionMeshPtr merged(const Layer& layer, std::size_t block, const ZMapSnapshot& moment,
                                       Worker& worker, const std::stop_token& stop) const;
    void assemble();
    void cover(SurfaceSnapshot& shown, std::size_t layer, int bx, int by) const;

    Surface m_surface; ///< the unmerged regions
    std::vector<std::size_t>
        m_together;                 ///< regions that are decimated together, starting from their own borders
    std::vector<bool> m_isTogether; ///< per region
    std::vector<Layer> m_layers;
    SurfaceSnapshot m_merged;
};

/// The surface of a z-map with every region decimated, for files: regions of the certified method are merged
/// as far as rounding to single precision allows. After a stop the result is not a valid surface.
[[nodiscard]] SurfaceSnapshot decimatedWhole(const ZMapSnapshot& zmap, const DecimationParameters& parameters,
                                             const WorkContext& context = {});

} // namespace proveout
