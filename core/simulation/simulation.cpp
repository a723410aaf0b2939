// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/simulation.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/memory.h"
#include "core/base/stop_watch.h"
#include "core/base/text.h"
#include "core/decimation/map_memory.h"
#include "core/decimation/refined_surface.h"
#include "core/simulation/block_cutter.h"
#include "core/simulation/changed_regions.h"
#include "core/simulation/checkpoints.h"
#include "core/simulation/finding_log.h"
#include "core/simulation/schedule.h"
#include "core/simulation/tool_choice.h"

namespace proveout {

namespace {

/// Cutting time between two checkpoints. A step backward replays at most this much, and the decimation
/// period.
constexpr double kCheckpointSeconds = 0.01;

/// The stock on its way through the program.
struct StockRun {
    ZMap zmap;
    std::size_t block = 0;
    double removedMm3 = 0;
    double cutSeconds = 0;

    [[nodiscard]] Checkpoint moment() const { return {block, zmap.snapshot(), removedMm3, cutSeconds, 0}; }
    void goOnFrom(const Checkpoint& moment) {
        zmap = ZMap(moment.zmap);
        block = moment.block;
        removedMm3 = moment.removedMm3;
        cutSeconds = moment.cutSeconds;
    }
};

Result<void> checkRanges(const DecimationParameters& parameters) {
    Result<void> result;
    describe(parameters, [&result](const auto& value, const Field& field) {
        if (field.minimum == field.maximum)
            return;
        const auto number = static_cast<double>(value);
        if (!(number >= field.minimum && number <= field.maximum) && result)
            result = failure("parameter-out-of-range",
                             PROVEOUT_TEXT("Core", "The parameter \"{}\" is {}; it must lie in {} … {}."),
                             {field.key, fmt::format("{}", number), fmt::format("{}", field.minimum),
                              fmt::format("{}", field.maximum)});
    });
    return result;
}

} // namespace

struct Simulation::State {
    std::shared_ptr<const Program> program;
    std::shared_ptr<const Setup> setup;
    DecimationParameters parameters;
    Schedule schedule{parameters};
    ToolChoice tools;

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

    /// What is shown at rest, and the z-map that it follows.
    struct AtRest {
        RefinedSurface surface;
        std::optional<ZMapSnapshot> zmap;
        double bytes = 0; ///< what it takes
        bool isShown = false;
        bool fits = true; ///< false: there is no memory for it now

        void outdate() {
            isShown = false;
            fits = true;
        }
    };
    AtRest atRest;

    Checkpoints checkpoints;
    PersistentArray<BlockStatistics> rows;
    FindingLog findings;
    Effort effort;

    // --- one block

    /// Nothing where it was stopped: the block counts as not executed.
    std::optional<CutRecord> cutNext(StockRun& run, FindingLog* log, const WorkContext& context) {
        const StopWatch watch;
        auto record = cutBlock(run.zmap, *program, run.block, *setup, tools, log, context.stop);
        const double seconds = watch.seconds();
        effort.cutSeconds += seconds;
        if (!record)
            return std::nullopt;
        atRest.outdate();
        ++run.block;
        run.removedMm3 += record->removedMm3;
        run.cutSeconds += seconds;
        if (checkpoints.wanted() &&
            run.cutSeconds - checkpoints.before(run.block).cutSeconds > kCheckpointSeconds)
            checkpoints.add(run.moment());
        return record;
    }

    /// The box of a slanted motion holds regions that it never touched: only changed heights count.
    void touchChanged(const IndexRect& changed) {
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

    void step(const WorkContext& context) {
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
        row.removedMm3 = static_cast<float>(record->removedMm3);
        row.maxDepth = static_cast<float>(record->maxDepth);
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

    /// Decimates dirty regions by `base`; returns the seconds it took.
    double decimate(std::span<const std::size_t> regions, const WorkContext& context) {
        const StopWatch watch;
        (void)surface.decimateRegions(regions, base.zmap, context);
        const double seconds = watch.seconds();
        effort.decimationSeconds += seconds;
        return seconds;
    }

    /// The dirty regions without those in `without` (ascending).
    [[nodiscard]] std::vector<std::size_t> dirtyRegions(std::span<const std::size_t> without) const {
        std::vector<std::size_t> out;
        for (std::size_t region = 0; region < surface.grid().regionCount(); ++region)
            if (surface.isDirty(region) && !std::ranges::binary_search(without, region))
                out.push_back(region);
        return out;
    }

    void refine(const WorkContext& context) {
        std::vector<std::size_t> changed;
        ZMapSnapshot now = stock.zmap.snapshot();
        const double needed = bytesAtRest(parameters, now.grid(), surface.faces());
        if (needed - atRest.bytes > static_cast<double>(memoryLimitBytes())) {
            atRest = {};
            atRest.fits = false;
            return;
        }
        atRest.bytes = needed;
        if (atRest.zmap)
            changed = differingRegions(*atRest.zmap, now, atRest.surface.grid());
        else
            atRest.surface = RefinedSurface(now.grid().nx, now.grid().ny, parameters);
        atRest.zmap = std::move(now);
        atRest.isShown = atRest.surface.follow(*atRest.zmap, changed, context);
    }

    /// The row of the present block tells of the present surface.
    void noteSurface() {
        if (stock.block == 0 || stock.block > rows.size())
            return;
        BlockStatistics& row = rows.edit(stock.block - 1);
        row.facesShown = static_cast<std::uint32_t>(surface.faces());
        row.regionsDirty = static_cast<std::uint32_t>(surface.dirtyRegions());
    }

    /// Brings the surface to where the schedule has it: dirty are the regions that differ from `base`.
    void settle(const WorkContext& context) {
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

    /// Leaving a block whose decimation was stopped: its row would tell of a surface that never was.
    void abandonUnfinished() {
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

    /// The nearest known moment at or before `block`.
    [[nodiscard]] Checkpoint nearest(std::size_t block) const {
        const Checkpoint& saved = checkpoints.before(block);
        if (stock.block <= block && stock.block >= saved.block)
            return stock.moment();
        if (base.block <= block && base.block >= saved.block)
            return base;
        return saved;
    }

    /// Replays up to `block`; false where it was stopped.
    bool replay(StockRun& run, std::size_t block, const WorkContext& context) {
        const std::size_t from = run.block;
        while (run.block < block && !context.stopped()) {
            (void)cutNext(run, nullptr, context);
            context.tell(static_cast<double>(run.block - from) / static_cast<double>(block - from));
        }
        return run.block == block;
    }

    /// Goes to a block that has been executed before, and settles the surface there.
    void jump(std::size_t block, const WorkContext& context) {
        if (stock.block == rows.size() && checkpoints.wanted())
            checkpoints.add(stock.moment()); // the way back to the farthest block
        StockRun run;
        std::optional<Checkpoint> newBase;
        const auto moment = schedule.lastMoment(block);
        if (moment && *moment != base.block) {
            run.goOnFrom(nearest(*moment));
            if (!replay(run, *moment, context.part(0, 0.4)))
                return;
            newBase = run.moment();
        }
        if (block != stock.block) {
            const Checkpoint start = nearest(block);
            if (!newBase || start.block > run.block)
                run.goOnFrom(start);
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

    /// To the nearest checkpoint at or before `kept`, without any work: nothing may stay of what came behind.
    void fallBack(std::size_t kept) {
        const Checkpoint saved = checkpoints.before(kept);
        const ZMapSnapshot shown = base.zmap;
        unfinished.reset();
        atRest.outdate();
        stock.goOnFrom(saved);
        if (base.block > kept)
            base = saved;
        for (const ZMapSnapshot& other : {base.zmap, saved.zmap})
            for (const auto region : differingRegions(shown, other, surface.grid()))
                surface.touchRegion(region);
        behind = true;
    }

    void seek(std::size_t block, const WorkContext& context) {
        if (block <= rows.size()) {
            jump(block, context);
            return;
        }
        if (behind || stock.block != rows.size())
            jump(rows.size(), context.quiet());
        const std::size_t from = stock.block;
        if (from != rows.size())
            return; // stopped on the way
        while (stock.block < block && !context.stopped()) {
            step(context);
            context.tell(static_cast<double>(stock.block - from) / static_cast<double>(block - from));
        }
    }

    void useParameters(const DecimationParameters& wanted) {
        parameters = wanted;
        schedule = Schedule(wanted);
        surface = Surface(stock.zmap.grid().nx, stock.zmap.grid().ny, whileCutting(wanted));
        atRest = {};
    }
};

Simulation::Simulation(std::unique_ptr<State> state) : m_state(std::move(state)) {}
Simulation::~Simulation() = default;

Result<std::unique_ptr<Simulation>> Simulation::create(std::shared_ptr<const Program> program,
                                                       std::shared_ptr<const Setup> setup,
                                                       const DecimationParameters& parameters,
                                                       const WorkContext& context) {
    if (auto fine = checkRanges(parameters); !fine)
        return tl::unexpected(std::move(fine.error()));
    const auto grid = makeGrid(setup->stock, setup->spacing);
    if (!grid)
        return tl::unexpected(grid.error());
    const auto limit = static_cast<double>(memoryLimitBytes());
    if (auto fits = checkMapMemory(setup->stock, *grid, parameters, {}, limit); !fits)
        return tl::unexpected(std::move(fits.error()));

    const StopWatch watch;
    auto state = std::make_unique<State>();
    state->tools = ToolChoice(*program, setup->tools);
    state->stock.zmap = ZMap(setup->stock, *grid);
    state->program = std::move(program);
    state->setup = std::move(setup);
    state->useParameters(parameters);
    state->base = state->stock.moment();
    state->checkpoints.restart(state->base);
    // Of what is left beside the map, and no more than a part of it: other programs want to live too.
    const auto quarter = static_cast<std::size_t>(memoryLimitBytes() / 4);
    state->checkpoints.setBudget(std::min(Checkpoints::kStandardBudget, quarter));
    state->effort.allocateSeconds = watch.seconds();
    state->settle(context);
    return std::unique_ptr<Simulation>(new Simulation(std::move(state)));
}

std::size_t Simulation::position() const {
    return m_state->stock.block;
}

std::size_t Simulation::blockCount() const {
    return m_state->program->blockCount();
}

bool Simulation::settled() const {
    return !m_state->behind;
}

void Simulation::step(const WorkContext& context) {
    if (!atEnd())
        m_state->step(context);
}

void Simulation::seek(std::size_t block, const WorkContext& context) {
    m_state->seek(std::min(block, blockCount()), context);
}

void Simulation::setParameters(const DecimationParameters& parameters, const WorkContext& context) {
    if (!checkRanges(parameters))
        return;
    if (!(parameters == m_state->parameters)) {
        m_state->useParameters(parameters);
        m_state->behind = true;
        // Nothing is decimated now, and an edit may outdate the old moment before anything is again.
        if (!m_state->schedule.decimates())
            m_state->base = m_state->checkpoints.before(0);
    }
    m_state->jump(position(), context);
}

std::size_t Simulation::replaceProgram(std::shared_ptr<const Program> program, const WorkContext& context) {
    State& state = *m_state;
    const ToolChoice tools(*program, state.setup->tools);
    // Another tool at work changes every block, though no block reads differently.
    const std::size_t kept =
        tools.assumed() == state.tools.assumed() ? state.program->firstDifference(*program) : 0;
    state.rows.truncate(kept);
    state.findings.truncate(kept);
    state.checkpoints.truncate(kept);
    state.program = std::move(program);
    state.tools = tools;
    const std::size_t wanted = std::min(position(), kept);
    if (position() > kept) {
        state.jump(kept, context);
        if (position() != kept)
            state.fallBack(kept); // the stock of the old program must not stay
    }
    return wanted;
}

void Simulation::setCheckpointBudget(std::size_t bytes) {
    m_state->checkpoints.setBudget(bytes);
}

bool Simulation::canRefine() const {
    const State& state = *m_state;
    return canMerge(state.parameters) && state.schedule.repeats() && state.atRest.fits &&
           !state.atRest.isShown;
}

void Simulation::refine(const WorkContext& context) {
    if (canRefine())
        m_state->refine(context);
}

SurfaceSnapshot Simulation::decimatedNow(const WorkContext& context) const {
    const DecimationParameters wanted = forExport(m_state->parameters);
    if (canMerge(wanted) || !(wanted == m_state->surface.parameters()))
        return decimatedWhole(zmap(), wanted, context);
    Surface surface = m_state->surface; // its meshes are those wanted
    (void)surface.decimateDirty(zmap(), context);
    return surface.snapshot();
}

ZMapSnapshot Simulation::zmap() const {
    return m_state->stock.zmap.snapshot();
}

Simulation::Effort Simulation::effort() const {
    return m_state->effort;
}

Frame Simulation::frame() const {
    const State& state = *m_state;
    Frame frame;
    frame.block = state.stock.block;
    frame.program = state.program;
    frame.setup = state.setup;
    frame.parameters = state.parameters;
    frame.zmap = zmap();
    frame.surface = state.atRest.isShown ? state.atRest.surface.snapshot() : state.surface.snapshot();
    frame.level = state.atRest.isShown ? state.parameters.level : ErrorLevel::sample;
    frame.statistics = state.rows;
    frame.findings = state.findings.diagnostics(*state.program, state.tools);
    frame.removedMm3 = state.stock.removedMm3;
    if (frame.block > 0) {
        const auto motions = state.program->blockMotions(frame.block - 1);
        const Motion last = state.program->motion(motions.last - 1);
        frame.cutterPosition = last.end;
        frame.cutterKnown = last.endKnown == kAllAxes;
        frame.tool = state.tools.tool(last.tool);
    } else {
        frame.cutterPosition = state.setup->start.value_or(Vec3(0));
        frame.cutterKnown = state.setup->start.has_value();
        frame.tool = state.tools.tool(0);
    }
    return frame;
}

} // namespace proveout
