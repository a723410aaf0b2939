// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/convex_profile.h"

#include <algorithm>
#include <cmath>

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
        // A ball that grows all round stays a ball, and keeps its closed solution.
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

/// Whether the filled inside of `next` is all that `piece` is.
bool coveredBy(const ProfilePiece& piece, const ProfilePiece& next) {
    return piece.kind == PieceKind::line && piece.z0 == piece.z1 && piece.z1 == next.z0;
}

} // namespace

std::vector<ConvexProfile> convexProfiles(const Cutter& cutter, double rimSlack) {
    const auto& pieces = cutter.solvablePieces();
    std::vector<ConvexProfile> profiles;
    profiles.reserve(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (i + 1 == pieces.size() || !coveredBy(pieces[i], pieces[i + 1]))
            profiles.push_back(filledInside(pieces[i], rimSlack));
    }
    return profiles;
}

} // namespace proveout
