// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/play_ahead.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/stop_watch.h"
#include "core/simulation/run/block_rows.h"
#include "core/simulation/run/changed_regions.h"

namespace proveout {

namespace {

/// A stretch ends when the regions to be made have so many points: some 4 ms of work on two threads, beside
/// which waking threads and waiting for the last one count little. The tiles of much longer ones would leave
/// the caches.
constexpr std::size_t kPointsOfStretch = 30'000;
constexpr std::size_t kBlocksOfStretch = 1024;

double sum(const std::vector<double>& seconds) {
    double all = 0;
    for (const double one : seconds)
        all += one;
    return all;
}

/// The seconds of all threads that a stretch took to cut, and those that its regions took.
double cutSeconds(const CutStretch& stretch) {
    double all = 0;
    for (const CutStretch::Block& block : stretch.blocks)
        all += block.seconds;
    return all;
}

double madeSeconds(const CutStretch& stretch) {
    double all = 0;
    for (const CutStretch::Moment& moment : stretch.moments)
        all += sum(moment.seconds);
    return all;
}

} // namespace

PlayAhead::PlayAhead(Simulation::State& state, std::size_t last)
    : m_state(state), m_last(last), m_shown(state.stock.block),
      m_front(state.surface.grid(), state.base.zmap, state.surface.listOfDirtyRegions()) {}

void PlayAhead::play(Simulation::State& state, std::size_t block, const WorkContext& context) {
    const auto isPlayed = [&](std::size_t one) {
        return one < state.rows.size() && state.rows[one].isPlayed();
    };
    const auto part = [&](std::size_t at) { return static_cast<double>(at) / static_cast<double>(block); };
    for (std::size_t next = 0; next < block && !context.stopped();) {
        std::size_t last = next;
        while (last < block && !isPlayed(last))
            ++last;
        if (last == next) {
            ++next;
            continue;
        }
        if (state.stock.block != next || state.behind)
            state.seek(next, context.quiet());
        PlayAhead(state, last).run(context.part(part(next), part(last)));
        if (state.behind && state.surfaceMemory.exceeded())
            state.giveUpSurface(); // the blocks that have no rows yet are played without a surface
        else
            next = last;
    }
    if (!context.stopped())
        state.seek(block, context.quiet());
}

void PlayAhead::run(const WorkContext& context) {
    const std::size_t first = m_shown;
    CutStretch next = cutStretch(context);
    while (!next.blocks.empty()) {
        CutStretch now = std::exchange(next, {});
        // Two stretches at once need memory for the tiles of both.
        const bool isSmall = now.points < 4 * kPointsOfStretch;
        const StopWatch watch;
        const auto work = [&](const WorkContext& limited) {
            inParallel(now.jobs.size() + 1, [&](std::size_t k) {
                if (k > 0)
                    make(now, now.jobs[k - 1], limited.stop);
                else if (isSmall)
                    apart([&] { next = cutStretch(context.quiet()); });
            });
        };
        (void)m_state.surfaceMemory.limit(m_state.surface, now.points, context,
                                          work); // without a mesh, show() ends
        // The wall time of the threads is divided among what they did.
        const double ofCutting = cutSeconds(next);
        const double ofThreads = ofCutting + madeSeconds(now);
        const double share = ofThreads > 0 ? std::min(watch.seconds() / ofThreads, 1.0) : 1;
        m_state.effort.cutSeconds -= (1 - share) * ofCutting;
        if (!show(now, share)) {
            keepUnshown(next);
            return fallBehind();
        }
        if (!isSmall)
            next = cutStretch(context);
        context.report(static_cast<double>(m_shown - first) / static_cast<double>(m_last - first));
    }
}

CutStretch PlayAhead::cutStretch(const WorkContext& context) {
    Simulation::State& state = m_state;
    CutStretch stretch;
    while (state.stock.block < m_last && stretch.blocks.size() < kBlocksOfStretch &&
           stretch.points < kPointsOfStretch && !context.stopped()) {
        const bool isNew = state.stock.block >= state.rows.size();
        const double before = state.stock.cutSeconds;
        const auto record = state.cutNext(state.stock, isNew ? &state.findings : nullptr, context);
        if (!record)
            break;
        m_front.add(stretch, state.stock.zmap, *record, state.stock.cutSeconds - before);
        if (state.schedule.isMoment(state.stock.block))
            m_front.addMoment(stretch, state.stock.moment());
    }
    return stretch;
}

void PlayAhead::make(CutStretch& stretch, const CutStretch::Job& job, const std::stop_token& stop) const {
    if (stop.stop_requested())
        return;
    CutStretch::Moment& moment = stretch.moments[job.moment];
    const StopWatch watch;
    moment.made[job.region] = m_state.surface.make(moment.regions[job.region], moment.at.zmap, stop);
    moment.seconds[job.region] = watch.seconds();
}

/// Brings rows and surface to the end of a stretch; false, before the first block whose surface is missing,
/// if it was stopped.
bool PlayAhead::show(CutStretch& stretch, double share) {
    auto moment = stretch.moments.begin();
    for (std::size_t k = 0; k < stretch.blocks.size(); ++k) {
        const bool isMoment = moment != stretch.moments.end() && moment->at.block == m_shown + 1;
        if (isMoment &&
            !std::ranges::all_of(moment->made, [](const auto& made) { return made.mesh != nullptr; })) {
            stretch.blocks.erase(stretch.blocks.begin(),
                                 stretch.blocks.begin() + static_cast<std::ptrdiff_t>(k));
            keepUnshown(stretch);
            return false;
        }
        show(stretch.blocks[k], isMoment ? &*moment : nullptr, share);
        if (isMoment)
            ++moment;
    }
    return true;
}

void PlayAhead::show(CutStretch::Block& block, CutStretch::Moment* moment, double share) {
    Simulation::State& state = m_state;
    for (const std::size_t region : block.touched)
        state.surface.touchRegion(region);
    BlockStatistics row = recordedRow(block.record, state.surface.facesFull());
    row.cutSeconds = static_cast<float>(block.seconds);
    row.decimationSeconds = 0;
    if (moment != nullptr) {
        const StopWatch watch;
        state.base = std::move(moment->at);
        row.regionsDecimated = static_cast<std::uint32_t>(moment->regions.size());
        state.surface.adopt(moment->regions, moment->made);
        const double seconds = share * sum(moment->seconds) + watch.seconds();
        row.decimationSeconds = static_cast<float>(seconds);
        state.effort.decimationSeconds += seconds;
    }
    row.facesShown = static_cast<std::uint32_t>(state.surface.faces());
    row.regionsDirty = static_cast<std::uint32_t>(state.surface.dirtyRegions());
    if (m_shown == state.rows.size())
        state.rows.push_back(row);
    else
        state.rows.edit(m_shown) = row;
    ++m_shown;
}

/// Rows of blocks that have been cut, as of those that a seek passes.
void PlayAhead::keepUnshown(const CutStretch& stretch) {
    for (const CutStretch::Block& block : stretch.blocks) {
        if (m_shown == m_state.rows.size())
            m_state.rows.push_back(recordedRow(block.record, m_state.surface.facesFull()));
        ++m_shown;
    }
}

void PlayAhead::fallBehind() {
    Simulation::State& state = m_state;
    for (const auto region :
         differingRegions(state.base.zmap, state.stock.zmap.snapshot(), state.surface.grid()))
        state.surface.touchRegion(region);
    state.behind = state.schedule.decimates();
}

} // namespace proveout
