// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/study/chart.h"
#include "core/study/figures.h"
#include "core/study/rehearsal.h"

namespace proveout {

/// What was measured of a region size and period that was also forecast.
struct MeasuredSchedule {
    int regionCells;
    int period;
    double seconds;
    std::string label;
};

/// Prediction and reality: forecast cost by period, a curve for each of the best region sizes, no decimation
/// for comparison, and a mark for each run that was measured.
[[nodiscard]] Chart forecastChart(const Rehearsal& rehearsal, std::span<const MeasuredSchedule> measured,
                                  Words words = englishWords);

} // namespace proveout
