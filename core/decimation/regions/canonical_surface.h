// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/geometry.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The canonical full mesh of a z-map as a function of place: what every error is measured against. Places
/// are in cells, (i, j) being a z-map point; heights in mm, relative to the top of the stock. Refers to the
/// moment it was made of. Any thread.
class CanonicalSurface {
public:
    explicit CanonicalSurface(const ZMapSnapshot& zmap) : m_zmap(zmap) {}

    [[nodiscard]] double height(double i, double j) const;
    /// The largest vertical distance between the surface and the straight line from `a` to `b`, mm. The
    /// difference of two piecewise linear surfaces is largest over a vertex of one of them or where an edge
    /// of one crosses an edge of the other; for the latter it is enough to ask this of each edge of one.
    [[nodiscard]] double distanceAlong(const Vec3& a, const Vec3& b) const;

private:
    const ZMapSnapshot& m_zmap;
};

} // namespace proveout
