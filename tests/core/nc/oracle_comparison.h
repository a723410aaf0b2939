// SPDX-License-Identifier: GPL-3.0-or-later
// Compares a program with what LinuxCNC's stand-alone interpreter made of the same text.
#pragma once

#include <string>

#include "core/nc/program.h"
#include "tests/core/nc/oracle_records.h"

namespace proveout::test {

struct OracleTolerances {
    double point = 1e-6;  ///< mm
    double centre = 1e-4; ///< mm, of an arc's centre, and of its end by its sweep
    bool spindle = true;  ///< whether its speed is compared: under G96 the oracle tells the surface speed
};

/// The first error of a program; null where there is none.
const Diagnostic* firstError(const Program& program);

bool toldOnLine(const Program& program, int line);

/// Whether motions and events agree; else `why` says where they do not. `beginning`: the oracle's records are
/// only those before an error.
bool sameSteps(const OracleAnswer& answer, const Program& program, bool beginning,
               const OracleTolerances& tolerances, std::string& why);

} // namespace proveout::test
