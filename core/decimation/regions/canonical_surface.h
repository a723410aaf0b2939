// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

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
    /// The same at those of these places that count: `counts(Vec3)`.
    template<class Counts>
    [[nodiscard]] double distanceAlong(const Vec3& a, const Vec3& b, const Counts& counts) const;

private:
    const ZMapSnapshot& m_zmap;
};

template<class Counts>
double CanonicalSurface::distanceAlong(const Vec3& a, const Vec3& b, const Counts& counts) const {
    double largest = 0;
    const auto look = [&](const Vec3& place) {
        const double distance = std::abs(place.z - height(place.x, place.y));
        if (distance > largest && counts(place))
            largest = distance;
    };
    look(a);
    look(b);
    // The edges of the mesh are on four families of lines, each at the multiples of a step.
    struct Family {
        double from, to, step;
    };
    const std::array<Family, 4> families{
        {{a.x, b.x, 1}, {a.y, b.y, 1}, {a.x - a.y, b.x - b.y, 2}, {a.x + a.y, b.x + b.y, 2}}};
    for (const auto& [from, to, step] : families) {
        const double low = std::min(from, to) / step;
        const double high = std::max(from, to) / step;
        for (double line = std::floor(low) + 1; line < high; ++line)
            look(a + (line * step - from) / (to - from) * (b - a));
    }
    return largest;
}

} // namespace proveout
