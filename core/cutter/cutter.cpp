// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/cutter/solvable_pieces.h"

namespace proveout {

double heightOf(const ProfilePiece& piece, double r) {
    if (piece.kind == PieceKind::line) {
        const double along = piece.r1 > piece.r0 ? (r - piece.r0) / (piece.r1 - piece.r0) : 0.0;
        return piece.z0 + along * (piece.z1 - piece.z0);
    }
    const double out = r - piece.centreR;
    const double half = std::sqrt(std::max(0.0, piece.radius * piece.radius - out * out));
    return piece.kind == PieceKind::arc ? piece.centreZ - half : piece.centreZ + half;
}

Cutter::Cutter(std::string spec, CutterProfile profile, ToolBody body, CuttingData data)
    : m_spec(std::move(spec)), m_profile(std::move(profile)),
      m_solvable(proveout::solvablePieces(m_profile.pieces)),
      m_radius(m_profile.pieces.empty() ? 0.0 : m_profile.pieces.back().r1), m_body(std::move(body)),
      m_data(data) {
    m_body.fluteLength = std::max(m_body.fluteLength, profileHeight());
}

double Cutter::height(double r) const {
    for (const ProfilePiece& piece : pieces()) {
        if (r <= piece.r1)
            return heightOf(piece, std::max(r, piece.r0));
    }
    return std::numeric_limits<double>::infinity();
}

double Cutter::rimHeight() const {
    return pieces().empty() ? 0.0 : pieces().back().z1;
}

double Cutter::profileHeight() const {
    return head() && !head()->back.empty() ? head()->back.front().z0 : rimHeight();
}

} // namespace proveout
