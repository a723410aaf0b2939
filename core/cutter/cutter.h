// SPDX-License-Identifier: GPL-3.0-or-later
// A cutter is the curve h(r): the height of its surface above the tip at the radius r from its axis.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/cutter/cutting_data.h"
#include "core/cutter/holder.h"

namespace proveout {

enum class PieceKind { line, arc, upperArc };

/// One piece of a profile over radii [r0, r1], from (r0, z0) to (r1, z1). line: straight. arc: on the lower
/// half of a circle around (centreR, centreZ): z = centreZ - sqrt(radius² - (r - centreR)²). upperArc: on its
/// upper half, a hollow in the side of a cutter or the round top of a head.
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

/// A head that is wider than the neck above it. Seen from above, it reaches under material that stays.
struct NeckedHead {
    double neckRadius = 0;
    /// The top of the head from the neck outwards to the rim, without gaps in r; heights fall (or stay).
    std::vector<ProfilePiece> back;
};

/// The profile that the row of a shape makes.
struct CutterProfile {
    /// From the axis outwards, without gaps in r; heights rise (or stay), and may jump up between two pieces.
    std::vector<ProfilePiece> pieces;
    std::optional<NeckedHead> head; ///< none: above its rim the cutter is as wide as at the rim
};

/// The tool above the cutting edges, mm. Value type.
struct ToolBody {
    double fluteLength = 0;
    double shankRadius = 0;
    double shankLength = 0;            ///< from the end of the flutes upwards
    bool shankGiven = false;           ///< false: it is only assumed to be as thick as the cutter or its neck
    double stickOut = 0;               ///< from the tip to the face of the holder; 0: unknown
    std::vector<HolderSegment> holder; ///< from its face upwards; empty: unknown
};

/// The height of a piece at r0 <= r <= r1.
[[nodiscard]] double heightOf(const ProfilePiece& piece, double r);

/// A rotating cutter, tip at the origin, axis +Z, mm. Value type, immutable after construction.
class Cutter {
public:
    Cutter() = default;
    /// `spec` is the text it was made from, e.g. "ball:d=11,l=50". The flutes are at least as long as the
    /// profile is high; for a necked head, their length is that of head and neck.
    Cutter(std::string spec, CutterProfile profile, ToolBody body = {}, CuttingData data = {});

    [[nodiscard]] const std::string& spec() const { return m_spec; }
    [[nodiscard]] const std::vector<ProfilePiece>& pieces() const { return m_profile.pieces; }
    /// pieces() with lines in place of the arcs that cutting cannot solve, within kProfileError of them in
    /// height.
    [[nodiscard]] const std::vector<ProfilePiece>& solvablePieces() const { return m_solvable; }
    [[nodiscard]] const std::optional<NeckedHead>& head() const { return m_profile.head; }
    [[nodiscard]] double radius() const { return m_radius; } ///< the largest radius
    [[nodiscard]] const ToolBody& body() const { return m_body; }
    [[nodiscard]] const CuttingData& data() const { return m_data; }
    [[nodiscard]] double fluteLength() const { return m_body.fluteLength; }
    [[nodiscard]] double shankRadius() const { return m_body.shankRadius; }
    [[nodiscard]] double shankLength() const { return m_body.shankLength; }
    /// h(r) for 0 <= r <= radius(); +infinity outside. The rim belongs to the cutter.
    [[nodiscard]] double height(double r) const;
    /// Height of the profile at its rim, where the cylindrical part begins.
    [[nodiscard]] double rimHeight() const;
    /// Height of the whole profile, including a head's back.
    [[nodiscard]] double profileHeight() const;

    friend bool operator==(const Cutter& a, const Cutter& b) { return a.m_spec == b.m_spec; }

private:
    std::string m_spec;
    CutterProfile m_profile;
    std::vector<ProfilePiece> m_solvable;
    double m_radius = 0;
    ToolBody m_body;
    CuttingData m_data;
};

/// Makes a cutter from `SHAPE:key=value,…` according to the rows of shapes.h. Errors name the key and the
/// limits.
[[nodiscard]] Result<Cutter> parseCutter(std::string_view spec);

} // namespace proveout
