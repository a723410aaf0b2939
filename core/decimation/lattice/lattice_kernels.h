// SPDX-License-Identifier: GPL-3.0-or-later
// The inner loops of the certified method: how far the z-map is from a triangle at its points, and from an
// edge where the edge crosses the canonical mesh. There is one version per instruction set, chosen at run
// time; all give the same bits.
#pragma once

#include <cstdint>

#include "core/decimation/lattice/region_patch.h"

namespace proveout {

/// A vertex of a region's mesh: a point of the patch and its height there.
struct PatchVertex {
    std::int32_t i;
    std::int32_t j;
    float z;
};

/// Twice the signed area of a triangle, in cells; exact.
[[nodiscard]] constexpr std::int32_t twiceArea(const PatchVertex& a, const PatchVertex& b,
                                               const PatchVertex& c) {
    return (b.i - a.i) * (c.j - a.j) - (b.j - a.j) * (c.i - a.i);
}

/// A point of the patch and the vertical distance found there, mm, rounding included: the true distance is
/// not larger.
struct PatchDistance {
    float distance = 0;
    std::int32_t i = 0;
    std::int32_t j = 0;
};

/// The point of the closed triangle that is farthest from it; of equal ones that with the smallest row, then
/// the smallest column. Points on the sides of the patch are skipped: they are checked with the borders. The
/// triangle is counter-clockwise with a positive area.
[[nodiscard]] PatchDistance farthestPoint(const RegionPatch& patch, const PatchVertex& a,
                                          const PatchVertex& b, const PatchVertex& c, float limit);

/// The same distance if it is within `limit`; otherwise some distance beyond the limit, which is found
/// sooner.
[[nodiscard]] float distanceUpTo(const RegionPatch& patch, const PatchVertex& a, const PatchVertex& b,
                                 const PatchVertex& c, float limit);

} // namespace proveout
