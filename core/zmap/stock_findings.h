// SPDX-License-Identifier: GPL-3.0-or-later
// What a z-map cannot hold of a body. Inside the room only.
#pragma once

#include <algorithm>

#include "core/base/diagnostic.h"
#include "core/base/geometry.h"

namespace proveout {

/// Air under the surface of a body, which its z-map shows as material.
struct Undercut {
    /// Less is what roundings make of a level face, mm.
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
    /// Nothing where there is none.
    [[nodiscard]] Diagnostics reported() const;
};

} // namespace proveout
