// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rehearsed_regions.h"

#include <algorithm>
#include <iterator>

#include "core/base/stop_watch.h"
#include "core/decimation/regions/region_decimator.h"

namespace proveout {

namespace {

/// Number of regions of the uncut stock: all its regions are alike, except the narrow ones at the edge.
constexpr std::size_t kStartRegions = 16;

/// The share that a rehearsal decimates of the regions that all schedules of a size decimate.
constexpr double kSampledShare = 0.03;

/// Triangles of the uncut stock's regions: decimated ones have their own, the others as many in proportion to
/// their size.
std::vector<double> facesOf(const Surface& surface) {
    const SurfaceSnapshot now = surface.snapshot();
    double made = 0;
    double full = 0;
    for (std::size_t region = 0; region < now.meshes.size(); ++region)
        if (now.meshes[region]) {
            made += static_cast<double>(now.meshes[region]->triangles.size());
            full += static_cast<double>(fullRegionFaces(now.grid, region));
        }
    std::vector<double> faces;
    for (std::size_t region = 0; region < now.meshes.size(); ++region)
        faces.push_back(now.meshes[region]
                            ? static_cast<double>(now.meshes[region]->triangles.size())
                            : made / full * static_cast<double>(fullRegionFaces(now.grid, region)));
    return faces;
}

} // namespace

RehearsedRegions::RehearsedRegions(const ZMapSnapshot& uncut, const DecimationParameters& parameters,
                                   std::span<const int> periods, bool all, const std::stop_token& stop)
    : m_surface(startSurface(uncut, parameters, all, stop, m_perStartRegion)),
      m_faces(m_surface.grid(), facesOf(m_surface)), m_trace(m_surface.grid(), periods, m_faces.now()) {}

Surface RehearsedRegions::startSurface(const ZMapSnapshot& uncut, const DecimationParameters& parameters,
                                       bool all, const std::stop_token& stop, double& perRegion) {
    Surface surface(uncut.grid().nx, uncut.grid().ny, whileCutting(parameters)); // as in a run
    const std::size_t regions = surface.grid().regionCount();
    const std::size_t wanted = all ? regions : std::min(regions, kStartRegions);
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < wanted; ++k)
        chosen.push_back(k * regions / wanted);
    // The first one wakes sleeping threads and allocates storage.
    const std::size_t first = wanted > 1 ? surface.decimateRegions(std::span(chosen).first(1), uncut) : 0;
    const StopWatch watch;
    surface.decimateRegions(std::span(chosen).subspan(first), uncut, {stop, {}});
    perRegion = watch.seconds() / static_cast<double>(wanted - first);
    return surface;
}

void RehearsedRegions::block(const ZMapSnapshot& before, const ZMapSnapshot& after,
                             const IndexRect& changed) {
    m_lastTouched.clear();
    const RegionGrid& grid = m_trace.grid();
    const IndexRect near = changed.empty() ? IndexRect{} : grid.regionsTouching(changed);
    for (int ry = near.j0; ry < near.j1; ++ry)
        for (int rx = near.i0; rx < near.i1; ++rx) {
            const std::size_t region = grid.regionAt(rx, ry);
            if (!before.sameHeights(after, intersection(grid.points(region), changed)))
                m_lastTouched.push_back(region);
        }
    for (const std::size_t region : m_lastTouched)
        m_surface.touchRegion(region);
    m_trace.block(m_lastTouched);
}

std::size_t RehearsedRegions::affordable() const {
    const auto share = static_cast<std::size_t>(kSampledShare * double(m_trace.decimatedByAll()));
    return share > m_sampled ? share - m_sampled : 1;
}

std::size_t RehearsedRegions::sample(const ZMapSnapshot& now, const RehearsedRegions* reference) {
    const std::vector<std::size_t> touched = m_trace.touchedSinceSample();
    const auto pick = [this](const std::vector<std::size_t>& from, std::size_t most) {
        std::vector<std::size_t> picked;
        std::ranges::sample(from, std::back_inserter(picked), static_cast<std::ptrdiff_t>(most), m_random);
        return picked;
    };
    const std::size_t most = reference == nullptr ? touched.size() : affordable();
    const std::vector<std::size_t> last = pick(m_lastTouched, (most + 1) / 2);
    std::vector<std::size_t> others;
    std::ranges::set_difference(touched, last, std::back_inserter(others));
    others = pick(others, most - last.size());
    // Some are decimated first, unmeasured: a run decimates so often that it finds its storage in the caches.
    const std::size_t early = (others.size() + 3) / 4;
    m_surface.decimateRegions(std::span(others).first(early), now);
    measure(std::span(others).subspan(early), now);
    measure(last, now);
    m_sampled += others.size() + last.size();

    const SurfaceSnapshot surface = m_surface.snapshot();
    m_trace.sample(
        m_faces.update(touched, others, surface, (reference == nullptr ? *this : *reference).m_faces));
    std::size_t made = 0;
    for (const auto& batch : {last, others})
        for (const std::size_t region : batch)
            made += surface.meshes[region]->triangles.size();
    return made;
}

void RehearsedRegions::measure(std::span<const std::size_t> regions, const ZMapSnapshot& now) {
    if (regions.empty())
        return;
    const StopWatch watch;
    m_surface.decimateRegions(regions, now);
    const double seconds = watch.seconds();
    double made = 0;
    const SurfaceSnapshot surface = m_surface.snapshot();
    for (const std::size_t region : regions)
        made += static_cast<double>(surface.meshes[region]->triangles.size());
    m_samples.push_back({{1, static_cast<double>(regions.size()), made}, seconds});
}

CostModel::Decimation RehearsedRegions::fitted(Slowdown& slowdown) const {
    const Coefficients coefficients = fitCost(m_samples);
    slowdown.add(m_samples, coefficients);
    return {m_perStartRegion, coefficients};
}

} // namespace proveout
