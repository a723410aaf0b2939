// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/base/diagnostic.h"
#include "core/base/field.h"
#include "core/base/text.h"

namespace proveout {

/// How fast the machine is that runs the program. The defaults are those of no machine in particular: a
/// vertical machining centre of middle size. Value type; mm, seconds.
struct Machine {
    double rapidXY = 20000; ///< mm/min, of X and of Y alone: a slanted rapid is faster than each
    double rapidZ = 15000;
    double largestFeed = 10000;   ///< mm/min along the path
    double accelerationXY = 2000; ///< mm/s², of X and of Y alone
    double accelerationZ = 1500;
    double cornerDeviation = 0.02; ///< mm that a corner may be rounded by; 0: stop at each corner
    double toolChangeSeconds = 6;  ///< from chip to chip

    friend bool operator==(const Machine&, const Machine&) = default;
};

/// Names every field once; see field.h.
template<class Params, class Visitor>
void describe(Params& machine, Visitor&& visit) requires requires {
    machine.toolChangeSeconds;
}
{
    visit(machine.rapidXY, Field{"rapidXY", PROVEOUT_TEXT("Core", "Rapid traverse X/Y"), "mm/min",
                                 PROVEOUT_TEXT("Core", "Speed of X and of Y at rapid."), 1, 1e6, 500});
    visit(machine.rapidZ, Field{"rapidZ", PROVEOUT_TEXT("Core", "Rapid traverse Z"), "mm/min",
                                PROVEOUT_TEXT("Core", "Speed of Z at rapid."), 1, 1e6, 500});
    visit(machine.largestFeed,
          Field{"largestFeed", PROVEOUT_TEXT("Core", "Maximum feed rate"), "mm/min",
                PROVEOUT_TEXT("Core", "The machine limits the feed rate to this, whatever F says."), 1, 1e6,
                500});
    visit(machine.accelerationXY, Field{"accelerationXY", PROVEOUT_TEXT("Core", "Acceleration X, Y"), "mm/s²",
                                        PROVEOUT_TEXT("Core", "Acceleration of X and of Y."), 1, 1e6, 100});
    visit(machine.accelerationZ, Field{"accelerationZ", PROVEOUT_TEXT("Core", "Acceleration Z"), "mm/s²",
                                       PROVEOUT_TEXT("Core", "Acceleration of Z."), 1, 1e6, 100});
    visit(machine.cornerDeviation,
          Field{"cornerDeviation", PROVEOUT_TEXT("Core", "Cornering tolerance"), "mm",
                PROVEOUT_TEXT("Core", "Largest deviation of a rounded corner; 0: exact stop at each corner."),
                0, 10, 0.01});
    visit(machine.toolChangeSeconds,
          Field{"toolChange", PROVEOUT_TEXT("Core", "Tool change"), "s",
                PROVEOUT_TEXT("Core", "Tool change time, chip to chip."), 0, 3600, 0.5});
}

/// The machine as `key=value,…` says, with the keys of describe(); what is not named stays. Errors: a key
/// that there is none of, no number, out of range.
[[nodiscard]] Result<Machine> parseMachine(std::string_view text, Machine machine = {});

} // namespace proveout
