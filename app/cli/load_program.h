// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/cli/report.h"
#include "core/formats/job_file.h"
#include "core/nc/program/program.h"
#include "core/simulation/run/program_reading.h"

namespace proveout::cli {

/// Reads and interprets the program of a job, and adds its messages to `report`. Missing tools that comments
/// of the program describe are added to the job. Errors: the file cannot be read, or is not a program for a
/// supported control.
[[nodiscard]] Result<std::shared_ptr<const Program>> loadProgram(Job& job, Report& report);

/// The same in two steps: starts to interpret the program, of which the caller takes beginnings, and adds the
/// messages of the whole.
[[nodiscard]] Result<std::unique_ptr<ProgramReading>> startReading(Job& job);
[[nodiscard]] Result<void> reportProgram(const Program& program, const Job& job, Report& report);

} // namespace proveout::cli
