// SPDX-License-Identifier: GPL-3.0-or-later
// Lower bounds of passes. Compiled once per instruction set.
#if defined(PROVEOUT_CUTTING_SUPPORTING_PLANE) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_SUPPORTING_PLANE
#undef PROVEOUT_CUTTING_SUPPORTING_PLANE
#else
#define PROVEOUT_CUTTING_SUPPORTING_PLANE
#endif

#include "core/cutting/kernels/pass_envelope-inl.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

/// The values from which bounds are computed, for a vector of passes or for one pass in all lanes. As in
/// TilePass.
struct PassLanes {
    V along, across, alongX, acrossX, alongY, acrossY, begin, end, z, slope, rise, radius, ring, aheadRate,
        aheadRadius2, inner, outer, reach2, slack, blocksFrom;
};

HWY_INLINE PassLanes allLanesOf(const TilePass& pass) {
    return {all(pass.along),  all(pass.across),    all(pass.alongX),       all(pass.acrossX),
            all(pass.alongY), all(pass.acrossY),   all(pass.begin),        all(pass.end),
            all(pass.z),      all(pass.slope),     all(pass.rise),         all(pass.radius),
            all(pass.ring),   all(pass.aheadRate), all(pass.aheadRadius2), all(pass.inner),
            all(pass.outer),  all(pass.reach2),    all(pass.slack),        all(pass.blocksFrom)};
}

HWY_INLINE PassLanes lanesOf(const PassTable& table, std::size_t at) {
    const auto field = [&](std::size_t index)
                           HWY_ATTR { return hn::LoadU(kFloats, table.field(index) + at); };
    return {field(0),  field(1),  field(2),  field(3),  field(4),  field(5),  field(6),
            field(7),  field(8),  field(9),  field(10), field(11), field(12), field(13),
            field(14), field(15), field(16), field(17), field(18), field(19)};
}

/// Planes that are nowhere above the envelope: height over the middle of a block, and change per column and
/// row.
struct Planes {
    V middle;
    V perColumn;
    V perRow;
    M reaches; ///< whether the cutter reaches the block; otherwise nothing of the block is under it

    /// The lowest height over the block.
    [[nodiscard]] HWY_INLINE V lowest() const {
        const V tilt = hn::Add(hn::Abs(perColumn), hn::Abs(perRow));
        return minusProduct(all(kHalf), tilt, middle);
    }
    static constexpr float kHalf = (TileUnderWork::kBlock - 1) / 2.0F;
};

/// `column`, `row`: a block's middle, relative to the tile's. Any gradient g has such a plane, whose height
/// comes from the convex conjugate of profile and path: z(p) = min_u z₀ + m·u + h(|p - u|) is nowhere below
/// g·p + z₀ + min_u (m - g_s)·u - h*(|g|). Therefore the gradient need not be exact: it is estimated as that
/// of the profile at the cutter's approximate position when it is lowest over the middle.
HWY_INLINE Planes supportingPlanes(const PassLanes& pass, V column, V row) {
    const V zero = hn::Zero(kFloats);
    const V along = productPlus(row, pass.alongY, productPlus(column, pass.alongX, pass.along));
    const V across = productPlus(row, pass.acrossY, productPlus(column, pass.acrossX, pass.across));
    const V across2 = square(across);
    const V nearest = hn::Sub(along, hn::Min(hn::Max(along, pass.begin), pass.end));
    const V ahead = hn::Mul(pass.aheadRate, rootOf(hn::Sub(pass.aheadRadius2, across2)));
    const V wanted = hn::Add(along, ahead);
    const V place = hn::Min(hn::Max(wanted, pass.begin), pass.end);
    const V away = hn::Sub(along, place);
    const V distance = hn::Sqrt(productPlus(away, away, across2));
    // Near its end the arc is too steep for a useful bound.
    const V out = hn::Min(hn::Max(hn::Sub(distance, pass.ring), zero), hn::Mul(all(0.97F), pass.radius));
    const V up = hn::Sqrt(hn::Max(minusProduct(out, out, square(pass.radius)), all(kTiny)));
    const V ofLine = hn::IfThenElseZero(hn::Gt(distance, pass.inner), pass.rise);
    const V part = hn::Div(hn::Add(hn::Div(out, up), ofLine), hn::Max(distance, all(kTiny)));
    const V steepAcross = hn::Mul(part, across);
    const V steepAlong = hn::IfThenElse(hn::Eq(place, wanted), pass.slope, hn::Mul(part, away));
    const V steep2 = productPlus(steepAlong, steepAlong, square(steepAcross));
    const V steep = hn::Sqrt(steep2);
    const V flatPart = hn::Mul(steep, pass.inner);
    const V linePart = minusProduct(pass.rise, hn::Sub(pass.outer, pass.inner), hn::Mul(steep, pass.outer));
    const V conjugate =
        productPlus(pass.radius, hn::Sqrt(hn::Add(all(1), steep2)), hn::Max(flatPart, linePart));
    const V rest = hn::Sub(pass.slope, steepAlong);
    const V ofPath = hn::Min(hn::Mul(rest, pass.begin), hn::Mul(rest, pass.end));
    const V ofPoint = productPlus(steepAlong, along, hn::Mul(steepAcross, across));
    Planes planes;
    planes.middle = hn::Sub(hn::Add(hn::Add(pass.z, ofPath), hn::Sub(ofPoint, conjugate)),
                            hn::Mul(pass.slack, hn::Add(all(1), steep)));
    planes.perColumn = productPlus(steepAlong, pass.alongX, hn::Mul(steepAcross, pass.acrossX));
    planes.perRow = productPlus(steepAlong, pass.alongY, hn::Mul(steepAcross, pass.acrossY));
    const M near = hn::Le(productPlus(nearest, nearest, across2), pass.reach2);
    planes.reaches = hn::And(near, hn::Gt(along, pass.blocksFrom));
    return planes;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
