// SPDX-License-Identifier: GPL-3.0-or-later
// interpret: prints the meaning of a program as JSON Lines.
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/dialect_report.h"
#include "app/cli/field_options.h"
#include "app/cli/option_error.h"
#include "app/cli/report.h"
#include "app/cli/setup_options.h"
#include "core/formats/nc_motion.h"
#include "core/nc/codes/dialects.h"
#include "core/simulation/run/finding_log.h"
#include "core/simulation/run/interpretation.h"
#include "core/simulation/run/probed_stock.h"

namespace proveout::cli {

namespace {

struct InterpretCommandOptions {
    std::string program;
    ToolOptions tools;
    StockOptions stock;
    GivenFields control;
    std::vector<std::string> compared; ///< two dialects, or empty
};

ExitCode run(const InterpretCommandOptions& options) {
    Report report(options.program);
    const auto fail = [&report](Diagnostics diagnostics) {
        report.addFatal(std::move(diagnostics));
        return report.exitCode();
    };
    Setup setup;
    Result<void> given;
    describeControl(setup, OptionReader{options.control, given});
    if (!given)
        return fail(std::move(given.error()));
    InterpretOptions interpreting;
    setControl(setup, interpreting);
    interpreting.file = options.program;
    interpreting.maxBytes = programBytesThatFit();
    interpreting.subprogramFolders = {std::filesystem::path(options.program).parent_path()};
    interpreting.assumeStartAtZero = !setup.start;
    if (auto tools = options.tools.apply(setup.tools); !tools)
        return fail(std::move(tools.error()));
    if (options.tools.given())
        interpreting.tools = toolOffsets(setup.tools);
    if (auto stock = options.stock.apply(setup); !stock)
        return fail(std::move(stock.error()));
    if (!options.stock.spec.empty())
        interpreting.part = partToProbe(setup);
    auto text = NcText::load(options.program);
    if (!text)
        return fail(std::move(text.error()));

    if (!options.compared.empty()) {
        writeDifferences(std::cout, *text, interpreting, findDialect(options.compared.front())->id,
                         findDialect(options.compared.back())->id);
        return report.exitCode();
    }
    const auto program = interpretOn(setup, *text, interpreting);
    if (program->foreignKind() != nullptr)
        return fail(program->diagnostics());
    NcMotionMeta meta;
    meta.by = "proveout-cli " PROVEOUT_VERSION;
    meta.file = std::filesystem::path(options.program).filename().string();
    meta.blockDelete = setup.blockDelete;
    meta.start = interpreting.start;
    writeNcMotion(std::cout, *program, *text, meta);
    std::cout.flush();
    report.add(program->diagnostics());
    report.add(unusedCompensationStart(interpreting.compensationTypeB, *program));
    if (options.tools.given())
        report.add(FindingLog().diagnostics(*program, ToolChoice(*program, setup)));
    if (program->unverified() || program->motionCount() == 0)
        report.markUnverified();
    return report.exitCode();
}

} // namespace

void addInterpretCommand(CLI::App& app, ExitCode& exitCode) {
    auto* command = app.add_subcommand("interpret", "Print motions and events as JSON Lines (nc-motion/1)");
    auto options = std::make_shared<InterpretCommandOptions>();
    command->add_option("PROG", options->program, "NC program")->type_name("")->required();
    command
        ->add_option("--compare-dialects", options->compared,
                     "Instead, list the lines whose motion differs between two dialects")
        ->delimiter(',')
        ->expected(2)
        ->check(CLI::IsMember(dialectKeys()))
        ->type_name("D,D");
    options->tools.addTo(*command);
    options->stock.addTo(*command);
    const Setup nothing;
    describeControl(nothing, OptionAdder{.command = *command,
                                         .given = options->control,
                                         .defaultTexts = {{setup_field::kStart.key, "0,0,0, assumed"}}});
    command->callback([options, &exitCode] { exitCode = run(*options); });
}

} // namespace proveout::cli
