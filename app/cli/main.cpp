// SPDX-License-Identifier: GPL-3.0-or-later
// proveout-cli: the headless composition root.
#include <array>
#include <cstdio>
#include <exception>
#include <fmt/core.h>
#include <iostream>
#include <new>
#include <string>

#include "app/cli/command.h"

namespace {

using namespace proveout::cli;

/// One row a command, in the order of the help.
constexpr std::array kCommands{addInterpretCommand, addSimulateCommand, addDecimateCommand, addToolsCommand,
                               addFormatsCommand};

/// One sentence, and how the command that was named is used; the whole help would push the sentence off the
/// screen.
ExitCode refuse(const CLI::App& app, std::string sentence) {
    const auto chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    const std::string name = chosen.empty() ? app.get_name() : app.get_name() + " " + command.get_name();
    if (!sentence.ends_with('.'))
        sentence += '.';
    fmt::print(stderr, "proveout-cli: error: {} [usage]\n\n{}\nMore is told by {} --help\n", sentence,
               CLI::Formatter().make_usage(&command, name), name);
    return ExitCode::unusable;
}

/// A first argument that is neither a command nor an option; the parser would only say that one is missing.
bool isUnknownCommand(const CLI::App& app, const std::string& argument) {
    const auto named = [&](const CLI::App* command) { return command->get_name() == argument; };
    return !argument.starts_with('-') && app.get_subcommands(named).empty();
}

ExitCode run(int argc, char** argv) {
    CLI::App app("Proves out three-axis milling programs before they touch metal.", "proveout-cli");
    app.set_version_flag("--version", "proveout-cli " PROVEOUT_VERSION);
    app.require_subcommand(1);
    app.footer("Exit codes: 0 nothing found, 1 faults found, 2 something could not be checked, "
               "3 usage or unreadable input.");
    ExitCode exitCode = ExitCode::done;
    for (const auto add : kCommands)
        add(app, exitCode);
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
        fmt::print(stderr, "proveout-cli: error: The output cannot be written. [output-unwritable]\n");
        return ExitCode::unusable;
    }
    return exitCode;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return static_cast<int>(run(argc, argv));
    } catch (const std::bad_alloc&) {
        std::fputs("proveout-cli: error: There is not enough memory. [out-of-memory]\n", stderr);
    } catch (const std::exception& exception) {
        std::fprintf(stderr, "proveout-cli: error: %s [internal-error]\n", exception.what());
    }
    return static_cast<int>(ExitCode::unusable);
}
