// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the rims of any moment of a simulation.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/work_context.h"
#include "core/nc/program/program.h"
#include "core/simulation/run/motion_index.h"
#include "core/simulation/setup/setup.h"
#include "core/simulation/setup/tool_choice.h"
#include "core/zmap/grid_part.h"
#include "core/zmap/stock_shape.h"
#include "core/zmap/zmap.h"

namespace proveout {

struct Frame;

/// Only those between nearly level parts of the surface: points beside others stay where they are. The rims
/// of a tile are a function of the motions that may have lowered it and its surroundings. So only tiles over
/// which other motions were cut than in the moment for which they were found last are looked at again,
/// wherever in the program that was, and if it was edited since then. Owned by one thread, which need not be
/// that of the simulation; works on tiles in parallel inside.
class RimFinder {
public:
    RimFinder() = default;
    /// For moments whose map is this part of the stock of their setup.
    explicit RimFinder(const GridPart& part) : m_part(part) {}

    /// The z-map of a moment, with its rims and walls; without them if it was stopped. Tiles with the same
    /// walls as in the last result keep their pointers. Tiles that were found before a stop count for the
    /// next call.
    [[nodiscard]] ZMapSnapshot find(const Frame& moment, const WorkContext& context = {});

    /// The walls of a moment, as far as they are found in some time, for pictures while the program is
    /// played: those of tiles that are not looked at in time are left out, as are those of tiles over which
    /// there are too many motions. What is found counts for the next call.
    [[nodiscard]] WallPoints findSome(const Frame& moment, std::chrono::nanoseconds time);

private:
    using Clock = std::chrono::steady_clock;

    /// Makes this the finder of a moment; returns its motions.
    std::size_t begin(const Frame& moment);
    void restart(const Frame& moment);
    /// Keeps what the last program has in common with that of the moment.
    void follow(const Frame& moment);
    /// Both are false if they were stopped; `motions` of the program have been cut.
    bool readMotions(std::size_t motions, const std::stop_token& stop,
                     Clock::time_point until = Clock::time_point::max());
    bool findTiles(const ZMapSnapshot& zmap, std::size_t motions, const WorkContext& context);
    [[nodiscard]] std::vector<std::size_t> outdatedTiles(std::size_t motions) const;
    [[nodiscard]] RimTilePtr rimsOf(const ZMapSnapshot& zmap, std::size_t tile, std::size_t motions,
                                    const std::stop_token& stop) const;
    /// Looks at some of the tiles, and leaves the others in `tiles`.
    void findUntil(const ZMapSnapshot& zmap, std::size_t motions, Clock::time_point until,
                   std::vector<std::size_t>& tiles);
    [[nodiscard]] bool isQuick(std::size_t tile, std::size_t motions) const;
    void makeWalls(ZMapSnapshot& zmap, const RimMap& rims);
    void adopt(std::size_t tile, RimTilePtr rims, std::size_t end);

    std::optional<GridPart> m_part;           ///< nothing: the maps are of the whole stock
    std::shared_ptr<const Setup> m_setup;     ///< of the last moment; null: there was none
    std::unique_ptr<const StockTop> m_uncut;  ///< null: the whole box
    std::shared_ptr<const Program> m_program; ///< that of the index
    ToolChoice m_tools;
    MotionIndex m_index;
    RimMap m_rims;
    RimMap m_rimsOfWalls; ///< those from which the walls were made
    WallPoints m_walls;
    std::size_t m_nextTile = 0;        ///< where findSome() goes on
    std::vector<std::uint32_t> m_ends; ///< by tile: MotionIndex::endOver() of the motions of its rims
};

} // namespace proveout
