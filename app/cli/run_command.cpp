// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/run_command.h"

#include <cerrno>
#include <cstdio>
#include <fmt/core.h>
#include <iostream>
#include <string>
#include <system_error>
#include <utility>

#include "core/base/write_signals.h"
#include "core/verification/findings/command_line_findings.h"

namespace proveout::cli {

namespace {

/// One sentence and the usage of the given command; the complete help would scroll the sentence off the
/// screen.
ExitCode refuse(const CLI::App& app, std::string sentence) {
    const auto chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    const std::string name = chosen.empty() ? app.get_name() : app.get_name() + " " + command.get_name();
    if (sentence.ends_with('.'))
        sentence.pop_back();
    printFinding(app.get_name(), command_line_finding::kUsage, {std::move(sentence)});
    std::fputs(
        fmt::format("\n{}\nFor more, run {} --help\n", CLI::Formatter().make_usage(&command, name), name)
            .c_str(),
        stderr);
    return ExitCode::unusable;
}

/// A first argument that is neither a command nor an option; the parser would only report that a command is
/// missing.
bool isUnknownCommand(const CLI::App& app, const std::string& argument) {
    const auto named = [&](const CLI::App* command) { return command->get_name() == argument; };
    return !argument.starts_with('-') && app.get_subcommands(named).empty();
}

/// An empty value is a mistake, such as a script variable that was never set, and must not count as no value.
void refuseEmptyValues(CLI::App& app) {
    const CLI::Validator notEmpty(
        [](const std::string& value) { return value.empty() ? "must not be empty" : std::string(); },
        std::string());
    for (CLI::Option* option : app.get_options())
        if (option->get_items_expected_max() > 0)
            option->check(notEmpty);
    for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        refuseEmptyValues(*command);
}

/// `error`: 0 if the reason is no longer known.
ExitCode unwritableOutput(const CLI::App& app, int error) {
    if (error == 0)
        printFinding(app.get_name(), command_line_finding::kOutputUnwritable);
    else
        printFinding(app.get_name(), command_line_finding::kOutputUnwritableReason,
                     {std::generic_category().message(error)});
    return ExitCode::unusable;
}

} // namespace

void printFinding(const std::string& program, const FindingRow& row, std::vector<Argument> arguments) {
    Diagnostic diagnostic = diagnosticOf(row, std::move(arguments));
    diagnostic.file = program;
    // If stderr cannot be written either, the exit code still reports the failure.
    std::fputs((oneLine(diagnostic) + '\n').c_str(), stderr);
}

ExitCode runCommand(CLI::App& app, const ExitCode& exitCode, int argc, char** argv) {
    if (argc > 1 && isUnknownCommand(app, argv[1]))
        return refuse(app, fmt::format("\"{}\" is not a command.", argv[1]));
    reportFailedWrites();
    refuseEmptyValues(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& wanted) { // --help, --version
        app.exit(wanted);
    } catch (const CLI::ParseError& error) {
        return refuse(app, error.what());
    } catch (const std::system_error& error) { // thrown by the output functions
        if (std::ferror(stdout) == 0)
            throw;
        return unwritableOutput(app, error.code().value());
    }
    errno = 0;
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout.good())
        return unwritableOutput(app, errno);
    return exitCode;
}

} // namespace proveout::cli
