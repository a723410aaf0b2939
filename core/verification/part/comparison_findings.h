// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/diagnostic.h"
#include "core/verification/part/part_comparison.h"
#include "core/verification/rules/rules.h"

namespace proveout {

/// What a comparison found: one finding for all islands of one kind that one tool has made, and what could
/// not be judged.
[[nodiscard]] std::vector<RuleFinding> findingsOf(const PartComparison& comparison);

/// The unit of the values of a row of these findings; empty: they have none.
[[nodiscard]] const char* comparisonUnit(const FindingRow& row);

/// Why a part is not compared with a stock, or not all of it; empty: it is within it.
[[nodiscard]] Diagnostics placementFindings(const DesignPart& part, const StockBox& stock,
                                            const PartTolerance& tolerance);
/// Whether so little of it is within the stock that nothing is to be compared.
[[nodiscard]] bool isMisplaced(const DesignPart& part, const StockBox& stock);

} // namespace proveout
