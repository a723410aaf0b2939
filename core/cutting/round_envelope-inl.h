// SPDX-License-Identifier: GPL-3.0-or-later
// The envelope of one pass on a round path over a vector of points. Compiled once an instruction set.
#if defined(PROVEOUT_CUTTING_ROUND_ENVELOPE) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_ROUND_ENVELOPE
#undef PROVEOUT_CUTTING_ROUND_ENVELOPE
#else
#define PROVEOUT_CUTTING_ROUND_ENVELOPE
#endif

#include <array>
#include <numbers>

#include "core/cutting/pass_envelope-inl.h"

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

/// From the first axis; in [-π, π].
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

/// In [0, π/2] for what is in [0, 1].
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

/// The circle of a path's middle radius. What is outside of it is told from squares, whose difference is
/// taken near the tile: no digits go with the radius.
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

/// At one height: where it is nearest it is lowest.
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

// How far the cutter stands from a point, along a path of that fall, where it is lowest over it; by the
// square of the distance across. As the leads of straight paths, but each lane has a fall of its own.

struct RoundRimLead {
    RimLead rim;
    explicit RoundRimLead(const TilePass& pass) : rim(pass) {}
    HWY_INLINE V operator()(V across2, V) const { return rim(across2); }
};

struct RoundLineLead {
    V rise, flatTo2, rim2;
    explicit RoundLineLead(const TilePass& pass)
        : rise(all(pass.rise)), flatTo2(all(pass.flatTo * pass.flatTo)), rim2(all(pass.rim2)) {}
    HWY_INLINE V operator()(V across2, V fall) const {
        const V slower = hn::Mul(hn::Sub(rise, fall), hn::Add(rise, fall));
        const V touching = hn::Div(hn::Mul(square(fall), across2), hn::Max(slower, all(kTiny)));
        const V lead2 = hn::Max(touching, hn::Sub(flatTo2, across2));
        const V most2 = hn::Sub(rim2, across2);
        const M steeper = hn::Ge(fall, rise);
        return rootOf(hn::IfThenElse(steeper, most2, hn::Min(lead2, most2)));
    }
};

struct RoundBallLead {
    V radius2;
    RimLead rim;
    explicit RoundBallLead(const TilePass& pass) : radius2(all(pass.radius * pass.radius)), rim(pass) {}
    HWY_INLINE V operator()(V across2, V fall) const {
        const V sine = hn::Div(fall, hn::Sqrt(hn::Add(square(fall), all(1))));
        return hn::Min(hn::Mul(sine, rootOf(hn::Sub(radius2, across2))), rim(across2));
    }
};

struct RoundCornerLead {
    CornerShape shape;
    explicit RoundCornerLead(const TilePass& pass) : shape(pass) {}
    HWY_INLINE V operator()(V across2, V fall) const { return cornerLead(shape, fall, across2); }
};

/// How far a point's own direction is from where the cutter is lowest over it, on a path that rises or falls
/// evenly: the chord, on a circle of radius 1. Seen from a point, the cutter on a circle is as if on a
/// straight path that is the square root of the product of both radii long per radian, but that angles are
/// longer than their chords: the straight solution, corrected some times by how much longer.
template<class Lead>
struct SolvedChord {
    Lead lead;
    V fall; ///< mm per radian
    explicit SolvedChord(const TilePass& pass) : lead(pass), fall(hn::Abs(all(pass.round.climb))) {}
    HWY_INLINE V operator()(V, V across2, V perRadian) const {
        const V fallOfChord = hn::Div(fall, perRadian);
        V chord = hn::Min(hn::Div(lead(across2, fallOfChord), perRadian), all(2));
        for (int k = 0; k < kCorrections; ++k) {
            const V cosine = hn::Sqrt(hn::Max(minusProduct(all(0.25F), square(chord), all(1)), all(1e-6F)));
            chord = hn::Min(hn::Div(lead(across2, hn::Div(fallOfChord, cosine)), perRadian), all(2));
        }
        return chord;
    }

private:
    static constexpr int kCorrections = 2;
};

/// Rising or falling evenly. Whatever place the chord leads to is a place of the path, and the ends are
/// looked at besides, so that nothing that is found is too low.
template<class Form, class Chord>
struct HelixEnvelope {
    Form form;
    Chord chord;
    Circle circle;
    RoundEnds ends;
    V z, climb, ahead, half, rim2, widening;
    explicit HelixEnvelope(const TilePass& pass) : HelixEnvelope(pass, Chord(pass)) {}
    HelixEnvelope(const TilePass& pass, const Chord& chordOfPass)
        : form(pass), chord(chordOfPass), circle(pass.round), ends(pass.round), z(all(pass.z)),
          climb(all(pass.round.climb)), ahead(all(pass.round.climb < 0 ? 1.0F : -1.0F)),
          half(all(pass.round.half)), rim2(all(pass.rim2)), widening(all(pass.round.widening)) {}

    HWY_INLINE Cut operator()(V along, V across) const {
        const Cut begin = at(ends.fromBegin2(along, across), minusProduct(climb, half, z));
        const Cut end = at(ends.fromEnd2(along, across), productPlus(climb, half, z));
        const Cut between = inside(circle(along, across));
        const V infinite = all(kFar);
        const V lowest = hn::Min(hn::IfThenElse(begin.under, begin.z, infinite),
                                 hn::Min(hn::IfThenElse(end.under, end.z, infinite),
                                         hn::IfThenElse(between.under, between.z, infinite)));
        return {lowest, hn::Or(begin.under, hn::Or(end.under, between.under))};
    }

private:
    static constexpr float kFar = 1e30F;

    HWY_INLINE Cut at(V distance2, V height) const {
        return {hn::Add(height, form.height(distance2)), hn::Le(distance2, rim2)};
    }

    /// At the place where it is lowest, if the path has it.
    HWY_INLINE Cut inside(const RoundPlace& place) const {
        const V angle = angleOf(place.along, place.across);
        const V across2 = square(minusProduct(widening, angle, place.outside));
        const V product = hn::Mul(place.distance, productPlus(widening, angle, circle.radius));
        const V perRadian = rootOf(hn::Max(product, all(kTiny)));
        const V chordTo = chord(place.outside, across2, perRadian);
        const V turn = hn::Mul(all(2), arcSineOf(hn::Mul(all(0.5F), chordTo)));
        V where = productPlus(ahead, turn, angle);
        where = hn::Sub(where, hn::IfThenElseZero(hn::Gt(where, all(kPi)), all(2 * kPi)));
        where = hn::Add(where, hn::IfThenElseZero(hn::Lt(where, all(-kPi)), all(2 * kPi)));
        const V outside = minusProduct(widening, where, place.outside);
        const V there = hn::Mul(place.distance, productPlus(widening, where, circle.radius));
        const V distance2 = productPlus(outside, outside, hn::Mul(there, square(chordTo)));
        const M on = hn::And(hn::Le(hn::Abs(where), half), hn::Le(across2, rim2));
        return {hn::Add(productPlus(climb, where, z), form.height(distance2)), on};
    }
};

/// As withEnvelope() of straight paths.
template<class Work>
HWY_INLINE void withRoundEnvelope(const TilePass& pass, const Work& work) {
    switch (pass.form) {
    case TilePass::Form::flat:
        if (pass.level)
            return work(LevelRoundEnvelope<FlatForm>(pass));
        return work(HelixEnvelope<FlatForm, SolvedChord<RoundRimLead>>(pass));
    case TilePass::Form::line:
        if (pass.level)
            return work(LevelRoundEnvelope<LineForm>(pass));
        return work(HelixEnvelope<LineForm, SolvedChord<RoundLineLead>>(pass));
    case TilePass::Form::ball:
        if (pass.level)
            return work(LevelRoundEnvelope<BallForm>(pass));
        return work(HelixEnvelope<BallForm, SolvedChord<RoundBallLead>>(pass));
    case TilePass::Form::corner:
        if (pass.level)
            return work(LevelRoundEnvelope<CornerForm>(pass));
        return work(HelixEnvelope<CornerForm, SolvedChord<RoundCornerLead>>(pass));
    case TilePass::Form::whole:
        return work(LevelRoundEnvelope<WholeForm>(pass));
    }
}

/// Calls `work` with the envelope of a pass, whatever its path.
template<class Work>
HWY_INLINE void withAnyEnvelope(const TilePass& pass, const Work& work) {
    if (pass.path == TilePass::Path::round)
        withRoundEnvelope(pass, work);
    else
        withEnvelope(pass, work);
}

/// How far beside the path points lie, left of it positive.
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
