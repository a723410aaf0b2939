// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/decimation/surface/surface.h"

namespace proveout {

/// The triangles that the decimated regions of one size would have, when only some of them are decimated: a
/// region has as many beyond those of the uncut stock as another size, the reference, has on the same area,
/// times a factor that follows from the decimated regions (the ratio estimate of W. G. Cochran, "Sampling
/// Techniques", ch. 6). Owned by one thread.
class RegionFaces {
public:
    /// `uncut`: triangles of each region of the uncut stock, decimated.
    RegionFaces(const RegionGrid& grid, std::vector<double> uncut);

    [[nodiscard]] const std::vector<double>& now() const { return m_now; }
    /// Triangles of an area beyond those of the uncut stock: regions that are partly inside count by their
    /// share of cells.
    [[nodiscard]] double beyondUncut(const IndexRect& points) const;
    /// The regions of `touched` (ascending) have changed: those decimated in `surface` have its triangles,
    /// the others are estimated from `reference`, which has been updated to the same moment. `drawn` of them
    /// were decimated because they were chosen at random, and determine the factor. Returns the triangles of
    /// `touched`.
    std::vector<double> update(std::span<const std::size_t> touched, std::span<const std::size_t> drawn,
                               const SurfaceSnapshot& surface, const RegionFaces& reference);

private:
    RegionGrid m_grid;
    std::vector<double> m_uncut;
    std::vector<double> m_now;
    double m_beyond = 0;          ///< of regions drawn, with decreasing weight for older ones
    double m_referenceBeyond = 0; ///< of the reference, on the same areas
};

} // namespace proveout
