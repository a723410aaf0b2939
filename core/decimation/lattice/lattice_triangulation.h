// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/decimation/lattice/lattice_kernels.h"

namespace proveout {

/// A triangulation of the rectangle [0, width) × [0, height) of lattice points whose vertices are such
/// points. It stays Delaunay as long as vertices are only inserted; every predicate is exact. Storage grows
/// to the largest region seen and is kept.
///
/// Triangles are counter-clockwise. Edge 4t + k (k < 3) of triangle t leads from its k-th vertex to the next.
class LatticeTriangulation {
public:
    static constexpr std::int32_t kNone = -1;

    struct Triangle {
        std::array<std::int32_t, 3> vertex;
        float distance; ///< from the z-map, mm, as computed by the algorithm that uses the mesh
        std::array<std::int32_t, 3> twin;
        std::uint32_t state; ///< bits for the algorithm that uses the mesh; kDead once the triangle is
                             ///< removed
    };
    static constexpr std::uint32_t kDead = 1U << 31U;

    /// Two triangles over the corners; vertices 0 … 3 are south-west, south-east, north-east, north-west.
    void reset(const RegionPatch& patch);

    /// The given triangles, counter-clockwise, over the given vertices; they must cover a rectangle once.
    void assign(std::span<const PatchVertex> vertices,
                std::span<const std::array<std::int32_t, 3>> triangles);

    /// Inserts the point into the triangle that contains it, in its interior or on an edge, and restores the
    /// Delaunay property. Triangles made or changed are appended to `touched`, possibly more than once.
    std::int32_t insert(std::int32_t triangle, const PatchVertex& point, std::vector<std::int32_t>& touched);
    /// The triangle that contains a point, found by walking from `start`.
    [[nodiscard]] std::int32_t locate(std::int32_t start, std::int32_t i, std::int32_t j) const;

    [[nodiscard]] std::size_t triangleSlots() const { return m_triangles.size(); }
    [[nodiscard]] Triangle& triangle(std::int32_t t) { return m_triangles[static_cast<std::size_t>(t)]; }
    [[nodiscard]] const Triangle& triangle(std::int32_t t) const {
        return m_triangles[static_cast<std::size_t>(t)];
    }
    [[nodiscard]] std::size_t vertexCount() const { return m_vertices.size(); }
    [[nodiscard]] const PatchVertex& vertex(std::int32_t v) const {
        return m_vertices[static_cast<std::size_t>(v)];
    }
    /// An edge that starts at the vertex.
    [[nodiscard]] std::int32_t edgeFrom(std::int32_t v) const {
        return m_edgeFrom[static_cast<std::size_t>(v)];
    }

    [[nodiscard]] static std::int32_t triangleOf(std::int32_t edge) { return edge >> 2; }
    [[nodiscard]] static std::int32_t next(std::int32_t edge) {
        return (edge & 3) == 2 ? edge - 2 : edge + 1;
    }
    [[nodiscard]] static std::int32_t previous(std::int32_t edge) {
        return (edge & 3) == 0 ? edge + 2 : edge - 1;
    }
    [[nodiscard]] std::int32_t origin(std::int32_t edge) const {
        return triangle(edge >> 2).vertex[static_cast<std::size_t>(edge & 3)];
    }
    [[nodiscard]] std::int32_t twin(std::int32_t edge) const {
        return triangle(edge >> 2).twin[static_cast<std::size_t>(edge & 3)];
    }

    /// The edge of the outline that starts, or ends, at a vertex of the outline.
    [[nodiscard]] std::int32_t outlineFrom(std::int32_t v) const;
    [[nodiscard]] std::int32_t outlineTo(std::int32_t v) const;

    /// Writes a triangle and updates the twins of its neighbours.
    void write(std::int32_t t, const std::array<std::int32_t, 3>& vertex,
               const std::array<std::int32_t, 3>& twin);
    void kill(std::int32_t t) { triangle(t).state = kDead; }
    [[nodiscard]] bool isAlive(std::int32_t t) const { return (triangle(t).state & kDead) == 0; }

private:
    std::int32_t addVertex(const PatchVertex& point);
    std::int32_t addTriangle();
    void link(std::int32_t edge, std::int32_t twin);
    void flip(std::int32_t edge);
    void restoreDelaunay(std::vector<std::int32_t>& touched);
    [[nodiscard]] bool isToFlip(std::int32_t edge) const;

    std::vector<PatchVertex> m_vertices;
    std::vector<std::int32_t> m_edgeFrom;
    std::vector<Triangle> m_triangles;
    struct HalfEdge {
        std::int32_t low, high; ///< its vertices
        std::int32_t edge;
    };
    std::vector<HalfEdge> m_halfEdges;    ///< used by assign(), kept for its storage
    std::vector<std::int32_t> m_suspects; ///< edges opposite the inserted vertex that have to be checked
    std::int32_t m_parity = 0;
};

} // namespace proveout
