// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/wall_buffer.h"

#include <algorithm>

namespace proveout {
namespace {

/// The lattice points of a border, running so that the stock lies to the left: seen from outside, from left
/// to right.
std::vector<std::uint32_t> polyline(const SurfaceSnapshot& surface, const EdgeBorder& edge) {
    std::vector<std::uint32_t> points;
    const IndexRect rect = surface.grid.borderPoints(edge.border);
    const bool alongX = rect.width() > 1;
    const auto add = [&](std::uint32_t offset) {
        const int step = static_cast<int>(offset);
        points.push_back(surface.grid.lattice(rect.i0 + (alongX ? step : 0), rect.j0 + (alongX ? 0 : step)));
    };
    const auto last = static_cast<std::uint32_t>(std::max(rect.width(), rect.height()) - 1);
    if (const BorderLinePtr& line = surface.borders[edge.border])
        std::ranges::for_each(line->kept, add);
    else
        for (std::uint32_t offset = 0; offset <= last; ++offset)
            add(offset);
    if (edge.side == Side::north || edge.side == Side::west)
        std::ranges::reverse(points);
    return points;
}

} // namespace

std::vector<EdgeBorder> edgeBorders(const RegionGrid& grid) {
    std::vector<EdgeBorder> borders;
    const auto add = [&](int rx, int ry, Side side) {
        borders.push_back({side, grid.border(grid.regionAt(rx, ry), side)});
    };
    for (int rx = 0; rx < grid.regionsX(); ++rx) {
        add(rx, 0, Side::south);
        add(rx, grid.regionsY() - 1, Side::north);
    }
    for (int ry = 0; ry < grid.regionsY(); ++ry) {
        add(0, ry, Side::west);
        add(grid.regionsX() - 1, ry, Side::east);
    }
    return borders;
}

WallMesh wallMesh(const SurfaceSnapshot& surface, const EdgeBorder& edge) {
    WallMesh mesh;
    const RegionGrid& grid = surface.grid;
    const std::uint32_t floor = grid.lattice(0, grid.ny());
    const std::uint32_t middle = floor + grid.lattice(grid.nx() / 2, grid.ny() / 2);
    const std::vector<std::uint32_t> top = polyline(surface, edge);
    for (std::size_t k = 0; k + 1 < top.size(); ++k) {
        const std::uint32_t a = top[k];
        const std::uint32_t b = top[k + 1];
        mesh.wall.insert(mesh.wall.end(), {a + floor, b + floor, b, a + floor, b, a});
        mesh.underside.insert(mesh.underside.end(), {middle, b + floor, a + floor});
    }
    return mesh;
}

void WallBuffer::restart(const RegionGrid& grid) {
    m_grid = grid;
    m_indices.clear();
    m_pieces.clear();
    for (const EdgeBorder& edge : edgeBorders(grid))
        m_pieces.push_back({edge, nullptr, {}, 0, 0});
}

void WallBuffer::write(Gl& gl, Piece& piece, const SurfaceSnapshot& surface) {
    WallMesh mesh = wallMesh(surface, piece.edge);
    piece.line = surface.borders[piece.edge.border];
    piece.wall = static_cast<std::uint32_t>(mesh.wall.size());
    piece.underside = static_cast<std::uint32_t>(mesh.underside.size());
    mesh.wall.insert(mesh.wall.end(), mesh.underside.begin(), mesh.underside.end());
    piece.slot = m_indices.write(gl, piece.slot, mesh.wall, IndexWidth::bits32);
}

std::size_t WallBuffer::update(Gl& gl, const SurfaceSnapshot& surface) {
    if (m_pieces.empty() || !(surface.grid == m_grid))
        restart(surface.grid);
    std::size_t uploaded = 0;
    for (Piece& piece : m_pieces) {
        if (piece.wall > 0 && piece.line == surface.borders[piece.edge.border])
            continue;
        write(gl, piece, surface);
        uploaded += piece.wall + piece.underside;
    }
    if (uploaded > 0)
        collect();
    return uploaded;
}

void WallBuffer::collect() {
    m_lists = {};
    const auto add = [](DrawList& list, std::uint32_t count, std::uint32_t half) {
        list.counts.push_back(static_cast<GLsizei>(count));
        list.offsets.push_back(bufferPlace(std::size_t{half} * IndexBuffer::kHalf));
    };
    for (const Piece& piece : m_pieces) {
        add(m_lists[static_cast<std::size_t>(piece.edge.side)], piece.wall, piece.slot.offset);
        add(m_lists[kUnderside], piece.underside, piece.slot.offset + 2 * piece.wall);
    }
}

void WallBuffer::draw(Gl& gl, std::size_t face) {
    const DrawList& list = m_lists[face];
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices.id());
    gl.glMultiDrawElements(GL_TRIANGLES, list.counts.data(), GL_UNSIGNED_INT, list.offsets.data(),
                           static_cast<GLsizei>(list.counts.size()));
}

void WallBuffer::release(Gl& gl) {
    m_indices.release(gl);
    m_pieces.clear();
}

} // namespace proveout
