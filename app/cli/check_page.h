// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "app/cli/check_program.h"

namespace proveout::cli {

/// Writes the report of a checked program, whose JSON is `json`, as a page. Errors: the file cannot be
/// written.
[[nodiscard]] Result<void> writeReport(const std::string& file, const nlohmann::ordered_json& json,
                                       const CheckedProgram& checked);

} // namespace proveout::cli
