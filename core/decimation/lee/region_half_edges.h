// SPDX-License-Identifier: GPL-3.0-or-later
// The triangle mesh of a region while it is decimated (paper §4.1 and §4.3), in OpenMesh's half-edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/index_rect.h"
#include "core/decimation/lee/euler_operators.h"
#include "core/decimation/regions/region_grid.h"

namespace proveout {

/// A neighbour of a vertex, and the half-edge that leads to it.
struct Spoke {
    OpenMesh::HalfedgeHandle out;
    OpenMesh::VertexHandle tip;
    OpenMesh::Vec3d offset; ///< relative to the centre: cells, cells, mm
};

/// A vertex with its neighbours, counter-clockwise. Two consecutive neighbours span a face with the centre;
/// the last and the first do so only if the star is closed. The neighbours of a border vertex begin and end
/// with those along the border.
struct Star {
    OpenMesh::VertexHandle centre;
    bool closed = true;
    std::vector<Spoke> spokes;

    [[nodiscard]] std::size_t faceCount() const { return closed ? spokes.size() : spokes.size() - 1; }
    /// Face k is between spoke k and the next one.
    [[nodiscard]] std::size_t nextSpoke(std::size_t k) const { return k + 1 == spokes.size() ? 0 : k + 1; }
};

/// Vertex k of a region of w × h points is its point (k % w, k / w), even after other vertices have been
/// removed. One thread. Storage grows to the largest region seen and is kept.
class RegionHalfEdges {
public:
    using Vertex = OpenMesh::VertexHandle;

    /// The canonical 4-8 triangulation of the points of `rect`, filled in a predetermined manner: no search
    /// for the neighbours of a face is needed (paper §4.1).
    void build(const IndexRect& rect, std::span<const float> heights);
    /// Removes the vertices of a side that its polyline drops; the mesh then equals fullRegionMesh() with
    /// that border.
    void drawBorder(Side side, const BorderLine& line);

    [[nodiscard]] const HalfEdgeMesh& mesh() const { return m_mesh; }
    [[nodiscard]] int width() const { return m_width; } ///< points
    [[nodiscard]] int height() const { return m_height; }
    [[nodiscard]] Vertex vertex(int i, int j) const { return Vertex(j * m_width + i); }
    [[nodiscard]] bool onBorder(Vertex vertex) const { return m_mesh.is_boundary(vertex); }
    [[nodiscard]] bool isCorner(Vertex vertex) const;
    /// The neighbours of a vertex. The reference holds until the next call.
    [[nodiscard]] const Star& star(Vertex vertex);

    /// Whether the centre may collapse into a neighbour (paper §4.2.2): no face is flipped or becomes
    /// degenerate.
    [[nodiscard]] bool isCollapseValid(const Star& star, std::size_t target);
    /// Removes the centre; see collapseEdge().
    void collapse(const Star& star, std::size_t target);

    [[nodiscard]] std::size_t vertexCount() const;
    [[nodiscard]] std::size_t edgeCount() const;
    [[nodiscard]] std::size_t faceCount() const;
    /// Calls visit(a, b, c) with the vertices of every face, counter-clockwise.
    template<class Visit>
    void forEachFace(Visit&& visit) const;

private:
    void linkFace(int face, int first, int second, int third);
    void linkCells(const IndexRect& rect);
    void linkOutline();
    void removeAlongBorder(Vertex vertex, Vertex into);

    HalfEdgeMesh m_mesh;
    int m_width = 0;
    int m_height = 0;
    Star m_star;
};

template<class Visit>
void RegionHalfEdges::forEachFace(Visit&& visit) const {
    for (int f = 0; f < static_cast<int>(m_mesh.n_faces()); ++f) {
        const OpenMesh::FaceHandle face(f);
        if (m_mesh.status(face).deleted())
            continue;
        const auto first = m_mesh.halfedge_handle(face);
        const auto second = m_mesh.next_halfedge_handle(first);
        const auto third = m_mesh.next_halfedge_handle(second);
        visit(m_mesh.to_vertex_handle(first), m_mesh.to_vertex_handle(second),
              m_mesh.to_vertex_handle(third));
    }
}

} // namespace proveout
