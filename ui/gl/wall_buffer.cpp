// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/wall_buffer.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "ui/gl/coarse_points.h"

namespace proveout {
namespace {

struct EdgeBorder {
    Side side;
    std::size_t border;
};

/// Counter-clockwise, so that the stock is on the left.
std::vector<EdgeBorder> edgeBorders(const RegionGrid& grid) {
    const int lastX = grid.regionsX() - 1;
    const int lastY = grid.regionsY() - 1;
    std::vector<EdgeBorder> borders;
    const auto add = [&](int rx, int ry, Side side) {
        borders.push_back({side, grid.border(grid.regionAt(rx, ry), side)});
    };
    for (int rx = 0; rx <= lastX; ++rx)
        add(rx, 0, Side::south);
    for (int ry = 0; ry <= lastY; ++ry)
        add(lastX, ry, Side::east);
    for (int rx = lastX; rx >= 0; --rx)
        add(rx, lastY, Side::north);
    for (int ry = lastY; ry >= 0; --ry)
        add(0, ry, Side::west);
    return borders;
}

/// The lattice points of a border, also counter-clockwise.
std::vector<std::uint32_t> polyline(const SurfaceSnapshot& surface, const EdgeBorder& edge, int step) {
    std::vector<std::uint32_t> points;
    const IndexRect rect = surface.grid.borderPoints(edge.border);
    const bool alongX = rect.width() > 1;
    const auto add = [&](std::uint32_t offset) {
        const int along = static_cast<int>(offset);
        points.push_back(
            surface.grid.lattice(rect.i0 + (alongX ? along : 0), rect.j0 + (alongX ? 0 : along)));
    };
    const int count = std::max(rect.width(), rect.height());
    if (const BorderLinePtr& line = surface.borders[edge.border])
        std::ranges::for_each(line->kept, add);
    else
        for (const int offset : sampledPoints(0, count, count, step).points)
            add(static_cast<std::uint32_t>(offset));
    if (edge.side == Side::north || edge.side == Side::west)
        std::ranges::reverse(points);
    return points;
}

bool hasMergedMeshes(const SurfaceSnapshot& surface) {
    for (std::size_t region = 0; region < surface.meshes.size(); ++region)
        if (const RegionMeshPtr& mesh = surface.meshes[region]; mesh != nullptr && mesh->triangles.empty())
            return true;
    return false;
}

/// The border points at the edge of the map that belong to no triangle.
std::unordered_set<std::uint32_t> omittedPoints(const SurfaceSnapshot& surface,
                                                const std::vector<EdgeBorder>& borders, int step) {
    std::unordered_set<std::uint32_t> points;
    if (!hasMergedMeshes(surface))
        return points;
    for (const EdgeBorder& edge : borders) {
        const std::vector<std::uint32_t> line = polyline(surface, edge, step);
        points.insert(line.begin(), line.end());
    }
    for (std::size_t region = 0; region < surface.meshes.size(); ++region) {
        if (const RegionMeshPtr& mesh = surface.meshes[region]; mesh != nullptr)
            for (const LatticeTriangle& triangle : mesh->triangles)
                for (const std::uint32_t point : triangle)
                    points.erase(point);
        else // drawn from the z-map, which uses all border points
            for (const Side side : kSides)
                for (const std::uint32_t point :
                     polyline(surface, {side, surface.grid.border(region, side)}, step))
                    points.erase(point);
    }
    return points;
}

} // namespace

std::vector<WallLine> wallLines(const SurfaceSnapshot& surface, int step) {
    const std::vector<EdgeBorder> borders = edgeBorders(surface.grid);
    const std::unordered_set<std::uint32_t> omitted = omittedPoints(surface, borders, step);
    std::vector<WallLine> lines;
    lines.reserve(borders.size());
    std::size_t open = 0; // the line whose last point is still missing
    for (const EdgeBorder& edge : borders) {
        const std::size_t own = lines.size();
        lines.push_back({edge.side, {}});
        std::vector<std::uint32_t> points = polyline(surface, edge, step);
        points.pop_back(); // it is the first point of the next border
        for (const std::uint32_t point : points) {
            if (omitted.contains(point))
                continue;
            if (open != own)
                lines[open].points.push_back(point);
            lines[own].points.push_back(point);
            open = own;
        }
    }
    if (!lines.empty()) // the corners of the stock are always kept
        lines[open].points.push_back(lines.front().points.front());
    return lines;
}

WallMesh wallMesh(const RegionGrid& grid, const WallLine& line) {
    WallMesh mesh;
    const std::uint32_t floor = grid.lattice(0, grid.ny());
    const std::uint32_t middle = floor + grid.lattice(grid.nx() / 2, grid.ny() / 2);
    for (std::size_t k = 0; k + 1 < line.points.size(); ++k) {
        const std::uint32_t a = line.points[k];
        const std::uint32_t b = line.points[k + 1];
        mesh.wall.insert(mesh.wall.end(), {a + floor, b + floor, b, a + floor, b, a});
        mesh.underside.insert(mesh.underside.end(), {middle, b + floor, a + floor});
    }
    return mesh;
}

bool WallBuffer::write(Gl& gl, Piece& piece, WallLine line) {
    piece.line = std::move(line);
    WallMesh mesh = wallMesh(m_grid, piece.line);
    piece.wall = static_cast<std::uint32_t>(mesh.wall.size());
    piece.underside = static_cast<std::uint32_t>(mesh.underside.size());
    mesh.wall.insert(mesh.wall.end(), mesh.underside.begin(), mesh.underside.end());
    if (mesh.wall.empty())
        return true;
    const std::optional<IndexBuffer::Slot> slot =
        m_indices.write(gl, piece.slot, mesh.wall, IndexWidth::bits32);
    piece.slot = slot.value_or(IndexBuffer::Slot{});
    return slot.has_value();
}

std::optional<std::size_t> WallBuffer::writeChanged(Gl& gl, const std::vector<WallLine>& lines) {
    std::size_t uploaded = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        Piece& piece = m_pieces[k];
        if (piece.line.side == lines[k].side && piece.line.points == lines[k].points)
            continue;
        if (!write(gl, piece, lines[k]))
            return {};
        uploaded += piece.wall + piece.underside;
    }
    return uploaded;
}

std::optional<std::size_t> WallBuffer::update(Gl& gl, const SurfaceSnapshot& surface, int step) {
    const std::vector<WallLine> lines = wallLines(surface, step);
    if (m_pieces.size() != lines.size() || !(surface.grid == m_grid)) {
        m_grid = surface.grid;
        m_indices.clear();
        m_pieces.assign(lines.size(), {});
    }
    std::optional<std::size_t> uploaded = writeChanged(gl, lines);
    if (!uploaded) { // unless the room is only in pieces
        m_indices.restart(gl);
        m_pieces.assign(lines.size(), {});
        uploaded = writeChanged(gl, lines);
    }
    if (!uploaded)
        m_pieces.clear();
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
        if (piece.wall == 0)
            continue;
        add(m_lists[static_cast<std::size_t>(piece.line.side)], piece.wall, piece.slot.offset);
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
