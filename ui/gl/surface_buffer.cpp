// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/surface_buffer.h"

#include <algorithm>

namespace proveout {
namespace {

/// Strips of this many cells keep a row's points in the vertex cache until the next row uses them.
constexpr int kStripCells = 16;

/// The canonical 4-8 triangulation of a rectangle of points, as offsets from its first point.
std::vector<std::uint32_t> patternIndices(int nx, const IndexRect& points) {
    std::vector<std::uint32_t> indices;
    const int cellsX = points.width() - 1;
    const int cellsY = points.height() - 1;
    indices.reserve(static_cast<std::size_t>(cellsX) * static_cast<std::size_t>(cellsY) * 6);
    for (int strip = 0; strip < cellsX; strip += kStripCells)
        for (int j = 0; j < cellsY; ++j)
            for (int i = strip; i < std::min(strip + kStripCells, cellsX); ++i) {
                const auto sw = static_cast<std::uint32_t>(j) * static_cast<std::uint32_t>(nx) +
                                static_cast<std::uint32_t>(i);
                const std::uint32_t se = sw + 1;
                const std::uint32_t nw = sw + static_cast<std::uint32_t>(nx);
                const std::uint32_t ne = nw + 1;
                if ((points.i0 + i + points.j0 + j) % 2 == 0)
                    indices.insert(indices.end(), {sw, se, ne, sw, ne, nw});
                else
                    indices.insert(indices.end(), {sw, se, nw, se, ne, nw});
            }
    return indices;
}

/// The points of a region without those on its borders.
IndexRect inner(const IndexRect& points) {
    return {points.i0 + 1, points.j0 + 1, points.i1 - 1, points.j1 - 1};
}

bool hasCells(const IndexRect& points) {
    return points.width() > 1 && points.height() > 1;
}

bool meetsPolyline(const std::array<BorderLinePtr, 4>& borders) {
    return std::ranges::any_of(borders, [](const auto& line) { return line != nullptr; });
}

/// The triangles of a region drawn from the z-map that have a corner on its borders.
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

std::span<const std::uint32_t> flat(const std::vector<LatticeTriangle>& triangles) {
    static_assert(sizeof(LatticeTriangle) == 3 * sizeof(std::uint32_t));
    return {triangles.front().data(), triangles.size() * 3};
}

} // namespace

void SurfaceBuffer::DrawList::clear() {
    counts.clear();
    offsets.clear();
    baseVertices.clear();
}

void SurfaceBuffer::DrawList::add(std::uint32_t offset, std::uint32_t count, std::uint32_t baseVertex) {
    counts.push_back(static_cast<GLsizei>(count));
    offsets.push_back(bufferPlace(std::size_t{offset} * sizeof(std::uint32_t)));
    baseVertices.push_back(static_cast<GLint>(baseVertex));
}

void SurfaceBuffer::writeList(Gl& gl, Region& region, const std::vector<LatticeTriangle>& triangles,
                              Uploaded& uploaded) {
    region.count = static_cast<std::uint32_t>(triangles.size() * 3);
    if (triangles.empty())
        return;
    region.slot = m_indices.write(gl, region.slot, flat(triangles));
    ++uploaded.lists;
    uploaded.indices += region.count;
}

const SurfaceBuffer::Pattern& SurfaceBuffer::pattern(Gl& gl, const IndexRect& points, Uploaded& uploaded) {
    const auto key = std::tuple{points.width(), points.height(), (points.i0 + points.j0) % 2};
    auto found = m_patterns.find(key);
    if (found == m_patterns.end()) {
        const std::vector<std::uint32_t> indices = patternIndices(m_grid.nx(), points);
        const Pattern made{m_indices.write(gl, {}, indices), static_cast<std::uint32_t>(indices.size())};
        found = m_patterns.emplace(key, made).first;
        ++uploaded.lists;
        uploaded.indices += made.count;
    }
    return found->second;
}

SurfaceBuffer::Uploaded SurfaceBuffer::update(Gl& gl, const SurfaceSnapshot& surface) {
    Uploaded uploaded;
    bool changed = m_regions.empty();
    if (!(surface.grid == m_grid) || m_regions.size() != surface.meshes.size()) {
        m_grid = surface.grid;
        m_regions.assign(surface.meshes.size(), {});
        m_patterns.clear();
        m_indices.clear();
        changed = true;
    }
    for (std::size_t index = 0; index < m_regions.size(); ++index) {
        Region& region = m_regions[index];
        const RegionMeshPtr& mesh = surface.meshes[index];
        if (mesh != nullptr) {
            if (region.mesh == mesh)
                continue;
            region.mesh = mesh;
            region.borders = {};
            writeList(gl, region, mesh->triangles, uploaded);
        } else {
            const std::array<BorderLinePtr, 4> borders = surface.regionBorders(index);
            if (region.known && region.mesh == nullptr && region.borders == borders)
                continue;
            region.mesh = nullptr;
            region.borders = borders;
            if (meetsPolyline(borders))
                writeList(gl, region, transitionStrip(m_grid, index, borders), uploaded);
            else
                region.count = 0;
        }
        region.known = true;
        changed = true;
    }
    if (changed)
        collect(gl, uploaded);
    return uploaded;
}

void SurfaceBuffer::collect(Gl& gl, Uploaded& uploaded) {
    m_triangles = {};
    for (DrawList& list : m_lists)
        list.clear();
    for (std::size_t index = 0; index < m_regions.size(); ++index) {
        const Region& region = m_regions[index];
        const auto part = static_cast<std::size_t>(region.mesh ? Part::decimated : Part::fromZMap);
        if (region.count > 0) {
            m_lists[part].add(region.slot.offset, region.count, 0);
            m_triangles[part] += region.count / 3;
        }
        if (region.mesh != nullptr)
            continue;
        const IndexRect all = m_grid.points(index);
        const IndexRect points = meetsPolyline(region.borders) ? inner(all) : all;
        if (!hasCells(points))
            continue;
        const Pattern& shared = pattern(gl, points, uploaded);
        m_lists[part].add(shared.slot.offset, shared.count, m_grid.lattice(points.i0, points.j0));
        m_triangles[part] += shared.count / 3;
    }
}

void SurfaceBuffer::draw(Gl& gl, Part part) {
    const DrawList& list = m_lists[static_cast<std::size_t>(part)];
    if (list.counts.empty())
        return;
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices.id());
    gl.glMultiDrawElementsBaseVertex(GL_TRIANGLES, list.counts.data(), GL_UNSIGNED_INT, list.offsets.data(),
                                     static_cast<GLsizei>(list.counts.size()), list.baseVertices.data());
}

void SurfaceBuffer::release(Gl& gl) {
    m_indices.release(gl);
    m_regions.clear();
    m_patterns.clear();
}

} // namespace proveout
