// SPDX-License-Identifier: GPL-3.0-or-later
// What a simulation is made of, and how it goes from block to block. Only simulation*.cpp include this.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "core/simulation/run/checkpoints.h"
#include "core/simulation/run/finding_log.h"
#include "core/simulation/run/schedule.h"
#include "core/simulation/run/simulation.h"
#include "core/simulation/run/surface_at_rest.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

/// The stock on its way through the program.
struct StockRun {
    ZMap zmap;
    std::size_t block = 0;
    double removedMm3 = 0;
    double cutSeconds = 0;

    [[nodiscard]] Checkpoint moment() const { return {block, zmap.snapshot(), removedMm3, cutSeconds}; }
    void continueFrom(const Checkpoint& moment) {
        zmap = ZMap(moment.zmap);
        block = moment.block;
        removedMm3 = moment.removedMm3;
        cutSeconds = moment.cutSeconds;
    }
};

struct Simulation::State {
    std::shared_ptr<const Program> program;
    std::shared_ptr<const Setup> setup;
    DecimationParameters parameters;
    Schedule schedule{parameters};
    ToolChoice tools;
    Diagnostics stockFindings; ///< what the map cannot hold of the uncut stock
    Diagnostics setupFindings; ///< what of the setup does not fit the program

    StockRun stock;
    Surface surface;
    /// What the decimated regions were made of: they have the heights of this moment.
    Checkpoint base;
    /// Regions are still drawn from the z-map that the schedule would have decimated: somebody stopped us.
    bool behind = false;
    struct UnfinishedRow {
        bool first;          ///< the block had never been executed before
        BlockStatistics old; ///< else: what its row was
    };
    std::optional<UnfinishedRow> unfinished;

    SurfaceAtRest atRest;

    Checkpoints checkpoints;
    PersistentArray<BlockStatistics> rows;
    FindingLog findings;
    Effort effort;

    /// With the tools of that program, and what is to be said about the setup beside it.
    void useProgram(std::shared_ptr<const Program> wanted);

    // --- one block

    /// Nothing where it was stopped: the block counts as not executed.
    std::optional<CutRecord> cutNext(StockRun& run, FindingLog* log, const WorkContext& context);
    /// The next `count` blocks at once, which have been executed before, so that what they do is known but
    /// for the heights; false where it was stopped: none of them counts.
    bool cutMany(StockRun& run, std::size_t count, const WorkContext& context);
    /// Takes a checkpoint where the last one is long ago, in cutting time or in blocks.
    void rememberMoment(const StockRun& run);
    /// The box of a slanted motion holds regions that it never touched: only changed heights count.
    void touchChanged(const IndexRect& changed);
    void step(const WorkContext& context);

    // --- the surface

    /// Decimates dirty regions by `base`; returns the seconds it took.
    double decimate(std::span<const std::size_t> regions, const WorkContext& context);
    /// The dirty regions without those in `without` (ascending).
    [[nodiscard]] std::vector<std::size_t> dirtyRegions(std::span<const std::size_t> without) const;
    /// The row of the present block tells of the present surface.
    void noteSurface();
    /// Brings the surface to where the schedule has it: dirty are the regions that differ from `base`.
    void settle(const WorkContext& context);
    /// Leaving a block whose decimation was stopped: its row would tell of a surface that never was.
    void abandonUnfinished();

    // --- any block

    /// The nearest known moment at or before `block`.
    [[nodiscard]] Checkpoint nearest(std::size_t block) const;
    /// Replays up to `block`; false where it was stopped.
    bool replay(StockRun& run, std::size_t block, const WorkContext& context);
    /// Goes to a block that has been executed before, and settles the surface there.
    void jump(std::size_t block, const WorkContext& context);
    /// To the nearest known moment at or before `kept`, without any work: nothing may stay of what came
    /// behind.
    void fallBack(std::size_t kept);
    void seek(std::size_t block, const WorkContext& context);
    void useParameters(const DecimationParameters& wanted);
};

} // namespace proveout
