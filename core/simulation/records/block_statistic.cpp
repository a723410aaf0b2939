// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/records/block_statistic.h"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

#include "core/base/text.h"
#include "core/simulation/records/block_records.h"

namespace proveout {

namespace {

/// A value that the simulation has recorded itself.
template<auto member>
BlockValue noted(const ExecutedRun& run, std::size_t block) {
    return run.rows[block].*member;
}

/// The same for values of the surface after the block, and of a block that was played.
template<auto member>
BlockValue ofSurface(const ExecutedRun& run, std::size_t block) {
    return run.rows[block].surfaceIsMeasured() ? noted<member>(run, block) : BlockValue();
}

template<auto member>
BlockValue played(const ExecutedRun& run, std::size_t block) {
    return run.rows[block].isPlayed() ? noted<member>(run, block) : BlockValue();
}

BlockValue flag(bool set) {
    return std::uint32_t{set};
}

BlockValue cuts(const ExecutedRun& run, std::size_t block) {
    return flag(run.rows[block].cuts());
}

BlockValue firstContact(const ExecutedRun& run, std::size_t block) {
    return flag(isFirstContact(run.rows, block));
}

BlockValue rate(const ExecutedRun& run, std::size_t block) {
    if (run.program == nullptr)
        return {};
    const auto known = removalRate(*run.program, block, run.rows[block]);
    return known ? BlockValue(*known) : BlockValue();
}

BlockValue feedLength(const ExecutedRun& run, std::size_t block) {
    return run.program == nullptr ? BlockValue() : wayOf(*run.program, block).feedLength;
}

constexpr StatisticPlot kVolume{"removed-volume", PROVEOUT_TEXT("Plots", "Removed Volume"),
                                PROVEOUT_TEXT("Plots", "Volume (mm³)"), PROVEOUT_TEXT("Plots", "Removed"), 4};
constexpr StatisticPlot kDepth{"axial-depth", PROVEOUT_TEXT("Plots", "Axial Depth"),
                               PROVEOUT_TEXT("Plots", "Depth ap (mm)"), PROVEOUT_TEXT("Plots", "Axial depth"),
                               0};
constexpr StatisticPlot kEngagement{"radial-engagement", PROVEOUT_TEXT("Plots", "Radial Engagement"),
                                    PROVEOUT_TEXT("Plots", "Width ae (mm)"),
                                    PROVEOUT_TEXT("Plots", "Radial engagement"), 3};

constexpr std::array kStatistics{
    BlockStatistic{"facesShown", ofSurface<&BlockStatistics::facesShown>},
    BlockStatistic{"facesFull", noted<&BlockStatistics::facesFull>},
    BlockStatistic{"regionsDirty", ofSurface<&BlockStatistics::regionsDirty>},
    BlockStatistic{"regionsDecimated", played<&BlockStatistics::regionsDecimated>},
    BlockStatistic{"cutSeconds", played<&BlockStatistics::cutSeconds>},
    BlockStatistic{"decimationSeconds", played<&BlockStatistics::decimationSeconds>},
    BlockStatistic{"removedMm3", noted<&BlockStatistics::removedMm3>, &kVolume},
    BlockStatistic{"maxDepthMm", noted<&BlockStatistics::maxDepth>, &kDepth},
    BlockStatistic{"radialEngagementMm", noted<&BlockStatistics::radialEngagement>, &kEngagement},
    BlockStatistic{"cuts", cuts},
    BlockStatistic{"firstContact", firstContact},
    BlockStatistic{"rateMm3PerMin", rate},
    BlockStatistic{"feedLengthMm", feedLength},
};

} // namespace

std::span<const BlockStatistic> blockStatistics() {
    return kStatistics;
}

const BlockStatistic* findStatistic(std::string_view column) {
    const auto found = std::ranges::find_if(
        kStatistics, [column](const BlockStatistic& row) { return row.column == column; });
    return found == kStatistics.end() ? nullptr : &*found;
}

double asNumber(const BlockValue& value) {
    return std::visit(
        [](auto known) {
            if constexpr (std::is_same_v<decltype(known), std::monostate>)
                return std::numeric_limits<double>::quiet_NaN();
            else
                return static_cast<double>(known);
        },
        value);
}

} // namespace proveout
