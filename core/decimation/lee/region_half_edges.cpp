// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/lee/region_half_edges.h"

#include <algorithm>
#include <cassert>

namespace proveout {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

namespace {

/// The indices of the half-edges of a region. Edges: those along x row by row, those along y row by row, one
/// diagonal per cell. The even half-edge of an edge runs towards rising x or rising y; that of a diagonal
/// upwards.
struct EdgePlan {
    int cellsX;
    int cellsY;

    [[nodiscard]] int alongX(int i, int j) const { return 2 * (j * cellsX + i); }
    [[nodiscard]] int alongY(int i, int j) const {
        return 2 * (cellsX * (cellsY + 1) + j * (cellsX + 1) + i);
    }
    [[nodiscard]] int diagonal(int i, int j) const {
        return 2 * (cellsX * (cellsY + 1) + (cellsX + 1) * cellsY + j * cellsX + i);
    }
    [[nodiscard]] int edges() const { return diagonal(0, cellsY) / 2; }
};

constexpr int reversed(int halfEdge) {
    return halfEdge ^ 1;
}

} // namespace

void RegionHalfEdges::build(const IndexRect& rect, std::span<const float> heights) {
    m_width = rect.width();
    m_height = rect.height();
    const EdgePlan plan{m_width - 1, m_height - 1};
    const auto vertices = static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height);
    const auto edges = static_cast<std::size_t>(plan.edges());
    const std::size_t faces =
        2 * static_cast<std::size_t>(plan.cellsX) * static_cast<std::size_t>(plan.cellsY);
    assert(heights.size() == vertices);

    // The data of the previous region is overwritten item by item: clearing would touch everything twice.
    m_mesh.resize(vertices, edges, faces);
    for (std::size_t e = 0; e < edges; ++e)
        m_mesh.status(EdgeHandle(static_cast<int>(e))).set_bits(0);
    for (std::size_t f = 0; f < faces; ++f)
        m_mesh.status(FaceHandle(static_cast<int>(f))).set_bits(0);
    for (int j = 0, k = 0; j < m_height; ++j) {
        for (int i = 0; i < m_width; ++i, ++k) {
            m_mesh.status(VertexHandle(k)).set_bits(0);
            m_mesh.set_point(VertexHandle(k), {static_cast<double>(i), static_cast<double>(j),
                                               double{heights[static_cast<std::size_t>(k)]}});
        }
    }
    linkCells(rect);
    linkOutline();
}

void RegionHalfEdges::linkFace(int face, int first, int second, int third) {
    const FaceHandle f(face);
    const std::array loop{HalfedgeHandle(first), HalfedgeHandle(second), HalfedgeHandle(third)};
    for (std::size_t k = 0; k < loop.size(); ++k) {
        m_mesh.set_face_handle(loop[k], f);
        m_mesh.set_next_halfedge_handle(loop[k], loop[(k + 1) % 3]);
    }
    m_mesh.set_halfedge_handle(f, loop[0]);
}

void RegionHalfEdges::linkCells(const IndexRect& rect) {
    const EdgePlan plan{m_width - 1, m_height - 1};
    const auto join = [&](int halfEdge, VertexHandle from, VertexHandle to) {
        m_mesh.set_vertex_handle(HalfedgeHandle(halfEdge), to);
        m_mesh.set_vertex_handle(HalfedgeHandle(reversed(halfEdge)), from);
    };
    for (int j = 0; j < m_height; ++j) {
        for (int i = 0; i < m_width; ++i) {
            const bool hasEast = i + 1 < m_width;
            const bool hasNorth = j + 1 < m_height;
            if (hasEast) {
                join(plan.alongX(i, j), vertex(i, j), vertex(i + 1, j));
                m_mesh.set_halfedge_handle(vertex(i, j), HalfedgeHandle(plan.alongX(i, j)));
            }
            if (hasNorth)
                join(plan.alongY(i, j), vertex(i, j), vertex(i, j + 1));
            if (!hasEast || !hasNorth)
                continue;
            const int south = plan.alongX(i, j);
            const int north = reversed(plan.alongX(i, j + 1));
            const int west = reversed(plan.alongY(i, j));
            const int east = plan.alongY(i + 1, j);
            const int up = plan.diagonal(i, j);
            const int down = reversed(up);
            const int face = up - plan.diagonal(0, 0); // two faces per cell, just as a diagonal has two
                                                       // half-edges
            if ((rect.i0 + i + rect.j0 + j) % 2 == 0) {
                join(up, vertex(i, j), vertex(i + 1, j + 1));
                linkFace(face, south, east, down);
                linkFace(face + 1, up, north, west);
            } else {
                join(up, vertex(i + 1, j), vertex(i, j + 1));
                linkFace(face, south, up, west);
                linkFace(face + 1, east, north, down);
            }
        }
    }
}

// The outer half-edges run clockwise around the region: up its west side, east along the north, down the east
// side, west along the south. A border vertex starts its ring with the outer half-edge that leaves it; that
// is how OpenMesh recognizes border vertices.
void RegionHalfEdges::linkOutline() {
    const EdgePlan plan{m_width - 1, m_height - 1};
    const HalfedgeHandle start(plan.alongY(0, 0));
    HalfedgeHandle last = start;
    VertexHandle from = vertex(0, 0);
    const auto append = [&](int halfEdge) {
        const HalfedgeHandle outer(halfEdge);
        m_mesh.set_boundary(outer);
        m_mesh.set_halfedge_handle(from, outer);
        if (outer != start)
            m_mesh.set_next_halfedge_handle(last, outer);
        last = outer;
        from = m_mesh.to_vertex_handle(outer);
    };
    for (int j = 0; j < plan.cellsY; ++j)
        append(plan.alongY(0, j));
    for (int i = 0; i < plan.cellsX; ++i)
        append(plan.alongX(i, plan.cellsY));
    for (int j = plan.cellsY; j-- > 0;)
        append(reversed(plan.alongY(plan.cellsX, j)));
    for (int i = plan.cellsX; i-- > 0;)
        append(reversed(plan.alongX(i, 0)));
    m_mesh.set_next_halfedge_handle(last, start);
}

void RegionHalfEdges::drawBorder(Side side, const BorderLine& line) {
    const bool alongX = side == Side::south || side == Side::north;
    const int n = (alongX ? m_width : m_height) - 1;
    const auto at = [&](int k) {
        switch (side) {
        case Side::south:
            return vertex(k, 0);
        case Side::north:
            return vertex(k, m_height - 1);
        case Side::west:
            return vertex(0, k);
        case Side::east:
            break;
        }
        return vertex(m_width - 1, k);
    };
    const auto last = static_cast<std::uint32_t>(n);
    if (line.kept.size() == last + 1)
        return;
    // Each vertex collapses into the neighbour that snapToKept() names, starting with the one nearest to it,
    // so that each collapse runs along an existing edge.
    for (std::size_t k = 0; k + 1 < line.kept.size(); ++k) {
        const std::uint32_t a = line.kept[k];
        const std::uint32_t b = line.kept[k + 1];
        const std::uint32_t split = firstSnappedUp(a, b, last);
        for (std::uint32_t offset = a + 1; offset < split; ++offset)
            removeAlongBorder(at(static_cast<int>(offset)), at(static_cast<int>(a)));
        for (std::uint32_t offset = b; offset-- > split;)
            removeAlongBorder(at(static_cast<int>(offset)), at(static_cast<int>(b)));
    }
}

void RegionHalfEdges::removeAlongBorder(VertexHandle vertex, VertexHandle into) {
    const HalfedgeHandle outer = m_mesh.halfedge_handle(vertex);
    const HalfedgeHandle out = m_mesh.to_vertex_handle(outer) == into
                                   ? outer
                                   : m_mesh.opposite_halfedge_handle(m_mesh.prev_halfedge_handle(outer));
    assert(m_mesh.to_vertex_handle(out) == into && m_mesh.is_collapse_ok(out));
    collapseEdge(m_mesh, out);
}

bool RegionHalfEdges::isCorner(VertexHandle vertex) const {
    const int i = vertex.idx() % m_width;
    const int j = vertex.idx() / m_width;
    return (i == 0 || i == m_width - 1) && (j == 0 || j == m_height - 1);
}

const Star& RegionHalfEdges::star(VertexHandle vertex) {
    const HalfedgeHandle leaving = m_mesh.halfedge_handle(vertex);
    const auto turned = [&](HalfedgeHandle out) { // counter-clockwise to the next spoke
        return m_mesh.opposite_halfedge_handle(m_mesh.prev_halfedge_handle(out));
    };
    m_star.centre = vertex;
    m_star.closed = !m_mesh.is_boundary(leaving);
    m_star.spokes.clear();
    const OpenMesh::Vec3d centre = m_mesh.point(vertex);
    // The outer half-edge of a border vertex has no face: the gap follows it directly.
    const HalfedgeHandle first = m_star.closed ? leaving : turned(leaving);
    HalfedgeHandle out = first;
    do {
        const VertexHandle tip = m_mesh.to_vertex_handle(out);
        m_star.spokes.push_back({out, tip, m_mesh.point(tip) - centre});
        out = turned(out);
    } while (out != first);
    return m_star;
}

bool RegionHalfEdges::isCollapseValid(const Star& star, std::size_t target) {
    const OpenMesh::Vec3d t = star.spokes[target].offset;
    for (std::size_t k = 0; k < star.faceCount(); ++k) {
        const std::size_t next = star.nextSpoke(k);
        if (k == target || next == target)
            continue; // these faces are removed with the edge
        const OpenMesh::Vec3d a = star.spokes[k].offset - t;
        const OpenMesh::Vec3d b = star.spokes[next].offset - t;
        // Coordinates are whole numbers of cells, so the sign is exact: zero is the degenerate face of Fig.
        // 4(a), negative the flipped one of Fig. 4(b).
        if (a[0] * b[1] - a[1] * b[0] <= 0)
            return false;
    }
    // The new faces have positive areas that sum up to that of the polygon around the old ones, so they tile
    // it; an edge of theirs that exists elsewhere in the mesh would have to run outside of the polygon. Hence
    // no edge or face occurs twice, and OpenMesh's test of the rings is done only in builds with assertions.
    assert(m_mesh.is_collapse_ok(star.spokes[target].out));
    return true;
}

void RegionHalfEdges::collapse(const Star& star, std::size_t target) {
    collapseEdge(m_mesh, star.spokes[target].out);
}

std::size_t RegionHalfEdges::vertexCount() const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < m_mesh.n_vertices(); ++k)
        count += m_mesh.status(VertexHandle(static_cast<int>(k))).deleted() ? 0 : 1;
    return count;
}

std::size_t RegionHalfEdges::edgeCount() const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < m_mesh.n_edges(); ++k)
        count += m_mesh.status(EdgeHandle(static_cast<int>(k))).deleted() ? 0 : 1;
    return count;
}

std::size_t RegionHalfEdges::faceCount() const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < m_mesh.n_faces(); ++k)
        count += m_mesh.status(FaceHandle(static_cast<int>(k))).deleted() ? 0 : 1;
    return count;
}

} // namespace proveout
