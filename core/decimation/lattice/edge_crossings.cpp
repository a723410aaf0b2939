// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/lattice/edge_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <tuple>
#include <utility>

namespace proveout {

namespace {

/// One of the four families of lines. Line c holds the lattice points c·across + s·along of the patch.
struct Family {
    std::int32_t cFrom, cTo; ///< lines of the edge's ends
    std::int32_t sFrom, sTo; ///< positions of the ends along the lines
    std::int32_t step;       ///< distance between lines
    std::int32_t offset;     ///< of a line; the others are multiples of `step` from it
    std::ptrdiff_t across;
    std::ptrdiff_t along;
};

std::array<Family, 4> familiesOf(const RegionPatch& patch, const PatchVertex& a, const PatchVertex& b) {
    const std::ptrdiff_t stride = patch.stride();
    return {{{a.i, b.i, a.j, b.j, 1, 0, 1, stride},
             {a.j, b.j, a.i, b.i, 1, 0, stride, 1},
             {a.i - a.j, b.i - b.j, a.i, b.i, 2, patch.parity(), -stride, 1 + stride},
             {a.i + a.j, b.i + b.j, a.i, b.i, 2, patch.parity(), stride, 1 - stride}}};
}

bool liesInCanonicalMesh(const RegionPatch& patch, const PatchVertex& a, const PatchVertex& b) {
    const std::int32_t i = b.i - a.i;
    const std::int32_t j = b.j - a.j;
    return i == 0 || j == 0 || ((i == j || i == -j) && ((a.i + a.j + patch.parity()) & 1) == 0);
}

/// Calls visit(family, line, s, distance) for every crossing except those at the edge's ends; s is the
/// position along the line. Stops and returns false if visit returns false.
template<class Visit>
[[gnu::always_inline]] inline bool visitCrossings(const RegionPatch& patch, const PatchVertex& from,
                                                  const PatchVertex& to, Visit&& visit) {
    if (liesInCanonicalMesh(patch, from, to))
        return true; // it crosses the mesh at z-map points only
    const bool ordered = from.j < to.j || (from.j == to.j && from.i < to.i);
    const PatchVertex& a = ordered ? from : to;
    const PatchVertex& b = ordered ? to : from;
    const float* heights = patch.heights();
    const double rise = double{b.z} - double{a.z};
    for (const Family& family : familiesOf(patch, a, b)) {
        const std::int32_t lines = family.cTo - family.cFrom;
        if (lines == 0)
            continue;
        const std::int32_t low = std::min(family.cFrom, family.cTo) + 1;
        const std::int32_t high = std::max(family.cFrom, family.cTo);
        const double perLine = 1.0 / lines;
        const double advance = (family.sTo - family.sFrom) * perLine;
        const std::int32_t first =
            family.step == 1 ? low : low + ((low ^ family.offset) & 1); // the next line with the family's
                                                                        // parity
        for (std::int32_t c = first; c < high; c += family.step) {
            const double gone = c - family.cFrom;
            const double s = family.sFrom + gone * advance;
            const auto whole = static_cast<std::int32_t>(s);
            const double part = s - whole;
            const float* at = heights + c * family.across + whole * family.along;
            const double full = double{at[0]} + part * (double{at[family.along]} - double{at[0]});
            const double own = double{a.z} + gone * perLine * rise;
            if (!visit(family, c, s, std::abs(own - full)))
                return false;
        }
    }
    return true;
}

} // namespace

SurfaceCrossing farthestCrossing(const RegionPatch& patch, const PatchVertex& a, const PatchVertex& b) {
    double largest = 0;
    Family crossed{};
    std::int32_t line = 0;
    double where = 0;
    visitCrossings(patch, a, b, [&](const Family& family, std::int32_t c, double s, double distance) {
        if (distance > largest) {
            largest = distance;
            crossed = family;
            line = c;
            where = s;
        }
        return true;
    });
    if (largest == 0)
        return {};
    SurfaceCrossing found;
    found.distance = static_cast<float>(largest + patch.guard(largest));
    const auto below = static_cast<std::int32_t>(where);
    const bool isLowNearer = where - below < 0.5;
    const auto pointOf = [&](std::int32_t s) {
        const auto at = static_cast<std::int32_t>(line * crossed.across + s * crossed.along);
        return std::pair{at % patch.stride(), at / patch.stride()};
    };
    std::tie(found.nearI, found.nearJ) = pointOf(isLowNearer ? below : below + 1);
    std::tie(found.farI, found.farJ) = pointOf(isLowNearer ? below + 1 : below);
    return found;
}

bool crossingsWithin(const RegionPatch& patch, const PatchVertex& a, const PatchVertex& b, float limit) {
    const double most = double{limit} - patch.guard(double{limit});
    return visitCrossings(
        patch, a, b, [&](const Family&, std::int32_t, double, double distance) { return distance <= most; });
}

PatchDistance farthestBorderPoint(const RegionPatch& patch, const PatchVertex& a, const PatchVertex& b) {
    const std::int32_t length = std::max(std::abs(b.i - a.i), std::abs(b.j - a.j));
    double largest = 0;
    PatchDistance worst;
    for (std::int32_t k = 1; k < length; ++k) {
        const std::int32_t i = a.i + (b.i - a.i) / length * k;
        const std::int32_t j = a.j + (b.j - a.j) / length * k;
        const double z = double{a.z} + (double{b.z} - double{a.z}) * k / length;
        const double distance = std::abs(z - double{patch.at(i, j)});
        if (distance > largest) {
            largest = distance;
            worst = {0, i, j};
        }
    }
    worst.distance = static_cast<float>(largest + patch.guard(largest));
    return worst;
}

} // namespace proveout
