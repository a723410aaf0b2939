// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/run_command.h"

#include <cstdio>
#include <fmt/core.h>
#include <iostream>
#include <string>

namespace proveout::cli {

namespace {

/// One sentence, and how the command that was named is used; the whole help would push the sentence off the
/// screen.
ExitCode refuse(const CLI::App& app, std::string sentence) {
    const auto chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    const std::string name = chosen.empty() ? app.get_name() : app.get_name() + " " + command.get_name();
    if (!sentence.ends_with('.'))
        sentence += '.';
    fmt::print(stderr, "{}: error: {} [usage]\n\n{}\nMore is told by {} --help\n", app.get_name(), sentence,
               CLI::Formatter().make_usage(&command, name), name);
    return ExitCode::unusable;
}

/// A first argument that is neither a command nor an option; the parser would only say that one is missing.
bool isUnknownCommand(const CLI::App& app, const std::string& argument) {
    const auto named = [&](const CLI::App* command) { return command->get_name() == argument; };
    return !argument.starts_with('-') && app.get_subcommands(named).empty();
}

} // namespace

ExitCode runCommand(CLI::App& app, const ExitCode& exitCode, int argc, char** argv) {
    if (argc > 1 && isUnknownCommand(app, argv[1]))
        return refuse(app, fmt::format("\"{}\" is not a command.", argv[1]));
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& wanted) { // --help, --version
        app.exit(wanted);
    } catch (const CLI::ParseError& error) {
        return refuse(app, error.what());
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout.good()) {
        fmt::print(stderr, "{}: error: The output cannot be written. [output-unwritable]\n", app.get_name());
        return ExitCode::unusable;
    }
    return exitCode;
}

} // namespace proveout::cli
