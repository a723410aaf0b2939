// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/simulation.h"

#include <algorithm>
#include <utility>

#include "core/base/memory.h"
#include "core/base/stop_watch.h"
#include "core/simulation/run/block_recorder.h"
#include "core/simulation/run/play_ahead.h"
#include "core/simulation/run/simulation_state.h"
#include "core/simulation/setup/parameter_check.h"
#include "core/simulation/setup/setup_memory.h"
#include "core/simulation/setup/stock_position.h"

namespace proveout {

namespace {

void append(Diagnostics& findings, const Diagnostics& more) {
    findings.insert(findings.end(), more.begin(), more.end());
}

/// The tool of the frame's block, and where it is.
void noteCutter(Frame& frame, const ToolChoice& tools) {
    if (frame.block > 0) {
        const auto motions = frame.program->blockMotions(frame.block - 1);
        const Motion last = frame.program->motion(motions.last - 1);
        frame.cutterPosition = last.end;
        frame.cutterKnown = last.endKnown == kAllAxes;
        frame.tool = tools.tool(last.tool);
        frame.toolAssumed = tools.isAssumed(last.tool);
    } else {
        frame.cutterPosition = frame.setup->start.value_or(Vec3(0));
        frame.cutterKnown = frame.setup->start.has_value();
        frame.tool = frame.setup->startTool.value_or(tools.tool(0));
        frame.toolAssumed = tools.assumed().has_value();
    }
}

Result<void> checkStart(const Setup& setup, const DecimationParameters& parameters, double limitBytes) {
    if (auto fine = checkRanges(parameters); !fine)
        return fine;
    if (auto whole = checkShape(setup.shape); !whole)
        return whole;
    return checkSetupMemory(setup, parameters, limitBytes);
}

} // namespace

Simulation::Simulation(std::unique_ptr<State> state) : m_state(std::move(state)) {}
Simulation::~Simulation() = default;

Result<std::unique_ptr<Simulation>> Simulation::prepare(std::shared_ptr<const Program> program,
                                                        std::shared_ptr<const Setup> setup,
                                                        const DecimationParameters& parameters) {
    const std::uint64_t limit = memoryLimitBytes();
    if (auto fine = checkStart(*setup, parameters, static_cast<double>(limit)); !fine)
        return tl::unexpected(std::move(fine.error()));
    const StopWatch watch;
    auto state = std::make_unique<State>();
    state->surfaceMemory.allow(limit);
    UncutStock uncut = uncutStock(setup->stock, setup->shape, *makeGrid(setup->stock, setup->spacing));
    for (Diagnostic& finding : uncut.findings)
        finding.file = setup->shape.file.string();
    state->stock.zmap = std::move(uncut.zmap);
    state->stockFindings = std::move(uncut.findings);
    state->setup = std::move(setup);
    state->useProgram(std::move(program));
    state->useParameters(parameters);
    state->base = state->stock.moment();
    state->checkpoints.restart(state->base);
    // A quarter of the memory that is left beside the map, so that other programs can run as well.
    state->checkpoints.setBudget(std::min<std::size_t>(Checkpoints::kDefaultBudget, memoryLimitBytes() / 4));
    state->effort.allocateSeconds = watch.seconds();
    state->behind = state->schedule.decimates();
    return std::unique_ptr<Simulation>(new Simulation(std::move(state)));
}

Result<std::unique_ptr<Simulation>> Simulation::create(std::shared_ptr<const Program> program,
                                                       std::shared_ptr<const Setup> setup,
                                                       const DecimationParameters& parameters,
                                                       const WorkContext& context) {
    auto prepared = prepare(std::move(program), std::move(setup), parameters);
    if (prepared)
        (*prepared)->m_state->settle(context);
    return prepared;
}

std::size_t Simulation::position() const {
    return m_state->stock.block;
}

std::size_t Simulation::blockCount() const {
    return m_state->program->blockCount();
}

const Program& Simulation::program() const {
    return *m_state->program;
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

void Simulation::play(std::size_t block, const WorkContext& context) {
    PlayAhead::play(*m_state, std::min(block, blockCount()), context);
}

void Simulation::noteParameters(const DecimationParameters& parameters) {
    State& state = *m_state;
    if (!checkRanges(parameters) || parameters == state.parameters)
        return;
    state.useParameters(parameters);
    state.behind = true;
    if (state.schedule.decimates())
        return;
    // Nothing is decimated now, and an edit may outdate the old moment before the next decimation.
    state.base = state.checkpoints.before(0);
    state.settle({}); // no work: this only records that none is left
}

std::size_t Simulation::noteProgram(std::shared_ptr<const Program> program) {
    State& state = *m_state;
    const ToolChoice tools(*program, *state.setup);
    // A different tool in the spindle changes every block, though no block reads differently.
    const std::size_t kept =
        tools.assumed() == state.tools.assumed() ? state.program->firstDifference(*program) : 0;
    state.rows.truncate(kept);
    state.findings.truncate(kept);
    state.checkpoints.truncate(kept);
    state.useProgram(std::move(program));
    const std::size_t wanted = std::min(position(), kept);
    if (position() > kept)
        state.fallBack(kept); // the stock of the old program must not remain
    return wanted;
}

void Simulation::setCheckpointBudget(std::size_t bytes) {
    m_state->checkpoints.setBudget(bytes);
}

void Simulation::allowMemory(std::uint64_t bytes) {
    m_state->surfaceMemory.allow(bytes);
}

void Simulation::keepRecordsOf(BlockSet blocks) {
    m_state->keptRecords.keepOnly(std::move(blocks), m_state->stock.zmap);
}

bool Simulation::record(const BlockSet& blocks, const WorkContext& context) {
    State& state = *m_state;
    const Checkpoint start = state.nearest(blocks.first());
    return recordBlocks(state.rows, blocks, start, *state.program, *state.setup, state.tools, context);
}

bool Simulation::canRefine() const {
    const State& state = *m_state;
    return canMerge(state.parameters) && state.schedule.repeats() && state.atRest.isWanted();
}

void Simulation::refine(RimFinder& rims, const WorkContext& context) {
    if (canRefine())
        m_state->atRest.follow(frame(), rims, m_state->surface.faces(), context);
}

SurfaceSnapshot Simulation::decimatedNow(const WorkContext& context) const {
    const DecimationParameters wanted = forExport(m_state->parameters);
    if (canMerge(wanted) || !(wanted == m_state->surface.parameters()))
        return decimatedWhole(zmap(), wanted, context);
    Surface surface = m_state->surface; // its meshes already have the required parameters
    (void)surface.decimateDirty(zmap(), context);
    return surface.snapshot();
}

ZMapSnapshot Simulation::zmap() const {
    return m_state->stock.zmap.snapshot();
}

const ToolChoice& Simulation::tools() const {
    return m_state->tools;
}

Simulation::Effort Simulation::effort() const {
    return m_state->effort;
}

const PersistentArray<BlockStatistics>& Simulation::rows() const {
    return m_state->rows;
}

const FindingLog& Simulation::findings() const {
    return m_state->findings;
}

Frame Simulation::frame() const {
    const State& state = *m_state;
    Frame frame;
    frame.block = state.stock.block;
    frame.program = state.program;
    frame.setup = state.setup;
    frame.parameters = state.parameters;
    frame.zmap = state.atRest.isShown() ? state.atRest.zmap() : zmap();
    frame.surface = state.atRest.isShown() ? state.atRest.snapshot() : state.surface.snapshot();
    frame.level = state.atRest.isShown() ? state.parameters.level : ErrorLevel::sample;
    frame.statistics = state.rows;
    frame.findings = state.stockFindings;
    append(frame.findings, state.setupFindings);
    append(frame.findings, state.findings.diagnostics(*state.program, state.tools));
    if (state.surfaceMemory.exceeded())
        frame.findings.push_back(state.surfaceMemory.finding(*state.setup, state.parameters));
    frame.removedMm3 = state.keptRecords.removedMm3(state.stock.zmap, state.stock.removedMm3);
    if (atEnd() && frame.removedMm3 <= 0)
        append(frame.findings, untouchedStock(*state.program, *state.setup, state.tools));
    noteCutter(frame, state.tools);
    return frame;
}

} // namespace proveout
