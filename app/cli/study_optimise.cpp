// SPDX-License-Identifier: GPL-3.0-or-later
// study --optimise: chooses region size and period before the program runs, and compares the prediction with
// measurements.
#include "app/cli/study_optimise.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <utility>

#include "core/base/stop_watch.h"

namespace proveout::cli {

namespace {

nlohmann::ordered_json toJson(const Forecast& forecast) {
    return {{"region", forecast.regionCells},       {"period", forecast.period},
            {"seconds", forecast.seconds},          {"faces", forecast.count.faces},
            {"moments", forecast.count.moments},    {"regionsDecimated", forecast.count.regionsDecimated},
            {"facesMade", forecast.count.facesMade}};
}

nlohmann::ordered_json toJson(const Measured& measured) {
    return {{"seconds", measured.median}, {"spread", measured.spread}};
}

nlohmann::ordered_json toJson(const CostModel& model) {
    nlohmann::ordered_json decimation = nlohmann::ordered_json::array();
    for (const auto& [cells, fitted] : model.decimation)
        decimation.push_back({{"region", cells},
                              {"perStartRegion", fitted.perStartRegion},
                              {"perMomentRegionFace", fitted.perMomentRegionFace}});
    return {{"cutSeconds", model.cutSeconds},
            {"drawPerFrameFaceRegion", model.drawPerFrameFaceRegion},
            {"uploadPerFrameFaceRegion", model.uploadPerFrameFaceRegion},
            {"decimation", std::move(decimation)}};
}

std::string text(const Measured& measured) {
    return fmt::format("{:.4f} s (spread {:.1f} %)", measured.median, 100 * measured.spread);
}

/// Replaces the list of points by the best point.
Result<Optimised::Exhaustive> searchAll(const StudyJob& job, const DecimationParameters& given,
                                        const Rehearsal& rehearsal) {
    const StopWatch watch;
    const auto counted = countAll(job, given, rehearsal);
    if (!counted)
        return tl::unexpected(counted.error());
    const Forecast& chosen = cheapest(rehearsal);
    const auto isChosen = [&](const Forecast& point) {
        return point.regionCells == chosen.regionCells && point.period == chosen.period;
    };
    return Optimised::Exhaustive{*std::ranges::min_element(*counted, {}, &Forecast::seconds),
                                 std::ranges::find_if(*counted, isChosen)->seconds,
                                 watch.seconds(),
                                 {}};
}

} // namespace

Result<Optimised> Optimised::of(const StudyJob& job, const DecimationParameters& given,
                                const SweepOptions& measuring, bool exhaustive) {
    auto rehearsal = rehearse(job, given, rehearsalFor(job), *measuring.drawing);
    if (!rehearsal)
        return tl::unexpected(std::move(rehearsal.error()));
    Optimised out{given, std::move(*rehearsal), {}, {}, {}};
    std::vector<StudyPoint> points{{withSchedule(given, cheapest(out.rehearsal))}, {given}};
    if (exhaustive) {
        auto searched = searchAll(job, given, out.rehearsal);
        if (!searched)
            return tl::unexpected(std::move(searched.error()));
        points.push_back({withSchedule(given, searched->best)});
        out.exhaustive = *searched;
    }
    const auto swept = runSweep(job, points, measuring);
    if (!swept)
        return tl::unexpected(swept.error());
    out.chosenMeasured = (*swept)[0].seconds;
    out.givenMeasured = (*swept)[1].seconds;
    if (exhaustive)
        out.exhaustive->bestMeasured = (*swept)[2].seconds;
    return out;
}

nlohmann::ordered_json Optimised::json() const {
    const Forecast& chosen = cheapest(rehearsal);
    nlohmann::ordered_json forecasts = nlohmann::ordered_json::array();
    for (const Forecast& forecast : rehearsal.forecasts)
        forecasts.push_back(toJson(forecast));
    nlohmann::ordered_json out{
        {"method", kMethodChoices[static_cast<std::size_t>(given.method)].key},
        {"allowance", given.allowance},
        {"region", chosen.regionCells},
        {"period", chosen.period},
        {"predictedSeconds", chosen.seconds},
        {"measuredSeconds", chosenMeasured.median},
        {"measuredSpread", chosenMeasured.spread},
        {"rehearsalSeconds", rehearsal.seconds},
        {"undecimatedPredictedSeconds", rehearsal.undecimated.seconds},
        {"given",
         {{"region", given.regionCells}, {"period", given.period}, {"measured", toJson(givenMeasured)}}},
        {"model", toJson(rehearsal.model)},
        {"forecasts", std::move(forecasts)}};
    if (exhaustive)
        out["exhaustive"] = {{"best", toJson(exhaustive->best)},
                             {"bestMeasured", toJson(exhaustive->bestMeasured)},
                             {"chosenSeconds", exhaustive->chosenSeconds},
                             {"chosenOverBest", exhaustive->chosenSeconds / exhaustive->best.seconds},
                             {"countSeconds", exhaustive->countSeconds}};
    return out;
}

void Optimised::print() const {
    const Forecast& chosen = cheapest(rehearsal);
    fmt::print("chosen       region {}, period {} (trial run {:.3f} s)\n", chosen.regionCells, chosen.period,
               rehearsal.seconds);
    fmt::print("predicted    {:.4f} s; {:.4f} s without decimation\n", chosen.seconds,
               rehearsal.undecimated.seconds);
    fmt::print("measured     {}\n", text(chosenMeasured));
    fmt::print("as set       {}, region {}, period {}\n", text(givenMeasured), given.regionCells,
               given.period);
    if (!exhaustive)
        return;
    const Forecast& best = exhaustive->best;
    fmt::print("best of {}  region {}, period {}: {:.4f} s from counts, measured {}\n",
               rehearsal.forecasts.size(), best.regionCells, best.period, best.seconds,
               text(exhaustive->bestMeasured));
    fmt::print("chosen/best  {:.4f} from counts, {:.4f} measured\n", exhaustive->chosenSeconds / best.seconds,
               chosenMeasured.median / exhaustive->bestMeasured.median);
}

} // namespace proveout::cli
