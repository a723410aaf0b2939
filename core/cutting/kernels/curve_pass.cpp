// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/kernels/curve_pass.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace proveout {

namespace {

/// How far a piece may deviate from the arc, over both sides, mm.
constexpr double kBulge = 8e-5;
constexpr int kMostPieces = 4096;
/// mm per mm. Single precision resolves positions to a millionth of a millimetre or two; a piece that is
/// steeper moves over ground by less than 1/300 of its height, and is treated as a plunge to its lower end.
constexpr double kSteepest = 300;

/// The number of pieces for a curve whose second derivative is nowhere larger than `bend`, over [begin, end].
double piecesOf(const ArcPath& path) {
    return std::max(1.0, std::ceil((path.end - path.begin) * std::sqrt(path.bend() / (8 * kBulge))));
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

CurvePass::CurvePass(const ConvexProfile& profile, const ArcPath& path)
    : m_profile(profile), m_path(path), m_pieces(static_cast<int>(piecesOf(path))), m_bulge(kBulge) {
    m_path.radius += m_bulge / 2;
}

void CurvePass::addOverTile(double x, double y, const TileSpacing& spacing,
                            std::vector<TilePass>& passes) const {
    const double reach = m_profile.rim + spacing.tileReach + m_bulge;
    const auto at = [&](int k) {
        return m_path.at(std::lerp(m_path.begin, m_path.end, k / static_cast<double>(m_pieces)));
    };
    const auto add = [&](int k) {
        StraightPath piece = straightPath(at(k), at(k + 1));
        if (std::abs(piece.slope) > kSteepest)
            piece = straightPath(lower(at(k), at(k + 1)), lower(at(k), at(k + 1)));
        const Vec2 middle = piece.from + 0.5 * piece.length * piece.along;
        if (std::hypot(x - middle.x, y - middle.y) <= reach + piece.length)
            passes.push_back(StraightPass(m_profile, piece).overTile(x, y, spacing));
    };
    // Odd multiples of falling powers of two: each piece once.
    for (int step = static_cast<int>(std::bit_ceil(static_cast<unsigned>(m_pieces))); step > 0; step /= 2) {
        for (int k = step; k < m_pieces; k += 2 * step)
            add(k);
    }
    add(0);
}

} // namespace proveout
