// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/setup_options.h"
#include "core/verification/rules/rules.h"
#include "core/verification/verdict/verdict.h"

namespace proveout::cli {

/// What is judged, and by which limits. Read by several threads at once.
struct CheckOptions {
    SetupOptions setup;
    RuleLimits limits;
    std::set<std::string> off;      ///< ids of rules
    std::set<std::string> accepted; ///< ids of entries of notCheckedRows()
};

/// A finding with all that machine-readable reports need.
struct CheckFinding {
    Diagnostic diagnostic{}; ///< at its first line
    std::size_t block = 0;   ///< 1-based; 0: none
    std::size_t count = 1;   ///< of blocks
    int lastLine = 0;
    int tool = 0;
    double value = 0;
    double limit = 0;
    const char* unit = ""; ///< empty: there is no value
    std::optional<Vec3> place = {};
};

struct CheckedProgram {
    std::filesystem::path input; ///< a program or a job
    std::filesystem::path program;
    Verdict verdict = Verdict::unverified;
    bool unusable = false; ///< it could not be read, or its setup is impossible
    std::vector<CheckFinding> findings = {};
    std::vector<NotChecked> notChecked = {};
    double seconds = 0;

    [[nodiscard]] ExitCode exitCode() const;
};

/// Interprets and runs one program, and judges it. Any thread; never throws: a failure becomes a finding.
[[nodiscard]] CheckedProgram checkProgram(const std::filesystem::path& input, const CheckOptions& options);

/// The object of `check --json`. Reads the files again for their digests.
[[nodiscard]] nlohmann::ordered_json toJson(const CheckedProgram& checked);

} // namespace proveout::cli
