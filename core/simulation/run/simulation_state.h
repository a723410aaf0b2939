// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a simulation, and how it moves from block to block. Only simulation*.cpp and PlayAhead include
// this.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "core/simulation/run/checkpoints.h"
#include "core/simulation/run/finding_log.h"
#include "core/simulation/run/kept_records.h"
#include "core/simulation/run/schedule.h"
#include "core/simulation/run/simulation.h"
#include "core/simulation/run/surface_at_rest.h"
#include "core/simulation/run/surface_memory.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

struct PortionCutting;

/// The stock at one position in the program.
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
    Diagnostics stockFindings; ///< what the map cannot represent of the uncut stock
    Diagnostics setupFindings; ///< the parts of the setup that do not fit the program

    StockRun stock;
    Surface surface;
    /// The moment from which the decimated regions were made: they have its heights.
    Checkpoint base;
    /// Some regions that the schedule would have decimated are still drawn from the z-map, because the work
    /// was stopped.
    bool behind = false;
    /// If the decimation of the present block was stopped: the row to restore if the block is left like this.
    std::optional<BlockStatistics> rowBefore;

    SurfaceMemory surfaceMemory;
    SurfaceAtRest atRest;
    KeptRecords keptRecords;

    Checkpoints checkpoints;
    PersistentArray<BlockStatistics> rows;
    FindingLog findings;
    Effort effort;

    /// Sets the program, with its tools, and the findings about the setup for it.
    void useProgram(std::shared_ptr<const Program> wanted);

    // --- one block

    /// Nothing if it was stopped: the block counts as not executed.
    std::optional<CutRecord> cutNext(StockRun& run, FindingLog* log, const WorkContext& context);
    /// Cuts the next `count` blocks at once, which have been executed before, so that everything except the
    /// heights is known; false if it was stopped: none of them counts.
    bool cutMany(StockRun& run, std::size_t count, PortionCutting& cutting, const WorkContext& context);
    /// Cuts the next `count` blocks at once, which have never been executed; their rows have no times and no
    /// faces. False if it was stopped: none of them counts.
    bool cutNew(StockRun& run, std::size_t count, PortionCutting& cutting, const WorkContext& context);
    /// Counts blocks that were cut into `run`, and the time for them; adds a checkpoint if one is due.
    void countCut(StockRun& run, std::size_t blocks, double seconds);
    void step(const WorkContext& context);

    // --- the surface

    /// Decimates dirty regions with the heights of `base`; returns the seconds it took.
    double decimate(std::span<const std::size_t> regions, const WorkContext& context);
    /// From now on nothing is decimated: all regions are drawn from the z-map.
    void giveUpSurface();
    /// Writes the present surface into the row of the present block.
    void noteSurface();
    /// Brings the surface into the state that the schedule requires: the regions that differ from `base` are
    /// dirty.
    void settle(const WorkContext& context);
    /// Called when leaving a block whose decimation was stopped: its row would describe a surface that never
    /// existed.
    void abandonUnfinished();

    // --- any block

    /// The nearest known checkpoint at or before `block`.
    [[nodiscard]] Checkpoint nearest(std::size_t block) const;
    /// Cuts up to `block`, in portions; false if it was stopped, at an earlier block.
    bool cutTo(StockRun& run, std::size_t block, const WorkContext& context);
    /// Moves to any block, and settles the surface there.
    void seek(std::size_t block, const WorkContext& context);
    void moveTo(StockRun&& run);
    /// After a stop: a replay has no result, but what was cut beyond the `known` blocks is kept, with a
    /// surface that is drawn from the z-map where it differs.
    void keepNew(StockRun&& run, std::size_t known);
    /// Moves to the nearest known checkpoint at or before `kept`, without any work; everything after it is
    /// discarded.
    void fallBack(std::size_t kept);
    void useParameters(const DecimationParameters& wanted);
};

} // namespace proveout
