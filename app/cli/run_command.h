// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/base/finding_row.h"

namespace proveout::cli {

/// Reads the arguments and runs the command that they name; `exitCode` is what its commands set. Help goes to
/// stdout; what cannot be read is told in one sentence, with how the command is used.
[[nodiscard]] ExitCode runCommand(CLI::App& app, const ExitCode& exitCode, int argc, char** argv);

/// Prints a finding about how `program` was called, or what became of it, to stderr.
void printFinding(const std::string& program, const FindingRow& row, std::vector<Argument> arguments = {});

} // namespace proveout::cli
