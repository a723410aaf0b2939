// SPDX-License-Identifier: GPL-3.0-or-later
// Values derived from the records of single blocks and of a run.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "core/base/geometry.h"
#include "core/base/persistent_array.h"
#include "core/base/work_context.h"
#include "core/nc/program/program.h"
#include "core/simulation/run/statistics.h"
#include "core/simulation/setup/setup.h"
#include "core/simulation/time/machine_time.h"

namespace proveout {

/// The path of one block, mm and seconds. A feed that is 0, unknown or per revolution has no known time.
struct BlockWay {
    double feedLength = 0;
    double rapidLength = 0;
    double feedSeconds = 0;  ///< of the feed motions, at their feed rate
    bool feedIsKnown = true; ///< whether the feed of all of them is known
};
[[nodiscard]] BlockWay wayOf(const Program& program, std::size_t block);

/// The volume that the block removes per minute, mm³; nothing if its feed is unknown or it is a rapid.
[[nodiscard]] std::optional<double> removalRate(const Program& program, std::size_t block,
                                                const BlockStatistics& row);

/// The same in the time that the machine needs for the motions of the block, that is, with its accelerations,
/// and for rapids too. 0 if the block removes nothing or needs no time.
[[nodiscard]] double machineRemovalRate(const MachineTimes& times, std::size_t block,
                                        const BlockStatistics& row);

/// The volume that the block removes per millimetre of its path, mm³: the cross-section of the cut. 0 if it
/// removes nothing or has no length.
[[nodiscard]] double removalPerLength(const MachineTimes& times, std::size_t block,
                                      const BlockStatistics& row);

/// Whether the cutter enters material from air in this block: the block cuts, and the one before did not.
[[nodiscard]] bool isFirstContact(const PersistentArray<BlockStatistics>& rows, std::size_t block);

/// The sums and extremes of a run. A block counts as a whole: either it cuts, or it moves through air.
struct RunTotals {
    double cuttingLength = 0; ///< mm at feed, of blocks that cut
    double airLength = 0;     ///< mm at feed, of blocks that do not
    double rapidLength = 0;   ///< mm
    std::size_t cuttingBlocks = 0;
    std::size_t airBlocks = 0; ///< at feed
    std::size_t contacts = 0;  ///< blocks of first contact
    struct Extreme {
        float value = 0;
        std::size_t block = 0; ///< 0-based
    };
    Extreme axialDepth;
    Extreme radialEngagement;
    std::optional<std::size_t> firstContact; ///< the first block of first contact
};
/// The totals of the first `blocks` rows.
[[nodiscard]] RunTotals totalsOf(const Program& program, const PersistentArray<BlockStatistics>& rows,
                                 std::size_t blocks);

/// The position of the cutter's tip on the path of a block where it first touches the stock that all blocks
/// before it have left, exact to StockContact::kTolerance; arcs are followed to kChordError. Nothing if it
/// does not touch the stock, or was stopped. Evaluates all motions before the block, so it is computed only
/// on demand.
[[nodiscard]] std::optional<Vec3> contactPlace(const std::shared_ptr<const Setup>& setup,
                                               const Program& program, std::size_t block,
                                               const WorkContext& context = {});

} // namespace proveout
