// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/profiles/level_profile.h"

#include <algorithm>
#include <array>
#include <limits>

namespace proveout {

namespace {

/// Distances are computed from numbers as large as the cutter and a tile; see StraightPass.
constexpr double kRimSlack = 1e-6;

float toFloat(double value) {
    return static_cast<float>(value);
}

LevelProfile::Piece pieceOf(const ProfilePiece& piece, double bottom, double rimSlack) {
    const double rim = piece.r1 + rimSlack + kRimSlack * (1 + piece.r1);
    LevelProfile::Piece made{};
    made.rim2 = toFloat(rim * rim);
    made.arc = piece.kind != PieceKind::line;
    made.r0 = toFloat(piece.r0);
    made.z0 = toFloat(piece.z0 - bottom);
    if (!made.arc && piece.r1 > piece.r0)
        made.rise = toFloat((piece.z1 - piece.z0) / (piece.r1 - piece.r0));
    made.centreR = toFloat(piece.centreR);
    made.centreZ = toFloat(piece.centreZ - bottom);
    made.radius2 = toFloat(piece.radius * piece.radius);
    made.side = piece.kind == PieceKind::arc ? -1.0F : 1.0F;
    return made;
}

/// Heights of the profile at this many radii, each the lowest up to the next one: heights never fall
/// outwards.
struct Steps {
    static constexpr std::size_t kCount = 24;
    std::array<double, kCount + 1> radii{};
    std::array<double, kCount> heights{};

    explicit Steps(std::span<const ProfilePiece> pieces) {
        const double rim = pieces.back().r1;
        std::size_t at = 0;
        for (std::size_t k = 0; k <= kCount; ++k) {
            radii[k] = rim * static_cast<double>(k) / kCount;
            while (at + 1 < pieces.size() && pieces[at].r1 < radii[k])
                ++at;
            if (k < kCount)
                heights[k] = heightOf(pieces[at], std::max(radii[k], pieces[at].r0)) - pieces.front().z0;
        }
    }

    /// The steepest line from (radii[from], 0) that is nowhere above the heights.
    [[nodiscard]] double riseFrom(std::size_t from) const {
        double rise = heights[from] / (radii[from + 1] - radii[from]);
        for (std::size_t k = from + 1; k < kCount; ++k)
            rise = std::min(rise, heights[k] / (radii[k + 1] - radii[from]));
        return rise;
    }
};

/// Flat, followed by a line that begins at the radius for which the line is high at the rim.
ConvexProfile convexBelow(std::span<const ProfilePiece> pieces, double rim) {
    const Steps steps(pieces);
    ConvexProfile below;
    below.rim = rim;
    below.flatTo = rim;
    double highest = 0;
    for (std::size_t from = 0; from < Steps::kCount; ++from) {
        const double rise = steps.riseFrom(from);
        const double height = rise * (rim - steps.radii[from]);
        if (height <= highest)
            continue;
        highest = height;
        below.side = ConvexProfile::Side::line;
        below.slope = rise;
        below.flatTo = steps.radii[from];
    }
    below.z0 = pieces.front().z0;
    return below;
}

} // namespace

LevelProfile::LevelProfile(std::span<const ProfilePiece> all, double rimSlack)
    : exact(all.begin(), all.end()), rim(all.back().r1 + rimSlack) {
    pieces.reserve(all.size());
    for (const ProfilePiece& piece : all)
        pieces.push_back(pieceOf(piece, all.front().z0, rimSlack));
    below = convexBelow(all, rim);
}

double LevelProfile::height(double radius) const {
    if (radius > rim)
        return std::numeric_limits<double>::infinity();
    const auto under = std::ranges::find_if(
        exact, [&](const ProfilePiece& piece) { return radius <= piece.r1 + (rim - exact.back().r1); });
    return heightOf(*under, std::clamp(radius, under->r0, under->r1));
}

} // namespace proveout
