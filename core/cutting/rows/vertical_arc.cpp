// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/rows/vertical_arc.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace proveout {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = std::numbers::pi;
/// Bounds that are nearer than this, mm, count as equal.
constexpr double kMet = 1e-5;
/// A radius that changes by less than this over a part, mm, counts as constant.
constexpr double kRound = 1e-10;

/// How far rounding may move a place on the rim off it.
constexpr double kOnRim = 1 + 1e-12;

double squared(double value) {
    return value * value;
}

double rootOf(double value) {
    return std::sqrt(std::max(0.0, value));
}

/// A path around a centre in the vertical plane, by the angle ψ from its lowest place: over ground it is at r
/// sin ψ, in height at -r cos ψ. Both are relative to the centre, and so is the point.
class VerticalArc {
public:
    VerticalArc(const ConvexProfile& profile, const ArcPath& path, const Vec2& point, double known)
        : m_profile(profile), m_path(path), m_centreZ(path.centre.z), m_best(known) {
        // In zx the angle is counted from +Z towards +X, in yz from +Y towards +Z.
        const bool zx = path.normal == 1;
        m_turn = zx ? kPi - path.angle : path.angle + kPi / 2;
        m_sweep = zx ? -path.sweep : path.sweep;
        const Vec2 to = point - Vec2(path.centre);
        m_along = zx ? to.x : to.y;
        m_across2 = squared(zx ? to.y : to.x);
    }

    double search(double middle, double half) {
        visit(middle, half);
        return m_best;
    }

private:
    /// Lowest heights over the point: of the circle, less the possible deviation of the path from it, and of
    /// places that are on the path.
    struct Bounds {
        double below = kInfinity;
        double found = kInfinity;
    };

    void visit(double middle, double half) {
        const double away = std::abs(m_path.widening) * half;
        const Bounds met = bounds(middle, half, away);
        m_best = std::min(m_best, met.found);
        if (away < kRound || !(met.below < m_best - kMet))
            return;
        visit(middle - half / 2, half / 2);
        visit(middle + half / 2, half / 2);
    }

    /// A minimum is at an end of the part, where the point crosses the rim, where a flat is lowest, or where
    /// the surface of a ball has the slope of the path: on the lower half (radius + c) sin ψ = along, on the
    /// upper one (radius - c) sin ψ = along, with c the radius of the ball's section through the point.
    Bounds bounds(double middle, double half, double away) const {
        const ConvexProfile wider = away > 0 ? m_profile.dilated(away) : m_profile;
        const double radius = m_path.radius + m_path.widening * middle;
        Bounds met;
        const auto look = [&](double psi) { lookAt(psi, middle, wider, radius, away, met); };
        const double from = m_turn + m_sweep * (middle - half);
        const double to = m_turn + m_sweep * (middle + half);
        const double lo = std::min(from, to);
        const double hi = std::max(from, to);
        look(lo);
        look(hi);
        if (radius <= 0 || squared(wider.rim) < m_across2)
            return met;
        const auto lookBySine = [&](double sine, bool lower, bool upper) {
            if (!(std::abs(sine) <= 1))
                return;
            const double angle = std::asin(sine);
            if (lower)
                lookWithin(angle, lo, hi, look);
            if (upper)
                lookWithin(kPi - angle, lo, hi, look);
        };
        const auto lookAtRim = [&](double rim) {
            const double reach = rootOf(squared(rim) - m_across2);
            lookBySine((m_along - reach) / radius, true, true);
            lookBySine((m_along + reach) / radius, true, true);
        };
        lookAtRim(wider.rim);
        // If the radius changes, a place on the wider rim may not be on the path; one this far inside surely
        // is.
        if (away > 0 && squared(std::max(0.0, m_profile.rim - away)) >= m_across2)
            lookAtRim(m_profile.rim - away);
        if (wider.side == ConvexProfile::Side::none) {
            lookWithin(0, lo, hi, look);
        } else {
            const double section = rootOf(squared(wider.radius) - m_across2);
            lookBySine(m_along / (radius + section), true, false);
            lookBySine(m_along / (radius - section), false, true);
        }
        return met;
    }

    /// Evaluates an angle, with whole turns added, where it falls into the part.
    template<class Look>
    static void lookWithin(double angle, double lo, double hi, Look&& look) {
        const double turn = 2 * kPi;
        const double first = angle + turn * std::ceil((lo - angle) / turn);
        if (first <= hi)
            look(first);
    }

    void lookAt(double psi, double middle, const ConvexProfile& wider, double radius, double away,
                Bounds& met) const {
        const double sine = std::sin(psi);
        const double cosine = std::cos(psi);
        const double distance2 = squared(radius * sine - m_along) + m_across2;
        if (distance2 <= squared(wider.rim) * kOnRim)
            met.below =
                std::min(met.below, m_centreZ - radius * cosine + wider.height(std::sqrt(distance2)) - away);
        const double t = m_sweep != 0 ? (psi - m_turn) / m_sweep : middle;
        const double real = m_path.radius + m_path.widening * t;
        const double realDistance2 = squared(real * sine - m_along) + m_across2;
        if (realDistance2 <= squared(m_profile.rim) * kOnRim)
            met.found =
                std::min(met.found, m_centreZ - real * cosine + m_profile.height(std::sqrt(realDistance2)));
    }

    const ConvexProfile& m_profile;
    const ArcPath& m_path;
    double m_centreZ;
    double m_turn = 0;  ///< ψ at t = 0
    double m_sweep = 0; ///< of ψ
    double m_along = 0;
    double m_across2 = 0;
    double m_best;
};

} // namespace

bool solvedAsVerticalArc(const ConvexProfile& profile, const ArcPath& path) {
    const bool ball = profile.side == ConvexProfile::Side::arc && profile.flatTo == 0 && profile.centreR == 0;
    return path.normal != 2 && path.climb == 0 && (ball || profile.side == ConvexProfile::Side::none);
}

double verticalArcEnvelope(const ConvexProfile& profile, const ArcPath& path, const ArcPart& part,
                           const Vec2& point, double known) {
    return VerticalArc(profile, path, point, known).search(part.middle, part.half);
}

} // namespace proveout
