// SPDX-License-Identifier: GPL-3.0-or-later
// Compares a program with the result of LinuxCNC's stand-alone interpreter for the same text.
#pragma once

#include <cstdint>
#include <string>

#include "core/nc/program/program.h"
#include "tests/core/nc/oracle_records.h"

namespace proveout::test {

struct OracleTolerances {
    double point = 1e-6;  ///< mm
    double centre = 1e-4; ///< mm, for an arc's centre, and for its end computed from the sweep
    bool spindle = true;  ///< whether the speed is compared: under G96 the oracle reports the surface speed
};

/// The first error of a program; null if there is none.
const Diagnostic* firstError(const Program& program);
/// Whether the message means that the control continues differently from here on.
bool isUnlikeControl(const Diagnostic& diagnostic);
/// The first message of either kind.
const Diagnostic* firstParting(const Program& program);

bool reportedOnLine(const Program& program, int line);

/// Which of the two lists ends early because of an error.
enum class Extent : std::uint8_t {
    whole,        ///< neither of them
    oracleBegins, ///< the oracle's list is the beginning of ours
    oursBegins,   ///< our list is the beginning of the oracle's
};

/// Whether motions and events agree; otherwise `why` describes the difference.
bool sameSteps(const OracleAnswer& answer, const Program& program, Extent extent,
               const OracleTolerances& tolerances, std::string& why);

} // namespace proveout::test
