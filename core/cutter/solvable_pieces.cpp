// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/solvable_pieces.h"

#include <algorithm>
#include <cmath>

namespace proveout {

namespace {

/// The largest deviation in height between an arc and the line between two points of it. The farthest point
/// is the one where the arc has the line's slope.
double chordError(const ProfilePiece& arc, double from, double to) {
    const double z0 = heightOf(arc, from);
    const double slope = (heightOf(arc, to) - z0) / (to - from);
    const double side = arc.kind == PieceKind::arc ? 1 : -1;
    const double away = side * slope * arc.radius / std::sqrt(1 + slope * slope);
    const double farthest = std::clamp(arc.centreR + away, from, to);
    return std::abs(heightOf(arc, farthest) - (z0 + slope * (farthest - from)));
}

/// The end of the longest line from `from` that is near enough, at most `last`. Errors grow with the length.
double lineEnd(const ProfilePiece& arc, double from, double last) {
    constexpr double kFinest = 1e-9;
    const auto tooFar = [&](double to) { return chordError(arc, from, to) > 2 * kProfileError; };
    if (last - from <= kFinest || !tooFar(last))
        return last;
    double near = from + kFinest;
    double far = last;
    while (far - near > kFinest) {
        const double middle = (near + far) / 2;
        (tooFar(middle) ? far : near) = middle;
    }
    return near;
}

ProfilePiece lineBetween(const ProfilePiece& arc, double from, double to, double shift) {
    ProfilePiece line;
    line.r0 = from;
    line.r1 = to;
    line.z0 = heightOf(arc, from) + shift;
    line.z1 = heightOf(arc, to) + shift;
    return line;
}

/// Lines between points of the arc, shifted so that they deviate equally to both sides of it.
void addLines(const ProfilePiece& arc, std::vector<ProfilePiece>& lines) {
    const bool hollow = arc.kind == PieceKind::upperArc;
    const double shift = hollow ? kProfileError : -kProfileError;
    double from = arc.r0;
    double last = arc.r1;
    if (hollow && arc.r0 - (arc.centreR - arc.radius) < kUprightPart)
        from = std::min(arc.r0 + kUprightPart, arc.r1);
    if (!hollow && arc.centreR + arc.radius - arc.r1 < kUprightPart)
        last = std::max(arc.r1 - kUprightPart, arc.r0);
    while (from < last) {
        const double to = lineEnd(arc, from, last);
        lines.push_back(lineBetween(arc, from, to, shift));
        from = to;
    }
    if (last < arc.r1)
        lines.push_back(lineBetween(arc, last, arc.r1, shift));
}

bool solvable(const ProfilePiece& piece) {
    return piece.kind == PieceKind::line || (piece.kind == PieceKind::arc && piece.centreR >= 0);
}

} // namespace

std::vector<ProfilePiece> solvablePieces(const std::vector<ProfilePiece>& pieces) {
    std::vector<ProfilePiece> all;
    all.reserve(pieces.size());
    for (const ProfilePiece& piece : pieces) {
        if (solvable(piece))
            all.push_back(piece);
        else
            addLines(piece, all);
    }
    return all;
}

} // namespace proveout
