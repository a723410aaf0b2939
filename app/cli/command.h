// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace proveout::cli {

/// The exit codes of the command line, which are part of its interface. 3 takes precedence over 1, 1 over 2,
/// and 2 over 0.
enum class ExitCode : int {
    done = 0,       ///< nothing was found
    faults = 1,     ///< the program would cause damage
    unverified = 2, ///< something in the program could not be checked
    unusable = 3,   ///< wrong usage, unreadable input, unwritable output
};

/// Each function adds one or two commands: its options to `app`, and a callback that runs it and stores its
/// exit code in `exitCode`, which must outlive `app`.
void addInterpretCommand(CLI::App& app, ExitCode& exitCode);
void addCheckCommand(CLI::App& app, ExitCode& exitCode);
void addSimulateCommand(CLI::App& app, ExitCode& exitCode);
void addDecimateCommand(CLI::App& app, ExitCode& exitCode);
void addToolsCommand(CLI::App& app, ExitCode& exitCode);
void addHeadlessStudyCommand(CLI::App& app, ExitCode& exitCode);
void addFormatsCommand(CLI::App& app, ExitCode& exitCode);
void addStocksCommand(CLI::App& app, ExitCode& exitCode);
void addLspCommand(CLI::App& app, ExitCode& exitCode);
void addNcListings(CLI::App& app, ExitCode& exitCode); ///< dialects and rules

} // namespace proveout::cli
