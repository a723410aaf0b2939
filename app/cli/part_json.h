// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "core/verification/part/part_comparison.h"

namespace proveout::cli {

/// The object "part" of `check --json`: totals, histogram and the islands, the deepest first.
[[nodiscard]] nlohmann::ordered_json toJson(const PartComparison& comparison);

/// Prints such an object in words: whether the part is right, and the deepest islands.
void printPart(const nlohmann::ordered_json& part);

} // namespace proveout::cli
