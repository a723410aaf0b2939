// SPDX-License-Identifier: GPL-3.0-or-later
// A cutter is the curve h(r): the height of its surface above the tip at the radius r from its axis.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"

namespace proveout {

enum class PieceKind { line, arc };

/// One piece of the profile over radii [r0, r1]. Heights rise (or stay) with the radius and each piece is
/// convex. line: from (r0, z0) straight to (r1, z1). arc:  the lower quarter of a circle round (centreR,
/// centreZ): z = centreZ - sqrt(radius² - (r - centreR)²).
struct ProfilePiece {
    PieceKind kind = PieceKind::line;
    double r0 = 0;
    double r1 = 0;
    double z0 = 0;
    double z1 = 0;
    double centreR = 0;
    double centreZ = 0;
    double radius = 0;
};

/// A rotating cutter, tip at the origin, axis +Z, mm. Value type, immutable after construction.
class Cutter {
public:
    Cutter() = default;
    /// `pieces` from the axis outwards, without gaps in r; `spec` is the text it was made from, e.g.
    /// "ball:d=11,l=50".
    Cutter(std::string spec, std::vector<ProfilePiece> pieces, double fluteLength, double shankRadius,
           double shankLength);

    [[nodiscard]] const std::string& spec() const { return m_spec; }
    [[nodiscard]] const std::vector<ProfilePiece>& pieces() const { return m_pieces; }
    [[nodiscard]] double radius() const { return m_radius; } ///< the largest radius
    [[nodiscard]] double fluteLength() const { return m_fluteLength; }
    [[nodiscard]] double shankRadius() const { return m_shankRadius; }
    [[nodiscard]] double shankLength() const { return m_shankLength; } ///< from the end of the flutes upwards
    /// h(r) for 0 <= r <= radius(); +infinity outside. The rim belongs to the cutter.
    [[nodiscard]] double height(double r) const;
    /// Height of the profile at its rim, where the cylindrical part begins.
    [[nodiscard]] double rimHeight() const;

    friend bool operator==(const Cutter& a, const Cutter& b) { return a.m_spec == b.m_spec; }

private:
    std::string m_spec;
    std::vector<ProfilePiece> m_pieces;
    double m_radius = 0;
    double m_fluteLength = 0;
    double m_shankRadius = 0;
    double m_shankLength = 0;
};

/// Makes a cutter from `SHAPE:key=value,…` by the rows of shapes.h. Errors name the key and the limits.
[[nodiscard]] Result<Cutter> parseCutter(std::string_view spec);

} // namespace proveout
