// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/surface/surface.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/base/memory.h"
#include "core/base/parallel.h"
#include "core/decimation/regions/random_order.h"
#include "core/decimation/surface/decimator_pool.h"
#include "core/decimation/surface/tally.h"

namespace proveout {

namespace {

// Families of seeds: a border and a region with the same index must not have the same random order.
constexpr std::uint64_t kBorderSeeds = 1;
constexpr std::uint64_t kRegionSeeds = 2;
/// A border takes a hundredth of the time of a region: a few of them are not worth waking a thread.
constexpr std::size_t kBordersOfTask = 64;

int cellsOfRegions(int nx, int ny, const DecimationParameters& parameters) {
    return row(parameters.method).wholeMap ? std::max(nx, ny) - 1 : parameters.regionCells;
}

} // namespace

std::array<BorderLinePtr, 4> SurfaceSnapshot::regionBorders(std::size_t region) const {
    const std::array<std::size_t, 4> indices = grid.borders(region);
    return {borders[indices[0]], borders[indices[1]], borders[indices[2]], borders[indices[3]]};
}

std::vector<LatticeTriangle> SurfaceSnapshot::triangles(std::size_t region) const {
    const RegionMeshPtr& mesh = meshes[region];
    return mesh ? mesh->triangles : fullRegionMesh(grid, region, regionBorders(region));
}

std::vector<LatticeTriangle> SurfaceSnapshot::triangles() const {
    std::vector<LatticeTriangle> all;
    all.reserve(faces);
    for (std::size_t region = 0; region < meshes.size(); ++region) {
        if (const RegionMeshPtr& mesh = meshes[region]) {
            all.insert(all.end(), mesh->triangles.begin(), mesh->triangles.end());
        } else {
            const std::vector<LatticeTriangle> full = fullRegionMesh(grid, region, regionBorders(region));
            all.insert(all.end(), full.begin(), full.end());
        }
    }
    return all;
}

std::vector<LatticeTriangle> SurfaceSnapshot::releaseTriangles() {
    std::vector<LatticeTriangle> all = triangles();
    meshes = {};
    borders = {};
    returnFreedMemory();
    return all;
}

double SurfaceSnapshot::largestError() const {
    double largest = 0;
    for (std::size_t region = 0; region < meshes.size(); ++region)
        if (const RegionMeshPtr& mesh = meshes[region])
            largest = std::max(largest, mesh->largestError);
    return largest;
}

Surface::Surface(int nx, int ny, const DecimationParameters& parameters)
    : m_parameters(parameters), m_pool(std::make_shared<DecimatorPool>()) {
    m_state.grid = RegionGrid(nx, ny, cellsOfRegions(nx, ny, parameters));
    m_state.meshes = PersistentArray<RegionMeshPtr>(m_state.grid.regionCount());
    m_state.borders = PersistentArray<BorderLinePtr>(m_state.grid.borderCount());
    m_allowances = RegionAllowances(m_state.grid, parameters.allowance);
    m_state.facesFull = 2 * static_cast<std::size_t>(nx - 1) * static_cast<std::size_t>(ny - 1);
    m_state.faces = m_state.facesFull;
    m_dirty = RegionSet(m_state.grid.regionCount());
    m_state.dirtyRegions = m_dirty.size();
}

std::size_t Surface::facesMade() const {
    return m_pool ? m_pool->facesMade() : 0;
}

std::size_t Surface::touch(const IndexRect& changed) {
    const std::size_t before = m_state.dirtyRegions;
    const IndexRect regions = grid().regionsTouching(changed);
    for (int ry = regions.j0; ry < regions.j1; ++ry)
        for (int rx = regions.i0; rx < regions.i1; ++rx)
            touchRegion(grid().regionAt(rx, ry));
    return m_state.dirtyRegions - before;
}

void Surface::touchRegion(std::size_t region) {
    if (isDirty(region))
        return;
    m_state.faces -= m_state.meshes[region]->triangles.size();
    m_facesHeld -= m_state.meshes[region]->triangles.size();
    m_state.meshes.edit(region) = nullptr;
    m_state.faces += fullRegionFaces(grid(), region, m_state.regionBorders(region));
    m_dirty.insert(region);
    m_state.dirtyRegions = m_dirty.size();
    for (const std::size_t border : grid().borders(region))
        releaseBorderIfUnused(border);
}

std::vector<std::size_t> Surface::followView(std::span<const double> allowances) {
    std::vector<std::size_t> outdated = m_allowances.follow(allowances);
    for (const std::size_t region : outdated)
        touchRegion(region);
    return outdated;
}

std::size_t Surface::decimateDirty(const ZMapSnapshot& moment, const WorkContext& context) {
    return m_state.dirtyRegions == 0 ? 0 : decimateRegions(m_dirty.list(), moment, context);
}

std::size_t Surface::decimateRegions(std::span<const std::size_t> regions, const ZMapSnapshot& moment,
                                     const WorkContext& context) {
    assert(moment.grid().nx == grid().nx() && moment.grid().ny == grid().ny());
    const bool decimates = row(m_parameters.method).create != nullptr && m_parameters.allowance > 0;
    if (!decimates || regions.empty() || context.stopped())
        return 0;
    // Borders first: each by its own samples, so that both its regions get the same polyline.
    if (m_parameters.borders == BorderRule::shared)
        drawMissingBorders(regions, moment, {}, context);

    std::vector<std::size_t> batch(regions.begin(), regions.end());
    std::set<std::size_t> worked(regions.begin(), regions.end());
    for (bool again = false; !batch.empty(); again = true) {
        std::vector<RegionMeshPtr> meshes = decimateBatch(batch, moment, again ? context.quiet() : context);
        ExtrasOfBorders wanted;
        for (std::size_t k = 0; k < batch.size(); ++k) {
            if (!meshes[k])
                continue;
            for (const BorderPoint& point : meshes[k]->wanted)
                wanted[grid().border(batch[k], point.side)].push_back(point.offset);
            if (meshes[k]->wanted.empty())
                publish(batch[k], std::move(meshes[k]));
        }
        batch.clear();
        if (!wanted.empty() && !context.stopped())
            batch = redraw(std::move(wanted), worked, moment, context);
        worked.insert(batch.begin(), batch.end());
    }
    const auto done = static_cast<std::size_t>(
        std::count_if(regions.begin(), regions.end(), [&](std::size_t region) { return !isDirty(region); }));
    for (const std::size_t region : worked) // stopped: no border may stay simplified between two dirty
                                            // regions
        if (isDirty(region))
            for (const std::size_t border : grid().borders(region))
                releaseBorderIfUnused(border);
    return done;
}

std::vector<RegionMeshPtr> Surface::decimateBatch(std::span<const std::size_t> regions,
                                                  const ZMapSnapshot& moment,
                                                  const WorkContext& context) const {
    std::vector<RegionMeshPtr> meshes(regions.size());
    Tally tally(context, regions.size());
    inParallel(regions.size(), [&](std::size_t k) {
        if (context.stopped())
            return;
        RegionMeshPtr mesh = decimated(regions[k], m_state.regionBorders(regions[k]), moment, context.stop);
        if (context.stopped())
            return; // perhaps in the middle of a region
        meshes[k] = std::move(mesh);
        tally.finished();
    });
    return meshes;
}

/// Draws borders with more points than before, and returns the regions at them, now dirty, that must be
/// decimated with these points: of the regions that were already dirty, only those in `worked`, which were
/// requested or whose borders changed. Points are only ever added, so it ends, in practice after two or three
/// rounds.
std::vector<std::size_t> Surface::redraw(ExtrasOfBorders wanted, const std::set<std::size_t>& worked,
                                         const ZMapSnapshot& moment, const WorkContext& context) {
    std::vector<std::size_t> regions;
    for (const auto& [border, offsets] : wanted)
        for (const std::size_t region : grid().sharers(border))
            if (region != RegionGrid::kNoRegion && (!isDirty(region) || worked.contains(region)))
                regions.push_back(region);
    std::sort(regions.begin(), regions.end());
    regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
    // All borders of these regions keep the extra points they have.
    for (const std::size_t region : regions) {
        for (const std::size_t border : grid().borders(region)) {
            const BorderLinePtr& line = m_state.borders[border];
            if (line && !line->extras.empty())
                wanted[border].insert(wanted[border].end(), line->extras.begin(), line->extras.end());
        }
    }
    for (auto& [border, offsets] : wanted) {
        std::sort(offsets.begin(), offsets.end());
        offsets.erase(std::unique(offsets.begin(), offsets.end()), offsets.end());
    }
    for (const std::size_t region : regions) {
        touchRegion(region);
        for (const std::size_t border : grid().borders(region))
            releaseBorderIfUnused(border);
    }
    drawMissingBorders(regions, moment, wanted, context);
    return regions;
}

/// With a stopped context some borders are skipped; no region is decimated then either.
void Surface::drawMissingBorders(std::span<const std::size_t> regions, const ZMapSnapshot& moment,
                                 const ExtrasOfBorders& extras, const WorkContext& context) {
    std::vector<std::size_t> missing;
    for (const std::size_t region : regions)
        for (const std::size_t border : grid().borders(region))
            if (!m_state.borders[border])
                missing.push_back(border);
    std::sort(missing.begin(), missing.end());
    missing.erase(std::unique(missing.begin(), missing.end()), missing.end());

    std::vector<BorderLinePtr> lines(missing.size());
    inParallelRanges(missing.size(), kBordersOfTask, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last && !context.stopped(); ++k) {
            const auto found = extras.find(missing[k]);
            lines[k] = borderLine(missing[k], moment,
                                  found == extras.end() ? std::span<const std::uint32_t>() : found->second);
        }
    });
    for (std::size_t k = 0; k < missing.size(); ++k)
        if (lines[k])
            drawBorder(missing[k], std::move(lines[k]));
}

BorderLinePtr Surface::borderLine(std::size_t border, const ZMapSnapshot& moment,
                                  std::span<const std::uint32_t> extras) const {
    const IndexRect rect = grid().borderPoints(border);
    const bool alongX = rect.height() == 1 && rect.width() > 1;
    std::vector<float> heights(static_cast<std::size_t>(rect.width() * rect.height()));
    moment.read(rect, heights);
    const std::vector<std::uint32_t> walls = moment.walls().offsetsIn(rect);
    const BorderSamples samples{heights, alongX ? moment.grid().hx : moment.grid().hy,
                                mixSeed(m_parameters.seed, kBorderSeeds, border), extras, walls};
    DecimationParameters parameters = m_parameters;
    parameters.allowance = m_allowances.border(border);
    return std::make_shared<const BorderLine>(row(m_parameters.method).simplifyBorder(samples, parameters));
}

MadeRegion Surface::make(std::size_t region, const ZMapSnapshot& moment, const std::stop_token& stop) const {
    MadeRegion made;
    if (m_parameters.borders == BorderRule::shared) {
        const std::array<std::size_t, 4> indices = grid().borders(region);
        for (std::size_t side = 0; side < indices.size(); ++side)
            made.borders[side] = borderLine(indices[side], moment, {});
    }
    RegionMeshPtr mesh = decimated(region, made.borders, moment, stop);
    if (!stop.stop_requested()) // else it may have been stopped in the middle
        made.mesh = std::move(mesh);
    return made;
}

void Surface::adopt(std::span<const std::size_t> regions, std::span<MadeRegion> made) {
    for (std::size_t k = 0; k < regions.size(); ++k) {
        const std::array<std::size_t, 4> indices = grid().borders(regions[k]);
        for (std::size_t side = 0; side < indices.size(); ++side)
            if (made[k].borders[side] && !m_state.borders[indices[side]])
                drawBorder(indices[side], std::move(made[k].borders[side]));
    }
    for (std::size_t k = 0; k < regions.size(); ++k) {
        assert(made[k].mesh->wanted.empty());
        publish(regions[k], std::move(made[k].mesh));
    }
}

RegionMeshPtr Surface::decimated(std::size_t region, const std::array<BorderLinePtr, 4>& borders,
                                 const ZMapSnapshot& moment, const std::stop_token& stop) const {
    DecimatorPool::Loan worker(*m_pool, row(m_parameters.method));
    RegionDecimator& decimator = *(*worker).decimator;
    std::vector<float>& heights = (*worker).heights;
    const IndexRect rect = grid().points(region);
    heights.resize(static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height()));
    moment.read(rect, heights);
    const std::vector<std::uint32_t> walls = moment.walls().offsetsIn(rect);
    const RegionSamples samples{rect, moment.grid().hx, moment.grid().hy, heights, walls};
    DecimationParameters parameters = m_parameters;
    parameters.allowance = m_allowances.region(region);
    RegionMesh mesh = decimator.decimate(grid(), samples, borders,
                                         mixSeed(m_parameters.seed, kRegionSeeds, region), parameters, stop);
    mesh.allowance = parameters.allowance;
    m_pool->noteFaces(mesh.triangles.size());
    return std::make_shared<const RegionMesh>(std::move(mesh));
}

void Surface::publish(std::size_t region, RegionMeshPtr mesh) {
    m_state.faces -= fullRegionFaces(grid(), region, m_state.regionBorders(region));
    m_state.faces += mesh->triangles.size();
    m_facesHeld += mesh->triangles.size();
    m_state.meshes.edit(region) = std::move(mesh);
    m_dirty.erase(region);
    m_state.dirtyRegions = m_dirty.size();
}

// The two functions below are called only while all regions at the border are dirty: each of them then shows
// one triangle less per point that the polyline drops.
void Surface::drawBorder(std::size_t border, BorderLinePtr line) {
    m_state.borders.edit(border) = std::move(line);
    m_state.faces -= facesHidden(border);
}

void Surface::releaseBorderIfUnused(std::size_t border) {
    if (!m_state.borders[border])
        return;
    for (const std::size_t region : grid().sharers(border))
        if (region != RegionGrid::kNoRegion && !isDirty(region))
            return;
    m_state.faces += facesHidden(border);
    m_state.borders.edit(border) = nullptr;
}

std::size_t Surface::facesHidden(std::size_t border) const {
    const IndexRect rect = grid().borderPoints(border);
    const auto points = static_cast<std::size_t>(rect.width() * rect.height());
    const std::size_t sharers = grid().sharers(border)[1] == RegionGrid::kNoRegion ? 1 : 2;
    return (points - m_state.borders[border]->kept.size()) * sharers;
}

} // namespace proveout
