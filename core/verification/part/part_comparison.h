// SPDX-License-Identifier: GPL-3.0-or-later
// The stock that a program leaves, compared with the part that it is to make.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/work_context.h"
#include "core/part/deviation.h"
#include "core/part/islands.h"
#include "core/simulation/run/frame.h"

namespace proveout {

/// An island with what made it.
struct ComparedIsland {
    Island of;
    bool isUncut = false;                  ///< no tool has cut the stock there
    std::optional<std::size_t> block = {}; ///< 0-based: the one that cut too deep, or left the stock
    int line = 0;                          ///< of the block; 0: none
    int tool = 0;                          ///< of the block
};

/// How much of the part's surface, as points of the grid, deviates by how much.
struct DeviationHistogram {
    static constexpr int kBins = 41;
    static constexpr int kMiddle = 20; ///< the bin around 0
    /// Of a bin, mm; the first and the last also count what is beyond.
    double width = 0;
    std::array<std::size_t, kBins> points{};

    [[nodiscard]] double middleOf(int bin) const { return width * (bin - kMiddle); }
};

/// Immutable once made; any thread.
struct PartComparison {
    PartTolerance tolerance;
    Deviation deviation; ///< of the end of the program
    /// The deepest ones, at most kMostIslands. Blocks are known of the first kMostBlamed of them.
    std::vector<ComparedIsland> islands;
    std::size_t gouges = 0; ///< of all islands
    std::size_t excesses = 0;
    double missingMm3 = 0; ///< of all islands
    double leftMm3 = 0;
    std::size_t judgedPoints = 0;
    double lowestMm = 0; ///< the extreme deviations
    double highestMm = 0;
    DeviationHistogram histogram;

    static constexpr std::size_t kMostIslands = 10'000;
    static constexpr std::size_t kMostBlamed = 200;
};

/// Compares the map of a frame, which is the end of its program; gives it its walls if it has none. Null if
/// it was stopped.
[[nodiscard]] std::shared_ptr<const PartComparison> comparePart(const Frame& end,
                                                                std::shared_ptr<const DesignPart> part,
                                                                const PartTolerance& tolerance,
                                                                const WorkContext& context = {});

/// The memory for it, beside the part and the map.
[[nodiscard]] double comparisonBytes(const Grid& grid);

/// How much of the box of a part is over the stock and not below its floor, as a fraction of its volume.
[[nodiscard]] double overlap(const DesignPart& part, const StockBox& stock);

} // namespace proveout
