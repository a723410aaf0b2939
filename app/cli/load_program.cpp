// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/load_program.h"

#include <utility>

#include "app/cli/setup_options.h"
#include "core/simulation/run/interpretation.h"
#include "core/simulation/setup/tool_proposals.h"

namespace proveout::cli {

namespace {

Result<NcText> loadText(Job& job) {
    auto text = NcText::load(job.program);
    if (text)
        addProposals(job.setup.tools, proposeTools(*text));
    return text;
}

} // namespace

Result<std::shared_ptr<const Program>> loadProgram(Job& job, Report& report) {
    const auto text = loadText(job);
    if (!text)
        return tl::unexpected(text.error());
    auto program = interpretOn(job.setup, *text, interpretOptions(job.setup, job.program));
    if (auto read = reportProgram(*program, job, report); !read)
        return tl::unexpected(std::move(read.error()));
    return program;
}

Result<std::unique_ptr<ProgramReading>> startReading(Job& job) {
    auto text = loadText(job);
    if (!text)
        return tl::unexpected(std::move(text.error()));
    return std::make_unique<ProgramReading>(job.setup, std::move(*text),
                                            interpretOptions(job.setup, job.program));
}

Result<void> reportProgram(const Program& program, const Job& job, Report& report) {
    if (program.foreignKind() != nullptr)
        return tl::unexpected(program.diagnostics());
    report.add(program.diagnostics());
    report.add(unusedCompensationStart(job.setup.compensationTypeB, program));
    if (program.unverified() || program.motionCount() == 0)
        report.markUnverified();
    return {};
}

} // namespace proveout::cli
