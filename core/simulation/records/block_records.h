// SPDX-License-Identifier: GPL-3.0-or-later
// What the records of single blocks say of them, and of a run.
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

/// The way of one block, mm and seconds. What is a feed of 0, unknown or per revolution takes no known time.
struct BlockWay {
    double feedLength = 0;
    double rapidLength = 0;
    double feedSeconds = 0;  ///< of the feed motions, at their feed
    bool feedIsKnown = true; ///< of all of them
};
[[nodiscard]] BlockWay wayOf(const Program& program, std::size_t block);

/// The volume that the block removes in a minute, mm³; nothing where its feed is not known or it is a rapid.
[[nodiscard]] std::optional<double> removalRate(const Program& program, std::size_t block,
                                                const BlockStatistics& row);

/// The same in the time that the machine takes for the motions of the block, so with its accelerations, and
/// of rapids too. 0 where it removes nothing or takes no time.
[[nodiscard]] double machineRemovalRate(const MachineTimes& times, std::size_t block,
                                        const BlockStatistics& row);

/// The volume that the block removes on a millimetre of its path, mm³: the cross-section of what is cut. 0
/// where it removes nothing or has no length.
[[nodiscard]] double removalPerLength(const MachineTimes& times, std::size_t block,
                                      const BlockStatistics& row);

/// Whether the cutter comes into material from air in this block: it cuts, and the one before did not.
[[nodiscard]] bool isFirstContact(const PersistentArray<BlockStatistics>& rows, std::size_t block);

/// The sums and extremes of a run. A block counts as a whole: it cuts or goes through air.
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
    std::optional<std::size_t> firstContact; ///< the first of all
};
/// Of the first `blocks` rows.
[[nodiscard]] RunTotals totalsOf(const Program& program, const PersistentArray<BlockStatistics>& rows,
                                 std::size_t blocks);

/// The place of the cutter's tip on the way of a block where it first touches the stock that all blocks
/// before it have left, exact to StockContact::kTolerance; arcs are followed to kChordError. Nothing where it
/// touches none, or was stopped. Takes in all motions before the block, so it is for when somebody asks.
[[nodiscard]] std::optional<Vec3> contactPlace(const std::shared_ptr<const Setup>& setup,
                                               const Program& program, std::size_t block,
                                               const WorkContext& context = {});

} // namespace proveout
