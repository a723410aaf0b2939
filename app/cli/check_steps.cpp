// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/check_steps.h"

#include <optional>
#include <utility>

#include "core/formats/part_file.h"

namespace proveout::cli {

InterpretedJob interpretJob(Job& job, const NcText& text, const InterpretAgain& interpret,
                            const InterpretAgain& again) {
    InterpretedJob read{.program = {}, .proposals = proposeTools(text)};
    addProposals(job.setup.tools, read.proposals);
    const InterpretOptions options = interpretOptions(job.setup, job.program);
    read.program = interpret(options);
    if (!job.setup.startTool)
        read.program = withAssumedTool(std::move(read.program), options, job.setup.tools, again);
    return read;
}

Result<std::shared_ptr<const CheckReport>> judgeJob(Job& job, const InterpretedJob& read, const Judging& how,
                                                    const SetupOptions& options, const WorkContext& context) {
    if (how.hasStock) {
        job.parameters.method = DecimationMethod::none;
        job.parameters.period = 0;
        SetupOptions::settleGrid(job, *read.program, {});
        if (auto fits = options.checkGrid(job, {}); !fits)
            return tl::unexpected(std::move(fits.error()));
    }
    std::optional<PartToCompare> part;
    if (job.part)
        part = {.of = readPart(*job.part, how.memoryBytes), .tolerance = job.part->tolerance};
    return check({.program = read.program,
                  .setup = std::make_shared<const Setup>(job.setup),
                  .machine = job.machine,
                  .hasStock = how.hasStock,
                  .warnings = job.warnings,
                  .proposals = read.proposals,
                  .part = std::move(part),
                  .keepsResult = how.keepsResult},
                 job.check, how.memoryBytes, context);
}

} // namespace proveout::cli
