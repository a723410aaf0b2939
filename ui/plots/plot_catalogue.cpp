// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_catalogue.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <QtGlobal>

#include "core/simulation/records/block_records.h"
#include "core/simulation/records/block_statistic.h"

namespace proveout {
namespace {

constexpr const char* kBlocks = QT_TRANSLATE_NOOP("Plots", "Block"); ///< label of the x axis

// Fig. 10 of the paper: the number of triangles grows with every cut and falls with every decimation.
constexpr std::array kFaces{
    PlotSeries{"facesFull", QT_TRANSLATE_NOOP("Plots", "Without decimation"), 1, Qt::DashLine,
               Qt::SolidPattern},
    PlotSeries{"facesShown", QT_TRANSLATE_NOOP("Plots", "Shown"), 0, Qt::SolidLine, Qt::NoBrush},
};

double faces(const PlotInput& input, std::size_t row, std::size_t series) {
    static const std::array curves{findStatistic(kFaces[0].key), findStatistic(kFaces[1].key)};
    return asNumber(curves[series]->read({input.blocks, input.program}, row));
}

// Fig. 11 of the paper: the time spent on a frame. Cutting and decimation are measured per block, uploading
// and drawing per frame, which covers many blocks in a fast run or after a jump.
constexpr std::array kTimes{
    PlotSeries{"cutMs", QT_TRANSLATE_NOOP("Plots", "Cutting"), 0, Qt::SolidLine, Qt::SolidPattern},
    PlotSeries{"decimationMs", QT_TRANSLATE_NOOP("Plots", "Decimation"), 2, Qt::SolidLine, Qt::BDiagPattern},
    PlotSeries{"uploadMs", QT_TRANSLATE_NOOP("Plots", "Upload"), 3, Qt::SolidLine, Qt::FDiagPattern},
    PlotSeries{"drawMs", QT_TRANSLATE_NOOP("Plots", "Drawing"), 1, Qt::SolidLine, Qt::Dense5Pattern},
};

const FrameStatistics* pictureOf(const PlotInput& input, std::size_t row) {
    const auto found = std::ranges::upper_bound(input.frames, row, {}, &FrameStatistics::lastBlock);
    return found != input.frames.end() && found->firstBlock <= row ? &*found : nullptr;
}

PictureBlocks pictureBlocks(const PlotInput& input, std::size_t row) {
    const FrameStatistics* picture = pictureOf(input, row);
    return picture != nullptr ? PictureBlocks{picture->firstBlock, picture->lastBlock} : PictureBlocks();
}

/// Rounded to single precision, as it was measured, so that 0.0005 s gives 0.5 ms.
double milliseconds(const PlotInput& input, std::size_t row, std::size_t series) {
    constexpr std::size_t kOfBlock = 2; // curves that are measured per block
    if (series < kOfBlock)
        return double{1e3F *
                      (series == 0 ? input.blocks[row].cutSeconds : input.blocks[row].decimationSeconds)};
    const FrameStatistics* picture = pictureOf(input, row);
    if (picture == nullptr)
        return std::numeric_limits<double>::quiet_NaN();
    const float seconds = series == kOfBlock ? picture->uploadSeconds : picture->drawSeconds;
    return double{1e3F * seconds} / (picture->lastBlock - picture->firstBlock);
}

constexpr std::array kRate{
    PlotSeries{"machineRateMm3PerMin", QT_TRANSLATE_NOOP("Plots", "Removal rate"), 2, Qt::SolidLine,
               Qt::SolidPattern},
};

constexpr std::array kPerLength{
    PlotSeries{"removedMm3PerMm", QT_TRANSLATE_NOOP("Plots", "Volume per length"), 1, Qt::SolidLine,
               Qt::SolidPattern},
};

using ByTimes = double (*)(const MachineTimes&, std::size_t block, const BlockStatistics&);

/// A gap where the times of the block are not known yet: 0 would mean an air cut.
template<ByTimes value>
double timed(const PlotInput& input, std::size_t row, std::size_t) {
    if (input.times == nullptr || row + 1 >= input.times->secondsAfter.size())
        return std::numeric_limits<double>::quiet_NaN();
    return value(*input.times, row, input.blocks[row]);
}

/// The curves of the statistics that have a plot of their own, in the sequence of the table.
std::vector<PlotSeries> ownCurves() {
    std::vector<PlotSeries> curves;
    for (const BlockStatistic& statistic : blockStatistics())
        if (statistic.plot != nullptr)
            curves.push_back({statistic.column, statistic.plot->curve, statistic.plot->colour, Qt::SolidLine,
                              Qt::SolidPattern});
    return curves;
}

void addOwn(std::vector<PlotSpec>& plots) {
    static const std::vector<PlotSeries> curves = ownCurves();
    auto curve = curves.begin();
    for (const BlockStatistic& statistic : blockStatistics()) {
        if (statistic.plot == nullptr)
            continue;
        plots.push_back({statistic.plot->id, statistic.plot->title, kBlocks, statistic.plot->axis, false,
                         false, false, std::span(curve++, 1),
                         [&statistic](const PlotInput& input, std::size_t row, std::size_t) {
                             return asNumber(statistic.read({input.blocks, input.program}, row));
                         }});
    }
}

std::vector<PlotSpec> makePlots() {
    std::vector<PlotSpec> plots{
        {"faces", QT_TRANSLATE_NOOP("Plots", "Triangles"), kBlocks, QT_TRANSLATE_NOOP("Plots", "Triangles"),
         false, false, true, kFaces, faces, nullptr, true},
        {"block-time", QT_TRANSLATE_NOOP("Plots", "Time per Block"), kBlocks,
         QT_TRANSLATE_NOOP("Plots", "Time (ms)"), true, false, false, kTimes, milliseconds, pictureBlocks,
         true},
    };
    addOwn(plots);
    plots.push_back({"removal-rate", QT_TRANSLATE_NOOP("Plots", "Removal Rate"), kBlocks,
                     QT_TRANSLATE_NOOP("Plots", "MRR (mm³/min)"), false, true, false, kRate,
                     timed<machineRemovalRate>});
    plots.push_back({"volume-per-length", QT_TRANSLATE_NOOP("Plots", "Volume per Length"), kBlocks,
                     QT_TRANSLATE_NOOP("Plots", "Volume (mm³/mm)"), false, true, false, kPerLength,
                     timed<removalPerLength>});
    return plots;
}

} // namespace

std::span<const PlotSpec> plotCatalogue() {
    static const std::vector<PlotSpec> plots = makePlots();
    return plots;
}

} // namespace proveout
