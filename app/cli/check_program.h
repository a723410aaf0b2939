// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/cli/check_settings.h"
#include "app/cli/command.h"
#include "app/cli/setup_options.h"
#include "core/verification/check/check_report.h"

namespace proveout::cli {

/// What is judged, and by which limits. Read by several threads at once.
struct CheckOptions {
    SetupOptions setup;
    PartOptions part;
    CheckSettings settings;
    bool keepsResult = false; ///< CheckSubject
};

struct CheckedProgram {
    std::filesystem::path input; ///< a program or a job
    std::filesystem::path program;
    std::vector<std::filesystem::path> files = {}; ///< that the job names
    bool unusable = false;                         ///< it could not be read, or its setup is impossible
    CheckReport report = {};
    double seconds = 0;

    [[nodiscard]] ExitCode exitCode() const;
};

/// Interprets and runs one program, and judges it. Any thread; never throws: a failure becomes a finding.
[[nodiscard]] CheckedProgram checkProgram(const std::filesystem::path& input, const CheckOptions& options);

/// The object of `check --json`. Reads the files again for their digests.
[[nodiscard]] nlohmann::ordered_json toJson(const CheckedProgram& checked);

} // namespace proveout::cli
