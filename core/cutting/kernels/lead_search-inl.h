// SPDX-License-Identifier: GPL-3.0-or-later
// Searches for the place where a cutter on a helix or a slope is lowest over a point. Compiled once per
// instruction set.
#if defined(PROVEOUT_CUTTING_LEAD_SEARCH) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_LEAD_SEARCH
#undef PROVEOUT_CUTTING_LEAD_SEARCH
#else
#define PROVEOUT_CUTTING_LEAD_SEARCH
#endif

#include <algorithm>
#include <type_traits>

#include "core/cutting/kernels/round_envelope-inl.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

inline constexpr float kFar = 1e30F;

// The slope of the curve that a profile's side is a part of, divided by the distance from the axis; the
// argument is the square of that distance.

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
HWY_INLINE V steepness(const HollowForm& form, V distance2) {
    const V distance = hn::Sqrt(distance2);
    const V in = hn::Sub(form.ring, distance);
    const V up = hn::Sqrt(hn::Max(minusProduct(in, in, form.radius2), all(kTiny)));
    return hn::Div(in, hn::Mul(up, hn::Max(distance, all(kTiny))));
}

// The square of the radius at which that curve ends by itself.

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
HWY_INLINE V endOf(const HollowForm& form) {
    return square(form.ring);
}

/// The square of the radius at which that curve begins. Curves other than a hollow are assumed to continue
/// inwards, so that they have no corner; where the continued curve is lowest on the flat, so is the profile.
/// A hollow is steepest where it begins.
template<class Form>
HWY_INLINE V startOf(const Form&) {
    return hn::Zero(kFloats);
}
HWY_INLINE V startOf(const HollowForm& form) {
    return square(form.flatTo);
}

/// A point beside a path: its distance, and how the distance to the cutter grows: with c for how far ahead
/// the cutter is, it is the root of aside² + product · c².
struct PointAside {
    V aside;
    V product;
};

/// Points are given by their distance outside of a helix, the cutter's positions by the chord to them on a
/// circle of radius 1, from the point's own direction.
class RoundWay {
public:
    static constexpr float kLongest = 2;
    explicit RoundWay(const TilePass& pass) : m_radius(all(pass.round.radius)) {}

    [[nodiscard]] static float least(const TilePass& pass) {
        return -std::min(std::sqrt(pass.rim2), pass.round.radius);
    }
    [[nodiscard]] static float most(const TilePass& pass) { return std::sqrt(pass.rim2); }
    /// Edges of the flat.
    [[nodiscard]] static float innerEdge(const TilePass& pass) { return std::max(-pass.flatTo, least(pass)); }
    [[nodiscard]] static float outerEdge(const TilePass& pass) { return pass.flatTo; }
    [[nodiscard]] static float fall(const TilePass& pass) { return pass.round.climb; }
    [[nodiscard]] HWY_INLINE PointAside operator()(V outside) const {
        const V product = hn::Mul(hn::Add(m_radius, outside), m_radius);
        return {outside, hn::Max(product, all(kTiny))};
    }
    /// How fast the position advances along the path, as a function of the chord.
    [[nodiscard]] static HWY_INLINE V cosine(V chord) {
        return rootOf(minusProduct(all(0.25F), square(chord), all(1)));
    }
    [[nodiscard]] static HWY_INLINE V along(V chord) {
        return hn::Mul(all(2), arcSineOf(hn::Mul(all(0.5F), chord)));
    }

private:
    V m_radius;
};

/// Points are given by the square of their distance from a straight path, positions by how far ahead they
/// are.
class StraightWay {
public:
    static constexpr float kLongest = 1e6F;
    explicit StraightWay(const TilePass&) {}

    [[nodiscard]] static float least(const TilePass&) { return 0; }
    [[nodiscard]] static float most(const TilePass& pass) { return pass.rim2; }
    [[nodiscard]] static float innerEdge(const TilePass&) { return 0; }
    [[nodiscard]] static float outerEdge(const TilePass& pass) { return pass.flatTo * pass.flatTo; }
    [[nodiscard]] static float fall(const TilePass& pass) { return pass.slope; }
    [[nodiscard]] HWY_INLINE PointAside operator()(V across2) const {
        return {hn::Sqrt(hn::Max(across2, hn::Zero(kFloats))), all(1)};
    }
    [[nodiscard]] static HWY_INLINE V cosine(V) { return all(1); }
    [[nodiscard]] static HWY_INLINE V along(V ahead) { return ahead; }
};

/// For fitBands(). With R and ρ for the radii of a helix and a point, the point is o = ρ - R outside of it,
/// and its distance d to the cutter satisfies d² = o² + ρRc²; on a straight path d² = o² + c². The height
/// over the point falls with c as long as h'(d)/d · ρRc√(1 - c²/4), or h'(d)/d · c, is less than the path's
/// fall: it is lowest where that first ceases to hold.
template<class Form, class Way>
class LeadSearch {
public:
    explicit LeadSearch(const TilePass& pass)
        : m_form(pass), m_way(pass), m_fall(hn::Abs(all(Way::fall(pass)))), m_rim2(all(pass.rim2)),
          m_error(std::min(kFitError + kFitDistance * pass.rise, kMostError)) {}

    /// The acceptable error of heights, mm.
    [[nodiscard]] float error() const { return m_error; }
    /// Whether more than one lowest place was found.
    [[nodiscard]] bool ambiguous() const { return m_ambiguous; }
    /// Whether the height falls again where a point leaves the rim.
    [[nodiscard]] bool leaves() const { return m_leaves; }

    /// The value from which touchingChord2() computes the chord. It counts where there is a lowest place,
    /// which for a hollow may be its start; elsewhere it is the nearest to one.
    HWY_INLINE V value(V variable, M& counts) {
        const PointAside at = m_way(variable);
        const PointAside point{hn::Max(hn::Abs(at.aside), all(kNearest)), at.product};
        const V start = startFor(point);
        const Search search = searchFrom<kSteps>(start, point);
        const M risesAtOnce = hn::Gt(surplusAt(start, point), hn::Zero(kFloats));
        V chord = turning<kHalvings>(search, point);
        if (!hn::AllTrue(kFloats, search.found))
            chord = hn::IfThenElse(search.found, chord, nearestTo(search, point));
        chord = hn::IfThenElse(risesAtOnce, start, chord);
        counts = hn::Or(search.found, risesAtOnce);
        noteRim(point, chord, counts);
        return std::is_same_v<Form, LineForm> ? square(hn::Div(chord, point.aside)) : square(chord);
    }

    /// The square of how far ahead the cutter is, for a point that is not used for a fit: accurate enough for
    /// the height there. Where it rises from the start on, that is the start; if there is no lowest place,
    /// roughly where the height falls least fast.
    HWY_INLINE V ahead2(V across2) {
        const PointAside at = m_way(across2);
        const PointAside point{hn::Max(at.aside, all(kNearest)), at.product};
        const V start = startFor(point);
        const Search search = searchFrom<kFewSteps>(start, point);
        const M risesAtOnce = hn::Gt(surplusAt(start, point), hn::Zero(kFloats));
        const V place = hn::IfThenElse(search.found, turning<kFewHalvings>(search, point), search.best);
        return square(hn::IfThenElse(risesAtOnce, start, place));
    }

    HWY_INLINE V height(V variable, V value) const {
        const PointAside point = m_way(variable);
        const V aside2 = square(point.aside);
        const V chord2 = hn::Max(touchingChord2<Form>(value, aside2), upTo(startOf(m_form), point));
        const V within2 = hn::Max(hn::Min(chord2, upTo(m_rim2, point)), hn::Zero(kFloats));
        return minusProduct(m_fall, Way::along(hn::Sqrt(within2)),
                            m_form.height(productPlus(point.product, within2, aside2)));
    }

private:
    static constexpr float kShortest = 1e-3F;
    static constexpr int kSteps = 24;
    static constexpr float kWithin = 1 - 1e-6F; ///< the end, where arcs are vertical
    static constexpr int kHalvings = 30;
    static constexpr int kFewSteps = 12;
    static constexpr int kFewHalvings = 11;  ///< of such a step, to where height hardly changes
    static constexpr float kNearest = 1e-4F; ///< mm: the least distance from the path, to avoid division by
                                             ///< zero
    static constexpr int kThirds = 12;
    static constexpr float kFitDistance = 2e-6F; ///< mm: the accuracy of distances
    static constexpr float kMostError = 2e-4F;

    struct Search {
        V start;
        V last;
        V from; ///< the lowest place is between these
        V to;
        M found; ///< if there is one
        V best;  ///< where the surplus is
        V most;
    };

    /// As a fraction of the last chord; dense near it, where arcs become steep.
    static constexpr float placeOf(int step, int steps) {
        const float part = static_cast<float>(step) / static_cast<float>(steps);
        return std::is_same_v<Form, HollowForm> ? part * part : part * (2 - part);
    }
    /// The square of the chord at which a point has this distance from the axis.
    [[nodiscard]] static HWY_INLINE V upTo(V distance2, const PointAside& point) {
        const V ahead2 = hn::Sub(distance2, square(point.aside));
        return hn::Min(hn::Div(ahead2, point.product), all(Way::kLongest * Way::kLongest));
    }
    [[nodiscard]] HWY_INLINE V surplusAt(V chord, const PointAside& point) const {
        const V distance2 = productPlus(point.product, square(chord), square(point.aside));
        const V steep = hn::Mul(steepness(m_form, distance2), point.product);
        return hn::Sub(hn::Mul(steep, hn::Mul(chord, Way::cosine(chord))), m_fall);
    }
    [[nodiscard]] HWY_INLINE V startFor(const PointAside& point) const {
        return rootOf(upTo(startOf(m_form), point));
    }
    template<int steps>
    [[nodiscard]] HWY_INLINE Search searchFrom(V start, const PointAside& point) {
        const V last = hn::Max(hn::Mul(rootOf(upTo(endOf(m_form), point)), all(kWithin)), start);
        const V surplusAtStart = surplusAt(start, point);
        const M none = hn::Gt(point.product, all(kFar));
        Search search{start, last, start, last, none, start, surplusAtStart};
        M rising = hn::Gt(surplusAtStart, hn::Zero(kFloats));
        V before = start;
        for (int k = 1; k <= steps; ++k) {
            const V chord = productPlus(hn::Sub(last, start), all(placeOf(k, steps)), start);
            const V surplus = surplusAt(chord, point);
            const M rises = hn::Gt(surplus, hn::Zero(kFloats));
            const M turns = hn::AndNot(rising, rises);
            m_ambiguous |= any(hn::And(turns, search.found));
            const M first = hn::AndNot(search.found, turns);
            search.to = hn::IfThenElse(first, chord, search.to);
            search.from = hn::IfThenElse(first, before, search.from);
            search.found = hn::Or(search.found, turns);
            rising = rises;
            before = chord;
            const M better = hn::Gt(surplus, search.most);
            search.most = hn::IfThenElse(better, surplus, search.most);
            search.best = hn::IfThenElse(better, chord, search.best);
        }
        return search;
    }
    template<int halvings>
    [[nodiscard]] HWY_INLINE V turning(Search search, const PointAside& point) const {
        for (int k = 0; k < halvings; ++k) {
            const V middle = hn::Mul(all(0.5F), hn::Add(search.from, search.to));
            const M beyond = hn::Gt(surplusAt(middle, point), hn::Zero(kFloats));
            search.to = hn::IfThenElse(beyond, middle, search.to);
            search.from = hn::IfThenElse(beyond, search.from, middle);
        }
        return hn::Mul(all(0.5F), hn::Add(search.from, search.to));
    }
    /// The chord where the height falls least fast.
    [[nodiscard]] HWY_INLINE V nearestTo(const Search& search, const PointAside& point) const {
        if constexpr (std::is_same_v<Form, FlatForm>)
            return all(Way::kLongest);
        const V step = hn::Mul(hn::Sub(search.last, search.start), all(2.0F / kSteps));
        V from = hn::Max(hn::Sub(search.best, step), search.start);
        V to = hn::Min(hn::Add(search.best, step), search.last);
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
    /// Notes whether heights fall again where points leave the rim before they are as far as possible, while
    /// the place that was found is not there.
    HWY_INLINE void noteRim(const PointAside& point, V chord, M found) {
        const V most = rootOf(upTo(m_rim2, point));
        const M there = hn::And(found, hn::Ge(chord, most));
        const M falls = hn::Le(surplusAt(hn::Mul(most, all(kWithin)), point), hn::Zero(kFloats));
        const M leaving = hn::And(hn::Lt(most, all(Way::kLongest)), hn::Gt(most, all(kShortest)));
        if constexpr (!std::is_same_v<Form, FlatForm>)
            m_leaves |= any(hn::AndNot(there, hn::And(leaving, hn::Or(falls, hn::Not(found)))));
    }

    Form m_form;
    Way m_way;
    V m_fall; ///< of the path: mm per radian, or per mm
    V m_rim2;
    float m_error; ///< larger on steep lines, where single precision is less accurate
    bool m_ambiguous = false;
    bool m_leaves = false;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
