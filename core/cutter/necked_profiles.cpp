// SPDX-License-Identifier: GPL-3.0-or-later
// Cutters with a head that is wider than their neck.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include "core/base/figures_argument.h"
#include "core/cutter/cutter_findings.h"
#include "core/cutter/shape_profiles.h"

namespace proveout {

namespace {

tl::unexpected<Diagnostics> neckTooThick(double neck, double limit) {
    return failure(cutter_finding::kNeckTooThick, {fmt::format("{}", neck), figures("{:.6g}", limit)});
}

/// The upper part of a circle around (centreR, centreZ), between two radii.
ProfilePiece roundTop(double centreR, double centreZ, double radius, double r0, double r1) {
    ProfilePiece piece = sideBetween(r0, 0, r1, 0);
    piece.kind = PieceKind::upperArc;
    piece.centreR = centreR;
    piece.centreZ = centreZ;
    piece.radius = radius;
    piece.z0 = heightOf(piece, r0);
    piece.z1 = heightOf(piece, r1);
    return piece;
}

/// A disc with a quarter circle around it.
std::vector<ProfilePiece> roundedBottom(double radius, double corner) {
    std::vector<ProfilePiece> pieces;
    if (corner < radius)
        pieces.push_back(ringBetween(0, radius - corner));
    if (corner > 0)
        pieces.push_back(cornerFrom(radius - corner, corner));
    pieces.back().r1 = radius; // the sum may round to something else
    return pieces;
}

} // namespace

/// d, neck
Result<CutterProfile> lollipopProfile(const ShapeValues& values) {
    const double radius = values[0] / 2;
    const double neck = values[1] / 2;
    if (neck >= radius)
        return neckTooThick(values[1], values[0]);
    return CutterProfile{{cornerFrom(0, radius)},
                         NeckedHead{neck, {roundTop(0, radius, radius, neck, radius)}}};
}

/// d, w, neck, r
Result<CutterProfile> slotProfile(const ShapeValues& values) {
    const double radius = values[0] / 2;
    const double width = values[1];
    const double neck = values[2] / 2;
    const double corner = values[3];
    if (const double largest = std::min(radius, width / 2); corner > largest)
        return cornerTooLarge(corner, largest);
    if (neck >= radius - corner)
        return neckTooThick(values[2], 2 * (radius - corner));
    NeckedHead head{neck, {ringBetween(neck, radius - corner, width)}};
    if (corner > 0)
        head.back.push_back(roundTop(radius - corner, width - corner, corner, radius - corner, radius));
    return CutterProfile{roundedBottom(radius, corner), head};
}

/// d, angle, h, neck, r. `d` is the largest diameter, including the rounding between face and flank.
Result<CutterProfile> dovetailProfile(const ShapeValues& values) {
    const double radius = values[0] / 2;
    const double angle = glm::radians(values[1]);
    const double height = values[2];
    const double corner = values[4];
    if (corner > radius)
        return cornerTooLarge(corner, radius);
    const double ring = radius - corner;
    // The point where the rounding meets the flank.
    const double flankR = ring + corner * std::sin(angle);
    const double flankZ = corner * (1 + std::cos(angle));
    const double top = flankR - (height - flankZ) / std::tan(angle);
    if (height < flankZ)
        return cornerTooLarge(corner, height / (1 + std::cos(angle)));
    if (top <= 0)
        return failure(cutter_finding::kHeadTooHigh,
                       {fmt::format("{}", height), figures("{:.4g}", flankZ + flankR * std::tan(angle))});
    const double neck = values[3] > 0 ? values[3] / 2 : top;
    if (neck > top)
        return neckTooThick(values[3], 2 * top);
    NeckedHead head{neck, {}};
    if (neck < top)
        head.back.push_back(ringBetween(neck, top, height));
    if (top < flankR)
        head.back.push_back(sideBetween(top, height, flankR, flankZ));
    if (corner > 0)
        head.back.push_back(roundTop(ring, corner, corner, flankR, radius));
    return CutterProfile{roundedBottom(radius, corner), head};
}

} // namespace proveout
