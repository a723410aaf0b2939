// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/kernels/curve_pass.h"

#include <algorithm>
#include <bit>
#include <cmath>

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

/// The number of pieces for a curve whose second derivative is nowhere larger than `bend`, over [begin, end].
double piecesOf(const ArcPath& path) {
    return std::max(1.0, std::ceil((path.end - path.begin) * std::sqrt(path.bend() / (8 * kBulge))));
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

} // namespace

bool CurvePass::suffices(const ConvexProfile& profile, const ArcPath& path, const TileSpacing& spacing) {
    // A vertical arc is steep in few pieces, a helix in all of them.
    StraightPath like;
    if (path.normal == 2)
        like.slope = path.climb / (path.sweep * std::min(path.radius, path.radius + path.widening));
    return piecesOf(path) <= kMostPieces && StraightPass::suffices(profile, like, spacing);
}

CurvePass::CurvePass(std::span<const ConvexProfile> profiles, const ArcPath& path)
    : m_profiles(profiles.begin(), profiles.end()), m_path(path), m_pieces(static_cast<int>(piecesOf(path))) {
    for (const ConvexProfile& profile : profiles)
        m_rim = std::max(m_rim, profile.rim);
}

CurvePass::CurvePass(const HollowedProfiles& profiles, const ArcPath& path)
    : CurvePass(profiles.convex, path) {
    m_hollows = profiles.hollow;
    for (const HollowProfile& hollow : profiles.hollow)
        m_rim = std::max(m_rim, hollow.below.rim);
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
        for (const ConvexProfile& profile : m_profiles) {
            if (distance <= profile.rim)
                passes.push_back(StraightPass(profile, piece).overTile(x, y, spacing));
        }
        for (const HollowProfile& hollow : m_hollows) {
            if (distance <= hollow.below.rim)
                passes.push_back(StraightPass(hollow, piece).overTile(x, y, spacing));
        }
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
