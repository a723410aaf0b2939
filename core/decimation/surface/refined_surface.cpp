// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/surface/refined_surface.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <utility>

#include "core/base/memory.h"
#include "core/base/parallel.h"
#include "core/decimation/surface/region_merge.h"
#include "core/decimation/surface/tally.h"

namespace proveout {

struct RefinedSurface::Worker {
    RegionMerge merge;
    std::vector<float> heights;
};

namespace {

/// The share of the regions themselves in the total time, as measured for a first run.
constexpr double kShareOfRegions = 0.4;

/// The mesh of the regions of a merged block other than its first.
const RegionMeshPtr& nothingLeft() {
    static const auto mesh = std::make_shared<const RegionMesh>();
    return mesh;
}

} // namespace

RefinedSurface::RefinedSurface(int nx, int ny, const DecimationParameters& parameters, int mostCells)
    : m_surface(nx, ny, parameters) {
    const RegionGrid& regions = grid();
    int side = 1;
    while (side < std::max(regions.regionsX(), regions.regionsY()) &&
           2 * side * regions.cells() <= mostCells) {
        side *= 2;
        Layer layer;
        layer.regions = side;
        layer.blocksX = (regions.regionsX() + side - 1) / side;
        layer.blocksY = (regions.regionsY() + side - 1) / side;
        layer.blocks.resize(static_cast<std::size_t>(layer.blocksX) *
                            static_cast<std::size_t>(layer.blocksY));
        m_layers.push_back(std::move(layer));
    }
}

bool RefinedSurface::follow(const ZMapSnapshot& moment, std::span<const std::size_t> changed,
                            const WorkContext& context) {
    for (const std::size_t region : changed)
        m_surface.touchRegion(region);
    if (m_surface.dirtyRegions() > 0 && !redecimate(moment, context.part(0, kShareOfRegions)))
        return false;
    const double share =
        (1 - kShareOfRegions) / static_cast<double>(std::max<std::size_t>(m_layers.size(), 1));
    for (std::size_t layer = 0; layer < m_layers.size(); ++layer) {
        const double begin = kShareOfRegions + share * static_cast<double>(layer);
        if (!mergeLayer(layer, moment, context.part(begin, begin + share)))
            return false;
    }
    assemble();
    return true;
}

/// Points that a border kept for one of its regions may become unnecessary once that region is decimated
/// again. So all regions connected by such borders are decimated again without these points; if a region
/// beyond them turns out to need one, it joins them and all start again. The result is the same as if all
/// regions of a surface were decimated together.
bool RefinedSurface::redecimate(const ZMapSnapshot& moment, const WorkContext& context) {
    m_isTogether.resize(grid().regionCount());
    const auto join = [this](std::size_t region) {
        if (!m_isTogether[region])
            m_together.push_back(region);
        m_isTogether[region] = true;
    };
    for (std::size_t region = 0; region < grid().regionCount(); ++region)
        if (m_surface.isDirty(region))
            join(region);
    bool again = false;
    for (std::size_t joined = 0; joined != m_together.size();) {
        const SurfaceSnapshot before = m_surface.snapshot();
        spreadAlongExtras(before);
        joined = m_together.size();
        if (m_surface.parameters().level == ErrorLevel::surface)
            for (const std::size_t region : m_together)
                m_surface.touchRegion(region);
        (void)m_surface.decimateDirty(moment, again ? context.quiet() : context);
        again = true;
        if (m_surface.dirtyRegions() > 0)
            return false;
        for (std::size_t region = 0; region < grid().regionCount(); ++region)
            if (m_surface.mesh(region) != before.meshes[region])
                join(region);
    }
    for (const std::size_t region : m_together)
        m_isTogether[region] = false;
    m_together.clear();
    return true;
}

/// Adds the regions that borders with extra points connect to those that are joined already.
void RefinedSurface::spreadAlongExtras(const SurfaceSnapshot& shown) {
    for (std::size_t k = 0; k < m_together.size(); ++k) {
        for (const std::size_t border : grid().borders(m_together[k])) {
            const BorderLinePtr& line = shown.borders[border];
            if (!line || line->extras.empty())
                continue;
            for (const std::size_t region : grid().sharers(border)) {
                if (region == RegionGrid::kNoRegion || m_isTogether[region])
                    continue;
                m_isTogether[region] = true;
                m_together.push_back(region);
            }
        }
    }
}

/// The mesh that covers a block of the layer below `layer` (a region, below the first layer).
RegionMeshPtr RefinedSurface::meshBelow(std::size_t layer, int bx, int by) const {
    if (layer == 0)
        return m_surface.mesh(grid().regionAt(bx, by));
    const Layer& below = m_layers[layer - 1];
    return below.blocks[static_cast<std::size_t>(by * below.blocksX + bx)].mesh;
}

bool RefinedSurface::mergeLayer(std::size_t index, const ZMapSnapshot& moment, const WorkContext& context) {
    Layer& layer = m_layers[index];
    const int belowX = index == 0 ? grid().regionsX() : m_layers[index - 1].blocksX;
    const int belowY = index == 0 ? grid().regionsY() : m_layers[index - 1].blocksY;
    std::vector<std::size_t> changed;
    for (std::size_t block = 0; block < layer.blocks.size(); ++block) {
        const int bx = static_cast<int>(block) % layer.blocksX;
        const int by = static_cast<int>(block) / layer.blocksX;
        std::array<RegionMeshPtr, 4> parts;
        bool whole = true;
        std::size_t triangles = 0;
        for (int k = 0; k < 4; ++k) {
            const int x = 2 * bx + k % 2;
            const int y = 2 * by + k / 2;
            if (x >= belowX || y >= belowY)
                continue;
            const RegionMeshPtr& part = parts[static_cast<std::size_t>(k)] = meshBelow(index, x, y);
            whole &= part && parts[0] && part->allowance == parts[0]->allowance;
            triangles += part ? part->triangles.size() : 0;
        }
        if (parts == layer.blocks[block].parts && layer.blocks[block].mesh)
            continue;
        layer.blocks[block] = {parts, nullptr};
        if (whole && triangles <= kMostTriangles)
            changed.push_back(block);
    }
    std::vector<RegionMeshPtr> meshes(changed.size());
    tbb::enumerable_thread_specific<Worker> workers;
    Tally tally(context, changed.size());
    inParallel(changed.size(), [&](std::size_t k) {
        if (context.stopped())
            return;
        meshes[k] = merged(layer, changed[k], moment, workers.local(), context.stop);
        tally.finished();
    });
    if (context.stopped())
        return false;
    for (std::size_t k = 0; k < changed.size(); ++k)
        layer.blocks[changed[k]].mesh = std::move(meshes[k]);
    return true;
}

RegionMeshPtr RefinedSurface::merged(const Layer& layer, std::size_t block, const ZMapSnapshot& moment,
                                     Worker& worker, const std::stop_token& stop) const {
    std::vector<RegionMeshPtr> parts;
    for (const RegionMeshPtr& part : layer.blocks[block].parts)
        if (part)
            parts.push_back(part);
    if (parts.size() == 1)
        return parts.front(); // at the edge of the map
    const int cells = layer.regions * grid().cells();
    const int i0 = static_cast<int>(block) % layer.blocksX * cells;
    const int j0 = static_cast<int>(block) / layer.blocksX * cells;
    const IndexRect rect{i0, j0, std::min(i0 + cells + 1, grid().nx()),
                         std::min(j0 + cells + 1, grid().ny())};
    worker.heights.resize(static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height()));
    moment.read(rect, worker.heights);
    DecimationParameters parameters = m_surface.parameters();
    parameters.allowance = parts.front()->allowance;
    const std::vector<std::uint32_t> walls = moment.walls().offsetsIn(rect);
    return worker.merge.merge(grid(), {rect, moment.grid().hx, moment.grid().hy, worker.heights, walls},
                              parts, {cells / 2, cells / 2}, parameters, stop);
}

void RefinedSurface::assemble() {
    SurfaceSnapshot shown = m_surface.snapshot();
    const std::size_t layers = m_layers.size();
    const int topX = layers == 0 ? grid().regionsX() : m_layers.back().blocksX;
    const int topY = layers == 0 ? grid().regionsY() : m_layers.back().blocksY;
    for (int by = 0; by < topY; ++by)
        for (int bx = 0; bx < topX; ++bx)
            cover(shown, layers, bx, by);
    shown.faces = 0;
    for (std::size_t region = 0; region < shown.meshes.size(); ++region)
        shown.faces += shown.meshes[region]->triangles.size();
    m_merged = std::move(shown);
}

/// Shows a block of the layer below `layer` as one mesh, or as its parts.
void RefinedSurface::cover(SurfaceSnapshot& shown, std::size_t layer, int bx, int by) const {
    if (layer == 0)
        return; // a region, shown unmerged
    const Layer& own = m_layers[layer - 1];
    const RegionMeshPtr& mesh = own.blocks[static_cast<std::size_t>(by * own.blocksX + bx)].mesh;
    if (!mesh) {
        const int belowX = layer == 1 ? grid().regionsX() : m_layers[layer - 2].blocksX;
        const int belowY = layer == 1 ? grid().regionsY() : m_layers[layer - 2].blocksY;
        for (int y = 2 * by; y < std::min(2 * by + 2, belowY); ++y)
            for (int x = 2 * bx; x < std::min(2 * bx + 2, belowX); ++x)
                cover(shown, layer - 1, x, y);
        return;
    }
    const int endX = std::min((bx + 1) * own.regions, grid().regionsX());
    const int endY = std::min((by + 1) * own.regions, grid().regionsY());
    for (int y = by * own.regions; y < endY; ++y)
        for (int x = bx * own.regions; x < endX; ++x)
            shown.meshes.edit(grid().regionAt(x, y)) = nothingLeft();
    shown.meshes.edit(grid().regionAt(bx * own.regions, by * own.regions)) = mesh;
}

namespace {

SurfaceSnapshot wholeSurface(const ZMapSnapshot& zmap, const DecimationParameters& parameters,
                             const WorkContext& context) {
    const Grid& grid = zmap.grid();
    if (canMerge(parameters)) {
        RefinedSurface surface(grid.nx, grid.ny, parameters, kMostExportCells);
        (void)surface.follow(zmap, {}, context);
        return surface.snapshot();
    }
    Surface surface(grid.nx, grid.ny, parameters);
    (void)surface.decimateDirty(zmap, context);
    return surface.snapshot();
}

} // namespace

SurfaceSnapshot decimatedWhole(const ZMapSnapshot& zmap, const DecimationParameters& parameters,
                               const WorkContext& context) {
    SurfaceSnapshot surface = wholeSurface(zmap, parameters, context);
    returnFreedMemory(); // the parts that were merged had twice as much as remains
    return surface;
}

} // namespace proveout
