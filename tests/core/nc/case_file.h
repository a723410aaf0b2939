// SPDX-License-Identifier: GPL-3.0-or-later
// Cases of a dialect, one per file: a program, and what its control does by a rule of its manual.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/nc/run/interpreter.h"

namespace proveout::test {

/// A case: a heading of "# key: value" lines, the program, a line "=>", and the expected steps.
///
/// Keys: rule (required: the rule and its source), dialect (required), start ("x y z", or "unknown"; by
/// default 0 0 0, which is also machine zero), tools ("1 d6 l50, 2 d10": diameters and lengths), delete
/// ("yes": blocks that begin with "/" are skipped), start-up ("B": of cutter compensation), lint ("yes": its
/// messages are among the steps).
///
/// Steps, each with the line of the program that it comes from:
///   4 rapid 10 0 5             to X Y Z, mm
///   4 feed 10 0 5 F100         mm/min; without F if there is no feed rate
///   4 arc 10 0 5 c 5 0 180 F100   centre in its plane, sweep in degrees, counter-clockwise positive
///   4 dwell 1.5                seconds
///   4 tool 3
///   4 length 0 0 50            the active tool length offset
///   4 offset 1 10 0 0          work offset system and its zero in machine coordinates
///   4 stop | optional-stop | end
///   4 flood on | mist off | inch | mm
///   ! 4:7 word-twice           a warning or an error, line and column
struct CaseFile {
    std::string rule;
    InterpretOptions options;
    std::string program;
    std::vector<std::string> steps;
};

/// Throws std::runtime_error with the reason if the file is not a valid case.
CaseFile readCase(const std::filesystem::path& file);

/// The steps of a program in the format of the case files, with messages after the motions and events.
std::vector<std::string> stepsOf(const Program& program);

/// Whether two steps are equal, with a tolerance of 1e-6 for numbers.
bool sameStep(const std::string& expected, const std::string& actual);

} // namespace proveout::test
