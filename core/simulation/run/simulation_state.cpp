// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/simulation_state.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/memory.h"
#include "core/base/stop_watch.h"
#include "core/simulation/run/block_cutter.h"
#include "core/simulation/run/block_rows.h"
#include "core/simulation/run/changed_regions.h"
#include "core/simulation/run/portions.h"
#include "core/simulation/setup/automatic_grid.h"
#include "core/simulation/setup/stock_position.h"

namespace proveout {

namespace {

/// The dirty regions, except those in `without` (ascending).
std::vector<std::size_t> dirtyRegions(const Surface& surface, std::span<const std::size_t> without) {
    std::vector<std::size_t> regions = surface.listOfDirtyRegions();
    if (!without.empty())
        std::erase_if(regions,
                      [&](std::size_t region) { return std::ranges::binary_search(without, region); });
    return regions;
}

/// The parts of a setup that do not fit a program.
Diagnostics misfits(const Program& program, const Setup& setup, const ToolChoice& tools, const Grid& grid) {
    Diagnostics findings = misplacedStock(program, setup, tools);
    std::ranges::move(coarseGrid(grid, smallestCutter(program, setup, tools), setup.automaticGrid),
                      std::back_inserter(findings));
    return findings;
}

} // namespace

void Simulation::State::useProgram(std::shared_ptr<const Program> wanted) {
    program = std::move(wanted);
    tools = ToolChoice(*program, *setup);
    setupFindings = misfits(*program, *setup, tools, stock.zmap.grid());
}

// --- one block

std::optional<CutRecord> Simulation::State::cutNext(StockRun& run, FindingLog* log,
                                                    const WorkContext& context) {
    const StopWatch watch;
    auto record = cutBlock(run.zmap, *program, run.block, *setup, tools, log, context.stop);
    if (record)
        run.removedMm3 += record->removedMm3;
    countCut(run, record ? 1 : 0, watch.seconds());
    return record;
}

bool Simulation::State::cutMany(StockRun& run, std::size_t count, PortionCutting& cutting,
                                const WorkContext& context) {
    const StopWatch watch;
    const bool done =
        cutBlocks(run.zmap, *program, run.block, run.block + count, *setup, tools, context.stop, cutting);
    for (std::size_t k = 0; done && k < count; ++k)
        run.removedMm3 += rows[run.block + k].removedMm3;
    countCut(run, done ? count : 0, watch.seconds());
    return done;
}

bool Simulation::State::cutNew(StockRun& run, std::size_t count, PortionCutting& cutting,
                               const WorkContext& context) {
    const StopWatch watch;
    const auto records = cutBlocksInTurn(run.zmap, *program, run.block, run.block + count, *setup, tools,
                                         &findings, context.stop, cutting, keptRecords.blocks());
    for (std::size_t k = 0; records && k < count; ++k) {
        rows.push_back(keptRecords.row(run.block + k, (*records)[k], surface.facesFull()));
        run.removedMm3 += (*records)[k].removedMm3;
    }
    countCut(run, records ? count : 0, watch.seconds());
    return records.has_value();
}

void Simulation::State::countCut(StockRun& run, std::size_t blocks, double seconds) {
    effort.cutSeconds += seconds;
    if (blocks == 0)
        return; // stopped
    effort.blocksCut += blocks;
    run.block += blocks;
    run.cutSeconds += seconds;
    atRest.outdate();
    if (checkpoints.isDue(run.block, run.cutSeconds, checkpointBlocks(*program)))
        checkpoints.add(run.moment());
}

void Simulation::State::step(const WorkContext& context) {
    if (behind)
        seek(stock.block, context);
    if (behind)
        return;
    const std::size_t block = stock.block;
    const bool first = block == rows.size();
    const double secondsBefore = stock.cutSeconds;
    const auto record = cutNext(stock, first ? &findings : nullptr, context);
    if (!record)
        return;
    touchChanged(surface, stock.zmap, base.zmap, record->changed);

    BlockStatistics row = recordedRow(*record, surface.facesFull());
    const BlockStatistics old = first ? row : rows[block];
    row.cutSeconds = static_cast<float>(stock.cutSeconds - secondsBefore);
    row.decimationSeconds = 0;
    if (schedule.isMoment(stock.block)) {
        base = stock.moment();
        row.regionsDecimated = static_cast<std::uint32_t>(surface.dirtyRegions());
        row.decimationSeconds = static_cast<float>(decimate(surface.listOfDirtyRegions(), context.quiet()));
        behind = schedule.decimates() && surface.dirtyRegions() > 0;
    }
    if (first)
        rows.push_back(row);
    else
        rows.edit(block) = row;
    if (behind)
        rowBefore = old;
    noteSurface();
}

// --- the surface

double Simulation::State::decimate(std::span<const std::size_t> regions, const WorkContext& context) {
    const StopWatch watch;
    if (surfaceMemory.isWatched() && !atRest.isShown())
        atRest = {}; // it may be large, and is made again
    const auto work = [&](const auto& limited) { surface.decimateRegions(regions, base.zmap, limited); };
    if (!surfaceMemory.limit(surface, surface.grid().pointsOf(regions.size()), context, work))
        giveUpSurface();
    const double seconds = watch.seconds();
    effort.decimationSeconds += seconds;
    return seconds;
}

void Simulation::State::giveUpSurface() {
    schedule = Schedule::never();
    surface = Surface(stock.zmap.grid().nx, stock.zmap.grid().ny, whileCutting(parameters));
    atRest = {};
    base = checkpoints.before(0);
    returnFreedMemory();
}

void Simulation::State::noteSurface() {
    if (behind || stock.block == 0 || stock.block > rows.size())
        return;
    BlockStatistics& row = rows.edit(stock.block - 1);
    row.facesShown = static_cast<std::uint32_t>(surface.faces());
    row.regionsDirty = static_cast<std::uint32_t>(surface.dirtyRegions());
}

void Simulation::State::settle(const WorkContext& context) {
    behind = false;
    if (schedule.decimates()) {
        const auto dirty = differingRegions(stock.zmap.snapshot(), base.zmap, surface.grid());
        (void)decimate(dirtyRegions(surface, dirty), context);
        for (const auto region : dirty)
            surface.touchRegion(region);
        behind = schedule.decimates() && surface.dirtyRegions() > dirty.size();
    }
    if (!behind)
        rowBefore.reset();
    noteSurface();
}

void Simulation::State::abandonUnfinished() {
    if (rowBefore)
        rows.edit(stock.block - 1) = *rowBefore;
    rowBefore.reset();
}

// --- any block

Checkpoint Simulation::State::nearest(std::size_t block) const {
    const std::size_t saved = checkpoints.blockBefore(block);
    if (stock.block <= block && stock.block >= saved)
        return stock.moment();
    if (base.block <= block && base.block >= saved)
        return base;
    return checkpoints.before(block);
}

bool Simulation::State::cutTo(StockRun& run, std::size_t block, const WorkContext& context) {
    Portions portions(*program, checkpoints.wanted(), context.stop.stop_possible());
    PortionCutting cutting; // its memory serves all portions
    const std::size_t from = run.block;
    while (run.block < block && !context.stopped()) {
        const bool isNew = run.block >= rows.size();
        const std::size_t count = portions.from(run.block, isNew ? block : std::min(block, rows.size()));
        const StopWatch watch;
        if (!(isNew ? cutNew(run, count, cutting, context) : cutMany(run, count, cutting, context)))
            break;
        portions.took(watch.seconds());
        context.report(static_cast<double>(run.block - from) / static_cast<double>(block - from));
    }
    return run.block == block;
}

void Simulation::State::seek(std::size_t block, const WorkContext& context) {
    if (stock.block == rows.size() && checkpoints.wanted())
        checkpoints.add(stock.moment()); // the return to the farthest block
    const std::size_t known = rows.size();
    if (block == known + 1 && block == stock.block + 1)
        return step(context); // one block costs the same alone, and is measured
    StockRun run;
    std::optional<Checkpoint> newBase;
    const auto moment = schedule.lastMoment(block);
    if (moment && *moment != base.block) {
        run.continueFrom(nearest(*moment));
        if (!cutTo(run, *moment, context.part(0, 0.6)))
            return keepNew(std::move(run), known);
        newBase = run.moment();
    }
    if (block != stock.block) {
        const Checkpoint start = nearest(block);
        if (!newBase || start.block > run.block)
            run.continueFrom(start);
        const bool reached = cutTo(run, block, context.part(newBase ? 0.6 : 0, 0.65));
        if (!reached)
            return keepNew(std::move(run), known);
        moveTo(std::move(run));
    }
    if (newBase) {
        for (const auto region : differingRegions(base.zmap, newBase->zmap, surface.grid()))
            surface.touchRegion(region);
        base = std::move(*newBase);
    }
    settle(context.part(0.65, 1));
}

void Simulation::State::moveTo(StockRun&& run) {
    abandonUnfinished();
    atRest.outdate();
    stock = std::move(run);
}

void Simulation::State::keepNew(StockRun&& run, std::size_t known) {
    if (run.block <= known)
        return;
    moveTo(std::move(run));
    for (const auto region : differingRegions(base.zmap, stock.zmap.snapshot(), surface.grid()))
        surface.touchRegion(region);
    behind = schedule.decimates();
}

void Simulation::State::fallBack(std::size_t kept) {
    const Checkpoint saved = nearest(kept);
    const ZMapSnapshot shown = base.zmap;
    rowBefore.reset();
    atRest.outdate();
    stock.continueFrom(saved);
    if (base.block > kept)
        base = saved;
    for (const ZMapSnapshot& other : {base.zmap, saved.zmap})
        for (const auto region : differingRegions(shown, other, surface.grid()))
            surface.touchRegion(region);
    behind = true;
}

void Simulation::State::useParameters(const DecimationParameters& wanted) {
    parameters = wanted;
    schedule = Schedule(wanted);
    surfaceMemory.begin(*setup, stock.zmap.grid(), wanted);
    surface = Surface(stock.zmap.grid().nx, stock.zmap.grid().ny, whileCutting(wanted));
    atRest = {};
}

} // namespace proveout
