// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "core/base/figures_argument.h"
#include "core/cutter/cutter_findings.h"
#include "core/cutter/shape_profiles.h"

namespace proveout {

ProfilePiece ringBetween(double r0, double r1, double z) {
    return sideBetween(r0, z, r1, z);
}

ProfilePiece sideBetween(double r0, double z0, double r1, double z1) {
    ProfilePiece piece;
    piece.r0 = r0;
    piece.r1 = r1;
    piece.z0 = z0;
    piece.z1 = z1;
    return piece;
}

ProfilePiece cornerFrom(double from, double cornerRadius) {
    ProfilePiece piece = sideBetween(from, 0, from + cornerRadius, cornerRadius);
    piece.kind = PieceKind::arc;
    piece.centreR = from;
    piece.centreZ = cornerRadius;
    piece.radius = cornerRadius;
    return piece;
}

tl::unexpected<Diagnostics> cornerTooLarge(double corner, double largest) {
    return failure(cutter_finding::kCornerRadiusTooLargeFit,
                   {fmt::format("{}", corner), figures("{:.4g}", largest)});
}

} // namespace proveout
