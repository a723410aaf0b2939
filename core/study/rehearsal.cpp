// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rehearsal.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "core/base/memory.h"
#include "core/base/stop_watch.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/decimation/surface/map_memory.h"
#include "core/simulation/run/block_cutter.h"
#include "core/simulation/setup/tool_choice.h"
#include "core/study/rehearsed_regions.h"
#include "core/study/study_findings.h"

namespace proveout {

namespace {

constexpr std::array kRegions{5, 8, 10, 12, 15, 20, 25, 30, 48, 64, 96, 128};
constexpr std::array kPeriods{-1, 1, 2, 5, 10, 15, 20, 30, 50, 100, 200, 500};
constexpr std::size_t kMostRegions = 250'000; ///< of one size; the traces need some 500 bytes for each
constexpr std::size_t kBlocksASample = 16;
constexpr std::size_t kMostSamples = 64;
constexpr std::size_t kDrawnSizes = 4; ///< region sizes whose frames are drawn

class Rehearsing {
public:
    Rehearsing(const StudyJob& job, const DecimationParameters& base, const RehearsalOptions& options,
               DrawCost& drawing, ZMap zmap)
        : m_job(job), m_base(base), m_options(options), m_drawing(drawing), m_zmap(std::move(zmap)),
          m_tools(*job.program, *job.setup) {}

    Result<Rehearsal> go(const WorkContext& context) {
        const StopWatch watch;
        start(context.stop);
        const std::size_t blocks = m_job.program->blockCount();
        const std::size_t stretch = samplingStretch(blocks);
        for (m_block = 1; m_block <= blocks && !context.stopped() && cut(context.stop); ++m_block) {
            if (m_drawNext)
                drawFrame(m_drawNext->parameters(), m_drawNext->surface(), 0);
            m_drawNext = nullptr;
            if (m_block % stretch == 0 || m_block == blocks)
                sample();
            context.report(static_cast<double>(m_block) / static_cast<double>(blocks));
        }
        if (context.stopped())
            return failure(study_finding::kStudyStopped);
        Rehearsal rehearsal = forecast(blocks);
        rehearsal.seconds = watch.seconds();
        return rehearsal;
    }

private:
    [[nodiscard]] std::size_t samplingStretch(std::size_t blocks) const {
        const auto least = static_cast<std::size_t>(std::max(1, m_options.samples));
        const std::size_t wanted = std::clamp(blocks / kBlocksASample, least, std::max(least, kMostSamples));
        return std::max<std::size_t>(1, blocks / wanted);
    }

    void start(const std::stop_token& stop) {
        m_moment = m_zmap.snapshot();
        const std::size_t sizes = m_options.regions.size();
        const std::size_t drawn = std::min(kDrawnSizes, sizes);
        for (std::size_t k = 0; k < sizes && !stop.stop_requested(); ++k) {
            DecimationParameters parameters = m_base;
            parameters.regionCells = m_options.regions[k];
            const bool isDrawn = drawn > 0 && k * drawn / sizes != (k + 1) * drawn / sizes;
            m_sizes.push_back(
                std::make_unique<RehearsedRegions>(m_moment, parameters, m_options.periods, isDrawn, stop));
            if (isDrawn)
                m_drawn.push_back(m_sizes.back().get());
        }
        // The other sizes are estimated from the smallest, whose regions fit into theirs with the smallest
        // remainder.
        const auto cells = [](const auto& size) { return size->parameters().regionCells; };
        if (!m_sizes.empty())
            m_reference = std::ranges::min_element(m_sizes, {}, cells)->get();
        m_drawing.begin();
    }

    /// False if it was stopped.
    bool cut(const std::stop_token& stop) {
        const StopWatch watch;
        const auto record =
            cutBlock(m_zmap, *m_job.program, m_block - 1, *m_job.setup, m_tools, nullptr, stop);
        m_cutSeconds += watch.seconds();
        if (!record)
            return false;
        ZMapSnapshot now = m_zmap.snapshot();
        for (const auto& size : m_sizes)
            size->block(m_moment, now, record->changed);
        m_moment = std::move(now);
        return true;
    }

    void sample() {
        RehearsedRegions* turn = m_drawn.empty() ? nullptr : m_drawn[m_samples++ % m_drawn.size()];
        if (turn != nullptr) { // the same moment without decimation, which shows best what faces cost
            const Surface full(m_zmap.grid().nx, m_zmap.grid().ny, turn->parameters());
            drawFrame(turn->parameters(), full.snapshot(), kOtherSurface);
        }
        sample(*m_reference, turn);
        for (const auto& size : m_sizes)
            if (size.get() != m_reference)
                sample(*size, turn);
        m_drawNext = turn; // one more frame, of an ordinary block
    }

    void sample(RehearsedRegions& size, const RehearsedRegions* turn) {
        if (&size == turn) // still dirty, and the graphics side gets to know it
            drawFrame(size.parameters(), size.surface(), kOtherSurface);
        const std::size_t made = size.sample(m_moment, &size == m_reference ? nullptr : m_reference);
        if (&size == turn)
            drawFrame(size.parameters(), size.surface(), static_cast<double>(made));
    }

    /// Draws the surface of this moment after `made` new triangles.
    void drawFrame(const DecimationParameters& parameters, SurfaceSnapshot surface, double made) {
        auto frame = std::make_shared<Frame>();
        frame->block = m_block;
        frame->program = m_job.program;
        frame->setup = m_job.setup;
        frame->parameters = parameters;
        frame->zmap = m_moment;
        frame->surface = std::move(surface);
        const auto motions = m_job.program->blockMotions(m_block - 1);
        const Motion last = m_job.program->motion(motions.last - 1);
        frame->cutterPosition = last.end;
        frame->cutterKnown = last.endKnown == kAllAxes;
        frame->tool = m_tools.tool(last.tool);
        frame->toolAssumed = m_tools.isAssumed(last.tool);
        const auto faces = static_cast<double>(frame->surface.faces);
        const auto regions = static_cast<double>(frame->surface.meshes.size());
        const DrawCost::Seconds seconds = m_drawing.draw(std::move(frame));
        m_draws.push_back({{1, faces, regions}, seconds.draw});
        if (made != kOtherSurface)
            m_uploads.push_back({{1, made, regions}, seconds.upload});
    }

    [[nodiscard]] static Coefficients fittedWhole(std::span<const CostSample> samples) {
        const Coefficients coefficients = fitCost(samples);
        Slowdown slowdown;
        slowdown.add(samples, coefficients);
        return scaled(coefficients, slowdown.factor());
    }

    Rehearsal forecast(std::size_t blocks) {
        Rehearsal out;
        out.model.cutSeconds = m_cutSeconds;
        out.model.drawPerFrameFaceRegion = fittedWhole(m_draws);
        out.model.uploadPerFrameFaceRegion = fittedWhole(m_uploads);
        Slowdown slowdown;
        for (std::size_t k = 0; k < m_sizes.size(); ++k)
            out.model.decimation[m_options.regions[k]] = m_sizes[k]->fitted(slowdown);
        for (auto& [cells, fitted] : out.model.decimation)
            fitted.perMomentRegionFace = scaled(fitted.perMomentRegionFace, slowdown.factor());
        for (std::size_t k = 0; k < m_sizes.size(); ++k) {
            const int cells = m_options.regions[k];
            for (std::size_t p = 0; p < m_options.periods.size(); ++p) {
                const WorkCount count = m_sizes[k]->count(p);
                out.forecasts.push_back({cells, m_options.periods[p], count, out.model.cost(count, cells)});
            }
        }
        WorkCount full;
        full.frames = blocks;
        full.faces = blocks * 2 * static_cast<std::uint64_t>(m_zmap.grid().nx - 1) *
                     static_cast<std::uint64_t>(m_zmap.grid().ny - 1);
        out.undecimated = {0, 0, full, out.model.cost(full, 0)};
        return out;
    }

    static constexpr double kOtherSurface = -1;

    const StudyJob& m_job;
    const DecimationParameters& m_base;
    const RehearsalOptions& m_options;
    DrawCost& m_drawing;
    ZMap m_zmap;
    ToolChoice m_tools;
    ZMapSnapshot m_moment; ///< after the last block
    std::size_t m_block = 0;
    std::size_t m_samples = 0;
    double m_cutSeconds = 0;
    std::vector<std::unique_ptr<RehearsedRegions>> m_sizes;
    std::vector<RehearsedRegions*> m_drawn;
    RehearsedRegions* m_reference = nullptr;
    const RehearsedRegions* m_drawNext = nullptr;
    std::vector<CostSample> m_draws;   ///< frames, triangles shown, regions shown
    std::vector<CostSample> m_uploads; ///< frames, triangles made, regions shown
};

} // namespace

RehearsalOptions rehearsalFor(const StudyJob& job) {
    RehearsalOptions options;
    if (const auto grid = makeGrid(job.setup->stock, job.setup->spacing)) {
        const int cells = std::max(grid->nx, grid->ny) - 1;
        for (const int region : kRegions)
            if ((region <= cells || options.regions.empty()) &&
                RegionGrid(grid->nx, grid->ny, region).regionCount() <= kMostRegions)
                options.regions.push_back(region);
    }
    for (const int period : kPeriods)
        if (period <= 1 || static_cast<std::size_t>(period) <= job.program->blockCount())
            options.periods.push_back(period);
    return options;
}

Result<Rehearsal> rehearse(const StudyJob& job, const DecimationParameters& base,
                           const RehearsalOptions& options, DrawCost& drawing, const WorkContext& context) {
    const DecimationMethodRow& method = row(base.method);
    if (method.create == nullptr || method.wholeMap || base.allowance <= 0)
        return failure(study_finding::kNothingToOptimise);
    const auto grid = makeGrid(job.setup->stock, job.setup->spacing);
    if (!grid)
        return tl::unexpected(grid.error());
    const auto limit = static_cast<double>(memoryLimitBytes());
    if (auto fits = checkMapMemory(job.setup->stock, *grid, base, {}, limit); !fits)
        return tl::unexpected(std::move(fits.error()));
    return Rehearsing(job, base, options, drawing, uncutStock(job.setup->stock, job.setup->shape, *grid).zmap)
        .go(context);
}

} // namespace proveout
