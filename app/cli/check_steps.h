// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of a check, which the command `check` and the language server share.
#pragma once

#include <cstdint>
#include <memory>

#include "app/cli/check_program.h"
#include "core/base/work_context.h"
#include "core/formats/job_file.h"
#include "core/nc/text/nc_text.h"
#include "core/simulation/run/interpretation.h"
#include "core/simulation/setup/tool_proposals.h"
#include "core/verification/check/check.h"

namespace proveout::cli {

struct InterpretedJob {
    std::shared_ptr<const Program> program;
    ToolProposals proposals; ///< the tools that comments describe
};

/// Interprets `text` as the program of a job by calling `interpret`, and `again` if a tool has to be assumed.
/// Adds to the job the tools that comments describe.
[[nodiscard]] InterpretedJob interpretJob(Job& job, const NcText& text, const InterpretAgain& interpret,
                                          const InterpretAgain& again);

struct Judging {
    bool hasStock = true;
    bool keepsResult = false; ///< CheckSubject
    std::uint64_t memoryBytes = 0;
};

/// Judges a program that interpretJob() has interpreted, by the rules of the job; settles an automatic grid
/// first. Results and errors are those of check(); `keepsResult`: CheckSubject.
[[nodiscard]] Result<std::shared_ptr<const CheckReport>> judgeJob(Job& job, const InterpretedJob& read,
                                                                  const Judging& how,
                                                                  const SetupOptions& options,
                                                                  const WorkContext& context = {});

} // namespace proveout::cli
