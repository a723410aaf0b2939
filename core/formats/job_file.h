// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/diagnostic.h"
#include "core/decimation/regions/parameters.h"
#include "core/formats/job_paths.h"
#include "core/part/part_spec.h"
#include "core/simulation/setup/check_rules.h"
#include "core/simulation/setup/machine.h"
#include "core/simulation/setup/setup.h"

namespace proveout {

/// A job: a program with everything it needs to run. `.proveout`, JSON with a schema number.
struct Job {
    std::filesystem::path program; ///< absolute once loaded; stored relative to the job file if possible
    Setup setup;
    DecimationParameters parameters;
    std::optional<Machine> machine = {}; ///< nothing: the defaults are assumed
    CheckRules check = {};
    std::optional<PartSpec> part = {}; ///< its file is not read; nothing: the stock is compared with no part
    Diagnostics warnings = {};         ///< about the file it was read from; never written
    bool regionNamed = false; ///< set by that file or by a later change of the job; never written. If false,
                              ///< the size is the default of method and map
};

/// Reads a job; the program itself is not opened. Region size and period that are not given are the defaults
/// of the method, on a map of this stock and grid. Errors name the JSON path of the field (e.g.
/// "stock.width") and the allowed values, all of them at once, with line and column. An unknown field is a
/// warning of the job with its place and name; if the job is refused, the warnings follow the errors. A stock
/// that comes from a file is read with the job, and a problem with that file is an error that names it; a
/// stock without a file name has no body yet. A job without a grid has an automatic one, whose spacing is
/// computed once the program is known. A newer schema is refused, and so are files larger or nested more
/// deeply than any job. A file outside the folder of the job that the rule does not allow is not read: an
/// error (id "job-outside"), whose second argument is that file.
[[nodiscard]] Result<Job> readJob(const std::filesystem::path& file, const OutsideRule& allowed);
/// The same; no file outside its folder is allowed.
[[nodiscard]] Result<Job> readJob(const std::filesystem::path& file);

/// The text that writeJob() writes to this file: names of other files are relative to it. Errors: a name is
/// not UTF-8.
[[nodiscard]] Result<std::string> jobText(const std::filesystem::path& file, const Job& job);

/// Writes a job atomically. Errors: the file cannot be written, or the program's name is not UTF-8.
[[nodiscard]] Result<void> writeJob(const std::filesystem::path& file, const Job& job);

} // namespace proveout
