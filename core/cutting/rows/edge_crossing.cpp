// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/rows/edge_crossing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/cutting/rows/circle_crossing.h"

namespace proveout {

namespace {

/// How far beyond the end of a line a wall still counts, mm: single precision cuts points that are outside
/// the rim by less.
constexpr double kBeyond = 1e-4;
/// A place so far inside the rim, mm, is under the cutter in spite of rounding.
constexpr double kInside = 1e-9;
/// The width to which places are bisected, mm.
constexpr double kResolved = 2e-9;
/// A part of an arc that deviates from its tangent by less than this, mm, is treated as its tangent.
constexpr double kAsTangent = 5e-9;

bool isBefore(const EdgeCrossing& a, const EdgeCrossing& b) {
    if (a.place != b.place)
        return a.place < b.place;
    return a.outwards.x != b.outwards.x ? a.outwards.x < b.outwards.x : a.outwards.y < b.outwards.y;
}

struct Sample {
    double place;
    double value;
};

/// Whether a convex function can be below 0 between `a` and `b`: the lines through two of three places bound
/// it from below beyond these two.
bool mayBeBelow(const Sample& a, const Sample& middle, const Sample& b) {
    const double left = b.place > middle.place ? (b.value - middle.value) / (b.place - middle.place) : 0;
    const double right = middle.place > a.place ? (middle.value - a.value) / (middle.place - a.place) : 0;
    return !(middle.value - left * (middle.place - a.place) > 0 &&
             middle.value + right * (b.place - middle.place) > 0);
}

/// A place between `a` and `b` where a convex function is below 0. Golden section search.
template<class Function>
std::optional<double> placeBelow(const Function& f, Sample a, Sample b) {
    constexpr double kGolden = 0.381966011250105;
    const auto sample = [&](double place) { return Sample{place, f(place)}; };
    Sample middle = sample(a.place + kGolden * (b.place - a.place));
    for (int step = 0; step < 80 && b.place - a.place > kResolved; ++step) {
        if (middle.value < 0)
            return middle.place;
        if (!mayBeBelow(a, middle, b))
            return std::nullopt;
        const bool right = b.place - middle.place > middle.place - a.place;
        const Sample probe = sample(right ? middle.place + kGolden * (b.place - middle.place)
                                          : middle.place - kGolden * (middle.place - a.place));
        if (probe.value < middle.value) {
            (right ? a : b) = middle;
            middle = probe;
        } else {
            (right ? b : a) = probe;
        }
    }
    return middle.value < 0 ? std::optional(middle.place) : std::nullopt;
}

/// The first place between `lo` and `hi` where a convex function is below 0; may be left out if it is after
/// `latest`.
template<class Function>
std::optional<double> firstPlaceBelow(const Function& f, double lo, double hi, double latest) {
    const double margin = std::min(kInside, (hi - lo) / 4);
    Sample above{lo + margin, f(lo + margin)};
    if (above.value < 0)
        return lo;
    if (above.place > latest)
        return std::nullopt;
    const Sample end{hi - margin, f(hi - margin)};
    const std::optional<double> found = end.value < 0 ? end.place : placeBelow(f, above, end);
    if (!found)
        return std::nullopt;
    double below = *found;
    while (below - above.place > kResolved) {
        const double middle = (above.place + below) / 2;
        (f(middle) < 0 ? below : above.place) = middle;
    }
    return above.place;
}

/// What is known about a crossing before it is searched.
struct Known {
    double least = 0;                                        ///< it is not before this
    double latest = std::numeric_limits<double>::infinity(); ///< nor is it needed after this
};

/// The crossing with a straight path whose heights are lower by `lowered`. Along a line over ground the
/// envelope of a convex profile on a straight path is convex.
EdgeCrossing crossing(const ConvexProfile& profile, StraightPath path, double lowered, const EdgeLine& line,
                      const Known& known) {
    path.from = line.seen(path.from - line.from);
    path.along = line.seen(path.along);
    if (!(path.lowest() + profile.z0 - lowered < line.highest()))
        return {};
    const Span span = rowSpan(path, profile.rim, 0);
    const double lo = std::max(span.lo, known.least);
    const double hi = std::min(span.hi, line.length + kBeyond);
    if (!(lo <= hi) || lo > known.latest)
        return {};
    const auto above = [&](double place) {
        return lowestContact(profile, path, {place, 0}).z - lowered - line.heightAt(place);
    };
    const std::optional<double> place = firstPlaceBelow(above, lo, hi, known.latest);
    if (!place)
        return {};
    const Vec2 point(*place, 0);
    const double nearest = std::clamp(glm::dot(point - path.from, path.along), 0.0, path.length);
    const Vec2 away = point - (path.from + path.along * nearest);
    const double distance = glm::length(away);
    return {*place, line.unseen(distance > kInside ? away / distance : Vec2(-1, 0))};
}

/// The search over an arc for one line.
class ArcCrossing {
public:
    ArcCrossing(const ConvexProfile& profile, const ArcPath& path, const EdgeLine& line, EdgeCrossing& first)
        : m_profile(profile), m_path(path), m_line(line), m_first(first), m_bend(path.bend()),
          m_zBend(path.normal == 2 ? 0.0 : m_bend) {}

    /// No crossing is before `least`.
    void run(std::span<const ArcPart> parts, double least) {
        std::vector<Part> open;
        for (const ArcPart& part : parts)
            if (reaches(part))
                if (const Part met = partOf(part.middle, part.half, least); mayBeFirst(met))
                    open.push_back(met);
        std::ranges::sort(open, {}, [](const Part& part) { return part.early.place; });
        for (const Part& part : open)
            if (mayBeFirst(part))
                refine(part);
    }

private:
    struct Part {
        double middle; ///< it spans t = middle ± half
        double half;
        EdgeCrossing early; ///< not later than the true one
    };

    [[nodiscard]] bool mayBeFirst(const Part& part) const {
        return part.early.found() && part.early.place <= m_first.place;
    }

    [[nodiscard]] bool reaches(const ArcPart& part) const {
        const Vec2 end = m_line.at(m_line.length);
        const Vec2 lo = glm::min(m_line.from, end) - m_profile.rim;
        const Vec2 hi = glm::max(m_line.from, end) + m_profile.rim;
        return part.lo.x <= hi.x && part.hi.x >= lo.x && part.lo.y <= hi.y && part.hi.y >= lo.y &&
               part.lowestZ + m_profile.z0 < m_line.highest();
    }

    /// By the tangent at the middle with a profile wider by the arc's deviation from it. Bounds are never
    /// before that of the whole, `least`: then which parts are left out cannot affect the result.
    [[nodiscard]] Part partOf(double middle, double half, double least) const {
        const auto [tip, rate] = m_path.tangentAt(middle);
        const Vec3 step = rate * half;
        const double away = 0.5 * m_bend * half * half;
        const EdgeCrossing early = crossing(m_profile.dilated(away), straightPath(tip - step, tip + step),
                                            0.5 * m_zBend * half * half, m_line, {least, m_first.place});
        return {middle, half, early};
    }

    void refine(const Part& part) {
        if (0.5 * m_bend * part.half * part.half < kAsTangent) {
            m_first.take(part.early);
            return;
        }
        const double quarter = part.half / 2;
        Part next = partOf(part.middle - quarter, quarter, part.early.place);
        Part other = partOf(part.middle + quarter, quarter, part.early.place);
        if (other.early.place < next.early.place)
            std::swap(next, other);
        if (mayBeFirst(next))
            refine(next);
        if (mayBeFirst(other))
            refine(other);
    }

    const ConvexProfile& m_profile;
    const ArcPath& m_path;
    const EdgeLine& m_line;
    EdgeCrossing& m_first;
    double m_bend;
    double m_zBend; ///< bend of the height alone
};

} // namespace

void EdgeCrossing::take(const EdgeCrossing& other) {
    if (isBefore(other, *this))
        *this = other;
}

void findCrossing(const ConvexProfile& profile, const StraightPath& path, const EdgeLine& line,
                  EdgeCrossing& first) {
    first.take(crossing(profile, path, 0, line, {0, first.place}));
}

void findCrossing(const ConvexProfile& profile, const ArcPath& path, std::span<const ArcPart> parts,
                  const EdgeLine& line, EdgeCrossing& first) {
    double least = 0;
    if (isRoundOverGround(path)) {
        const CircleEntry entry = entryUnderCircle(profile, path, line, kBeyond, first.place);
        if (!entry.crossing.found() || entry.crossing.place > first.place)
            return;
        if (entry.height < line.heightAt(entry.crossing.place)) {
            first.take(entry.crossing);
            return;
        }
        // It is so high there that the line meets it later.
        least = entry.crossing.place + kInside;
        if (least > first.place)
            return;
    }
    ArcCrossing(profile, path, line, first).run(parts, least);
}

} // namespace proveout
