// SPDX-License-Identifier: GPL-3.0-or-later
// Over a part of a helix the squared distance D of a point is a smooth function of the angle φ, and f(φ) =
// z(φ) + h(√D) is convex wherever D'' >= 0, if h is flat or a corner arc: then (h∘d)'' >= d'²·(h'' - h'/d),
// which for an arc is e²d'²/(…) >= 0, where e is the distance from the ring of its centres. So the one
// stationary place is the lowest, and it is found by replacing D with its own second-order Taylor polynomial:
// that is the straight motion of straight_sweep.h, whose solution is known. As value, slope and curvature of
// D agree, the error is squared in each step, even for the infinite slope at the rim.
#include "core/cutting/rows/helix_row.h"

#include <limits>

#include "core/cutting/profiles/lanes.h"
#include "core/cutting/profiles/profile_forms.h"
#include "core/cutting/profiles/vector_clones.h"

namespace proveout {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Steps in mm along the path below which a lane has converged; the remaining error is the square of it.
constexpr double kStill = 1e-6;

/// One part and one row in the part's own frame: the first axis points from the centre to the middle of the
/// part.
struct Helix {
    double x;
    double y;
    double xStep;
    double yStep;
    double radius;   ///< at the middle
    double widening; ///< per radian
    double z;
    double climb; ///< per radian
    double half;  ///< angle
    double rim2;
    bool circular;
    double rim;

    Helix(const ConvexProfile& profile, const ArcPath& path, const ArcPart& part, const RowPoints& row)
        : radius(path.radius + path.widening * part.middle), widening(path.widening / path.sweep),
          z(path.centre.z + path.climb * part.middle), climb(path.climb / path.sweep),
          half(std::abs(path.sweep) * part.half), rim2(profile.rim * profile.rim),
          circular(path.widening == 0), rim(profile.rim) {
        const double angle = path.angle + path.sweep * part.middle;
        const double cosine = std::cos(angle);
        const double sine = std::sin(angle);
        const double px = row.x - path.centre.x;
        const double py = row.y - path.centre.y;
        x = px * cosine + py * sine;
        y = py * cosine - px * sine;
        xStep = row.step * cosine;
        yStep = -row.step * sine;
    }
};

/// D and its derivatives at one angle; |φ| <= 0.1 + rounding, for which the series are exact.
struct Distance {
    Lanes value;
    Lanes halfSlope; ///< D'/2
    Lanes halfCurve; ///< D''/2

    PROVEOUT_LANES Distance(const Helix& helix, const Lanes& x, const Lanes& y, const Lanes& phi) {
        const Lanes p = phi * phi;
        // Taylor series by products: a quotient would cost more than all the rest.
        const Lanes sine =
            phi * (1 + p * (-1.0 / 6 + p * (1.0 / 120 + p * (-1.0 / 5040 + p * (1.0 / 362880)))));
        const Lanes cosine =
            1 + p * (-1.0 / 2 + p * (1.0 / 24 + p * (-1.0 / 720 + p * (1.0 / 40320 + p * (-1.0 / 3628800)))));
        const Lanes along = x * cosine + y * sine;
        const Lanes side = y * cosine - x * sine;
        const Lanes r = helix.radius + helix.widening * phi;
        value = (r - along) * (r - along) + side * side;
        halfSlope = (r - along) * helix.widening - r * side;
        halfCurve = helix.widening * helix.widening - 2 * helix.widening * side + r * along;
    }
};

// How far ahead the cutter is, as lead() of straight_sweep.h.

struct FlatAhead {
    double rim2;
    PROVEOUT_LANES Lanes operator()(const Lanes&, const Lanes& across2) const {
        return rootOf(rim2 - across2);
    }
};

struct BallAhead {
    double radius2;
    double rim2;
    PROVEOUT_LANES Lanes operator()(const Lanes& fall, const Lanes& across2) const {
        return lesser(rootOf(radius2 - across2) * fall / sqrtOf(1 + fall * fall), rootOf(rim2 - across2));
    }
};

struct CornerAhead {
    double ring;
    double corner;
    double flatTo2;
    double rim2;
    PROVEOUT_LANES Lanes operator()(const Lanes& fall, const Lanes& across2) const {
        const Lanes radii = touchingRadii(ring, corner, fall, across2);
        return lesser(greater(rootOf(radii * radii - across2), rootOf(flatTo2 - across2)),
                      rootOf(rim2 - across2));
    }
};

/// Known properties of the points and one part, as masks.
struct Facts {
    LaneMask convex;   ///< D'' >= 0 over the whole part
    LaneMask oneFall;  ///< on a circle, and its farthest place is not in the part: D has one minimum there
    LaneMask reachOut; ///< the cutter does not cover the whole circle
};

PROVEOUT_LANES Facts factsOf(const Helix& helix, const Lanes& x, const Lanes& y) {
    const Lanes from = sqrtOf(x * x + y * y);
    const double wide = std::fabs(helix.widening);
    // D''/2 at the middle against the most that it can lose towards the ends.
    const Lanes middle = helix.widening * helix.widening - 2 * helix.widening * y + helix.radius * x;
    const double loss = 3 * wide + helix.radius + wide * helix.half;
    const LaneMask farthest = (x <= 0) & (magnitude(y) <= -1.1 * helix.half * x);
    const LaneMask none{};
    return {middle >= helix.half * loss * from, helix.circular ? farthest == 0 : none,
            from + helix.radius >= helix.rim};
}

// Conditions under which the solution is the lowest place.

/// A flat needs only the place where the falling path leaves the rim.
struct FlatProof {
    PROVEOUT_LANES static LaneMask holds(const Facts& facts) { return facts.convex | facts.oneFall; }
};
/// For a ball, f is convex on a circle unless the whole circle is under the cutter: the numerator of f'' is B
/// cos²φ + 2 C cosφ + B with |C| <= B.
struct BallProof {
    PROVEOUT_LANES static LaneMask holds(const Facts& facts) {
        return facts.convex | (facts.oneFall & facts.reachOut);
    }
};
struct CornerProof {
    PROVEOUT_LANES static LaneMask holds(const Facts& facts) { return facts.convex; }
};

/// Angles during the iteration, and which of them have converged.
struct Approach {
    Lanes phi;
    LaneMask still;
};

PROVEOUT_LANES Approach nearestPlace(const Helix& helix, const Lanes& x, const Lanes& y) {
    constexpr int kMostSteps = 6;
    Approach at{Lanes{}, LaneMask{}};
    for (int step = 0; step < kMostSteps; ++step) {
        const Distance d(helix, x, y, at.phi);
        const Lanes downhill = d.halfSlope > 0 ? allLanes(-1) : allLanes(1);
        const Lanes newton = d.halfCurve > 0 ? -d.halfSlope / d.halfCurve : downhill;
        const Lanes next = lesser(greater(at.phi + newton, allLanes(-helix.half)), allLanes(helix.half));
        at.still = magnitude(next - at.phi) * helix.radius <= kStill;
        at.phi = next;
        if (!any(at.still == 0))
            break;
    }
    return at;
}

template<class Ahead>
PROVEOUT_LANES Approach lowestPlace(const Helix& helix, const Ahead& ahead, const Lanes& x, const Lanes& y,
                                    const LaneMask& under, const Lanes& nearest) {
    constexpr int kMostSteps = 8;
    constexpr double kLeastCurve = 1e-12;
    const double sign = helix.climb < 0 ? 1.0 : -1.0;
    Approach at{nearest, LaneMask{}};
    for (int step = 0; step < kMostSteps; ++step) {
        const Distance d(helix, x, y, at.phi);
        const LaneMask bent = d.halfCurve > kLeastCurve;
        const Lanes curve = bent ? d.halfCurve : allLanes(1);
        const Lanes speed = sqrtOf(curve);
        const Lanes offset = d.halfSlope / curve;
        // A value below zero does not correspond to a straight motion, but the iteration passes through it
        // without harm.
        const Lanes across2 = lesser(d.value - d.halfSlope * offset, allLanes(helix.rim2));
        const Lanes lead = ahead(std::fabs(helix.climb) / speed, across2);
        const Lanes next = lesser(greater(at.phi + sign * lead / speed - offset, allLanes(-helix.half)),
                                  allLanes(helix.half));
        at.still = bent & (magnitude(next - at.phi) * helix.radius <= kStill);
        at.phi = next;
        if (!any(under & (at.still == 0)))
            break;
    }
    return at;
}

template<class Form, class Ahead, class Proof>
PROVEOUT_LANES std::uint64_t lowerPoints(const Form& form, const Ahead& ahead, const Proof&,
                                         const Helix& helix, Columns columns, float* out) {
    std::uint64_t unsure = 0;
    for (int k0 = columns.begin; k0 < columns.end; k0 += kLanes) {
        const Lanes x = ramp(helix.x + helix.xStep * k0, helix.xStep);
        const Lanes y = ramp(helix.y + helix.yStep * k0, helix.yStep);
        LaneMask sure = Proof::holds(factsOf(helix, x, y));
        // The nearest place shows whether the cutter comes over the point.
        Approach at = nearestPlace(helix, x, y);
        const Lanes nearest2 = Distance(helix, x, y, at.phi).value;
        const LaneMask under = nearest2 <= helix.rim2;
        sure &= at.still;
        // If even the part's lowest end at that distance is above what other parts have reached, no search is
        // needed.
        const Lanes least = helix.z - std::fabs(helix.climb) * helix.half +
                            form.height(lesser(nearest2, allLanes(helix.rim2)));
        const LaneMask open = under & (least < load(out + k0, columns.end - k0));
        if (!any(open | (sure == 0)))
            continue;
        if (helix.climb != 0 && any(under)) {
            at = lowestPlace(helix, ahead, x, y, under, at.phi);
            sure &= at.still | (under == 0);
        }
        // Where the last step has left the rim by more than rounding, the search decides.
        const Lanes distance2 = Distance(helix, x, y, at.phi).value;
        sure &= (distance2 <= helix.rim2 * (1 + 1e-9)) | (under == 0);
        const Lanes z = helix.z + helix.climb * at.phi + form.height(lesser(distance2, allLanes(helix.rim2)));
        storeLower((sure & under) != 0 ? z : allLanes(kInfinity), columns.end - k0, out + k0);
        if (any(sure == 0)) {
            for (int k = 0; k < kLanes && k0 + k < columns.end; ++k)
                unsure |= std::uint64_t{sure[k] == 0} << (k0 + k);
        }
    }
    return unsure;
}

PROVEOUT_VECTOR_CLONES std::uint64_t lowerFlat(const FlatForm& form, const Helix& helix, Columns columns,
                                               float* out) {
    return lowerPoints(form, FlatAhead{helix.rim2}, FlatProof{}, helix, columns, out);
}

PROVEOUT_VECTOR_CLONES std::uint64_t lowerBall(const BallForm& form, const Helix& helix, Columns columns,
                                               float* out) {
    return lowerPoints(form, BallAhead{form.radius2, helix.rim2}, BallProof{}, helix, columns, out);
}

PROVEOUT_VECTOR_CLONES std::uint64_t lowerCorner(const CornerForm& form, double corner, const Helix& helix,
                                                 Columns columns, float* out) {
    return lowerPoints(form, CornerAhead{form.centreR, corner, form.flatTo * form.flatTo, helix.rim2},
                       CornerProof{}, helix, columns, out);
}

} // namespace

std::uint64_t helixRow(const ConvexProfile& profile, const ArcPath& path, const ArcPart& part,
                       const RowPoints& row, Columns columns, float* out) {
    const Helix helix(profile, path, part, row);
    if (profile.side == ConvexProfile::Side::none)
        return lowerFlat(FlatForm(profile), helix, columns, out);
    if (profile.flatTo == 0 && profile.centreR == 0)
        return lowerBall(BallForm(profile), helix, columns, out);
    return lowerCorner(CornerForm(profile), profile.radius, helix, columns, out);
}

} // namespace proveout
