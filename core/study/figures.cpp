// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/figures.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/study/figure_charts.h"

namespace proveout {

namespace {

// The paper uses regions of 5 to 30 cells and allowances of 0 to 0.1 mm.
constexpr std::array kRegions{5, 8, 10, 12, 15, 20, 25, 30, 48, 64, 96, 128};
constexpr std::array kAllowances{0.0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.09, 0.1};
constexpr std::array kPeriods{1, 2, 5, 10, 15, 20, 30, 40, 50, 75, 100, 200};

/// The paper's first sample: the method of its section 2.1 decimates the whole map after every block, and is
/// compared over as many blocks as that program has.
constexpr std::size_t kMethodBlocks = 255;

void addOnce(std::vector<StudyPoint>& points, const StudyPoint& point) {
    if (std::ranges::find(points, point) == points.end())
        points.push_back(point);
}

std::vector<StudyPoint> orderPoints(const StudySubject& subject) {
    std::vector<StudyPoint> points;
    if (subject.base.method != DecimationMethod::lee)
        return points; // the other methods have no removal order to choose
    for (const RemovalOrder order : {RemovalOrder::random, RemovalOrder::sequential})
        for (const int region : studiedRegions(subject.job))
            addOnce(points, orderPoint(subject, order, region));
    return points;
}

std::vector<StudyPoint> regionPoints(const StudySubject& subject) {
    std::vector<StudyPoint> points{undecimated(subject)};
    for (const RegionCurve& curve : regionCurves(subject))
        for (const int region : studiedRegions(subject.job))
            addOnce(points, regionPoint(subject, curve, region));
    return points;
}

std::vector<StudyPoint> allowancePoints(const StudySubject& subject) {
    std::vector<StudyPoint> points;
    for (const double allowance : kAllowances)
        addOnce(points, allowancePoint(subject, allowance));
    return points;
}

std::vector<StudyPoint> periodPoints(const StudySubject& subject) {
    std::vector<StudyPoint> points{undecimated(subject), periodPoint(subject, -1)};
    for (const int period : kPeriods)
        addOnce(points, periodPoint(subject, period));
    return points;
}

std::vector<StudyPoint> methodPoints(const StudySubject& subject) {
    std::vector<StudyPoint> points;
    for (const MethodCurve& curve : methodCurves(subject, kMethodBlocks))
        addOnce(points, curve.point);
    return points;
}

constexpr std::array kSweeps{
    SweepRow{SweepKind::order, "order", PROVEOUT_TEXT("Core", "Removal order"), orderPoints},
    SweepRow{SweepKind::region, "region", PROVEOUT_TEXT("Core", "Region size"), regionPoints},
    SweepRow{SweepKind::allowance, "allowance", PROVEOUT_TEXT("Core", "Error allowance"), allowancePoints},
    SweepRow{SweepKind::period, "period", PROVEOUT_TEXT("Core", "Decimation period"), periodPoints},
    SweepRow{SweepKind::method, "method", PROVEOUT_TEXT("Core", "Methods"), methodPoints},
};

Chart methodsOf(const StudySubject& subject, std::span<const StudyRun> runs) {
    return methodChart(subject, runs, kMethodBlocks);
}

constexpr std::array kFigures{
    FigureRow{"fig02", "2, 3", SweepKind::method,
              PROVEOUT_TEXT("Core", "Global and local decimation: rendering time of each frame"), methodsOf},
    FigureRow{"fig07", "7", SweepKind::order,
              PROVEOUT_TEXT("Core", "Decimation time and triangles by the order of removal"), orderChart},
    FigureRow{"fig08", "8", SweepKind::region, PROVEOUT_TEXT("Core", "Rendering time and region size"),
              regionChart},
    FigureRow{"fig09", "9, 14", SweepKind::allowance,
              PROVEOUT_TEXT("Core", "Triangles and rendering time against no decimation"), allowanceChart},
    FigureRow{"fig10", "10, 15", SweepKind::allowance,
              PROVEOUT_TEXT("Core", "Number of triangles of each frame"), facesChart},
    FigureRow{"fig11", "11, 16", SweepKind::allowance,
              PROVEOUT_TEXT("Core", "Rendering time of each frame, averages over 20 steps"), timesChart},
    FigureRow{"fig12", "12", SweepKind::period,
              PROVEOUT_TEXT("Core", "Number of triangles and rendering time by the decimation period"),
              periodChart},
};

} // namespace

std::string englishWords(const char* text) {
    return text;
}

std::span<const SweepRow> sweepTable() {
    return kSweeps;
}

std::span<const FigureRow> figureTable() {
    return kFigures;
}

std::vector<StudyVariant> studyVariants(const DecimationParameters& base) {
    std::vector<StudyVariant> variants;
    for (const DecimationMethodRow& method : decimationMethods()) {
        if (method.create == nullptr || method.wholeMap)
            continue;
        DecimationParameters parameters = base;
        parameters.method = method.method;
        parameters.regionCells = method.defaultRegion;
        parameters.period = method.defaultPeriod;
        const std::string key = kMethodChoices[static_cast<std::size_t>(method.method)].key;
        if (method.method == DecimationMethod::lee) {
            DecimationParameters letter = parameters;
            letter.certify = false;
            letter.borders = BorderRule::paper;
            variants.push_back({key + "-paper", letter});
        }
        variants.push_back({key, parameters});
    }
    return variants;
}

std::vector<StudyPoint> pointsOf(std::span<const SweepKind> kinds, const StudySubject& subject) {
    std::vector<StudyPoint> points;
    for (const SweepRow& sweep : kSweeps)
        if (std::ranges::find(kinds, sweep.kind) != kinds.end())
            for (const StudyPoint& point : sweep.points(subject))
                addOnce(points, point);
    return points;
}

std::vector<int> studiedRegions(const StudyJob& job) {
    const auto grid = makeGrid(job.setup->stock, job.setup->spacing);
    const int cells = grid ? std::max(grid->nx, grid->ny) - 1 : 0;
    std::vector<int> regions;
    for (const int region : kRegions)
        if (region <= cells || regions.empty())
            regions.push_back(region);
    return regions;
}

std::span<const int> studiedPeriods() {
    return kPeriods;
}

std::span<const double> studiedAllowances() {
    return kAllowances;
}

} // namespace proveout
