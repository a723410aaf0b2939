// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/forecast_chart.h"

#include <algorithm>
#include <fmt/format.h>

#include "core/base/text.h"

namespace proveout {

namespace {

constexpr std::size_t kCurves = 4; ///< so that the measured ones have colours of their own

/// Region sizes, the one with the cheapest period first.
std::vector<int> bestRegions(const Rehearsal& rehearsal) {
    std::vector<Forecast> sorted = rehearsal.forecasts;
    std::ranges::sort(sorted, {}, &Forecast::seconds);
    std::vector<int> regions;
    for (const Forecast& forecast : sorted)
        if (std::ranges::find(regions, forecast.regionCells) == regions.end())
            regions.push_back(forecast.regionCells);
    regions.resize(std::min(regions.size(), kCurves));
    return regions;
}

} // namespace

Chart forecastChart(const Rehearsal& rehearsal, std::span<const MeasuredSchedule> measured, Words words) {
    Chart chart;
    chart.id = "forecast";
    chart.title = words(PROVEOUT_TEXT("Core", "Predicted cost by region size and period"));
    chart.xLabel = words(PROVEOUT_TEXT("Core", "Decimation period s, blocks"));
    chart.yLabel = words(PROVEOUT_TEXT("Core", "Cost of the program, s"));
    chart.logarithmicX = true;
    double lo = 1;
    double hi = 1;
    int colour = 0;
    for (const int region : bestRegions(rehearsal)) {
        Curve curve{fmt::format("{0} × {0}", region), CurveLook::marked, colour++, false, {}};
        for (const Forecast& forecast : rehearsal.forecasts)
            if (forecast.regionCells == region && forecast.period > 0)
                curve.points.emplace_back(forecast.period, forecast.seconds);
        if (!curve.points.empty())
            hi = std::max(hi, curve.points.back().x);
        chart.curves.push_back(std::move(curve));
    }
    const double full = rehearsal.undecimated.seconds;
    chart.curves.push_back({words(PROVEOUT_TEXT("Core", "No decimation")),
                            CurveLook::level,
                            colour++,
                            false,
                            {{lo, full}, {hi, full}}});
    for (const MeasuredSchedule& point : measured) {
        const std::string label = fmt::format("{}: {}/{}", point.label, point.regionCells, point.period);
        if (point.period > 0)
            chart.curves.push_back(
                {label, CurveLook::marked, colour++, false, {{double(point.period), point.seconds}}});
        else // once at the start, or never: it has no position on the axis
            chart.curves.push_back(
                {label, CurveLook::level, colour++, false, {{lo, point.seconds}, {hi, point.seconds}}});
    }
    return chart;
}

} // namespace proveout
