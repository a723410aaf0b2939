// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the JSON of a run. Lengths in mm, blocks and lines from 1.
#pragma once

#include <memory>

#include <nlohmann/json.hpp>

#include "core/nc/program/program.h"
#include "core/simulation/records/block_records.h"
#include "core/simulation/setup/setup.h"

namespace proveout::cli {

/// The tool in the spindle before the first block, and whether it is assumed; null if no tool is known.
[[nodiscard]] nlohmann::ordered_json startToolAsJson(const Program& program, const Setup& setup);

/// One object per M code that was ignored.
[[nodiscard]] nlohmann::ordered_json ignoredCodesAsJson(const Program& program);

/// Lengths, counts and extremes of a run, and its first contact.
[[nodiscard]] nlohmann::ordered_json totalsAsJson(const RunTotals& totals, const Program& program,
                                                  const std::shared_ptr<const Setup>& setup);

} // namespace proveout::cli
