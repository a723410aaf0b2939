// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include "core/base/figures_argument.h"
#include "core/cutter/cutter_findings.h"
#include "core/cutter/shape_profiles.h"

namespace proveout {

namespace {

Result<CutterProfile> roundedFlat(double radius, double corner) {
    if (corner > radius)
        return failure(cutter_finding::kCornerRadiusTooLarge,
                       {fmt::format("{}", corner), figures("{}", radius)});
    if (corner == 0)
        return CutterProfile{{ringBetween(0, radius)}, {}};
    if (corner == radius)
        return CutterProfile{{cornerFrom(0, radius)}, {}};
    auto piece = cornerFrom(radius - corner, corner);
    piece.r1 = radius; // the sum may round to something else
    return CutterProfile{{ringBetween(0, radius - corner), piece}, {}};
}

tl::unexpected<Diagnostics> lowerThanItsTip(double height, double least) {
    return failure(cutter_finding::kTaperTooLow, {fmt::format("{}", height), figures("{:.4g}", least)});
}

/// A side that leans outwards by `lean` (radians, from the axis), through (radius, 0), up to `height`; its
/// corner with the tip plane is rounded.
Result<CutterProfile> leaningSide(double radius, double lean, double height, double corner) {
    const double lost = (1 - std::sin(lean)) / std::cos(lean); // of the tip's radius, per mm of the corner's
    const double ring = radius - corner * lost;
    if (ring < 0)
        return cornerTooLarge(corner, radius / lost);
    const double from = corner * (1 - std::sin(lean));
    if (from >= height)
        return lowerThanItsTip(height, from);
    CutterProfile profile;
    if (ring > 0)
        profile.pieces.push_back(ringBetween(0, ring));
    if (corner > 0) {
        ProfilePiece arc = cornerFrom(ring, corner);
        arc.r1 = ring + corner * std::cos(lean);
        arc.z1 = from;
        profile.pieces.push_back(arc);
    }
    const double begin = profile.pieces.back().r1;
    profile.pieces.push_back(sideBetween(begin, from, radius + height * std::tan(lean), height));
    return profile;
}

} // namespace

Result<CutterProfile> flatProfile(const ShapeValues& values) {
    return CutterProfile{{ringBetween(0, values[0] / 2)}, {}};
}

Result<CutterProfile> ballProfile(const ShapeValues& values) {
    return CutterProfile{{cornerFrom(0, values[0] / 2)}, {}};
}

Result<CutterProfile> bullProfile(const ShapeValues& values) {
    return roundedFlat(values[0] / 2, values[1]);
}

/// d, angle, h, r
Result<CutterProfile> taperProfile(const ShapeValues& values) {
    return leaningSide(values[0] / 2, glm::radians(values[1]), values[2], values[3]);
}

/// d, angle, h
Result<CutterProfile> taperBallProfile(const ShapeValues& values) {
    const double ball = values[0] / 2;
    const double lean = glm::radians(values[1]);
    const double from = ball * (1 - std::sin(lean));
    if (from >= values[2])
        return lowerThanItsTip(values[2], from);
    ProfilePiece tip = cornerFrom(0, ball);
    tip.r1 = ball * std::cos(lean);
    tip.z1 = from;
    return CutterProfile{
        {tip, sideBetween(tip.r1, from, tip.r1 + (values[2] - from) * std::tan(lean), values[2])}, {}};
}

/// d, angle, h, r
Result<CutterProfile> faceProfile(const ShapeValues& values) {
    constexpr double kUpright = 90;
    if (values[1] == kUpright)
        return roundedFlat(values[0] / 2, values[3]);
    return leaningSide(values[0] / 2, glm::radians(kUpright - values[1]), values[2], values[3]);
}

} // namespace proveout
