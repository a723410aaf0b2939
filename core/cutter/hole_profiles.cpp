// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include "core/base/figures_argument.h"
#include "core/cutter/cutter_findings.h"
#include "core/cutter/shape_profiles.h"

namespace proveout {

namespace {

/// Height of a cone with this included angle over `radius`.
double coneHeight(double radius, double angle) {
    return radius / std::tan(glm::radians(angle) / 2);
}

tl::unexpected<Diagnostics> tipTooLarge(double tip, double diameter) {
    return failure(cutter_finding::kTipTooLarge, {fmt::format("{}", tip), figures("{}", diameter)});
}

/// A flat tip, if it has a radius, and a side from there to (radius, height).
CutterProfile pointed(double tip, double radius, double height) {
    CutterProfile profile;
    if (tip > 0)
        profile.pieces.push_back(ringBetween(0, tip));
    profile.pieces.push_back(sideBetween(tip, 0, radius, height));
    return profile;
}

} // namespace

/// d, angle, tip
Result<CutterProfile> coneProfile(const ShapeValues& values) {
    const double radius = values[0] / 2;
    const double tip = values[2] / 2;
    if (tip >= radius)
        return tipTooLarge(values[2], values[0]);
    return pointed(tip, radius, coneHeight(radius - tip, values[1]));
}

/// d, angle. A drill cuts as a cone does; its chisel edge is ignored.
Result<CutterProfile> drillProfile(const ShapeValues& values) {
    return pointed(0, values[0] / 2, coneHeight(values[0] / 2, values[1]));
}

/// d, pilot, pl, angle, point
Result<CutterProfile> centreProfile(const ShapeValues& values) {
    const double radius = values[0] / 2;
    const double pilot = values[1] / 2;
    const double length = values[2];
    if (pilot >= radius)
        return failure(cutter_finding::kPilotTooLarge,
                       {fmt::format("{}", values[1]), figures("{}", values[0])});
    CutterProfile profile = pointed(0, pilot, coneHeight(pilot, values[4]));
    if (const double point = profile.pieces.back().z1; length < point)
        return failure(cutter_finding::kPilotTooShort, {fmt::format("{}", length), figures("{:.4g}", point)});
    profile.pieces.push_back(
        sideBetween(pilot, length, radius, length + coneHeight(radius - pilot, values[3])));
    return profile;
}

/// d, lead, angle
Result<CutterProfile> reamerProfile(const ShapeValues& values) {
    const double radius = values[0] / 2;
    const double lead = values[1];
    if (lead == 0)
        return CutterProfile{{ringBetween(0, radius)}, {}};
    const double slope = std::tan(glm::radians(values[2]));
    const double tip = radius - lead * slope;
    if (tip < 0)
        return failure(cutter_finding::kLeadTooLong,
                       {fmt::format("{}", lead), figures("{:.4g}", radius / slope)});
    return pointed(tip, radius, lead);
}

/// d, tip, lead
Result<CutterProfile> threadProfile(const ShapeValues& values) {
    if (values[2] == 0)
        return CutterProfile{{ringBetween(0, values[0] / 2)}, {}};
    if (values[1] >= values[0])
        return tipTooLarge(values[1], values[0]);
    return pointed(values[1] / 2, values[0] / 2, values[2]);
}

} // namespace proveout
