// SPDX-License-Identifier: GPL-3.0-or-later
// lsp: a language server for editors.
#include <memory>

#include "app/cli/check_program.h"
#include "app/cli/command.h"
#include "app/cli/lsp_server.h"
#include "app/cli/report.h"
#include "app/cli/thread_limit.h"

namespace proveout::cli {

namespace {

struct LspCommand {
    CheckOptions check;
    ThreadLimit threads;
    bool stdio = true;
};

ExitCode serve(LspCommand& command) {
    CheckRules anyRules;
    if (auto read = command.check.settings.apply(anyRules); !read) {
        Report report("proveout-cli");
        report.addFatal(std::move(read.error()));
        return report.exitCode();
    }
    return static_cast<ExitCode>(LspServer(command.check).run());
}

} // namespace

void addLspCommand(CLI::App& app, ExitCode& exitCode) {
    auto* command = app.add_subcommand("lsp", "Serve editors: problems, help and jumps while you type (LSP)");
    auto options = std::make_shared<LspCommand>();
    options->check.setup.addSharedTo(*command);
    options->check.settings.addTo(*command);
    options->threads.addTo(*command);
    command->add_flag("--stdio", options->stdio, "Use stdin and stdout, as it always does");
    command->footer("Exit codes: 0 after a shutdown request, 1 without one, 3 usage.");
    command->callback([options, &exitCode] {
        options->threads.apply();
        exitCode = serve(*options);
    });
}

} // namespace proveout::cli
