// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/load_program.h"

#include <utility>

#include "app/cli/setup_options.h"
#include "core/simulation/run/interpretation.h"
#include "core/simulation/setup/tool_proposals.h"

namespace proveout::cli {

Result<std::shared_ptr<const Program>> loadProgram(Job& job, Report& report) {
    auto text = NcText::load(job.program);
    if (!text)
        return tl::unexpected(std::move(text.error()));
    addProposals(job.setup.tools, proposeTools(*text));
    std::shared_ptr<const Program> program =
        interpretOn(job.setup, *text, interpretOptions(job.setup, job.program));
    if (program->foreignKind() != nullptr)
        return tl::unexpected(program->diagnostics());
    report.add(program->diagnostics());
    report.add(unusedCompensationStart(job.setup.compensationTypeB, *program));
    if (program->unverified() || program->motionCount() == 0)
        report.markUnverified();
    return program;
}

} // namespace proveout::cli
