// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <utility>

#include "core/base/diagnostic.h"
#include "core/base/field.h"
#include "core/base/geometry.h"
#include "core/base/text.h"

namespace proveout {

/// The speed of the machine that runs the program. The defaults describe a typical vertical machining centre
/// of middle size. Value type; mm, seconds.
struct Machine {
    double rapidXY = 20000; ///< mm/min, of X and of Y separately: a slanted rapid is faster than each
    double rapidZ = 15000;
    double largestFeed = 10000;   ///< mm/min along the path
    double largestSpindle = 0;    ///< rpm; 0: unknown
    double accelerationXY = 2000; ///< mm/s², of X and of Y separately
    double accelerationZ = 1500;
    double cornerDeviation = 0.02; ///< mm by which a corner may be rounded; 0: stop at each corner
    double toolChangeSeconds = 6;  ///< chip to chip
    // Travel in machine coordinates, mm; the same limit twice: unknown.
    double minX = 0;
    double maxX = 0;
    double minY = 0;
    double maxY = 0;
    double minZ = 0; ///< of the face of the spindle
    double maxZ = 0;
    // Machine coordinates of the program's zero, Z with the face of the spindle there; all 0: unknown.
    double offsetX = 0;
    double offsetY = 0;
    double offsetZ = 0;
    // Where tools are changed, in machine coordinates, Z of the face of the spindle; kNowhere: anywhere.
    static constexpr double kNowhere = -1e6;
    double changeX = kNowhere;
    double changeY = kNowhere;
    double changeZ = kNowhere;

    /// The travel of an axis, 0 to 2; nothing if it is unknown.
    [[nodiscard]] std::optional<std::pair<double, double>> travel(int axis) const;
    /// Where the program's zero is; nothing if it is unknown.
    [[nodiscard]] std::optional<Vec3> programZero() const;
    /// Where an axis, 0 to 2, must be for a tool change; nothing if it may be anywhere.
    [[nodiscard]] std::optional<double> toolChange(int axis) const;

    friend bool operator==(const Machine&, const Machine&) = default;
};

namespace machine_field {

constexpr Field position(const char* key, const char* label, const char* help) {
    return {
        .key = key, .label = label, .unit = "mm", .help = help, .minimum = -1e6, .maximum = 1e6, .step = 10};
}

} // namespace machine_field

/// Visits every field once; see field.h.
template<ParametersOf<Machine> Params, class Visitor>
void describe(Params& machine, Visitor&& visit) {
    visit(machine.rapidXY, Field{.key = "rapidXY",
                                 .label = PROVEOUT_TEXT("Core", "Rapid traverse X/Y"),
                                 .unit = "mm/min",
                                 .help = PROVEOUT_TEXT("Core", "Speed of X and of Y at rapid."),
                                 .minimum = 1,
                                 .maximum = 1e6,
                                 .step = 500,
                                 .decimals = 0});
    visit(machine.rapidZ, Field{.key = "rapidZ",
                                .label = PROVEOUT_TEXT("Core", "Rapid traverse Z"),
                                .unit = "mm/min",
                                .help = PROVEOUT_TEXT("Core", "Speed of Z at rapid."),
                                .minimum = 1,
                                .maximum = 1e6,
                                .step = 500,
                                .decimals = 0});
    visit(machine.largestFeed,
          Field{.key = "largestFeed",
                .label = PROVEOUT_TEXT("Core", "Maximum feed rate"),
                .unit = "mm/min",
                .help = PROVEOUT_TEXT("Core", "The machine limits the feed rate to this, whatever F says."),
                .minimum = 1,
                .maximum = 1e6,
                .step = 500,
                .decimals = 0});
    visit(machine.largestSpindle,
          Field{.key = "largestSpindle",
                .label = PROVEOUT_TEXT("Core", "Maximum spindle speed"),
                .unit = PROVEOUT_TEXT("Core", "rpm"),
                .help = PROVEOUT_TEXT(
                    "Core", "Programs are checked for higher spindle speeds; 0: unknown, not checked."),
                .minimum = 0,
                .maximum = 1e6,
                .step = 500,
                .decimals = 0});
    visit(machine.accelerationXY, Field{.key = "accelerationXY",
                                        .label = PROVEOUT_TEXT("Core", "Acceleration X, Y"),
                                        .unit = "mm/s²",
                                        .help = PROVEOUT_TEXT("Core", "Acceleration of X and of Y."),
                                        .minimum = 1,
                                        .maximum = 1e6,
                                        .step = 100,
                                        .decimals = 0});
    visit(machine.accelerationZ, Field{.key = "accelerationZ",
                                       .label = PROVEOUT_TEXT("Core", "Acceleration Z"),
                                       .unit = "mm/s²",
                                       .help = PROVEOUT_TEXT("Core", "Acceleration of Z."),
                                       .minimum = 1,
                                       .maximum = 1e6,
                                       .step = 100,
                                       .decimals = 0});
    visit(machine.cornerDeviation,
          Field{.key = "cornerDeviation",
                .label = PROVEOUT_TEXT("Core", "Cornering tolerance"),
                .unit = "mm",
                .help = PROVEOUT_TEXT("Core",
                                      "Largest deviation of a rounded corner; 0: exact stop at each corner."),
                .minimum = 0,
                .maximum = 10,
                .step = 0.01});
    visit(machine.toolChangeSeconds, Field{.key = "toolChange",
                                           .label = PROVEOUT_TEXT("Core", "Tool change time"),
                                           .unit = "s",
                                           .help = PROVEOUT_TEXT("Core", "Tool change time, chip to chip."),
                                           .minimum = 0,
                                           .maximum = 3600,
                                           .step = 0.5});
    visit(machine.minX,
          machine_field::position(
              "minX", PROVEOUT_TEXT("Core", "Travel X from"),
              PROVEOUT_TEXT(
                  "Core", "Least machine coordinate of X; the same as the greatest: unknown, not checked.")));
    visit(machine.maxX, machine_field::position("maxX", PROVEOUT_TEXT("Core", "Travel X to"),
                                                PROVEOUT_TEXT("Core", "Greatest machine coordinate of X.")));
    visit(machine.minY,
          machine_field::position(
              "minY", PROVEOUT_TEXT("Core", "Travel Y from"),
              PROVEOUT_TEXT(
                  "Core", "Least machine coordinate of Y; the same as the greatest: unknown, not checked.")));
    visit(machine.maxY, machine_field::position("maxY", PROVEOUT_TEXT("Core", "Travel Y to"),
                                                PROVEOUT_TEXT("Core", "Greatest machine coordinate of Y.")));
    visit(machine.minZ,
          machine_field::position(
              "minZ", PROVEOUT_TEXT("Core", "Travel Z from"),
              PROVEOUT_TEXT(
                  "Core", "Least machine coordinate of Z; the same as the greatest: unknown, not checked.")));
    visit(machine.maxZ, machine_field::position("maxZ", PROVEOUT_TEXT("Core", "Travel Z to"),
                                                PROVEOUT_TEXT("Core", "Greatest machine coordinate of Z.")));
    visit(machine.offsetX,
          machine_field::position("offsetX", PROVEOUT_TEXT("Core", "Part zero X"),
                                  PROVEOUT_TEXT("Core", "Machine coordinate X of X0 in the program, as in "
                                                        "G54 of the control; all three 0: unknown.")));
    visit(machine.offsetY,
          machine_field::position(
              "offsetY", PROVEOUT_TEXT("Core", "Part zero Y"),
              PROVEOUT_TEXT("Core", "Machine coordinate Y of Y0 in the program, as in G54 of the control.")));
    visit(machine.offsetZ,
          machine_field::position(
              "offsetZ", PROVEOUT_TEXT("Core", "Part zero Z"),
              PROVEOUT_TEXT("Core",
                            "Machine coordinate Z with the face of the spindle at Z0 of the program.")));
    visit(machine.changeX,
          machine_field::position(
              "changeX", PROVEOUT_TEXT("Core", "Tool change X"),
              PROVEOUT_TEXT("Core", "Machine coordinate X that M6 needs; -1000000: any. Leave it if M6 "
                                    "itself moves there.")));
    visit(machine.changeY, machine_field::position("changeY", PROVEOUT_TEXT("Core", "Tool change Y"),
                                                   PROVEOUT_TEXT("Core", "The same for Y.")));
    visit(machine.changeZ, machine_field::position(
                               "changeZ", PROVEOUT_TEXT("Core", "Tool change Z"),
                               PROVEOUT_TEXT("Core", "The same for Z, with the face of the spindle there.")));
}

/// Reads a machine from `PROFILE,key=value,…`, with the key of a profile (machine_profiles.h), which may be
/// missing, and the keys of describe(); values that are not named stay unchanged. Errors: an unknown profile
/// or key, not a number, out of range.
[[nodiscard]] Result<Machine> parseMachine(std::string_view text, Machine machine = {});

} // namespace proveout
