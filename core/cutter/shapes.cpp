// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/shapes.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include "core/base/text.h"

namespace proveout {

namespace {

constexpr double kLeastSize = 0.001;
constexpr double kLargestSize = 10000;

constexpr ShapeKey kDiameter{"d", PROVEOUT_TEXT("Core", "Diameter"), "mm", kLeastSize, kLargestSize, 10,
                             true};

constexpr std::array kDiameterOnly = {kDiameter};
constexpr std::array kBullKeys = {
    kDiameter,
    ShapeKey{"r", PROVEOUT_TEXT("Core", "Corner radius"), "mm", 0, kLargestSize, 1, true},
};
constexpr std::array kConeKeys = {
    kDiameter,
    ShapeKey{"angle", PROVEOUT_TEXT("Core", "Included angle"), "°", 1, 179, 90, true},
    ShapeKey{"tip", PROVEOUT_TEXT("Core", "Diameter of the flat tip"), "mm", 0, kLargestSize, 0, false},
};
constexpr std::array kDrillKeys = {
    kDiameter,
    ShapeKey{"angle", PROVEOUT_TEXT("Core", "Point angle"), "°", 1, 179, 118, true},
};

constexpr std::array kCommonKeys = {
    ShapeKey{"l", PROVEOUT_TEXT("Core", "Flute length"), "mm", kLeastSize, kLargestSize, 50, false},
    ShapeKey{"sd", PROVEOUT_TEXT("Core", "Shank diameter (0: as the cutter)"), "mm", 0, kLargestSize, 0,
             false},
    ShapeKey{"sl", PROVEOUT_TEXT("Core", "Shank length"), "mm", 0, kLargestSize, 30, false},
};

ProfilePiece flatTo(double radius) {
    ProfilePiece piece;
    piece.r1 = radius;
    return piece;
}

/// A quarter of a circle that leaves the tip plane at `from`.
ProfilePiece cornerFrom(double from, double cornerRadius) {
    ProfilePiece piece;
    piece.kind = PieceKind::arc;
    piece.r0 = from;
    piece.r1 = from + cornerRadius;
    piece.z1 = cornerRadius;
    piece.centreR = from;
    piece.centreZ = cornerRadius;
    piece.radius = cornerRadius;
    return piece;
}

Result<std::vector<ProfilePiece>> flatProfile(std::span<const double> values) {
    return std::vector{flatTo(values[0] / 2)};
}

Result<std::vector<ProfilePiece>> ballProfile(std::span<const double> values) {
    return std::vector{cornerFrom(0, values[0] / 2)};
}

Result<std::vector<ProfilePiece>> bullProfile(std::span<const double> values) {
    const double radius = values[0] / 2;
    const double corner = values[1];
    if (corner > radius)
        return failure(
            "corner-radius-too-large",
            PROVEOUT_TEXT("Core", "The corner radius r={} is larger than half the diameter, {} mm."),
            {fmt::format("{}", corner), fmt::format("{}", radius)});
    if (corner == 0)
        return std::vector{flatTo(radius)};
    if (corner == radius)
        return std::vector{cornerFrom(0, radius)};
    auto piece = cornerFrom(radius - corner, corner);
    piece.r1 = radius; // the sum may round to something else
    return std::vector{flatTo(radius - corner), piece};
}

Result<std::vector<ProfilePiece>> coneProfile(std::span<const double> values) {
    const double radius = values[0] / 2;
    const double tip = values[2] / 2;
    if (tip >= radius)
        return failure("tip-too-large",
                       PROVEOUT_TEXT("Core", "The flat tip tip={} is not smaller than the diameter, {} mm."),
                       {fmt::format("{}", values[2]), fmt::format("{}", values[0])});
    std::vector<ProfilePiece> pieces;
    if (tip > 0)
        pieces.push_back(flatTo(tip));
    ProfilePiece side;
    side.r0 = tip;
    side.r1 = radius;
    side.z1 = (radius - tip) / std::tan(glm::radians(values[1]) / 2);
    pieces.push_back(side);
    return pieces;
}

/// A drill cuts as a cone does; its chisel edge is left out.
Result<std::vector<ProfilePiece>> drillProfile(std::span<const double> values) {
    return coneProfile(std::array{values[0], values[1], 0.0});
}

constexpr std::array kShapes = {
    CutterShape{"flat", PROVEOUT_TEXT("Core", "Flat end mill"), kDiameterOnly, flatProfile},
    CutterShape{"ball", PROVEOUT_TEXT("Core", "Ball-end mill"), kDiameterOnly, ballProfile},
    CutterShape{"bull", PROVEOUT_TEXT("Core", "Bull-nose mill"), kBullKeys, bullProfile},
    CutterShape{"cone", PROVEOUT_TEXT("Core", "Cone or V cutter"), kConeKeys, coneProfile},
    CutterShape{"drill", PROVEOUT_TEXT("Core", "Drill"), kDrillKeys, drillProfile},
};

} // namespace

std::span<const CutterShape> cutterShapes() {
    return kShapes;
}

std::span<const ShapeKey> commonShapeKeys() {
    return kCommonKeys;
}

} // namespace proveout
