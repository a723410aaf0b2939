// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's first open question (section 6): choosing region size and period of a program before it runs.
#pragma once

#include "core/study/rehearsal.h"
#include "core/study/sweep.h"

namespace proveout {

/// The forecast with the lowest cost.
[[nodiscard]] const Forecast& cheapest(const Rehearsal& rehearsal);

/// `base` with the region size and period of a forecast.
[[nodiscard]] DecimationParameters withSchedule(const DecimationParameters& base, const Forecast& forecast);

/// The same points with counts of actual runs in place of the forecast ones, and their cost by the same
/// model, for comparison with the forecasts. Takes as long as the whole sweep; errors as for runStudy().
/// Nothing is drawn, because drawing does not change a count.
[[nodiscard]] Result<std::vector<Forecast>> countAll(const StudyJob& job, const DecimationParameters& base,
                                                     const Rehearsal& rehearsal,
                                                     const WorkContext& context = {});

} // namespace proveout
