// SPDX-License-Identifier: GPL-3.0-or-later
// proveout-cli: the headless composition root.
#include <array>
#include <cstdio>
#include <exception>
#include <new>

#include "app/cli/command.h"
#include "app/cli/run_command.h"
#include "core/base/memory.h"
#include "core/verification/findings/command_line_findings.h"

namespace {

using namespace proveout::cli;
using namespace proveout::command_line_finding;

/// One row per command; the help lists them in this sequence.
constexpr std::array kCommands{
    addInterpretCommand, addSimulateCommand, addCheckCommand,   addDecimateCommand, addHeadlessStudyCommand,
    addToolsCommand,     addStocksCommand,   addFormatsCommand, addNcListings,      addLspCommand};

ExitCode run(int argc, char** argv) {
    CLI::App app("Proves out three-axis milling programs before they touch metal.", "proveout-cli");
    app.set_version_flag("--version", "proveout-cli " PROVEOUT_VERSION);
    app.require_subcommand(1);
    app.footer("Exit codes: 0 nothing found, 1 faults found, 2 something could not be checked, "
               "3 usage or unreadable input.");
    ExitCode exitCode = ExitCode::done;
    for (const auto add : kCommands)
        add(app, exitCode);
    return runCommand(app, exitCode, argc, argv);
}

} // namespace

int main(int argc, char** argv) {
    proveout::returnLargeBlocksAtOnce();
    try {
        return static_cast<int>(run(argc, argv));
    } catch (const std::bad_alloc&) {
        // Prints directly, because formatting another message would need memory.
        std::fprintf(stderr, "proveout-cli: error: %s [%s]\n", kCommandOutOfMemory.text,
                     kCommandOutOfMemory.id);
    } catch (const std::exception& exception) {
        printFinding("proveout-cli", kCommandFailed, {exception.what()});
    }
    return static_cast<int>(ExitCode::unusable);
}
