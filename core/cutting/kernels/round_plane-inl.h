// SPDX-License-Identifier: GPL-3.0-or-later
// Lower bounds of passes on round paths. Compiled once per instruction set.
#if defined(PROVEOUT_CUTTING_ROUND_PLANE) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_ROUND_PLANE
#undef PROVEOUT_CUTTING_ROUND_PLANE
#else
#define PROVEOUT_CUTTING_ROUND_PLANE
#endif

#include "core/cutting/kernels/round_envelope-inl.h"
#include "core/cutting/kernels/supporting_plane-inl.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

/// Like supportingPlanes(), for one pass on a round path. Its lowest height all around the circle is a bound;
/// with s for the profile's slope at the block's middle, that is s·|r - R| - h*(s) by the convex conjugate.
/// On the outer side, where r is convex, the tangent plane of that is below it. On the inner side the plane
/// may be above it by as much as the circle bends over a block.
HWY_INLINE Planes roundPlanes(const TilePass& pass, V column, V row) {
    const TilePass::Round& round = pass.round;
    const V zero = hn::Zero(kFloats);
    const V along = productPlus(row, all(pass.alongY), hn::Mul(column, all(pass.alongX)));
    const V across = productPlus(row, all(pass.acrossY), hn::Mul(column, all(pass.acrossX)));
    const RoundPlace place = Circle(round)(along, across);
    const RoundEnds ends(round);
    const V aside = hn::Sub(hn::Abs(place.outside), all(round.spread));
    const V near = hn::Max(aside, zero);
    const V ofEnds = hn::Min(ends.fromBegin2(along, across), ends.fromEnd2(along, across));
    const V nearest2 = hn::IfThenElse(RoundSector(round).holds(place), square(near), ofEnds);
    // On the inner side, and there not near the centre.
    const M within = hn::Lt(place.outside, zero);
    const V reach = all(round.blockReach);
    const V clear = hn::Sub(place.distance, reach);
    const M central = hn::And(within, hn::Lt(clear, reach));
    const V out = hn::Min(hn::Max(hn::Sub(near, all(pass.ring)), zero), all(0.97F * pass.radius));
    const V up = hn::Sqrt(hn::Max(minusProduct(out, out, all(pass.radius * pass.radius)), all(kTiny)));
    const V ofLine = hn::IfThenElseZero(hn::Gt(near, all(pass.inner)), all(pass.rise));
    const V steep = hn::IfThenElse(central, zero, hn::Add(hn::Div(out, up), ofLine));
    const V flatPart = hn::Mul(steep, all(pass.inner));
    const V linePart =
        minusProduct(all(pass.rise), all(pass.outer - pass.inner), hn::Mul(steep, all(pass.outer)));
    const V conjugate =
        productPlus(all(pass.radius), hn::Sqrt(hn::Add(all(1), square(steep))), hn::Max(flatPart, linePart));
    const V bent = hn::Div(hn::Mul(all(0.5F), square(reach)), hn::Max(clear, all(kTiny)));
    const V bend = hn::IfThenElseZero(hn::AndNot(central, within), hn::Mul(steep, bent));
    const V outwards =
        hn::Div(hn::IfThenElse(within, hn::Neg(steep), steep), hn::Max(place.distance, all(kTiny)));
    const V steepAlong = hn::Mul(outwards, place.along);
    const V steepAcross = hn::Mul(outwards, place.across);
    Planes planes;
    const V middle = hn::Sub(productPlus(steep, aside, all(round.lowest)), hn::Add(conjugate, bend));
    planes.middle = hn::Sub(middle, hn::Mul(all(pass.slack), hn::Add(all(1), steep)));
    planes.perColumn = productPlus(steepAlong, all(pass.alongX), hn::Mul(steepAcross, all(pass.acrossX)));
    planes.perRow = productPlus(steepAlong, all(pass.alongY), hn::Mul(steepAcross, all(pass.acrossY)));
    planes.reaches = hn::Le(nearest2, all(pass.reach2));
    return planes;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
