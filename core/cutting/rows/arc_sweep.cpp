// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/rows/arc_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/cutting/rows/vertical_arc.h"

namespace proveout {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Bounds that are nearer than this, mm, count as equal.
constexpr double kMet = 3e-5;
/// A part that deviates from its tangent by less than this, mm, is treated as its tangent.
constexpr double kStraight = 1e-10;
/// Also the largest angle for which the series of helix_row.cpp are accurate.
constexpr double kPartAngle = 0.2;
constexpr double kMostParts = 1e6;

double squared(double value) {
    return value * value;
}

/// Search over one path for one point. `best` is the height at a position that the cutter really reaches.
struct Search {
    const ConvexProfile& profile;
    const ArcPath& path;
    Vec2 point;
    double bend;
    double zBend; ///< bend of the height alone
    double best;

    struct Bounds {
        double below;
        double found;
    };

    [[nodiscard]] double heightAt(double t) const {
        const Vec3 tip = path.at(t);
        const double distance2 = squared(tip.x - point.x) + squared(tip.y - point.y);
        if (!(distance2 <= squared(profile.rim)))
            return kInfinity;
        return tip.z + profile.height(std::sqrt(distance2));
    }

    [[nodiscard]] Bounds bounds(double middle, double half) const {
        const auto [tip, rate] = path.tangentAt(middle);
        const Vec3 step = rate * half;
        const double away = 0.5 * bend * half * half;
        const StraightPath tangent = straightPath(tip - step, tip + step);
        const Contact contact = lowestContact(profile.dilated(away), tangent, point);
        if (contact.z == kInfinity)
            return {kInfinity, kInfinity};
        const auto placeOf = [&](const Contact& met) {
            if (tangent.length == 0)
                return middle + half * (step.z < 0 ? 1.0 : -1.0);
            return middle + half * std::clamp(2 * met.along / tangent.length - 1, -1.0, 1.0);
        };
        double found = heightAt(placeOf(contact));
        if (found == kInfinity && profile.rim > away) {
            // The lowest place is where the point leaves the wider rim. A place as far inside the rim as the
            // arc may bend is surely on the path.
            ConvexProfile inner = profile;
            inner.rim -= away;
            const Contact safe = lowestContact(inner, tangent, point);
            if (safe.z != kInfinity)
                found = heightAt(placeOf(safe));
        }
        return {contact.z - 0.5 * zBend * half * half, found};
    }

    /// Evaluates both halves of a part before descending into the more promising one: the result often makes
    /// the other unnecessary.
    void refine(double middle, double half) {
        if (0.5 * bend * half * half < kStraight)
            return;
        const double quarter = half / 2;
        const Bounds left = bounds(middle - quarter, quarter);
        const Bounds right = bounds(middle + quarter, quarter);
        best = std::min({best, left.found, right.found});
        const double first = left.below < right.below ? -quarter : quarter;
        if (std::min(left.below, right.below) < best - kMet)
            refine(middle + first, quarter);
        if (std::max(left.below, right.below) < best - kMet)
            refine(middle - first, quarter);
    }

    void search(double middle, double half) {
        const Bounds met = bounds(middle, half);
        best = std::min(best, met.found);
        if (met.below < best - kMet)
            refine(middle, half);
    }
};

} // namespace

std::vector<ArcPart> splitArc(const ArcPath& path) {
    const double whole = path.end - path.begin;
    const auto count = static_cast<std::size_t>(
        std::clamp(std::ceil(std::abs(path.sweep) * whole / kPartAngle), 1.0, kMostParts));
    const double half = whole / (2 * static_cast<double>(count));
    // Between its two ends a curve deviates from its chord by at most bend · (2 half)² / 8.
    const double bulge = 0.5 * path.bend() * half * half;
    std::vector<ArcPart> parts(count);
    for (std::size_t k = 0; k < count; ++k) {
        ArcPart& part = parts[k];
        part.half = half;
        part.middle = path.begin + (2 * static_cast<double>(k) + 1) * half;
        const Vec3 a = path.at(part.middle - half);
        const Vec3 b = path.at(part.middle + half);
        part.bulge = bulge;
        part.chord = straightPath(a, b);
        part.lo = glm::min(Vec2(a), Vec2(b)) - bulge;
        part.hi = glm::max(Vec2(a), Vec2(b)) + bulge;
        part.lowestZ = std::min(a.z, b.z) - (path.normal == 2 ? 0.0 : bulge);
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const ArcPart& a, const ArcPart& b) { return a.lowestZ < b.lowestZ; });
    return parts;
}

double arcPartEnvelope(const ConvexProfile& profile, const ArcPath& path, const ArcPart& part,
                       const Vec2& point, double known) {
    const double reach = profile.rim;
    if (point.x < part.lo.x - reach || point.x > part.hi.x + reach || point.y < part.lo.y - reach ||
        point.y > part.hi.y + reach || !(part.lowestZ + profile.z0 < known))
        return known;
    if (solvedAsVerticalArc(profile, path))
        return verticalArcEnvelope(profile, path, part, point, known);
    const double bend = path.bend();
    Search search{profile, path, point, bend, path.normal == 2 ? 0.0 : bend, known};
    search.search(part.middle, part.half);
    return search.best;
}

double arcEnvelope(const ConvexProfile& profile, const ArcPath& path, const std::vector<ArcPart>& parts,
                   const Vec2& point) {
    double best = kInfinity;
    for (const ArcPart& part : parts)
        best = arcPartEnvelope(profile, path, part, point, best);
    return best;
}

} // namespace proveout
