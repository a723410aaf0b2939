// SPDX-License-Identifier: GPL-3.0-or-later
// Where a cutter on a helix is lowest over a point. Compiled once an instruction set.
#if defined(PROVEOUT_CUTTING_ROUND_LEAD) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_ROUND_LEAD
#undef PROVEOUT_CUTTING_ROUND_LEAD
#else
#define PROVEOUT_CUTTING_ROUND_LEAD
#endif

#include <algorithm>
#include <type_traits>

#include "core/cutting/round_envelope-inl.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

inline constexpr float kFar = 1e30F;

// The slope of what a profile's side is a part of over the distance from the axis, by the square of that.

HWY_INLINE V steepness(const FlatForm&, V) {
    return hn::Zero(kFloats);
}
HWY_INLINE V steepness(const LineForm& form, V distance2) {
    return hn::Div(form.rise, hn::Max(hn::Sqrt(distance2), all(kTiny)));
}
HWY_INLINE V steepness(const BallForm& form, V distance2) {
    return hn::Div(all(1), hn::Sqrt(hn::Max(hn::Sub(form.radius2, distance2), all(kTiny))));
}
HWY_INLINE V steepness(const CornerForm& form, V distance2) {
    const V distance = hn::Sqrt(distance2);
    const V out = hn::Sub(distance, form.ring);
    const V up = hn::Sqrt(hn::Max(minusProduct(out, out, form.radius2), all(kTiny)));
    return hn::Div(out, hn::Mul(up, hn::Max(distance, all(kTiny))));
}

// The square of the radius at which it ends by itself.

HWY_INLINE V endOf(const FlatForm&) {
    return all(kFar);
}
HWY_INLINE V endOf(const LineForm&) {
    return all(kFar);
}
HWY_INLINE V endOf(const BallForm& form) {
    return form.radius2;
}
HWY_INLINE V endOf(const CornerForm& form) {
    return square(hn::Add(form.ring, hn::Sqrt(form.radius2)));
}

/// For fitBands(). With ρ and R for a point's and the path's radius, o = ρ - R and c for the chord, on a
/// circle of radius 1, from the point's own direction to where the cutter stands, the distance is
/// d² = o² + ρRc². The height over the point falls with c as long as h'(d)/d · ρRc√(1 - c²/4) is less than
/// the path's fall: where that is so no more for the first time it is lowest. The profile's side is taken to
/// go on beyond its ends, so that there is nothing that bends; see HelixEnvelope::chordAt().
template<class Form>
class RoundLead {
public:
    explicit RoundLead(const TilePass& pass)
        : m_form(pass), m_radius(all(pass.round.radius)), m_fall(hn::Abs(all(pass.round.climb))),
          m_rim2(all(pass.rim2)), m_error(std::min(kFitError + kFitDistance * pass.rise, kMostError)) {}

    /// Of heights that will do, mm.
    [[nodiscard]] float error() const { return m_error; }
    /// More than one such place was found.
    [[nodiscard]] bool ambiguous() const { return m_ambiguous; }
    /// It falls again where a point leaves the rim.
    [[nodiscard]] bool leaves() const { return m_leaves; }

    /// What touchingChord2() makes the chord of. It counts where there is such a place; elsewhere it is the
    /// nearest to one.
    HWY_INLINE V value(V outside, M& counts) {
        const V product = hn::Max(hn::Mul(hn::Add(m_radius, outside), m_radius), all(kTiny));
        const Point point{hn::Max(hn::Abs(outside), all(kNearest)), product};
        const V last = hn::Mul(rootOf(upTo(endOf(m_form), point)), all(kWithin));
        Search search{hn::Zero(kFloats), last, hn::Zero(kFloats), all(-kFar)};
        M found = hn::Gt(point.product, all(kFar)); // none
        M rising = found;
        for (int k = 1; k <= kSteps; ++k) {
            const V chord = hn::Mul(last, all(placeOf(k)));
            const V surplus = surplusAt(chord, point);
            const M rises = hn::Gt(surplus, hn::Zero(kFloats));
            const M turns = hn::AndNot(rising, rises);
            m_ambiguous |= any(hn::And(turns, found));
            const M first = hn::AndNot(found, turns);
            search.to = hn::IfThenElse(first, chord, search.to);
            search.from = hn::IfThenElse(first, hn::Mul(last, all(placeOf(k - 1))), search.from);
            found = hn::Or(found, turns);
            rising = rises;
            const M better = hn::Gt(surplus, search.most);
            search.most = hn::IfThenElse(better, surplus, search.most);
            search.best = hn::IfThenElse(better, chord, search.best);
        }
        V chord = turning(search, point);
        if (!hn::AllTrue(kFloats, found))
            chord = hn::IfThenElse(found, chord, nearestTo(search, last, point));
        noteRim(point, chord, found);
        counts = found;
        return std::is_same_v<Form, LineForm> ? square(hn::Div(chord, point.outside)) : square(chord);
    }

    HWY_INLINE V height(V outside, V value) const {
        const V chord2 = touchingChord2<Form>(value, square(outside));
        const V product = hn::Mul(hn::Add(m_radius, outside), m_radius);
        const V within2 = hn::Max(hn::Min(chord2, upTo(m_rim2, {outside, hn::Max(product, all(kTiny))})),
                                  hn::Zero(kFloats));
        const V turn = hn::Mul(all(2), arcSineOf(hn::Mul(all(0.5F), hn::Sqrt(within2))));
        return minusProduct(m_fall, turn, m_form.height(productPlus(product, within2, square(outside))));
    }

private:
    static constexpr float kLongest = 2; ///< a chord
    static constexpr float kShortest = 1e-3F;
    static constexpr int kSteps = 24;
    static constexpr float kWithin = 1 - 1e-6F; ///< the end, where arcs are upright
    static constexpr int kHalvings = 30;
    static constexpr float kNearest = 1e-4F; ///< mm: to the circle, lest nothing be divided by nothing
    static constexpr int kThirds = 12;
    static constexpr float kFitDistance = 2e-6F; ///< mm: what distances are told to
    static constexpr float kMostError = 2e-4F;

    struct Point {
        V outside;
        V product;
    };
    struct Search {
        V from;
        V to;
        V best;
        V most;
    };

    /// Of the way to the last chord; close together near it, where arcs become steep.
    static constexpr float placeOf(int step) {
        const float part = static_cast<float>(step) / kSteps;
        return part * (2 - part);
    }
    /// The square of the chord at which a point is as far from the axis.
    [[nodiscard]] static HWY_INLINE V upTo(V distance2, const Point& point) {
        const V across2 = hn::Sub(distance2, square(point.outside));
        return hn::Min(hn::Div(across2, point.product), all(kLongest * kLongest));
    }
    [[nodiscard]] HWY_INLINE V surplusAt(V chord, const Point& point) const {
        const V distance2 = productPlus(point.product, square(chord), square(point.outside));
        const V cosine = rootOf(minusProduct(all(0.25F), square(chord), all(1)));
        const V steep = hn::Mul(steepness(m_form, distance2), point.product);
        return hn::Sub(hn::Mul(steep, hn::Mul(chord, cosine)), m_fall);
    }
    [[nodiscard]] HWY_INLINE V turning(Search search, const Point& point) const {
        for (int k = 0; k < kHalvings; ++k) {
            const V middle = hn::Mul(all(0.5F), hn::Add(search.from, search.to));
            const M beyond = hn::Gt(surplusAt(middle, point), hn::Zero(kFloats));
            search.to = hn::IfThenElse(beyond, middle, search.to);
            search.from = hn::IfThenElse(beyond, search.from, middle);
        }
        return hn::Mul(all(0.5F), hn::Add(search.from, search.to));
    }
    /// Where the height falls least fast.
    [[nodiscard]] HWY_INLINE V nearestTo(const Search& search, V last, const Point& point) const {
        if constexpr (std::is_same_v<Form, FlatForm>)
            return all(kLongest);
        const V step = hn::Mul(last, all(2.0F / kSteps));
        V from = hn::Max(hn::Sub(search.best, step), hn::Zero(kFloats));
        V to = hn::Min(hn::Add(search.best, step), last);
        for (int k = 0; k < kThirds; ++k) {
            const V third = hn::Mul(all(1 / 3.0F), hn::Sub(to, from));
            const V low = hn::Add(from, third);
            const V high = hn::Sub(to, third);
            const M rises = hn::Lt(surplusAt(low, point), surplusAt(high, point));
            from = hn::IfThenElse(rises, low, from);
            to = hn::IfThenElse(rises, to, high);
        }
        return hn::Mul(all(0.5F), hn::Add(from, to));
    }
    /// Whether heights fall again where points leave the rim before they are as far as can be, and the place
    /// that was found is not there.
    HWY_INLINE void noteRim(const Point& point, V chord, M found) {
        const V most = rootOf(upTo(m_rim2, point));
        const M there = hn::And(found, hn::Ge(chord, most));
        const M falls = hn::Le(surplusAt(hn::Mul(most, all(kWithin)), point), hn::Zero(kFloats));
        const M leaving = hn::And(hn::Lt(most, all(kLongest)), hn::Gt(most, all(kShortest)));
        if constexpr (!std::is_same_v<Form, FlatForm>)
            m_leaves |= any(hn::AndNot(there, hn::And(leaving, hn::Or(falls, hn::Not(found)))));
    }

    Form m_form;
    V m_radius;
    V m_fall; ///< mm per radian
    V m_rim2;
    float m_error; ///< on steep lines, which single precision tells less well, more
    bool m_ambiguous = false;
    bool m_leaves = false;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
