// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/rules/cutting_edge.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace proveout {

namespace {

/// The edge within a piece that reaches from below `height` to above it.
CuttingEdge edgeOf(const ProfilePiece& piece, double height) {
    if (piece.kind == PieceKind::line) {
        const double wide = piece.r1 - piece.r0;
        const double high = piece.z1 - piece.z0;
        return {piece.r0 + wide * (height - piece.z0) / high, high / std::hypot(wide, high)};
    }
    const double up = height - piece.centreZ;
    const double out = std::sqrt(std::max(0.0, piece.radius * piece.radius - up * up));
    const bool lower = piece.kind == PieceKind::arc;
    return {piece.centreR + (lower ? out : -out), out / piece.radius};
}

/// cos(kappa) at the inner end of a piece, where a lower arc is flattest, and along the whole of a line.
double largestCosine(const ProfilePiece& piece) {
    if (piece.kind == PieceKind::line)
        return (piece.r1 - piece.r0) / std::hypot(piece.r1 - piece.r0, piece.z1 - piece.z0);
    const double r = piece.kind == PieceKind::arc ? piece.r0 : piece.r1;
    const double sine = std::min(1.0, std::abs(r - piece.centreR) / piece.radius);
    return std::sqrt(1 - sine * sine);
}

} // namespace

CuttingEdge edgeAt(const Cutter& cutter, double height) {
    double radius = 0;
    for (const ProfilePiece& piece : cutter.pieces()) {
        if (height < piece.z0)
            return {radius, 1}; // between two pieces the edge is upright
        if (height < piece.z1)
            return edgeOf(piece, height);
        radius = piece.r1;
    }
    return {radius, 1};
}

double chipThickness(const Cutter& cutter, double feedPerTooth, double depth, double engagement) {
    const CuttingEdge edge = edgeAt(cutter, depth);
    const double share = edge.radius > 0 ? engagement / (2 * edge.radius) : 1;
    const double sine = share < 0.5 ? 2 * std::sqrt(share * (1 - share)) : 1;
    return feedPerTooth * sine * edge.sine;
}

double chipThicknessDown(const Cutter& cutter, double feedPerTooth, double depth) {
    double cosine = 0;
    for (const ProfilePiece& piece : cutter.pieces())
        if (piece.z0 < depth)
            cosine = std::max(cosine, largestCosine(piece));
    return feedPerTooth * cosine;
}

double surfaceSpeed(const Cutter& cutter, double depth, double rpm) {
    constexpr double kMmPerMetre = 1000;
    return std::numbers::pi * 2 * edgeAt(cutter, depth).radius * rpm / kMmPerMetre;
}

} // namespace proveout
