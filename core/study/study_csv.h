// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/study/chart.h"
#include "core/study/sweep.h"

namespace proveout {

/// The curves of a chart: curve, x, y; a row a point, and every point of the runs, also where a picture has
/// fewer. Units as in the labels of the axes, which stand in the head.
[[nodiscard]] std::string chartCsv(const Chart& chart);

/// A row a point of a sweep: parameters, counts, median seconds by phase, and the spread of the totals.
[[nodiscard]] std::string sweepCsv(std::span<const SweptPoint> points);

} // namespace proveout
