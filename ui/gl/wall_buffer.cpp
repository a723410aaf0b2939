// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/wall_buffer.h"

#include <algorithm>

namespace proveout {
namespace {

/// The regions along one side of the map, in the order of its border's offsets.
std::vector<std::size_t> regionsAlong(const RegionGrid& grid, Side side) {
    std::vector<std::size_t> regions;
    const bool alongX = side == Side::south || side == Side::north;
    const int count = alongX ? grid.regionsX() : grid.regionsY();
    regions.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k)
        regions.push_back(alongX ? grid.regionAt(k, side == Side::south ? 0 : grid.regionsY() - 1)
                                 : grid.regionAt(side == Side::west ? 0 : grid.regionsX() - 1, k));
    return regions;
}

/// The lattice points of one side of the map, running so that the stock lies to the left: seen from outside,
/// from left to right.
std::vector<std::uint32_t> polyline(const SurfaceSnapshot& surface, Side side) {
    std::vector<std::uint32_t> points;
    for (const std::size_t region : regionsAlong(surface.grid, side)) {
        const std::size_t border = surface.grid.border(region, side);
        const IndexRect rect = surface.grid.borderPoints(border);
        const bool alongX = rect.width() > 1;
        const auto add = [&](std::uint32_t offset) {
            const int step = static_cast<int>(offset);
            points.push_back(
                surface.grid.lattice(rect.i0 + (alongX ? step : 0), rect.j0 + (alongX ? 0 : step)));
        };
        const auto last = static_cast<std::uint32_t>(std::max(rect.width(), rect.height()) - 1);
        if (const BorderLinePtr& line = surface.borders[border])
            std::ranges::for_each(line->kept, add);
        else
            for (std::uint32_t offset = 0; offset <= last; ++offset)
                add(offset);
    }
    points.erase(std::unique(points.begin(), points.end()), points.end()); // Corners of neighbours.
    if (side == Side::north || side == Side::west)
        std::ranges::reverse(points);
    return points;
}

} // namespace

WallMesh wallMesh(const SurfaceSnapshot& surface) {
    WallMesh mesh;
    const RegionGrid& grid = surface.grid;
    const std::uint32_t floor = grid.lattice(0, grid.ny());
    const std::uint32_t middle = floor + grid.lattice(grid.nx() / 2, grid.ny() / 2);
    auto& underside = mesh.faces[WallMesh::kUnderside];
    for (const Side side : kSides) {
        const std::vector<std::uint32_t> top = polyline(surface, side);
        auto& wall = mesh.faces[static_cast<std::size_t>(side)];
        for (std::size_t k = 0; k + 1 < top.size(); ++k) {
            const std::uint32_t a = top[k];
            const std::uint32_t b = top[k + 1];
            wall.insert(wall.end(), {a + floor, b + floor, b, a + floor, b, a});
            underside.insert(underside.end(), {middle, b + floor, a + floor});
        }
    }
    return mesh;
}

std::size_t WallBuffer::update(Gl& gl, const SurfaceSnapshot& surface) {
    std::vector<BorderLinePtr> lines;
    for (const Side side : kSides)
        for (const std::size_t region : regionsAlong(surface.grid, side))
            lines.push_back(surface.borders[surface.grid.border(region, side)]);
    if (m_buffer != 0 && surface.grid == m_grid && lines == m_lines)
        return 0;
    m_grid = surface.grid;
    m_lines = std::move(lines);

    std::vector<std::uint32_t> indices;
    const WallMesh mesh = wallMesh(surface);
    for (std::size_t face = 0; face < WallMesh::kFaces; ++face) {
        m_first[face] = indices.size();
        indices.insert(indices.end(), mesh.faces[face].begin(), mesh.faces[face].end());
    }
    m_first[WallMesh::kFaces] = indices.size();
    if (m_buffer == 0)
        gl.glGenBuffers(1, &m_buffer);
    gl.glBindBuffer(GL_COPY_WRITE_BUFFER, m_buffer);
    gl.glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                    indices.data(), GL_DYNAMIC_DRAW);
    return indices.size();
}

void WallBuffer::draw(Gl& gl, std::size_t face) {
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffer);
    gl.glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(m_first[face + 1] - m_first[face]), GL_UNSIGNED_INT,
                      bufferPlace(m_first[face] * sizeof(std::uint32_t)));
}

void WallBuffer::release(Gl& gl) {
    if (m_buffer != 0)
        gl.glDeleteBuffers(1, &m_buffer);
    m_buffer = 0;
    m_lines.clear();
}

} // namespace proveout
