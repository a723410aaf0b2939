// SPDX-License-Identifier: GPL-3.0-or-later
// Reports what a z-map cannot represent of a body. Internal to this library.
#pragma once

#include <algorithm>

#include "core/base/diagnostic.h"
#include "core/base/geometry.h"

namespace proveout {

/// Air under the surface of a body, which its z-map shows as material.
struct Undercut {
    /// A smaller gap, in mm, is the result of rounding on a horizontal face.
    static constexpr double kLeast = 2e-3;

    double volumeMm3 = 0;
    double tallest = 0; ///< mm
    Vec3 place{0};      ///< the upper end of the tallest gap

    void add(double volume, double gap, const Vec3& where) {
        volumeMm3 += volume;
        if (gap > tallest)
            place = where;
        tallest = std::max(tallest, gap);
    }
    /// The findings; empty if there is no such air.
    [[nodiscard]] Diagnostics reported() const;
};

} // namespace proveout
