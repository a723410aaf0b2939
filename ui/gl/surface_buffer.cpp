// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/surface_buffer.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "ui/gl/coarse_points.h"

namespace proveout {
namespace {

/// Strips with this many cells keep a row's points in the vertex cache until the next row uses them.
constexpr int kStripCells = 16;

/// The canonical 4-8 triangulation of every step-th point of a rectangle, as offsets from its first point.
std::vector<std::uint32_t> patternIndices(int nx, const IndexRect& points, int step) {
    std::vector<std::uint32_t> indices;
    const std::vector<int> columns = sampledPoints(0, points.width(), points.width(), step).points;
    const std::vector<int> rows = sampledPoints(0, points.height(), points.height(), step).points;
    const auto cellsX = static_cast<int>(columns.size()) - 1;
    const auto cellsY = static_cast<int>(rows.size()) - 1;
    indices.reserve(static_cast<std::size_t>(cellsX) * static_cast<std::size_t>(cellsY) * 6);
    const auto offset = [&](int i, int j) {
        return static_cast<std::uint32_t>(rows[static_cast<std::size_t>(j)]) *
                   static_cast<std::uint32_t>(nx) +
               static_cast<std::uint32_t>(columns[static_cast<std::size_t>(i)]);
    };
    for (int strip = 0; strip < cellsX; strip += kStripCells)
        for (int j = 0; j < cellsY; ++j)
            for (int i = strip; i < std::min(strip + kStripCells, cellsX); ++i) {
                const std::uint32_t sw = offset(i, j);
                const std::uint32_t se = offset(i + 1, j);
                const std::uint32_t nw = offset(i, j + 1);
                const std::uint32_t ne = offset(i + 1, j + 1);
                if ((points.i0 + i + points.j0 + j) % 2 == 0)
                    indices.insert(indices.end(), {sw, se, ne, sw, ne, nw});
                else
                    indices.insert(indices.end(), {sw, se, nw, se, ne, nw});
            }
    return indices;
}

/// The points of a region excluding those on its borders.
IndexRect inner(const IndexRect& points) {
    return {points.i0 + 1, points.j0 + 1, points.i1 - 1, points.j1 - 1};
}

/// 16 bits if all indices fit. The size of the region does not decide this, because a merged mesh extends
/// beyond its own region.
IndexWidth widthFor(const std::vector<std::uint32_t>& indices) {
    const bool fits = std::ranges::all_of(
        indices, [](std::uint32_t index) { return index <= std::numeric_limits<std::uint16_t>::max(); });
    return fits ? IndexWidth::bits16 : IndexWidth::bits32;
}

bool hasCells(const IndexRect& points) {
    return points.width() > 1 && points.height() > 1;
}

bool meetsPolyline(const std::array<BorderLinePtr, 4>& borders) {
    return std::ranges::any_of(borders, [](const auto& line) { return line != nullptr; });
}

/// The triangles of a z-map region that have a corner on its borders.
std::vector<LatticeTriangle> transitionStrip(const RegionGrid& grid, std::size_t region,
                                             const std::array<BorderLinePtr, 4>& borders) {
    std::vector<LatticeTriangle> triangles = fullRegionMesh(grid, region, borders);
    const IndexRect within = inner(grid.points(region));
    const auto nx = static_cast<std::uint32_t>(grid.nx());
    std::erase_if(triangles, [&](const LatticeTriangle& triangle) {
        return std::ranges::all_of(triangle, [&](std::uint32_t point) {
            const auto i = static_cast<int>(point % nx);
            const auto j = static_cast<int>(point / nx);
            return i >= within.i0 && i < within.i1 && j >= within.j0 && j < within.j1;
        });
    });
    return triangles;
}

std::vector<std::uint32_t> indicesFrom(std::uint32_t first, const std::vector<LatticeTriangle>& triangles) {
    std::vector<std::uint32_t> indices;
    indices.reserve(triangles.size() * 3);
    for (const LatticeTriangle& triangle : triangles)
        for (const std::uint32_t point : triangle)
            indices.push_back(point - first);
    return indices;
}

} // namespace

void SurfaceBuffer::DrawList::clear() {
    counts.clear();
    offsets.clear();
    baseVertices.clear();
}

void SurfaceBuffer::DrawList::add(std::uint32_t offset, std::uint32_t count, std::uint32_t baseVertex) {
    counts.push_back(static_cast<GLsizei>(count));
    offsets.push_back(bufferPlace(std::size_t{offset} * IndexBuffer::kHalf));
    baseVertices.push_back(static_cast<GLint>(baseVertex));
}

IndexBuffer::Slot SurfaceBuffer::write(Gl& gl, IndexBuffer::Slot slot,
                                       const std::vector<std::uint32_t>& indices, IndexWidth width,
                                       Uploaded& uploaded) {
    ++uploaded.lists;
    uploaded.indices += indices.size();
    uploaded.bytes += indices.size() * (width == IndexWidth::bits16 ? 1 : 2) * IndexBuffer::kHalf;
    const std::optional<IndexBuffer::Slot> written = m_indices.write(gl, slot, indices, width);
    uploaded.fits = uploaded.fits && written;
    return written.value_or(IndexBuffer::Slot{});
}

void SurfaceBuffer::writeList(Gl& gl, std::size_t index, const std::vector<LatticeTriangle>& triangles,
                              Uploaded& uploaded) {
    Region& region = m_regions[index];
    region.count = static_cast<std::uint32_t>(triangles.size() * 3);
    if (triangles.empty())
        return;
    const std::vector<std::uint32_t> indices = indicesFrom(firstPoint(index), triangles);
    region.width = widthFor(indices);
    region.slot = write(gl, region.slot, indices, region.width, uploaded);
}

std::uint32_t SurfaceBuffer::firstPoint(std::size_t region) const {
    const IndexRect points = m_grid.points(region);
    return m_grid.lattice(points.i0, points.j0);
}

SurfaceBuffer::Pattern SurfaceBuffer::pattern(Gl& gl, const IndexRect& points, Uploaded& uploaded) {
    const auto key = std::tuple{points.width(), points.height(), (points.i0 + points.j0) % 2};
    auto found = m_patterns.find(key);
    if (found == m_patterns.end()) {
        const std::vector<std::uint32_t> indices = patternIndices(m_grid.nx(), points, m_step);
        const IndexWidth width = widthFor(indices);
        const Pattern made{write(gl, {}, indices, width, uploaded), width,
                           static_cast<std::uint32_t>(indices.size())};
        found = m_patterns.emplace(key, made).first;
    }
    return found->second;
}

bool SurfaceBuffer::updateRegion(Gl& gl, const SurfaceSnapshot& surface, std::size_t index,
                                 Uploaded& uploaded) {
    Region& region = m_regions[index];
    const RegionMeshPtr& mesh = surface.meshes[index];
    if (mesh != nullptr) {
        if (region.mesh == mesh)
            return false;
        region.mesh = mesh;
        region.borders = {};
        writeList(gl, index, mesh->triangles, uploaded);
    } else {
        const std::array<BorderLinePtr, 4> borders = surface.regionBorders(index);
        if (region.known && region.mesh == nullptr && region.borders == borders)
            return false;
        region.mesh = nullptr;
        region.borders = borders;
        if (meetsPolyline(borders))
            writeList(gl, index, transitionStrip(m_grid, index, borders), uploaded);
        else
            region.count = 0;
    }
    region.known = true;
    return true;
}

void SurfaceBuffer::forget() {
    m_regions.assign(m_regions.size(), {});
    m_patterns.clear();
    m_indices.clear();
    m_collected = false;
    m_resume = 0;
}

void SurfaceBuffer::updateRegions(Gl& gl, const SurfaceSnapshot& surface, const UploadBudget& budget,
                                  Uploaded& uploaded) {
    const std::size_t first = m_resume;
    for (std::size_t k = 0; k < m_regions.size() && uploaded.whole && uploaded.fits; ++k) {
        const std::size_t index = (first + k) % m_regions.size();
        if (!updateRegion(gl, surface, index, uploaded))
            continue;
        m_collected = false;
        uploaded.changed = true;
        uploaded.whole = !budget.spent();
        m_resume = index + 1;
    }
    if (uploaded.whole && uploaded.fits && !m_collected) {
        collect(gl, uploaded);
        m_collected = true;
    }
}

void SurfaceBuffer::setLimit(std::size_t bytes) {
    m_indices.setLimit(bytes);
    m_restarted = false;
}

SurfaceBuffer::Uploaded SurfaceBuffer::update(Gl& gl, const SurfaceSnapshot& surface,
                                              const UploadBudget& budget, int step) {
    Uploaded uploaded;
    if (!(surface.grid == m_grid) || m_regions.size() != surface.meshes.size() || step != m_step) {
        m_grid = surface.grid;
        m_step = step;
        m_regions.resize(surface.meshes.size());
        forget();
    }
    updateRegions(gl, surface, budget, uploaded);
    if (!uploaded.fits && !m_restarted) { // unless the room is only in pieces
        forget();
        m_indices.restart(gl);
        m_restarted = true; // updates in slices must not restart forever
        uploaded.whole = uploaded.fits = true;
        updateRegions(gl, surface, budget, uploaded);
    }
    if (!uploaded.fits)
        forget();
    else if (uploaded.whole)
        m_restarted = false;
    return uploaded;
}

std::size_t SurfaceBuffer::bytesFor(const SurfaceSnapshot& surface) {
    constexpr std::size_t kTriangle = 3 * sizeof(std::uint32_t);
    const auto cells = static_cast<std::size_t>(surface.grid.cells());
    std::size_t bytes = 0;
    for (std::size_t region = 0; region < surface.meshes.size(); ++region)
        if (const RegionMeshPtr& mesh = surface.meshes[region]; mesh != nullptr)
            bytes += SlotAllocator::rounded(mesh->triangles.size() * kTriangle);
        else if (meetsPolyline(surface.regionBorders(region)))
            bytes += SlotAllocator::rounded(8 * cells * kTriangle); // a strip of two triangles a cell
    return bytes;
}

void SurfaceBuffer::collect(Gl& gl, Uploaded& uploaded) {
    m_triangles = {};
    for (auto& ofPart : m_lists)
        for (DrawList& list : ofPart)
            list.clear();
    for (std::size_t index = 0; index < m_regions.size(); ++index) {
        const Region& region = m_regions[index];
        const Part part = region.mesh ? Part::decimated : Part::fromZMap;
        std::size_t& triangles = m_triangles[static_cast<std::size_t>(part)];
        if (region.count > 0) {
            listOf(part, region.width).add(region.slot.offset, region.count, firstPoint(index));
            triangles += region.count / 3;
        }
        if (region.mesh != nullptr)
            continue;
        const IndexRect all = m_grid.points(index);
        const IndexRect points = meetsPolyline(region.borders) ? inner(all) : all;
        if (!hasCells(points))
            continue;
        const Pattern shared = pattern(gl, points, uploaded);
        if (!uploaded.fits)
            return;
        listOf(part, shared.width)
            .add(shared.slot.offset, shared.count, m_grid.lattice(points.i0, points.j0));
        triangles += shared.count / 3;
    }
}

void SurfaceBuffer::draw(Gl& gl, Part part) {
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices.id());
    for (const IndexWidth width : {IndexWidth::bits16, IndexWidth::bits32}) {
        const DrawList& list = listOf(part, width);
        if (!list.counts.empty())
            gl.glMultiDrawElementsBaseVertex(
                GL_TRIANGLES, list.counts.data(),
                width == IndexWidth::bits16 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT, list.offsets.data(),
                static_cast<GLsizei>(list.counts.size()), list.baseVertices.data());
    }
}

void SurfaceBuffer::release(Gl& gl) {
    m_regions.clear();
    forget();
    m_indices.release(gl);
    m_restarted = false;
}

} // namespace proveout
