// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/cli/report.h"
#include "core/formats/job_file.h"
#include "core/nc/program/program.h"

namespace proveout::cli {

/// Reads and interprets the program of a job, and tells `report` what there is to say about it. Tools that
/// the program calls and the job lacks are added to the job where comments of the program describe them.
/// Errors: the file cannot be read, or is no program of a control that is read here.
[[nodiscard]] Result<std::shared_ptr<const Program>> loadProgram(Job& job, Report& report);

} // namespace proveout::cli
