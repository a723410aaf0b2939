// SPDX-License-Identifier: GPL-3.0-or-later
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/decimation/lattice/lattice_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway compiles this file once per target.
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/decimation/lattice/lattice_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace proveout::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::ScalableTag<float>;
using Vector = hn::Vec<Floats>;

constexpr float kUnit = std::numeric_limits<float>::epsilon() / 2;

/// A triangle prepared for the row scan: rectangle, plane and edge functions, all relative to corner a.
struct Scan {
    PatchVertex corner[3];
    int i0, i1, j0, j1; ///< the points to check, inclusive
    float slopeI, slopeJ;
    float guard; ///< the error that rounding may add to a distance

    Scan(const RegionPatch& patch, const PatchVertex& a, const PatchVertex& b, const PatchVertex& c)
        : corner{a, b, c} {
        i0 = std::max(1, std::min({a.i, b.i, c.i}));
        i1 = std::min(patch.width() - 2, std::max({a.i, b.i, c.i}));
        j0 = std::max(1, std::min({a.j, b.j, c.j}));
        j1 = std::min(patch.height() - 2, std::max({a.j, b.j, c.j}));
        const double inverse = 1.0 / twiceArea(a, b, c);
        const double zb = double{b.z} - a.z;
        const double zc = double{c.z} - a.z;
        slopeI = static_cast<float>((zb * (c.j - a.j) - zc * (b.j - a.j)) * inverse);
        slopeJ = static_cast<float>((zc * (b.i - a.i) - zb * (c.i - a.i)) * inverse);
        const int wide = std::max({a.i, b.i, c.i}) - std::min({a.i, b.i, c.i});
        const int high = std::max({a.j, b.j, c.j}) - std::min({a.j, b.j, c.j});
        // Slopes, their products, two sums, the difference, and the heights themselves: each rounds once.
        guard = 5 * kUnit *
                (static_cast<float>(patch.largest()) + std::abs(slopeI) * static_cast<float>(wide) +
                 std::abs(slopeJ) * static_cast<float>(high));
    }

    /// The rows of a column block [from, to] that the triangle can reach.
    void rowsOf(int from, int to, int& first, int& last) const {
        first = j0;
        last = j1;
        if (from <= i0 && i1 <= to)
            return;
        float low = static_cast<float>(j1);
        float high = static_cast<float>(j0);
        for (int k = 0; k < 3; ++k) {
            const PatchVertex& p = corner[k];
            const PatchVertex& q = corner[k == 2 ? 0 : k + 1];
            if (from <= p.i && p.i <= to) {
                low = std::min(low, static_cast<float>(p.j));
                high = std::max(high, static_cast<float>(p.j));
            }
            for (const int side : {from, to}) {
                if ((p.i < side) == (q.i < side))
                    continue;
                const float at = static_cast<float>(p.j) + static_cast<float>(side - p.i) *
                                                               static_cast<float>(q.j - p.j) /
                                                               static_cast<float>(q.i - p.i);
                low = std::min(low, at);
                high = std::max(high, at);
            }
        }
        constexpr float kNudge = 0x1p-9F; // far above the rounding of a quotient, far below 1/256 cell
        first = std::max(first, static_cast<int>(std::ceil(low - kNudge)));
        last = std::min(last, static_cast<int>(std::floor(high + kNudge)));
    }
};

/// The lanes of one column block in the current row.
struct Block {
    Vector inside[3]; ///< edge functions: all at least 0 inside the triangle; whole numbers, exact
    Vector step[3];
    Vector along; ///< height of the plane without its rise by rows

    Block(const Scan& scan, int column, int row) {
        const Floats d;
        const Vector i = hn::Iota(d, static_cast<float>(column));
        for (int k = 0; k < 3; ++k) {
            const PatchVertex& p = scan.corner[k];
            const PatchVertex& q = scan.corner[k == 2 ? 0 : k + 1];
            const auto di = static_cast<float>(q.i - p.i);
            const auto dj = static_cast<float>(q.j - p.j);
            step[k] = hn::Set(d, di);
            inside[k] = hn::Sub(hn::Set(d, di * static_cast<float>(row - p.j)),
                                hn::Mul(hn::Set(d, dj), hn::Sub(i, hn::Set(d, static_cast<float>(p.i)))));
        }
        // Points beyond the last column do not belong to the triangle: they may be on the side of the patch.
        inside[0] = hn::IfThenElse(hn::Le(i, hn::Set(d, static_cast<float>(scan.i1))), inside[0],
                                   hn::Set(d, -std::numeric_limits<float>::infinity()));
        const PatchVertex& a = scan.corner[0];
        along = hn::Add(hn::Set(d, a.z),
                        hn::Mul(hn::Set(d, scan.slopeI), hn::Sub(i, hn::Set(d, static_cast<float>(a.i)))));
    }

    /// Distances of a row's points, zero outside the triangle; advances to the next row.
    HWY_INLINE Vector distances(const float* heights, float rise) {
        const Floats d;
        const auto covered = hn::Ge(hn::Min(inside[0], hn::Min(inside[1], inside[2])), hn::Zero(d));
        const Vector away = hn::Abs(hn::Sub(hn::LoadU(d, heights), hn::Add(along, hn::Set(d, rise))));
        for (int k = 0; k < 3; ++k)
            inside[k] = hn::Add(inside[k], step[k]);
        return hn::IfThenElseZero(covered, away);
    }
};

PatchDistance farthestPointOf(const RegionPatch& patch, const PatchVertex& a, const PatchVertex& b,
                              const PatchVertex& c, float limit) {
    const Floats d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const Scan scan(patch, a, b, c);
    PatchDistance worst;
    if (scan.guard > limit / 8) {
        worst.distance = -1; // a needle: the caller uses doubles instead
        return worst;
    }
    for (int column = scan.i0; column <= scan.i1; column += lanes) {
        int first;
        int last;
        scan.rowsOf(column, column + lanes - 1, first, last);
        Block block(scan, column, first);
        Vector largest = hn::Zero(d);
        Vector where = hn::Zero(d);
        const float* heights = patch.heights() + static_cast<std::ptrdiff_t>(first) * patch.stride() + column;
        for (int row = first; row <= last; ++row, heights += patch.stride()) {
            const Vector away = block.distances(heights, scan.slopeJ * static_cast<float>(row - a.j));
            const auto farther = hn::Gt(away, largest);
            where = hn::IfThenElse(farther, hn::Set(d, static_cast<float>(row)), where);
            largest = hn::Max(largest, away);
        }
        const float top = hn::GetLane(hn::MaxOfLanes(d, largest));
        if (top == 0 || top < worst.distance)
            continue;
        // Of equal distances the smallest row, then the smallest column wins, so that the width of a vector
        // does not affect the result.
        const auto isTop = hn::Eq(largest, hn::Set(d, top));
        const Vector rows = hn::IfThenElse(isTop, where, hn::Set(d, 1e9F));
        const float row = hn::GetLane(hn::MinOfLanes(d, rows));
        const int lane = static_cast<int>(hn::FindFirstTrue(d, hn::Eq(rows, hn::Set(d, row))));
        const PatchDistance found{top, column + lane, static_cast<int>(row)};
        if (found.distance > worst.distance || found.j < worst.j)
            worst = found;
    }
    worst.distance += scan.guard;
    return worst;
}

float distanceOf(const RegionPatch& patch, const PatchVertex& a, const PatchVertex& b, const PatchVertex& c,
                 float limit) {
    const Floats d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const Scan scan(patch, a, b, c);
    if (scan.guard > limit)
        return scan.guard;
    const Vector most = hn::Set(d, limit - scan.guard);
    Vector largest = hn::Zero(d);
    for (int column = scan.i0; column <= scan.i1; column += lanes) {
        int first;
        int last;
        scan.rowsOf(column, column + lanes - 1, first, last);
        Block block(scan, column, first);
        const float* heights = patch.heights() + static_cast<std::ptrdiff_t>(first) * patch.stride() + column;
        for (int row = first; row <= last; ++row, heights += patch.stride()) {
            const Vector away = block.distances(heights, scan.slopeJ * static_cast<float>(row - a.j));
            largest = hn::Max(largest, away);
            if (!hn::AllFalse(d, hn::Gt(away, most)))
                return std::numeric_limits<float>::infinity();
        }
    }
    return hn::GetLane(hn::MaxOfLanes(d, largest)) + scan.guard;
}

} // namespace proveout::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace proveout {

namespace {

/// Call it once, so that later calls go straight to the version for this processor.
void chooseTarget() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

/// For needles on slopes, where the plane is so steep that floats are too coarse for it.
PatchDistance farthestPointInDoubles(const RegionPatch& patch, const PatchVertex& a, const PatchVertex& b,
                                     const PatchVertex& c) {
    const double inverse = 1.0 / twiceArea(a, b, c);
    const int i0 = std::max(1, std::min({a.i, b.i, c.i}));
    const int i1 = std::min(patch.width() - 2, std::max({a.i, b.i, c.i}));
    const int j0 = std::max(1, std::min({a.j, b.j, c.j}));
    const int j1 = std::min(patch.height() - 2, std::max({a.j, b.j, c.j}));
    double largest = 0;
    PatchDistance worst;
    for (int j = j0; j <= j1; ++j) {
        for (int i = i0; i <= i1; ++i) {
            const PatchVertex p{i, j, patch.at(i, j)};
            const double wa = twiceArea(p, b, c);
            const double wb = twiceArea(p, c, a);
            const double wc = twiceArea(p, a, b);
            if (wa < 0 || wb < 0 || wc < 0)
                continue;
            const double away =
                std::abs((wa * double{a.z} + wb * double{b.z} + wc * double{c.z}) * inverse - double{p.z});
            if (away > largest) {
                largest = away;
                worst.i = i;
                worst.j = j;
            }
        }
    }
    worst.distance = static_cast<float>(largest + patch.guard(largest));
    return worst;
}

} // namespace

HWY_EXPORT(farthestPointOf);
HWY_EXPORT(distanceOf);

PatchDistance farthestPoint(const RegionPatch& patch, const PatchVertex& a, const PatchVertex& b,
                            const PatchVertex& c, float limit) {
    if (twiceArea(a, b, c) == 1) // by Pick's theorem it holds only its corners
        return {};
    static auto* const kernel = (chooseTarget(), HWY_DYNAMIC_DISPATCH(farthestPointOf));
    const PatchDistance found = kernel(patch, a, b, c, limit);
    return found.distance < 0 ? farthestPointInDoubles(patch, a, b, c) : found;
}

float distanceUpTo(const RegionPatch& patch, const PatchVertex& a, const PatchVertex& b, const PatchVertex& c,
                   float limit) {
    if (twiceArea(a, b, c) == 1)
        return 0;
    static auto* const kernel = (chooseTarget(), HWY_DYNAMIC_DISPATCH(distanceOf));
    return kernel(patch, a, b, c, limit);
}

} // namespace proveout
#endif
