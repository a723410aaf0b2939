// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/base/diagnostic.h"
#include "core/base/field.h"
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

    friend bool operator==(const Machine&, const Machine&) = default;
};

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
}

/// Reads a machine from `key=value,…`, with the keys of describe(); values that are not named stay unchanged.
/// Errors: an unknown key, not a number, out of range.
[[nodiscard]] Result<Machine> parseMachine(std::string_view text, Machine machine = {});

} // namespace proveout
