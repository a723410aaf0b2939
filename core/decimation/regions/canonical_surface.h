// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/geometry.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The canonical full mesh of a z-map as a function of position, against which every error is measured.
/// Positions are in cells, (i, j) being a z-map point; heights in mm, relative to the top of the stock.
/// Refers to the snapshot it was made from. Any thread.
class CanonicalSurface {
public:
    explicit CanonicalSurface(const ZMapSnapshot& zmap) : m_zmap(zmap) {}

    [[nodiscard]] double height(double i, double j) const;
    /// The largest vertical distance between the surface and the straight line from `a` to `b`, mm. The
    /// difference of two piecewise linear surfaces is largest at a vertex of one of them or where an edge of
    /// one crosses an edge of the other; for the latter it is enough to compute this for each edge of one of
    /// them.
    [[nodiscard]] double distanceAlong(const Vec3& a, const Vec3& b) const;

private:
    const ZMapSnapshot& m_zmap;
};

} // namespace proveout
