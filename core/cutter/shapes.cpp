// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/shapes.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/cutter/shape_profiles.h"

namespace proveout {

namespace {

constexpr double kLeastSize = 0.001;
constexpr double kLargestSize = 10000;

constexpr ShapeKey kDiameter{"d", PROVEOUT_TEXT("Core", "Diameter"), "mm", kLeastSize, kLargestSize, 10,
                             true};

constexpr ShapeKey kCornerRadius{"r",  PROVEOUT_TEXT("Core", "Corner radius"), "mm", 0, kLargestSize, 0,
                                 false};
constexpr ShapeKey kFlatTip{
    "tip", PROVEOUT_TEXT("Core", "Diameter of the flat tip"), "mm", 0, kLargestSize, 0, false};
constexpr ShapeKey kIncludedAngle{"angle", PROVEOUT_TEXT("Core", "Included angle"), "°", 1, 179, 90, true};
/// From the axis.
constexpr ShapeKey kSideAngle{"angle", PROVEOUT_TEXT("Core", "Angle of each side"), "°", 0.5, 89, 3, true};
constexpr ShapeKey kTaperHeight{
    "h", PROVEOUT_TEXT("Core", "Height of the taper"), "mm", kLeastSize, kLargestSize, 20, true};

/// The same key with another proposed value, which is also the value of an optional key that is omitted.
constexpr ShapeKey withDefault(ShapeKey key, double defaultValue) {
    key.defaultValue = defaultValue;
    return key;
}

constexpr ShapeKey required(ShapeKey key) {
    key.required = true;
    return key;
}

constexpr ShapeKey whole(ShapeKey key) {
    key.whole = true;
    return key;
}

/// A limit of the use of a tool.
constexpr ShapeKey limit(const char* key, const char* label, const char* unit) {
    return {key, label, unit, 0, 1e6, 0, false};
}

/// A diameter of one part of a cutter.
constexpr ShapeKey diameterOf(const char* key, const char* label, double defaultValue,
                              double minimum = kLeastSize) {
    return {key, label, "mm", minimum, kLargestSize, defaultValue, true};
}

constexpr std::array kDiameterOnly = {kDiameter};
constexpr std::array kBullKeys = {kDiameter, required(withDefault(kCornerRadius, 1))};
constexpr std::array kConeKeys = {kDiameter, kIncludedAngle, kFlatTip};
constexpr std::array kDrillKeys = {
    kDiameter,
    ShapeKey{"angle", PROVEOUT_TEXT("Core", "Point angle"), "°", 1, 179, 118, true},
};
constexpr std::array kTaperKeys = {
    diameterOf("d", PROVEOUT_TEXT("Core", "Diameter at the tip"), 6),
    kSideAngle,
    kTaperHeight,
    kCornerRadius,
};
constexpr std::array kTaperBallKeys = {
    diameterOf("d", PROVEOUT_TEXT("Core", "Diameter of the ball"), 4),
    kSideAngle,
    kTaperHeight,
};
constexpr std::array kChamferKeys = {kDiameter, kIncludedAngle, required(withDefault(kFlatTip, 2))};
constexpr std::array kSpotKeys = {kDiameter, withDefault(kDrillKeys[1], 90)};
constexpr std::array kCentreKeys = {
    kDiameter,
    diameterOf("pilot", PROVEOUT_TEXT("Core", "Diameter of the pilot"), 4),
    ShapeKey{"pl", PROVEOUT_TEXT("Core", "Length of the pilot with its point"), "mm", kLeastSize,
             kLargestSize, 5, true},
    ShapeKey{"angle", PROVEOUT_TEXT("Core", "Included angle"), "°", 1, 179, 60, false},
    ShapeKey{"point", PROVEOUT_TEXT("Core", "Point angle of the pilot"), "°", 1, 179, 118, false},
};
constexpr ShapeKey kLead{"lead", PROVEOUT_TEXT("Core", "Length of the lead"), "mm", 0, kLargestSize, 0.5,
                         false};
constexpr std::array kReamerKeys = {
    kDiameter,
    kLead,
    ShapeKey{"angle", PROVEOUT_TEXT("Core", "Angle of each side"), "°", 0.5, 89, 45, false},
};
constexpr std::array kTapKeys = {
    kDiameter,
    required(withDefault(kFlatTip, 7)),
    required(withDefault(kLead, 6)),
    ShapeKey{"pitch", PROVEOUT_TEXT("Core", "Pitch of the thread (0: unknown)"), "mm", 0, 100, 0, false},
};
constexpr std::array kThreadMillKeys = {kDiameter, kFlatTip, withDefault(kLead, 0)};
constexpr std::array kFaceKeys = {
    withDefault(kDiameter, 50),
    ShapeKey{"angle", PROVEOUT_TEXT("Core", "Approach angle of the edge"), "°", 10, 90, 45, true},
    ShapeKey{"h", PROVEOUT_TEXT("Core", "Height of the edge"), "mm", kLeastSize, kLargestSize, 6, true},
    withDefault(kCornerRadius, 0.8),
};
constexpr std::array kFormKeys = {
    ShapeKey{"p", PROVEOUT_TEXT("Core", "Profile, RADIUS/HEIGHT:… from the tip outwards"), "", 0, 0, 0, true,
             "0/0:3/0:4/1@3/1:6/3@-2:6/8"},
};
constexpr ShapeKey kNeck = diameterOf("neck", PROVEOUT_TEXT("Core", "Diameter of the neck"), 6);
constexpr std::array kLollipopKeys = {
    diameterOf("d", PROVEOUT_TEXT("Core", "Diameter of the ball"), 10),
    kNeck,
};
constexpr std::array kSlotKeys = {
    withDefault(kDiameter, 20),
    ShapeKey{"w", PROVEOUT_TEXT("Core", "Width of the head"), "mm", kLeastSize, kLargestSize, 6, true},
    withDefault(kNeck, 9),
    kCornerRadius,
};
constexpr std::array kDovetailKeys = {
    withDefault(kDiameter, 20),
    ShapeKey{"angle", PROVEOUT_TEXT("Core", "Angle between face and flank"), "°", 10, 89, 60, true},
    ShapeKey{"h", PROVEOUT_TEXT("Core", "Height of the head"), "mm", kLeastSize, kLargestSize, 6, true},
    ShapeKey{"neck", PROVEOUT_TEXT("Core", "Diameter of the neck (0: as the head's top)"), "mm", 0,
             kLargestSize, 0, false},
    kCornerRadius,
};

constexpr std::string_view kCentreKey = "centre";

constexpr std::array kCommonKeys = {
    ShapeKey{"l", PROVEOUT_TEXT("Core", "Flute length"), "mm", kLeastSize, kLargestSize, 50, false},
    ShapeKey{"sd", PROVEOUT_TEXT("Core", "Shank diameter (0: as the cutter)"), "mm", 0, kLargestSize, 0,
             false},
    ShapeKey{"sl", PROVEOUT_TEXT("Core", "Shank length"), "mm", 0, kLargestSize, 30, false},
    ShapeKey{"so", PROVEOUT_TEXT("Core", "Stick-out, from tip to holder (0: unknown)"), "mm", 0, kLargestSize,
             0, false},
    ShapeKey{"holder", PROVEOUT_TEXT("Core", "Holder, DIAMETERxHEIGHT+… from its face upwards"), "", 0, 0, 0,
             false, "", "40x30+40-60x15"},
    whole({"z", PROVEOUT_TEXT("Core", "Teeth (0: unknown)"), "", 0, 1000, 0, false}),
    whole({"centre", PROVEOUT_TEXT("Core", "Centre-cutting (1: yes, 0: no)"), "", 0, 1, 1, false}),
    ShapeKey{"ramp", PROVEOUT_TEXT("Core", "Steepest ramp into material"), "°", 0, 90, 90, false},
    limit("maxap", PROVEOUT_TEXT("Core", "Maximum axial depth (0: any)"), "mm"),
    limit("maxae", PROVEOUT_TEXT("Core", "Maximum engagement (0: any)"), "mm"),
    limit("maxchip", PROVEOUT_TEXT("Core", "Maximum chip thickness (0: any)"), "mm"),
    limit("maxrpm", PROVEOUT_TEXT("Core", "Maximum spindle speed (0: any)"), "rpm"),
    limit("maxfeed", PROVEOUT_TEXT("Core", "Maximum feed in a cut (0: any)"), "mm/min"),
    limit("maxvc", PROVEOUT_TEXT("Core", "Maximum surface speed (0: any)"), "m/min"),
    limit("maxmrr", PROVEOUT_TEXT("Core", "Maximum removal rate (0: any)"), "cm³/min"),
};

constexpr bool kNotCentreCutting = false;

constexpr std::array kShapes = {
    CutterShape{"flat", PROVEOUT_TEXT("Core", "Flat end mill"), kDiameterOnly, flatProfile},
    CutterShape{"ball", PROVEOUT_TEXT("Core", "Ball-end mill"), kDiameterOnly, ballProfile},
    CutterShape{"bull", PROVEOUT_TEXT("Core", "Bull-nose mill"), kBullKeys, bullProfile},
    CutterShape{"cone", PROVEOUT_TEXT("Core", "Cone or V cutter"), kConeKeys, coneProfile},
    CutterShape{"drill", PROVEOUT_TEXT("Core", "Drill"), kDrillKeys, drillProfile},
    CutterShape{"taper", PROVEOUT_TEXT("Core", "Tapered end mill"), kTaperKeys, taperProfile},
    CutterShape{"taperball", PROVEOUT_TEXT("Core", "Tapered ball-end mill"), kTaperBallKeys,
                taperBallProfile},
    CutterShape{"chamfer", PROVEOUT_TEXT("Core", "Chamfer mill"), kChamferKeys, coneProfile},
    CutterShape{"face", PROVEOUT_TEXT("Core", "Face mill"), kFaceKeys, faceProfile, kNotCentreCutting},
    CutterShape{"spot", PROVEOUT_TEXT("Core", "Spot drill"), kSpotKeys, drillProfile},
    CutterShape{"centre", PROVEOUT_TEXT("Core", "Centre drill"), kCentreKeys, centreProfile},
    CutterShape{"reamer", PROVEOUT_TEXT("Core", "Reamer"), kReamerKeys, reamerProfile, kNotCentreCutting},
    CutterShape{"tap", PROVEOUT_TEXT("Core", "Tap"), kTapKeys, threadProfile, kNotCentreCutting},
    CutterShape{"threadmill", PROVEOUT_TEXT("Core", "Thread mill"), kThreadMillKeys, threadProfile,
                kNotCentreCutting},
    CutterShape{"lollipop", PROVEOUT_TEXT("Core", "Lollipop cutter"), kLollipopKeys, lollipopProfile},
    CutterShape{"tslot", PROVEOUT_TEXT("Core", "T-slot or keyseat cutter"), kSlotKeys, slotProfile,
                kNotCentreCutting},
    CutterShape{"dovetail", PROVEOUT_TEXT("Core", "Dovetail cutter"), kDovetailKeys, dovetailProfile,
                kNotCentreCutting},
    CutterShape{"form", PROVEOUT_TEXT("Core", "Form cutter"), kFormKeys, formProfile},
};

} // namespace

std::span<const CutterShape> cutterShapes() {
    return kShapes;
}

const CutterShape* shapeOf(std::string_view spec) {
    const std::string_view key = spec.substr(0, spec.find(':'));
    const auto* const row =
        std::ranges::find_if(kShapes, [&](const CutterShape& shape) { return key == shape.key; });
    return row == kShapes.end() ? nullptr : row;
}

std::span<const ShapeKey> commonShapeKeys() {
    return kCommonKeys;
}

std::vector<ShapeKey> keysOf(const CutterShape& shape) {
    std::vector<ShapeKey> keys(shape.keys.begin(), shape.keys.end());
    keys.insert(keys.end(), kCommonKeys.begin(), kCommonKeys.end());
    for (ShapeKey& key : keys)
        if (std::string_view(key.key) == kCentreKey)
            key.defaultValue = shape.centreCutting ? 1 : 0;
    return keys;
}

const char* labelOfDefault(std::string_view spec, std::string_view key) {
    if (key == "shape")
        return PROVEOUT_TEXT("Core", "Shape");
    const CutterShape* shape = shapeOf(spec);
    const std::span<const ShapeKey> own = shape == nullptr ? std::span<const ShapeKey>() : shape->keys;
    for (const std::span<const ShapeKey> keys : {own, commonShapeKeys()})
        for (const ShapeKey& row : keys)
            if (key == row.key)
                return row.label;
    return nullptr;
}

} // namespace proveout
