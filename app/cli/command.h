// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace proveout::cli {

/// Exit codes of the command line: a contract. 3 outranks 1 outranks 2 outranks 0.
enum class ExitCode : int {
    done = 0,       ///< and nothing was found
    faults = 1,     ///< the program would do harm
    unverified = 2, ///< something in the program could not be checked
    unusable = 3,   ///< usage, unreadable input, unwritable output
};

/// Each adds a command or two: its options to `app`, and a callback that runs it and leaves its exit code in
/// `exitCode`, which must outlive `app`.
void addInterpretCommand(CLI::App& app, ExitCode& exitCode);
void addSimulateCommand(CLI::App& app, ExitCode& exitCode);
void addDecimateCommand(CLI::App& app, ExitCode& exitCode);
void addToolsCommand(CLI::App& app, ExitCode& exitCode);
void addHeadlessStudyCommand(CLI::App& app, ExitCode& exitCode);
void addFormatsCommand(CLI::App& app, ExitCode& exitCode);
void addStocksCommand(CLI::App& app, ExitCode& exitCode);
void addNcListings(CLI::App& app, ExitCode& exitCode); ///< dialects, rules

} // namespace proveout::cli
