// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/study/chart.h"
#include "core/study/figures.h"
#include "core/study/rehearsal.h"

namespace proveout {

/// A region size and period that was both measured and forecast.
struct MeasuredSchedule {
    int regionCells;
    int period;
    double seconds;
    std::string label;
};

/// Prediction and measurement: forecast cost by period, with a curve for each of the best region sizes, the
/// run without decimation for comparison, and a mark for each measured run.
[[nodiscard]] Chart forecastChart(const Rehearsal& rehearsal, std::span<const MeasuredSchedule> measured,
                                  Words words = englishWords);

} // namespace proveout
