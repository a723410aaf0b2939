// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/simulation_state.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/stop_watch.h"
#include "core/simulation/run/block_cutter.h"
#include "core/simulation/run/changed_regions.h"
#include "core/simulation/setup/automatic_grid.h"
#include "core/simulation/setup/stock_position.h"

namespace proveout {

namespace {

/// Cutting time between two checkpoints. A step backward replays at most this much, and the decimation
/// period.
constexpr double kCheckpointSeconds = 0.01;
/// Even cheap blocks add up when all of them are executed: checkpoints are at most this fraction of the
/// program apart, so that an edit cuts little more than what follows it.
constexpr std::size_t kCheckpointsOfProgram = 64;
constexpr std::size_t kFewestBlocksBetween = 16; ///< in a short program, which is cut at once anyway
/// Blocks that are cut at once when they are not shown one by one.
constexpr std::size_t kFirstPortion = 16;

} // namespace

void Simulation::State::useProgram(std::shared_ptr<const Program> wanted) {
    program = std::move(wanted);
    tools = ToolChoice(*program, *setup);
    setupFindings = misplacedStock(*program, *setup, tools);
    std::ranges::move(
        coarseGrid(stock.zmap.grid(), smallestCutter(*program, *setup, tools), setup->automaticGrid),
        std::back_inserter(setupFindings));
}

// --- one block

std::optional<CutRecord> Simulation::State::cutNext(StockRun& run, FindingLog* log,
                                                    const WorkContext& context) {
    const StopWatch watch;
    auto record = cutBlock(run.zmap, *program, run.block, *setup, tools, log, context.stop);
    const double seconds = watch.seconds();
    effort.cutSeconds += seconds;
    if (!record)
        return std::nullopt;
    atRest.outdate();
    ++effort.blocksCut;
    ++run.block;
    run.removedMm3 += record->removedMm3;
    run.cutSeconds += seconds;
    rememberMoment(run);
    return record;
}

bool Simulation::State::cutMany(StockRun& run, std::size_t count, const WorkContext& context) {
    const StopWatch watch;
    const bool done =
        cutBlocks(run.zmap, *program, run.block, run.block + count, *setup, tools, context.stop);
    const double seconds = watch.seconds();
    effort.cutSeconds += seconds;
    if (!done)
        return false;
    atRest.outdate();
    effort.blocksCut += count;
    for (const std::size_t end = run.block + count; run.block < end; ++run.block)
        run.removedMm3 += rows[run.block].removedMm3;
    run.cutSeconds += seconds;
    rememberMoment(run);
    return true;
}

void Simulation::State::rememberMoment(const StockRun& run) {
    if (!checkpoints.wanted())
        return;
    const std::size_t farBlocks =
        std::max(program->blockCount() / kCheckpointsOfProgram, kFewestBlocksBetween);
    if (run.cutSeconds - checkpoints.cutSecondsBefore(run.block) > kCheckpointSeconds ||
        run.block - checkpoints.blockBefore(run.block) >= farBlocks)
        checkpoints.add(run.moment());
}

void Simulation::State::touchChanged(const IndexRect& changed) {
    const RegionGrid& grid = surface.grid();
    if (changed.empty() || surface.dirtyRegions() == grid.regionCount())
        return;
    const IndexRect regions = grid.regionsTouching(changed);
    for (int ry = regions.j0; ry < regions.j1; ++ry)
        for (int rx = regions.i0; rx < regions.i1; ++rx) {
            const auto region = grid.regionAt(rx, ry);
            if (surface.isDirty(region))
                continue;
            if (!sameHeights(stock.zmap, base.zmap, intersection(grid.points(region), changed)))
                surface.touchRegion(region);
        }
}

void Simulation::State::step(const WorkContext& context) {
    if (behind)
        jump(stock.block, context);
    if (behind)
        return;
    const std::size_t block = stock.block;
    const bool first = block == rows.size();
    const double secondsBefore = stock.cutSeconds;
    const auto record = cutNext(stock, first ? &findings : nullptr, context);
    if (!record)
        return;
    touchChanged(record->changed);

    BlockStatistics row;
    row.facesFull = static_cast<std::uint32_t>(surface.facesFull());
    row.cutSeconds = static_cast<float>(stock.cutSeconds - secondsBefore);
    row.removedMm3 = record->removedMm3;
    row.maxDepth = static_cast<float>(record->maxDepth);
    row.radialEngagement = static_cast<float>(record->radialEngagement());
    const BlockStatistics old = first ? row : rows[block];
    if (schedule.isMoment(stock.block)) {
        base = stock.moment();
        row.regionsDecimated = static_cast<std::uint32_t>(surface.dirtyRegions());
        row.decimationSeconds = static_cast<float>(decimate(dirtyRegions({}), context.quiet()));
        behind = surface.dirtyRegions() > 0;
    }
    if (first)
        rows.push_back(row);
    else
        rows.edit(block) = row;
    if (behind)
        unfinished = UnfinishedRow{first, old};
    noteSurface();
}

// --- the surface

double Simulation::State::decimate(std::span<const std::size_t> regions, const WorkContext& context) {
    const StopWatch watch;
    (void)surface.decimateRegions(regions, base.zmap, context);
    const double seconds = watch.seconds();
    effort.decimationSeconds += seconds;
    return seconds;
}

std::vector<std::size_t> Simulation::State::dirtyRegions(std::span<const std::size_t> without) const {
    std::vector<std::size_t> out;
    for (std::size_t region = 0; region < surface.grid().regionCount(); ++region)
        if (surface.isDirty(region) && !std::ranges::binary_search(without, region))
            out.push_back(region);
    return out;
}

void Simulation::State::noteSurface() {
    if (stock.block == 0 || stock.block > rows.size())
        return;
    BlockStatistics& row = rows.edit(stock.block - 1);
    row.facesShown = static_cast<std::uint32_t>(surface.faces());
    row.regionsDirty = static_cast<std::uint32_t>(surface.dirtyRegions());
}

void Simulation::State::settle(const WorkContext& context) {
    behind = false;
    if (schedule.decimates()) {
        const auto dirty = differingRegions(stock.zmap.snapshot(), base.zmap, surface.grid());
        (void)decimate(dirtyRegions(dirty), context);
        for (const auto region : dirty)
            surface.touchRegion(region);
        behind = surface.dirtyRegions() > dirty.size();
    }
    if (!behind)
        unfinished.reset();
    noteSurface();
}

void Simulation::State::abandonUnfinished() {
    const std::size_t block = stock.block;
    if (unfinished && unfinished->first) {
        rows.truncate(block - 1);
        findings.truncate(block - 1);
    } else if (unfinished && block <= rows.size()) {
        rows.edit(block - 1) = unfinished->old;
    }
    unfinished.reset();
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

bool Simulation::State::replay(StockRun& run, std::size_t block, const WorkContext& context) {
    const std::size_t from = run.block;
    std::size_t portion = kFirstPortion;
    while (run.block < block && !context.stopped()) {
        const std::size_t count = std::min(portion, block - run.block);
        const StopWatch watch;
        if (!cutMany(run, count, context))
            break;
        // Portions take about as long as the time between two checkpoints: that many blocks share the
        // start-up work.
        if (watch.seconds() < kCheckpointSeconds / 2)
            portion *= 2;
        else if (watch.seconds() > kCheckpointSeconds)
            portion = std::max(portion / 2, kFirstPortion);
        context.report(static_cast<double>(run.block - from) / static_cast<double>(block - from));
    }
    return run.block == block;
}

void Simulation::State::jump(std::size_t block, const WorkContext& context) {
    if (stock.block == rows.size() && checkpoints.wanted())
        checkpoints.add(stock.moment()); // the return to the farthest block
    StockRun run;
    std::optional<Checkpoint> newBase;
    const auto moment = schedule.lastMoment(block);
    if (moment && *moment != base.block) {
        run.continueFrom(nearest(*moment));
        if (!replay(run, *moment, context.part(0, 0.4)))
            return;
        newBase = run.moment();
    }
    if (block != stock.block) {
        const Checkpoint start = nearest(block);
        if (!newBase || start.block > run.block)
            run.continueFrom(start);
        if (!replay(run, block, context.part(0.4, 0.6)))
            return;
        abandonUnfinished();
        atRest.outdate();
        stock = std::move(run);
    }
    if (newBase) {
        for (const auto region : differingRegions(base.zmap, newBase->zmap, surface.grid()))
            surface.touchRegion(region);
        base = std::move(*newBase);
    }
    settle(context.part(0.6, 1));
}

void Simulation::State::fallBack(std::size_t kept) {
    const Checkpoint saved = nearest(kept);
    const ZMapSnapshot shown = base.zmap;
    unfinished.reset();
    atRest.outdate();
    stock.continueFrom(saved);
    if (base.block > kept)
        base = saved;
    for (const ZMapSnapshot& other : {base.zmap, saved.zmap})
        for (const auto region : differingRegions(shown, other, surface.grid()))
            surface.touchRegion(region);
    behind = true;
}

void Simulation::State::seek(std::size_t block, const WorkContext& context) {
    if (block <= rows.size()) {
        jump(block, context);
        return;
    }
    if (behind || stock.block != rows.size())
        jump(rows.size(), context.quiet());
    const std::size_t from = stock.block;
    if (from != rows.size())
        return; // stopped before the end
    while (stock.block < block && !context.stopped()) {
        step(context);
        context.report(static_cast<double>(stock.block - from) / static_cast<double>(block - from));
    }
}

void Simulation::State::useParameters(const DecimationParameters& wanted) {
    parameters = wanted;
    schedule = Schedule(wanted);
    surface = Surface(stock.zmap.grid().nx, stock.zmap.grid().ny, whileCutting(wanted));
    atRest = {};
}

} // namespace proveout
