// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_catalogue.h"

#include <array>
#include <limits>

#include <QtGlobal>

#include "core/simulation/block_records.h"

namespace proveout {
namespace {

double blockNumber(const PlotInput&, std::size_t row) {
    return static_cast<double>(row + 1);
}

double blockBefore(const PlotInput&, std::size_t row) {
    return static_cast<double>(row);
}

double firstBlock(const PlotInput& input, std::size_t row) {
    return input.frames[row].firstBlock;
}

double lastBlock(const PlotInput& input, std::size_t row) {
    return input.frames[row].lastBlock;
}

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

// The paper's Fig. 11: where the time of a picture goes. The paper draws every block; where a picture stands
// for many (a fast run, a jump to the end), the mean of a block is what compares with the others.
constexpr std::array kTimes{
    PlotSeries{"cutMs", QT_TRANSLATE_NOOP("Plots", "Cutting"), 0, Qt::SolidLine, Qt::SolidPattern},
    PlotSeries{"decimationMs", QT_TRANSLATE_NOOP("Plots", "Decimation"), 2, Qt::SolidLine, Qt::BDiagPattern},
    PlotSeries{"uploadMs", QT_TRANSLATE_NOOP("Plots", "Upload"), 3, Qt::SolidLine, Qt::FDiagPattern},
    PlotSeries{"drawMs", QT_TRANSLATE_NOOP("Plots", "Drawing"), 1, Qt::SolidLine, Qt::Dense5Pattern},
};

double milliseconds(const PlotInput& input, std::size_t row, std::size_t series) {
    const FrameStatistics& frame = input.frames[row];
    const std::array seconds{frame.cutSeconds, frame.decimationSeconds, frame.uploadSeconds,
                             frame.drawSeconds};
    return 1e3 * double{seconds.at(series)} / (frame.lastBlock - frame.firstBlock);
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
    {"faces", QT_TRANSLATE_NOOP("Plots", "Faces"), QT_TRANSLATE_NOOP("Plots", "Block"),
     QT_TRANSLATE_NOOP("Plots", "Triangles"), PlotRows::blocks, false, false, kFaces, blockBefore,
     blockNumber, faces},
    {"block-time", QT_TRANSLATE_NOOP("Plots", "Time per Block"), QT_TRANSLATE_NOOP("Plots", "Block"),
     QT_TRANSLATE_NOOP("Plots", "Time (ms)"), PlotRows::frames, true, false, kTimes, firstBlock, lastBlock,
     milliseconds},
    {"removed-volume", QT_TRANSLATE_NOOP("Plots", "Removed Volume"), QT_TRANSLATE_NOOP("Plots", "Block"),
     QT_TRANSLATE_NOOP("Plots", "Volume (mm³)"), PlotRows::blocks, false, false, kVolume, blockBefore,
     blockNumber, volume},
    {"axial-depth", QT_TRANSLATE_NOOP("Plots", "Axial Depth"), QT_TRANSLATE_NOOP("Plots", "Block"),
     QT_TRANSLATE_NOOP("Plots", "Depth (mm)"), PlotRows::blocks, false, false, kDepth, blockBefore,
     blockNumber, depth},
    {"radial-engagement", QT_TRANSLATE_NOOP("Plots", "Radial Engagement"),
     QT_TRANSLATE_NOOP("Plots", "Block"), QT_TRANSLATE_NOOP("Plots", "Width (mm)"), PlotRows::blocks, false,
     false, kEngagement, blockBefore, blockNumber, engagement},
    {"removal-rate", QT_TRANSLATE_NOOP("Plots", "Removal Rate"), QT_TRANSLATE_NOOP("Plots", "Block"),
     QT_TRANSLATE_NOOP("Plots", "Rate (mm³/min)"), PlotRows::blocks, false, true, kRate, blockBefore,
     blockNumber, timed<machineRemovalRate>},
    {"volume-per-length", QT_TRANSLATE_NOOP("Plots", "Volume per Length"),
     QT_TRANSLATE_NOOP("Plots", "Block"), QT_TRANSLATE_NOOP("Plots", "Volume (mm³/mm)"), PlotRows::blocks,
     false, true, kPerLength, blockBefore, blockNumber, timed<removalPerLength>},
}};

} // namespace

std::span<const PlotSpec> plotCatalogue() {
    return kPlots;
}

std::size_t rowCount(const PlotSpec& plot, const PlotInput& input) {
    return plot.rows == PlotRows::blocks ? input.blocks.size() : input.frames.size();
}

} // namespace proveout
