// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/regions/canonical_surface.h"

#include <algorithm>
#include <cmath>

namespace proveout {

double CanonicalSurface::height(double i, double j) const {
    const Grid& grid = m_zmap.grid();
    const int west = static_cast<int>(std::clamp(std::floor(i), 0.0, grid.nx - 2.0));
    const int south = static_cast<int>(std::clamp(std::floor(j), 0.0, grid.ny - 2.0));
    const double u = i - west;
    const double v = j - south;
    const auto at = [&](int di, int dj) { return static_cast<double>(m_zmap.height(west + di, south + dj)); };
    if ((west + south) % 2 == 0) // the diagonal "/": two of the triangle's edges are grid lines
        return at(0, 0) + (u >= v ? u * (at(1, 0) - at(0, 0)) + v * (at(1, 1) - at(1, 0))
                                  : v * (at(0, 1) - at(0, 0)) + u * (at(1, 1) - at(0, 1)));
    if (u + v <= 1) // below "\"
        return at(0, 0) + u * (at(1, 0) - at(0, 0)) + v * (at(0, 1) - at(0, 0));
    return at(1, 1) + (1 - u) * (at(0, 1) - at(1, 1)) + (1 - v) * (at(1, 0) - at(1, 1));
}

double CanonicalSurface::distanceAlong(const Vec3& a, const Vec3& b) const {
    return distanceAlong(a, b, [](const Vec3&) { return true; });
}

} // namespace proveout
