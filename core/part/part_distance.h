// SPDX-License-Identifier: GPL-3.0-or-later
// How far points are from the surface of a part, and on which side of it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/work_context.h"
#include "core/part/facet_tree.h"

namespace proveout {

/// The signed distance from the surface of a mesh: positive outside, negative inside. The side is that of the
/// pseudo-normal of the nearest place, which is exact for closed meshes whose facets do not meet but at their
/// sides. Source: J. A. Bærentzen and H. Aanæs, Signed Distance Computation Using the Angle Weighted
/// Pseudonormal, 2005. Immutable; any thread.
class PartDistance {
public:
    using Facet = FacetTree::Facet;

    struct Place {
        double distance; ///< mm
        Vec3 nearest;    ///< on the surface
        std::uint32_t facet;
        /// Whether the side is known: false at the open edge of a mesh, where more than two facets meet in an
        /// edge, and where facets turn back on themselves.
        bool hasSide;
    };

    /// As FacetTree. Facets without an area count as sides of their neighbours.
    PartDistance(std::span<const Vec3> vertices, std::span<const Facet> facets);

    /// Nothing if the mesh has no facet within a distance, mm.
    [[nodiscard]] std::optional<Place> at(const Vec3& point,
                                          double within = std::numeric_limits<double>::infinity()) const;
    /// Whether the surface is somewhere above a point, in the vertical line through it.
    [[nodiscard]] bool isBelow(const Vec3& point) const { return m_tree.isBelow(point); }
    /// The places of many points, in parallel; fast where each is near the one before it. A stopped context
    /// leaves some of them out.
    [[nodiscard]] std::vector<std::optional<Place>> at(std::span<const Vec3> points,
                                                       const WorkContext& context = {}) const;

private:
    struct SideNormal {
        Vec3 normal{0};
        bool isOpen = true; ///< not two facets have this side
    };

    void addSides(std::span<const Facet> facets);
    [[nodiscard]] Place placeOf(const Vec3& point, const FacetTree::Nearest& nearest) const;

    FacetTree m_tree;
    std::vector<Facet> m_facets;
    std::vector<Vec3> m_normals;    ///< of the facets, of unit length; 0: without an area
    std::vector<Vec3> m_atVertices; ///< sums of normals, weighted by angles
    std::vector<bool> m_isOpenVertex;
    std::vector<std::array<SideNormal, 3>> m_sides; ///< of each facet
};

} // namespace proveout
