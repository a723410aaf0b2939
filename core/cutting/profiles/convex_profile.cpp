// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/profiles/convex_profile.h"

#include <algorithm>
#include <cmath>

#include "core/cutting/profiles/hollow_profile.h"

namespace proveout {

double ConvexProfile::height(double r) const {
    if (r <= flatTo || side == Side::none)
        return z0;
    if (side == Side::line)
        return z0 + slope * (r - flatTo);
    const double out = r - centreR;
    return centreZ - std::sqrt(std::max(0.0, radius * radius - out * out));
}

ConvexProfile ConvexProfile::dilated(double margin) const {
    ConvexProfile wider = *this;
    wider.rim += margin;
    if (side == Side::arc && flatTo == 0 && centreR == 0) {
        // A ball that grows on all sides stays a ball, and keeps its closed solution.
        wider.radius += margin;
        wider.z0 -= margin;
        return wider;
    }
    wider.flatTo += margin;
    wider.centreR += margin;
    return wider;
}

namespace {

ConvexProfile filledInside(const ProfilePiece& piece, double rimSlack) {
    ConvexProfile profile;
    profile.z0 = piece.z0;
    profile.flatTo = piece.r0;
    profile.rim = piece.r1 + rimSlack;
    if (piece.kind == PieceKind::arc) {
        profile.side = ConvexProfile::Side::arc;
        profile.centreR = piece.centreR;
        profile.centreZ = piece.centreZ;
        profile.radius = piece.radius;
    } else if (piece.z1 > piece.z0 && piece.r1 > piece.r0) {
        profile.side = ConvexProfile::Side::line;
        profile.slope = (piece.z1 - piece.z0) / (piece.r1 - piece.r0);
    } else {
        profile.flatTo = profile.rim;
    }
    return profile;
}

/// Whether `next` with its filled inside covers all of `piece`. A hollow leaves the edge of its flat to the
/// piece before it.
bool coveredBy(const ProfilePiece& piece, const ProfilePiece& next) {
    return piece.kind == PieceKind::line && next.kind != PieceKind::upperArc && piece.z0 == piece.z1 &&
           piece.z1 == next.z0;
}

/// Whether `piece` is a wall on the rim of `before`.
bool restsOn(const ProfilePiece& before, const ProfilePiece& piece) {
    return piece.r0 == piece.r1 && before.r1 == piece.r0 && before.z1 <= piece.z0;
}

/// Calls `work` with those pieces that the others do not cover.
template<class Work>
void forEachNeeded(const std::vector<ProfilePiece>& pieces, const Work& work) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const bool wall = i > 0 && restsOn(pieces[i - 1], pieces[i]);
        if (!wall && (i + 1 == pieces.size() || !coveredBy(pieces[i], pieces[i + 1])))
            work(pieces[i]);
    }
}

HollowProfile hollow(const ProfilePiece& piece, double rimSlack) {
    ProfilePiece chord = piece;
    chord.kind = PieceKind::line;
    return {filledInside(chord, rimSlack), piece.centreR, piece.centreZ, piece.radius};
}

} // namespace

std::vector<ConvexProfile> convexProfiles(const Cutter& cutter, double rimSlack) {
    std::vector<ConvexProfile> profiles;
    profiles.reserve(cutter.solvablePieces().size());
    forEachNeeded(cutter.solvablePieces(),
                  [&](const ProfilePiece& piece) { profiles.push_back(filledInside(piece, rimSlack)); });
    return profiles;
}

std::optional<HollowedProfiles> hollowedProfiles(const Cutter& cutter, double rimSlack) {
    HollowedProfiles profiles;
    bool all = true;
    forEachNeeded(cutter.pieces(), [&](const ProfilePiece& piece) {
        if (piece.kind == PieceKind::upperArc)
            profiles.hollow.push_back(hollow(piece, rimSlack));
        else
            profiles.convex.push_back(filledInside(piece, rimSlack));
        all = all && (piece.kind != PieceKind::arc || piece.centreR >= 0);
    });
    if (!all || profiles.hollow.empty())
        return std::nullopt;
    return profiles;
}

} // namespace proveout
