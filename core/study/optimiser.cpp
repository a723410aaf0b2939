// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/optimiser.h"

#include <algorithm>

namespace proveout {

const Forecast& cheapest(const Rehearsal& rehearsal) {
    return *std::ranges::min_element(rehearsal.forecasts, {}, &Forecast::seconds);
}

DecimationParameters withSchedule(const DecimationParameters& base, const Forecast& forecast) {
    DecimationParameters parameters = base;
    parameters.regionCells = forecast.regionCells;
    parameters.period = forecast.period;
    return parameters;
}

Result<std::vector<Forecast>> countAll(const StudyJob& job, const DecimationParameters& base,
                                       const Rehearsal& rehearsal, const WorkContext& context) {
    std::vector<Forecast> counted = rehearsal.forecasts;
    for (std::size_t k = 0; k < counted.size(); ++k) {
        Forecast& point = counted[k];
        const auto run = runStudy(job, {withSchedule(base, point)}, nullptr, 1, {context.stop, {}});
        if (!run)
            return tl::unexpected(run.error());
        point.count = run->count;
        point.seconds = rehearsal.model.cost(point.count, point.regionCells);
        context.report(static_cast<double>(k + 1) / static_cast<double>(counted.size()));
    }
    return counted;
}

} // namespace proveout
