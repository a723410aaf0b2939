// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_catalogue.h"

#include <algorithm>
#include <array>
#include <limits>

#include <QtGlobal>

#include "core/simulation/records/block_records.h"

namespace proveout {
namespace {

// The paper's Fig. 10: faces grow with every cut and fall with every decimation.
constexpr std::array kFaces{
    PlotSeries{"facesFull", QT_TRANSLATE_NOOP("Plots", "Without decimation"), 1, Qt::DashLine,
               Qt::SolidPattern},
    PlotSeries{"facesShown", QT_TRANSLATE_NOOP("Plots", "Shown"), 0, Qt::SolidLine, Qt::NoBrush},
};

double faces(const PlotInput& input, std::size_t row, std::size_t series) {
    const BlockStatistics& block = input.blocks[row];
    return series == 0 ? block.facesFull : block.facesShown;
}

// The paper's Fig. 11: where the time of a picture goes. Cutting and decimation are measured block by block;
// uploading and drawing by picture, which in a fast run or after a jump stands for many blocks.
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

/// In single precision, as it was measured: 0.0005 s are 0.5 ms then.
double milliseconds(const PlotInput& input, std::size_t row, std::size_t series) {
    constexpr std::size_t kOfBlock = 2; // curves
    if (series < kOfBlock)
        return double{1e3F *
                      (series == 0 ? input.blocks[row].cutSeconds : input.blocks[row].decimationSeconds)};
    const FrameStatistics* picture = pictureOf(input, row);
    if (picture == nullptr)
        return std::numeric_limits<double>::quiet_NaN();
    const float seconds = series == kOfBlock ? picture->uploadSeconds : picture->drawSeconds;
    return double{1e3F * seconds} / (picture->lastBlock - picture->firstBlock);
}

constexpr std::array kVolume{
    PlotSeries{"removedMm3", QT_TRANSLATE_NOOP("Plots", "Removed"), 4, Qt::SolidLine, Qt::SolidPattern},
};

double volume(const PlotInput& input, std::size_t row, std::size_t) {
    return double{input.blocks[row].removedMm3};
}

constexpr std::array kDepth{
    PlotSeries{"maxDepthMm", QT_TRANSLATE_NOOP("Plots", "Axial depth"), 0, Qt::SolidLine, Qt::SolidPattern},
};

double depth(const PlotInput& input, std::size_t row, std::size_t) {
    return double{input.blocks[row].maxDepth};
}

constexpr std::array kEngagement{
    PlotSeries{"radialEngagementMm", QT_TRANSLATE_NOOP("Plots", "Radial engagement"), 3, Qt::SolidLine,
               Qt::SolidPattern},
};

double engagement(const PlotInput& input, std::size_t row, std::size_t) {
    return double{input.blocks[row].radialEngagement};
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

/// Where the times of the block are not known yet, there is a gap: 0 would say that it goes through air.
template<ByTimes value>
double timed(const PlotInput& input, std::size_t row, std::size_t) {
    if (input.times == nullptr || row + 1 >= input.times->secondsAfter.size())
        return std::numeric_limits<double>::quiet_NaN();
    return value(*input.times, row, input.blocks[row]);
}

const std::array<PlotSpec, 7> kPlots{{
    {"faces", QT_TRANSLATE_NOOP("Plots", "Triangles"), QT_TRANSLATE_NOOP("Plots", "Block"),
     QT_TRANSLATE_NOOP("Plots", "Triangles"), false, false, true, kFaces, faces},
    {"block-time", QT_TRANSLATE_NOOP("Plots", "Time per Block"), QT_TRANSLATE_NOOP("Plots", "Block"),
     QT_TRANSLATE_NOOP("Plots", "Time (ms)"), true, false, false, kTimes, milliseconds, pictureBlocks},
    {"removed-volume", QT_TRANSLATE_NOOP("Plots", "Removed Volume"), QT_TRANSLATE_NOOP("Plots", "Block"),
     QT_TRANSLATE_NOOP("Plots", "Volume (mm³)"), false, false, false, kVolume, volume},
    {"axial-depth", QT_TRANSLATE_NOOP("Plots", "Axial Depth"), QT_TRANSLATE_NOOP("Plots", "Block"),
     QT_TRANSLATE_NOOP("Plots", "Depth ap (mm)"), false, false, false, kDepth, depth},
    {"radial-engagement", QT_TRANSLATE_NOOP("Plots", "Radial Engagement"),
     QT_TRANSLATE_NOOP("Plots", "Block"), QT_TRANSLATE_NOOP("Plots", "Width ae (mm)"), false, false, false,
     kEngagement, engagement},
    {"removal-rate", QT_TRANSLATE_NOOP("Plots", "Removal Rate"), QT_TRANSLATE_NOOP("Plots", "Block"),
     QT_TRANSLATE_NOOP("Plots", "MRR (mm³/min)"), false, true, false, kRate, timed<machineRemovalRate>},
    {"volume-per-length", QT_TRANSLATE_NOOP("Plots", "Volume per Length"),
     QT_TRANSLATE_NOOP("Plots", "Block"), QT_TRANSLATE_NOOP("Plots", "Volume (mm³/mm)"), false, true, false,
     kPerLength, timed<removalPerLength>},
}};

} // namespace

std::span<const PlotSpec> plotCatalogue() {
    return kPlots;
}

} // namespace proveout
