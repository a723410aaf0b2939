// SPDX-License-Identifier: GPL-3.0-or-later
// The envelope of one pass on a round path over a vector of points. Compiled once per instruction set.
#if defined(PROVEOUT_CUTTING_ROUND_ENVELOPE) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_ROUND_ENVELOPE
#undef PROVEOUT_CUTTING_ROUND_ENVELOPE
#else
#define PROVEOUT_CUTTING_ROUND_ENVELOPE
#endif

#include <array>
#include <numbers>
#include <type_traits>

#include "core/cutting/kernels/band_fit-inl.h"
#include "core/cutting/kernels/hollow_envelope-inl.h"
#include "core/cutting/kernels/pass_envelope-inl.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

inline constexpr float kPi = std::numbers::pi_v<float>;

/// Coefficients from the constant on.
template<std::size_t count>
HWY_INLINE V polynomial(const std::array<float, count>& coefficients, V x) {
    V sum = all(coefficients[count - 1]);
    for (std::size_t k = count - 1; k-- > 0;)
        sum = productPlus(sum, x, all(coefficients[k]));
    return sum;
}

/// atan(√z) / √z up to the tangent of π/8, asin(√z) / √z up to a half: interpolated at the roots of a
/// Chebyshev polynomial, to 1e-8 of the angle and 5e-8.
inline constexpr std::array kArcTangent = {0.999999981F, -0.333327858F, 0.199740824F, -0.138484902F,
                                           0.0797629181F};
inline constexpr std::array kArcSine = {1.00000007F, 0.166652196F, 0.0754534558F, 0.0397944433F,
                                        0.0503576819F};

/// The angle from the first axis, in [-π, π].
HWY_INLINE V angleOf(V x, V y) {
    constexpr float kTangentOfEighth = 0.414213562F;
    const V wide = hn::Abs(x);
    const V high = hn::Abs(y);
    const V ratio = hn::Div(hn::Min(wide, high), hn::Max(hn::Max(wide, high), all(kTiny)));
    const M upper = hn::Gt(ratio, all(kTangentOfEighth));
    const V turned = hn::Div(hn::Sub(ratio, all(1)), hn::Add(ratio, all(1)));
    const V tangent = hn::IfThenElse(upper, turned, ratio);
    const V part = hn::Mul(tangent, polynomial(kArcTangent, square(tangent)));
    const V eighth = hn::Add(part, hn::IfThenElseZero(upper, all(kPi / 4)));
    const V quarter = hn::IfThenElse(hn::Gt(high, wide), hn::Sub(all(kPi / 2), eighth), eighth);
    const V half = hn::IfThenElse(hn::Lt(x, hn::Zero(kFloats)), hn::Sub(all(kPi), quarter), quarter);
    return hn::CopySign(half, y);
}

/// The result is in [0, π/2] for arguments in [0, 1].
HWY_INLINE V arcSineOf(V sine) {
    const M large = hn::Gt(sine, all(0.5F));
    const V rest = rootOf(hn::Mul(all(0.5F), hn::Sub(all(1), sine)));
    const V small = hn::IfThenElse(large, rest, sine);
    const V angle = hn::Mul(small, polynomial(kArcSine, square(small)));
    return hn::IfThenElse(large, minusProduct(all(2), angle, all(kPi / 2)), angle);
}

/// Points beside a circle.
struct RoundPlace {
    V along; ///< from the centre
    V across;
    V distance;
    V outside; ///< how much farther than the circle
};

/// The circle with the path's middle radius. The distance outside of it is computed from squares whose
/// difference is formed near the tile, so that a large radius costs no precision.
struct Circle {
    V middleAlong, middleAcross, excess, radius;
    explicit Circle(const TilePass::Round& round)
        : middleAlong(all(round.middleAlong)), middleAcross(all(round.middleAcross)),
          excess(all(round.excess)), radius(all(round.radius)) {}

    HWY_INLINE RoundPlace operator()(V along, V across) const {
        const V fromAlong = hn::Add(along, middleAlong);
        const V fromAcross = hn::Add(across, middleAcross);
        const V ofAcross = productPlus(across, hn::Add(fromAcross, middleAcross), excess);
        const V more = productPlus(along, hn::Add(fromAlong, middleAlong), ofAcross);
        const V distance = hn::Sqrt(productPlus(fromAlong, fromAlong, square(fromAcross)));
        return {fromAlong, fromAcross, distance, hn::Div(more, hn::Add(distance, radius))};
    }
};

/// The ends of a round path.
struct RoundEnds {
    V beginAlong, beginAcross, endAlong, endAcross;
    explicit RoundEnds(const TilePass::Round& round)
        : beginAlong(all(round.beginAlong)), beginAcross(all(round.beginAcross)),
          endAlong(all(round.endAlong)), endAcross(all(round.endAcross)) {}

    HWY_INLINE V fromBegin2(V along, V across) const {
        const V off = hn::Sub(along, beginAlong);
        return productPlus(off, off, square(hn::Sub(across, beginAcross)));
    }
    HWY_INLINE V fromEnd2(V along, V across) const {
        const V off = hn::Sub(along, endAlong);
        return productPlus(off, off, square(hn::Sub(across, endAcross)));
    }
};

/// Whether a path passes between the centre and a point, or beyond it.
struct RoundSector {
    V sine, cosine;
    explicit RoundSector(const TilePass::Round& round) : sine(all(round.sine)), cosine(all(round.cosine)) {}
    HWY_INLINE M holds(const RoundPlace& place) const {
        return hn::Ge(hn::Mul(place.along, sine), hn::Mul(hn::Abs(place.across), cosine));
    }
};

/// At one height, the cutter is lowest where it is nearest.
template<class Form>
struct LevelRoundEnvelope {
    Form form;
    Circle circle;
    RoundEnds ends;
    RoundSector sector;
    V z, rim2, widening;
    bool widens;
    explicit LevelRoundEnvelope(const TilePass& pass)
        : form(pass), circle(pass.round), ends(pass.round), sector(pass.round), z(all(pass.z)),
          rim2(all(pass.rim2)), widening(all(pass.round.widening)), widens(pass.round.widening != 0) {}

    HWY_INLINE V distance2(V along, V across) const {
        const RoundPlace place = circle(along, across);
        V outside = place.outside;
        if (widens)
            outside = minusProduct(widening, angleOf(place.along, place.across), outside);
        const V ofEnds = hn::Min(ends.fromBegin2(along, across), ends.fromEnd2(along, across));
        return hn::IfThenElse(sector.holds(place), square(outside), ofEnds);
    }
    HWY_INLINE Cut operator()(V along, V across) const {
        const V nearest2 = distance2(along, across);
        return {hn::Add(z, form.height(nearest2)), hn::Le(nearest2, rim2)};
    }
};

/// The square of the chord to where a cutter touches, from the value of the bands. Below a cone it is nearly
/// proportional to the distance from the circle, and as sharp as it where that distance is zero, so the bands
/// give their ratio.
template<class Form>
HWY_INLINE V touchingChord2(V value, V outside2) {
    return std::is_same_v<Form, LineForm> ? hn::Mul(value, outside2) : value;
}

/// Rising or falling evenly. Bands give the position of the cutter where it is lowest over a point, as the
/// chord to it from the point's own direction. Any position that they lead to is a position of the path, and
/// the ends are evaluated as well, so that no result is too low.
template<class Form>
struct HelixEnvelope {
    Form form;
    BandFit chord2;
    bool rim; ///< whether it may be lowest where the point is on the rim
    Circle circle;
    RoundEnds ends;
    V z, climb, ahead, half, flat2, rim2, nearRim2;
    explicit HelixEnvelope(const TilePass& pass)
        : form(pass), chord2{pass.bands->bands.data(), pass.bands->count}, rim(pass.bands->rim),
          circle(pass.round), ends(pass.round), z(all(pass.z)), climb(all(pass.round.climb)),
          ahead(all(pass.round.climb < 0 ? 1.0F : -1.0F)), half(all(pass.round.half)),
          flat2(all(pass.flatTo * pass.flatTo)), rim2(all(pass.rim2)), nearRim2(all(pass.rim2 * kRounded)) {}

    HWY_INLINE Cut operator()(V along, V across) const {
        const Cut begin = at(ends.fromBegin2(along, across), minusProduct(climb, half, z));
        const Cut end = at(ends.fromEnd2(along, across), productPlus(climb, half, z));
        return lower(lower(begin, end), inside(circle(along, across)));
    }

private:
    static constexpr float kRounded = 1 + 4e-6F; ///< values that rounding moves beyond the rim still count as
                                                 ///< on it

    static HWY_INLINE Cut lower(const Cut& a, const Cut& b) {
        const V infinite = all(1e30F);
        const V z = hn::Min(hn::IfThenElse(a.under, a.z, infinite), hn::IfThenElse(b.under, b.z, infinite));
        return {z, hn::Or(a.under, b.under)};
    }

    HWY_INLINE Cut at(V distance2, V height) const {
        return {hn::Add(height, form.height(distance2)), hn::Le(distance2, rim2)};
    }

    /// The height where it touches, neither on its flat nor beyond its rim, and where the point leaves the
    /// rim.
    HWY_INLINE Cut inside(const RoundPlace& place) const {
        const V angle = angleOf(place.along, place.across);
        const V outside2 = square(place.outside);
        const V product = hn::Mul(place.distance, circle.radius);
        const V part = hn::Div(all(1), hn::Max(product, all(kTiny)));
        const V most2 = hn::Min(hn::Mul(hn::Sub(rim2, outside2), part), all(4));
        const V least2 = hn::Mul(hn::Sub(flat2, outside2), part);
        const V touching2 = touchingChord2<Form>(chord2(place.outside), outside2);
        const V within2 = hn::Min(hn::Max(touching2, least2), most2);
        const Cut touching = atChord(rootOf(within2), angle, outside2, product);
        return rim ? lower(touching, atChord(rootOf(most2), angle, outside2, product)) : touching;
    }

    HWY_INLINE Cut atChord(V chord, V angle, V outside2, V product) const {
        const V turn = hn::Mul(all(2), arcSineOf(hn::Mul(all(0.5F), chord)));
        V where = productPlus(ahead, turn, angle);
        where = hn::Sub(where, hn::IfThenElseZero(hn::Gt(where, all(kPi)), all(2 * kPi)));
        where = hn::Add(where, hn::IfThenElseZero(hn::Lt(where, all(-kPi)), all(2 * kPi)));
        const V distance2 = productPlus(product, square(chord), outside2);
        const M on = hn::And(hn::Le(hn::Abs(where), half), hn::Le(distance2, nearRim2));
        return {hn::Add(productPlus(climb, where, z), form.height(hn::Min(distance2, rim2))), on};
    }
};

/// Like withEnvelope() for straight paths.
template<class Work>
HWY_INLINE void withRoundEnvelope(const TilePass& pass, const Work& work) {
    switch (pass.form) {
    case TilePass::Form::flat:
        if (pass.level)
            return work(LevelRoundEnvelope<FlatForm>(pass));
        return work(HelixEnvelope<FlatForm>(pass));
    case TilePass::Form::line:
        if (pass.level)
            return work(LevelRoundEnvelope<LineForm>(pass));
        return work(HelixEnvelope<LineForm>(pass));
    case TilePass::Form::ball:
        if (pass.level)
            return work(LevelRoundEnvelope<BallForm>(pass));
        return work(HelixEnvelope<BallForm>(pass));
    case TilePass::Form::corner:
        if (pass.level)
            return work(LevelRoundEnvelope<CornerForm>(pass));
        return work(HelixEnvelope<CornerForm>(pass));
    case TilePass::Form::hollow:
        return work(HelixEnvelope<HollowForm>(pass)); // level ones are cut whole
    case TilePass::Form::whole:
        return work(LevelRoundEnvelope<WholeForm>(pass));
    }
}

/// Calls `work` with the envelope of a pass on any path.
template<class Work>
HWY_INLINE void withAnyEnvelope(const TilePass& pass, const Work& work) {
    if (pass.path == TilePass::Path::round)
        withRoundEnvelope(pass, work);
    else if (pass.form == TilePass::Form::hollow && pass.lead >= 0)
        work(HollowEnvelope(pass));
    else
        withEnvelope(pass, work);
}

/// The distance of points from the path, positive to the left of it.
HWY_INLINE V besidePath(const TilePass& pass, V along, V across) {
    if (pass.path == TilePass::Path::straight)
        return across;
    return hn::Mul(all(pass.round.left), Circle(pass.round)(along, across).outside);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
