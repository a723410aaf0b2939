// SPDX-License-Identifier: GPL-3.0-or-later
// The facet of a mesh that is nearest to a point.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/part/nearest_on_facet.h"

namespace proveout {

/// A hierarchy of boxes over the facets of a mesh, split along a Morton curve through their middles. Copies
/// the facets, sorted; about 130 bytes a facet. Immutable; any thread.
class FacetTree {
public:
    using Facet = std::array<std::uint32_t, 3>; ///< indices of its vertices

    struct Nearest {
        std::uint32_t facet; ///< its index in the mesh
        NearestOnFacet at;
        double distance2; ///< mm²
    };

    FacetTree() = default; ///< of no facets
    /// mm; coordinates are finite and indices in range. In parallel.
    FacetTree(std::span<const Vec3> vertices, std::span<const Facet> facets);

    [[nodiscard]] bool empty() const { return m_facets.empty(); }
    /// The nearest place within a distance, mm; of several equally near, that of the first facet in the mesh.
    /// Nothing if there is none. A close bound, as from a point nearby, saves time.
    [[nodiscard]] std::optional<Nearest>
    nearest(const Vec3& point, double within = std::numeric_limits<double>::infinity()) const;
    /// Whether a facet is somewhere above a point, in the vertical line through it.
    [[nodiscard]] bool isBelow(const Vec3& point) const;

private:
    static constexpr std::size_t kFacetsOfLeaf = 4;

    /// The boxes of both children, so that one look decides for both. Rounded outwards.
    struct Node {
        std::array<std::array<float, 6>, 2> boxes; ///< low x, y, z, high x, y, z; from m_origin
        std::array<std::uint32_t, 2> children;     ///< a node; or the first facet of a leaf
        std::array<std::uint8_t, 2> counts;        ///< of facets in a leaf; 0: a node
    };
    struct SortedFacet {
        std::array<Vec3, 3> corners;
        std::uint32_t index;
    };
    struct Box {
        Vec3 lo{std::numeric_limits<double>::infinity()};
        Vec3 hi{-std::numeric_limits<double>::infinity()};
        void add(const Box& other) {
            lo = glm::min(lo, other.lo);
            hi = glm::max(hi, other.hi);
        }
    };
    struct Child {
        std::uint32_t index;
        std::uint8_t count;
        Box box;
    };

    [[nodiscard]] Child build(std::span<const std::uint64_t> codes, std::size_t first, std::size_t last);
    [[nodiscard]] Child leaf(std::size_t first, std::size_t last) const;
    [[nodiscard]] std::array<float, 6> rounded(const Box& box) const;
    void look(std::size_t first, std::size_t count, const Vec3& point, std::optional<Nearest>& best,
              double& least2) const;

    Vec3 m_origin{0};
    std::vector<SortedFacet> m_facets;
    std::vector<Node> m_nodes; ///< children after their parents; the first is the root
};

} // namespace proveout
