// SPDX-License-Identifier: GPL-3.0-or-later
// Where the design part of a job is, and what is allowed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/diagnostic.h"
#include "core/base/field.h"
#include "core/base/text.h"

namespace proveout {

/// How far a stock may be from its part, normal to it, mm. Value type.
struct PartTolerance {
    double below = 0.1;   ///< so much may be missing
    double above = 0.1;   ///< so much may be left
    double allowance = 0; ///< stock that is to be left on the part; deviations count from there

    friend bool operator==(const PartTolerance&, const PartTolerance&) = default;
};

/// The mesh of the file is scaled, then turned about its own Z axis, and its zero is placed at x, y, z
/// (program coordinates). Value type.
struct PartSpec {
    std::filesystem::path file;
    double x = 0; ///< mm
    double y = 0;
    double z = 0;
    double turn = 0;  ///< degrees, counter-clockwise seen from above
    double scale = 1; ///< mm per unit of the file
    PartTolerance tolerance = {};

    friend bool operator==(const PartSpec&, const PartSpec&) = default;
};

namespace part_field {

inline constexpr double kFarthest = 1e6; ///< mm, of a position
inline constexpr double kWidest = 100;   ///< mm, of a tolerance

constexpr Field position(const char* key, const char* label) {
    return {.key = key,
            .label = label,
            .unit = "mm",
            .help = PROVEOUT_TEXT("Core", "Program coordinate of the zero of the part's file."),
            .minimum = -kFarthest,
            .maximum = kFarthest,
            .step = 1};
}
inline constexpr Field kTurn{.key = "turn",
                             .label = PROVEOUT_TEXT("Core", "Turned"),
                             .unit = "°",
                             .help = PROVEOUT_TEXT("Core", "About its Z axis, counter-clockwise from above."),
                             .minimum = -360,
                             .maximum = 360,
                             .step = 90};
inline constexpr Field kScale{
    .key = "scale",
    .label = PROVEOUT_TEXT("Core", "Scale"),
    .unit = "",
    .help = PROVEOUT_TEXT("Core", "Millimetres in a unit of the file: 1, or 25.4 for inches."),
    .minimum = 1e-3,
    .maximum = 1e3,
    .step = 1,
    .decimals = 4};
inline constexpr Field kBelow{
    .key = "below",
    .label = PROVEOUT_TEXT("Core", "May be missing"),
    .unit = "mm",
    .help = PROVEOUT_TEXT("Core", "Tolerance into the part, normal to its surface; more is a gouge."),
    .minimum = 0,
    .maximum = kWidest,
    .step = 0.01};
inline constexpr Field kAbove{
    .key = "above",
    .label = PROVEOUT_TEXT("Core", "May be left"),
    .unit = "mm",
    .help = PROVEOUT_TEXT("Core", "Tolerance outside of the part, normal to its surface; more is excess."),
    .minimum = 0,
    .maximum = kWidest,
    .step = 0.01};
inline constexpr Field kAllowance{
    .key = "allowance",
    .label = PROVEOUT_TEXT("Core", "Stock allowance"),
    .unit = "mm",
    .help = PROVEOUT_TEXT(
        "Core",
        "Stock that the program is to leave on the part, as for finishing; deviations count from it."),
    .minimum = -kWidest,
    .maximum = kWidest,
    .step = 0.1};

} // namespace part_field

/// Visits every field once; see field.h.
template<ParametersOf<PartTolerance> Params, class Visitor>
void describe(Params& tolerance, Visitor&& visit) {
    visit(tolerance.below, part_field::kBelow);
    visit(tolerance.above, part_field::kAbove);
    visit(tolerance.allowance, part_field::kAllowance);
}
template<ParametersOf<PartSpec> Params, class Visitor>
void describe(Params& part, Visitor&& visit) {
    describe(part.tolerance, visit);
    visit(part.x, part_field::position("x", PROVEOUT_TEXT("Core", "Zero X")));
    visit(part.y, part_field::position("y", PROVEOUT_TEXT("Core", "Zero Y")));
    visit(part.z, part_field::position("z", PROVEOUT_TEXT("Core", "Zero Z")));
    visit(part.turn, part_field::kTurn);
    visit(part.scale, part_field::kScale);
}

/// Reads the name of a file, or "x=…,y=…,z=…,turn=…,scale=…,below=…,above=…,allowance=…,file=…", where each
/// value but the file may be missing; the file is last, because its name may contain commas. It is not read.
/// Values that are not named stay those of `before`. Errors: an unknown key, a value that is invalid.
[[nodiscard]] Result<PartSpec> parsePart(std::string_view text, const PartSpec& before = {});

/// Reads "A" or "A,B" of the command line: how much may be missing, and left (the same if it is not given).
[[nodiscard]] Result<PartTolerance> parseTolerance(std::string_view text, const PartTolerance& before = {});

} // namespace proveout
