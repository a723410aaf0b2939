// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/figure_charts.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <set>

#include "core/base/diagnostic.h"
#include "core/base/text.h"
#include "core/study/averages.h"

namespace proveout {

namespace {

constexpr std::size_t kAverageOf = 20; ///< steps, as in Fig. 16

const StudyRun* find(std::span<const StudyRun> runs, const StudyPoint& point) {
    const auto found = std::ranges::find(runs, point, &StudyRun::point);
    return found == runs.end() ? nullptr : &*found;
}

std::string periodText(int period) {
    return fmt::format("s = {}", period);
}

/// A marked text, translated for the subject, with its numbers.
std::string said(const StudySubject& subject, const char* text, const std::vector<std::string>& numbers) {
    return fillIn(subject.words(text), numbers);
}

std::string allowanceText(const StudySubject& subject, double allowance) {
    return allowance > 0 ? fmt::format("ε = {} mm", allowance)
                         : subject.words(PROVEOUT_TEXT("Core", "ε = 0 (no decimation)"));
}

std::string methodText(const StudySubject& subject) {
    const DecimationParameters& base = subject.base;
    std::string method = subject.words(kMethodChoices[static_cast<std::size_t>(base.method)].label);
    if (base.method == DecimationMethod::lee)
        method += ", " + subject.words(base.certify ? PROVEOUT_TEXT("Core", "with certificate")
                                                    : PROVEOUT_TEXT("Core", "as in the paper"));
    return method;
}

/// Method and region size, which most figures hold fixed.
std::string fixedText(const StudySubject& subject) {
    const std::string cells = std::to_string(subject.base.regionCells);
    return methodText(subject) + ", " +
           said(subject, PROVEOUT_TEXT("Core", "regions {} × {}"), {cells, cells});
}

double seconds(const StudyRun& run) {
    return run.seconds.total();
}

double faces(const StudyRun& run) {
    return static_cast<double>(run.count.faces);
}

/// One point per place, from the whole run, for those runs that exist.
template<class Value, class PointAt, class Measure>
std::vector<Vec2> overRuns(std::span<const StudyRun> runs, std::span<const Value> places, PointAt pointAt,
                           Measure measure) {
    std::vector<Vec2> points;
    for (const Value place : places)
        if (const StudyRun* run = find(runs, pointAt(place)))
            points.emplace_back(static_cast<double>(place), measure(*run));
    return points;
}

/// One value per block.
template<class Measure>
std::vector<Vec2> overBlocks(const StudyRun& run, Measure measure) {
    std::vector<Vec2> points;
    points.reserve(run.rows.size());
    for (std::size_t block = 0; block < run.rows.size(); ++block)
        points.emplace_back(static_cast<double>(block + 1), measure(run.rows[block]));
    return points;
}

double facesOfRow(const StudyRow& row) {
    return row.faces;
}

double millisecondsOfRow(const StudyRow& row) {
    return 1e3 * double{row.seconds};
}

/// A dashed line across the curves that exist already.
void addLevel(Chart& chart, const StudyRun* run, double (*measure)(const StudyRun&), std::string label,
              int colour) {
    if (run == nullptr || chart.curves.empty() || chart.curves.front().points.empty())
        return;
    double lo = chart.curves.front().points.front().x;
    double hi = lo;
    for (const Curve& curve : chart.curves)
        for (const Vec2& point : curve.points) {
            lo = std::min(lo, point.x);
            hi = std::max(hi, point.x);
        }
    const double y = measure(*run);
    chart.curves.push_back({std::move(label), CurveLook::level, colour, false, {{lo, y}, {hi, y}}});
}

/// The allowances whose frames the paper draws one by one: zero, the smallest, a middle one, the largest.
constexpr std::array kDrawnAllowances{0.0, 0.01, 0.05, 0.1};

} // namespace

StudyPoint undecimated(const StudySubject& subject) {
    return allowancePoint(subject, 0);
}

std::vector<RegionCurve> regionCurves(const StudySubject& subject) {
    std::vector<RegionCurve> curves{{-1, subject.base.allowance}};
    for (const double allowance : std::set{0.01, subject.base.allowance, 0.1})
        curves.push_back({subject.base.period, allowance});
    return curves;
}

std::vector<MethodCurve> methodCurves(const StudySubject& subject, std::size_t blocks) {
    DecimationParameters none = undecimated(subject).parameters;
    DecimationParameters global = subject.base;
    global.method = DecimationMethod::global;
    global.period = 1;
    const std::string period = std::to_string(subject.base.period);
    return {{subject.words(PROVEOUT_TEXT("Core", "No decimation")), {none, blocks}},
            {subject.words(PROVEOUT_TEXT("Core", "Global, after each block")), {global, blocks}},
            {said(subject, PROVEOUT_TEXT("Core", "Local, s = {}"), {period}), {subject.base, blocks}}};
}

StudyPoint orderPoint(const StudySubject& subject, RemovalOrder order, int region) {
    StudyPoint point{subject.base};
    point.parameters.order = order;
    point.parameters.regionCells = region;
    return point;
}

StudyPoint regionPoint(const StudySubject& subject, const RegionCurve& curve, int region) {
    StudyPoint point{subject.base};
    point.parameters.regionCells = region;
    point.parameters.period = curve.period;
    point.parameters.allowance = curve.allowance;
    return point;
}

StudyPoint allowancePoint(const StudySubject& subject, double allowance) {
    StudyPoint point{subject.base};
    point.parameters.allowance = allowance;
    return point;
}

StudyPoint periodPoint(const StudySubject& subject, int period) {
    StudyPoint point{subject.base};
    point.parameters.period = period;
    return point;
}

Chart methodChart(const StudySubject& subject, std::span<const StudyRun> runs, std::size_t blocks) {
    Chart chart;
    chart.subtitle =
        fixedText(subject) + ", " + allowanceText(subject, subject.base.allowance) + "; " +
        said(subject, PROVEOUT_TEXT("Core", "averages over {} steps"), {std::to_string(kAverageOf)});
    chart.xLabel = subject.words(PROVEOUT_TEXT("Core", "Step (block)"));
    chart.yLabel = subject.timeLabel + ", ms";
    int colour = 0;
    for (const MethodCurve& curve : methodCurves(subject, blocks)) {
        if (const StudyRun* run = find(runs, curve.point))
            chart.curves.push_back({curve.label, CurveLook::marked, colour, false,
                                    windowAverages(overBlocks(*run, millisecondsOfRow), kAverageOf)});
        ++colour;
    }
    return chart;
}

Chart orderChart(const StudySubject& subject, std::span<const StudyRun> runs) {
    Chart chart;
    chart.subtitle = methodText(subject) + ", " + periodText(subject.base.period) + ", " +
                     allowanceText(subject, subject.base.allowance);
    chart.xLabel = subject.words(PROVEOUT_TEXT("Core", "Region size, cells"));
    chart.yLabel = subject.words(PROVEOUT_TEXT("Core", "Decimation time, s"));
    chart.rightLabel = subject.words(PROVEOUT_TEXT("Core", "Triangles shown in all frames"));
    const std::vector<int> regions = studiedRegions(subject.job);
    for (const RemovalOrder order : {RemovalOrder::random, RemovalOrder::sequential}) {
        const auto pointAt = [&](int region) { return orderPoint(subject, order, region); };
        const bool random = order == RemovalOrder::random;
        const int colour = static_cast<int>(order);
        chart.curves.push_back({subject.words(random ? PROVEOUT_TEXT("Core", "Time, random")
                                                     : PROVEOUT_TEXT("Core", "Time, sequential")),
                                CurveLook::marked, colour, false,
                                overRuns<int>(runs, regions, pointAt,
                                              [](const StudyRun& run) { return run.seconds.decimate; })});
        chart.curves.push_back({subject.words(random ? PROVEOUT_TEXT("Core", "Triangles, random")
                                                     : PROVEOUT_TEXT("Core", "Triangles, sequential")),
                                CurveLook::marked, colour + 2, true,
                                overRuns<int>(runs, regions, pointAt, faces)});
    }
    return chart;
}

Chart regionChart(const StudySubject& subject, std::span<const StudyRun> runs) {
    Chart chart;
    chart.subtitle = methodText(subject);
    chart.xLabel = subject.words(PROVEOUT_TEXT("Core", "Region size, cells"));
    chart.yLabel = subject.timeLabel + ", s";
    const std::vector<int> regions = studiedRegions(subject.job);
    int colour = 0;
    for (const RegionCurve& curve : regionCurves(subject))
        chart.curves.push_back(
            {periodText(curve.period) + ", " + allowanceText(subject, curve.allowance), CurveLook::marked,
             colour++, false,
             overRuns<int>(
                 runs, regions, [&](int region) { return regionPoint(subject, curve, region); }, seconds)});
    addLevel(chart, find(runs, undecimated(subject)), seconds,
             subject.words(PROVEOUT_TEXT("Core", "No decimation")), colour);
    return chart;
}

Chart allowanceChart(const StudySubject& subject, std::span<const StudyRun> runs) {
    Chart chart;
    chart.subtitle = fixedText(subject) + ", " + periodText(subject.base.period);
    chart.xLabel = subject.words(PROVEOUT_TEXT("Core", "Error allowance ε, mm"));
    chart.yLabel = subject.words(PROVEOUT_TEXT("Core", "Ratio to ε = 0"));
    const StudyRun* reference = find(runs, undecimated(subject));
    if (reference == nullptr)
        return chart;
    const auto pointAt = [&](double allowance) { return allowancePoint(subject, allowance); };
    const auto ratios = [&](double (*measure)(const StudyRun&)) {
        return overRuns<double>(runs, studiedAllowances(), pointAt,
                                [&](const StudyRun& run) { return measure(run) / measure(*reference); });
    };
    chart.curves.push_back({subject.words(PROVEOUT_TEXT("Core", "Number of triangles")), CurveLook::marked, 0,
                            false, ratios(faces)});
    chart.curves.push_back({subject.timeLabel, CurveLook::marked, 1, false, ratios(seconds)});
    return chart;
}

Chart facesChart(const StudySubject& subject, std::span<const StudyRun> runs) {
    Chart chart;
    chart.subtitle = fixedText(subject) + ", " + periodText(subject.base.period);
    chart.xLabel = subject.words(PROVEOUT_TEXT("Core", "Step (block)"));
    chart.yLabel = subject.words(PROVEOUT_TEXT("Core", "Number of triangles"));
    int colour = 0;
    for (const double allowance : kDrawnAllowances) {
        if (const StudyRun* run = find(runs, allowancePoint(subject, allowance)))
            chart.curves.push_back({allowanceText(subject, allowance), CurveLook::plain, colour, false,
                                    overBlocks(*run, facesOfRow)});
        ++colour;
    }
    return chart;
}

Chart timesChart(const StudySubject& subject, std::span<const StudyRun> runs) {
    Chart chart = facesChart(subject, {});
    chart.yLabel = subject.timeLabel + ", ms";
    int colour = 0;
    double highest = 0;
    for (const double allowance : kDrawnAllowances) {
        if (const StudyRun* run = find(runs, allowancePoint(subject, allowance))) {
            const std::vector<Vec2> points = overBlocks(*run, millisecondsOfRow);
            const std::vector<Vec2> averages = windowAverages(points, kAverageOf);
            for (const Vec2& point : averages)
                highest = std::max(highest, point.y);
            const std::string label = allowanceText(subject, allowance);
            chart.curves.push_back({label + ", " + subject.words(PROVEOUT_TEXT("Core", "each step")),
                                    CurveLook::faint, colour, false, points, false});
            chart.curves.push_back({label, CurveLook::plain, colour, false, averages});
            chart.curves.push_back({label + ", " + subject.words(PROVEOUT_TEXT("Core", "straight line")),
                                    CurveLook::level, colour, false, straightLine(points), false});
        }
        ++colour;
    }
    chart.topOfLeft = 2.5 * highest; // a single hiccup of the machine must not flatten everything else
    return chart;
}

Chart periodChart(const StudySubject& subject, std::span<const StudyRun> runs) {
    Chart chart;
    chart.subtitle = fixedText(subject) + ", " + allowanceText(subject, subject.base.allowance);
    chart.xLabel = subject.words(PROVEOUT_TEXT("Core", "Decimation period s, blocks"));
    chart.yLabel = subject.timeLabel + ", s";
    chart.rightLabel = subject.words(PROVEOUT_TEXT("Core", "Triangles shown in all frames"));
    chart.logarithmicX = true;
    const auto pointAt = [&](int period) { return periodPoint(subject, period); };
    chart.curves.push_back({subject.timeLabel, CurveLook::marked, 1, false,
                            overRuns<int>(runs, studiedPeriods(), pointAt, seconds)});
    addLevel(chart, find(runs, pointAt(-1)), seconds, subject.words(PROVEOUT_TEXT("Core", "Time, s = -1")),
             1);
    addLevel(chart, find(runs, undecimated(subject)), seconds,
             subject.words(PROVEOUT_TEXT("Core", "Time, no decimation")), 5);
    chart.curves.push_back({subject.words(PROVEOUT_TEXT("Core", "Number of triangles")), CurveLook::marked, 0,
                            true, overRuns<int>(runs, studiedPeriods(), pointAt, faces)});
    return chart;
}

} // namespace proveout
