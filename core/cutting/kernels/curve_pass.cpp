// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/kernels/curve_pass.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace proveout {

namespace {

/// How far a piece may deviate from the arc, over both sides, mm.
constexpr double kBulge = 8e-5;
/// The same times the slope of the arc, by which a height differs where the arc is beside its place.
constexpr double kBulgeOfHeight = 5e-4;
constexpr int kMostPieces = 4096;
/// mm per mm. Single precision resolves positions to a millionth of a millimetre or two; a piece that is
/// steeper moves over ground by less than 1/300 of its height, and is treated as a plunge to its lower end.
constexpr double kSteepest = 300;

/// Hollows are cut at the ends of pieces, although over a point beside a piece they may be lowest in its
/// middle: their wall then stands up to length² / (8 · distance) beside its place. So much is allowed, mm.
constexpr double kWallBeside = 2e-4;
/// mm per mm. Where a hollow is steeper, it is cut in the middle of pieces as well: its wall then stands
/// within 5e-5 mm of its place, and heights are within 1e-3 mm up to a slope of 20.
constexpr double kSteepHollow = 4;

/// The number of pieces for a curve whose second derivative is nowhere larger than `bend`, over [begin, end].
double piecesOf(const ArcPath& path) {
    return std::max(1.0, std::ceil((path.end - path.begin) * std::sqrt(path.bend() / (8 * kBulge))));
}

/// Its inner part, as far as it is steep.
std::optional<HollowProfile> steepPart(HollowProfile hollow) {
    const double in = hollow.radius * kSteepHollow / std::sqrt(1 + kSteepHollow * kSteepHollow);
    ConvexProfile& below = hollow.below;
    const double rim = hollow.centreR - in;
    if (rim <= below.flatTo)
        return std::nullopt;
    if (rim < below.rim) {
        const double height = hollow.centreZ + std::sqrt(hollow.radius * hollow.radius - in * in);
        below.slope = (height - below.z0) / (rim - below.flatTo);
        below.rim = rim;
    }
    return hollow;
}

/// The same where pieces are no longer than hollows allow.
double piecesOf(const ArcPath& path, std::span<const HollowProfile> hollows) {
    double pieces = piecesOf(path);
    const double length = path.radius * std::abs(path.sweep) * (path.end - path.begin);
    for (const HollowProfile& hollow : hollows)
        pieces = std::max(pieces, std::ceil(length / std::sqrt(8 * hollow.below.flatTo * kWallBeside)));
    return pieces;
}

/// The number of parts of a piece that is as steep as the line between two places.
int partsOf(const Vec3& from, const Vec3& to) {
    const double over = std::hypot(to.x - from.x, to.y - from.y);
    const double rise = std::min(std::abs(to.z - from.z), kSteepest * over);
    return over > 0 ? static_cast<int>(std::ceil(std::sqrt(kBulge / kBulgeOfHeight * (1 + rise / over)))) : 1;
}

const Vec3& lower(const Vec3& a, const Vec3& b) {
    return a.z < b.z ? a : b;
}

StraightPath placeOn(StraightPath path, double along) {
    path.from += along * path.along;
    path.z += along * path.slope;
    path.length = 0;
    return path;
}

/// Whether it falls from one place to the next; where it does not, the first is the lower end.
bool fallsAfter(std::span<const Vec3> places, std::size_t place) {
    return places[place + 1].z < places[place].z;
}

/// The higher end of a piece if it is not the lower end of its neighbour.
std::optional<Vec3> topOf(std::span<const Vec3> places, std::size_t piece) {
    if (fallsAfter(places, piece))
        return piece > 0 && fallsAfter(places, piece - 1) ? std::nullopt : std::optional(places[piece]);
    const std::size_t top = piece + 1;
    return top + 1 < places.size() && !fallsAfter(places, top) ? std::nullopt : std::optional(places[top]);
}

} // namespace

bool CurvePass::suffices(const ConvexProfile& profile, const ArcPath& path, const TileSpacing& spacing) {
    // A vertical arc is steep in few pieces, a helix in all of them.
    StraightPath like;
    if (path.normal == 2)
        like.slope = path.climb / (path.sweep * std::min(path.radius, path.radius + path.widening));
    return piecesOf(path) <= kMostPieces && StraightPass::suffices(profile, like, spacing);
}

bool CurvePass::allSuffice(const HollowedProfiles& profiles, const ArcPath& path,
                           const TileSpacing& spacing) {
    const auto each = [&](const ConvexProfile& profile) { return suffices(profile, path, spacing); };
    const auto below = [&](const HollowProfile& hollow) { return each(hollow.below); };
    return path.climb == 0 && path.widening == 0 && piecesOf(path, profiles.hollow) <= kMostPieces &&
           std::ranges::all_of(profiles.convex, each) && std::ranges::all_of(profiles.hollow, below);
}

CurvePass::CurvePass(std::span<const ConvexProfile> profiles, const ArcPath& path)
    : m_profiles(profiles.begin(), profiles.end()), m_path(path), m_pieces(static_cast<int>(piecesOf(path))) {
    for (const ConvexProfile& profile : profiles)
        m_rim = std::max(m_rim, profile.rim);
}

CurvePass::CurvePass(const HollowedProfiles& profiles, const ArcPath& path)
    : CurvePass(profiles.convex, path) {
    m_hollows = profiles.hollow;
    m_pieces = static_cast<int>(piecesOf(path, m_hollows));
    for (const HollowProfile& hollow : m_hollows) {
        m_rim = std::max(m_rim, hollow.below.rim);
        if (const auto steep = steepPart(hollow))
            m_steep.push_back(*steep);
    }
}

std::vector<Vec3> CurvePass::places() const {
    const auto at = [&](double piece, int parts) {
        ArcPath path = m_path;
        path.radius += kBulge / (2.0 * parts * parts); // so that the pieces deviate to both sides
        return path.at(std::lerp(path.begin, path.end, piece / m_pieces));
    };
    std::vector<Vec3> places{m_path.at(m_path.begin)};
    places.reserve(static_cast<std::size_t>(m_pieces) + 1);
    Vec3 next = places.front();
    int partsBefore = 1;
    for (int k = 0; k < m_pieces; ++k) {
        const Vec3 from = next;
        next = at(k + 1, 1);
        const bool atEnd = k == 0 || k + 1 == m_pieces; // where a place is exactly on the arc
        const int parts = std::max(partsOf(from, next), atEnd ? 2 : 1);
        const int finest = std::max(parts, partsBefore);
        if (k > 0)
            places.push_back(finest > 1 ? at(k, finest) : from);
        for (int part = 1; part < parts; ++part)
            places.push_back(at(k + static_cast<double>(part) / parts, parts));
        partsBefore = parts;
    }
    places.push_back(m_path.at(m_path.end));
    return places;
}

void CurvePass::addOverTile(double x, double y, const TileSpacing& spacing,
                            std::vector<TilePass>& passes) const {
    const double margin = spacing.tileReach + kBulge;
    const std::vector<Vec3> places = this->places();
    const auto add = [&](std::size_t k) {
        StraightPath piece = straightPath(places[k], places[k + 1]);
        if (std::abs(piece.slope) > kSteepest) {
            const Vec3& bottom = lower(places[k], places[k + 1]);
            piece = straightPath(bottom, bottom);
        }
        const Vec2 middle = piece.from + 0.5 * piece.length * piece.along;
        const double distance = std::hypot(x - middle.x, y - middle.y) - margin - piece.length;
        if (distance > m_rim)
            return;
        const auto addHollows = [&](const std::vector<HollowProfile>& hollows, const StraightPath& path) {
            for (const HollowProfile& hollow : hollows) {
                if (distance <= hollow.below.rim)
                    passes.push_back(StraightPass::atLowerEnd(hollow, path).overTile(x, y, spacing));
            }
        };
        for (const ConvexProfile& profile : m_profiles) {
            if (distance <= profile.rim)
                passes.push_back(StraightPass(profile, piece).overTile(x, y, spacing));
        }
        addHollows(m_hollows, piece);
        addHollows(m_steep, placeOn(piece, 0.5 * piece.length));
        if (const auto top = topOf(places, k))
            addHollows(m_hollows, straightPath(*top, *top));
    };
    // Odd multiples of falling powers of two: each piece once.
    const std::size_t pieces = places.size() - 1;
    for (std::size_t step = std::bit_ceil(pieces); step > 0; step /= 2) {
        for (std::size_t k = step; k < pieces; k += 2 * step)
            add(k);
    }
    add(0);
}

} // namespace proveout
