// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/base/finding_row.h"

namespace proveout::cli {

/// Reads the arguments and runs the given command; `exitCode` is set by its commands. Help is printed on
/// stdout; an invalid argument is reported in one sentence, followed by the usage of the command.
[[nodiscard]] ExitCode runCommand(CLI::App& app, const ExitCode& exitCode, int argc, char** argv);

/// Prints a finding about how `program` was called, or about its failure, to stderr.
void printFinding(const std::string& program, const FindingRow& row, std::vector<Argument> arguments = {});

} // namespace proveout::cli
