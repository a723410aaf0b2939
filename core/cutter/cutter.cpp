// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

double heightOf(const ProfilePiece& piece, double r) {
    if (piece.kind == PieceKind::line) {
        const double along = piece.r1 > piece.r0 ? (r - piece.r0) / (piece.r1 - piece.r0) : 0.0;
        return piece.z0 + along * (piece.z1 - piece.z0);
    }
    const double out = r - piece.centreR;
    return piece.centreZ - std::sqrt(std::max(0.0, piece.radius * piece.radius - out * out));
}

} // namespace

Cutter::Cutter(std::string spec, std::vector<ProfilePiece> pieces, double fluteLength, double shankRadius,
               double shankLength)
    : m_spec(std::move(spec)), m_pieces(std::move(pieces)),
      m_radius(m_pieces.empty() ? 0.0 : m_pieces.back().r1), m_fluteLength(fluteLength),
      m_shankRadius(shankRadius), m_shankLength(shankLength) {}

double Cutter::height(double r) const {
    for (const ProfilePiece& piece : m_pieces) {
        if (r <= piece.r1)
            return heightOf(piece, std::max(r, piece.r0));
    }
    return std::numeric_limits<double>::infinity();
}

double Cutter::rimHeight() const {
    return m_pieces.empty() ? 0.0 : m_pieces.back().z1;
}

} // namespace proveout
