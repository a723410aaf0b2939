// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/study/chart.h"
#include "core/study/sweep.h"

namespace proveout {

/// The curves of a chart: curve, x, y; one row per point, with every point of the runs, even if a picture
/// shows fewer. Units as in the labels of the axes, which are in the header row.
[[nodiscard]] std::string chartCsv(const Chart& chart);

/// One row per point of a sweep: parameters, counts, median seconds by phase, and the spread of the totals.
[[nodiscard]] std::string sweepCsv(std::span<const SweptPoint> points);

} // namespace proveout
