// SPDX-License-Identifier: GPL-3.0-or-later
// Compares a program with what LinuxCNC's stand-alone interpreter made of the same text.
#pragma once

#include <cstdint>
#include <string>

#include "core/nc/program/program.h"
#include "tests/core/nc/oracle_records.h"

namespace proveout::test {

struct OracleTolerances {
    double point = 1e-6;  ///< mm
    double centre = 1e-4; ///< mm, of an arc's centre, and of its end by its sweep
    bool spindle = true;  ///< whether its speed is compared: under G96 the oracle tells the surface speed
};

/// The first error of a program; null where there is none.
const Diagnostic* firstError(const Program& program);
/// Whether it tells that the control runs what follows otherwise than we do.
bool isUnlikeControl(const Diagnostic& diagnostic);
/// The first of either.
const Diagnostic* firstParting(const Program& program);

bool reportedOnLine(const Program& program, int line);

/// Which of both lists ends early, because of an error.
enum class Extent : std::uint8_t {
    whole,        ///< neither
    oracleBegins, ///< the oracle's is the beginning of ours
    oursBegins,   ///< ours is the beginning of the oracle's
};

/// Whether motions and events agree; else `why` says where they do not.
bool sameSteps(const OracleAnswer& answer, const Program& program, Extent extent,
               const OracleTolerances& tolerances, std::string& why);

} // namespace proveout::test
