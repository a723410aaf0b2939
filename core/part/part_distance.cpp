// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/part/part_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/parallel.h"

namespace proveout {

namespace {

constexpr std::size_t kPointsOfTask = 1024;

Vec3 unit(const Vec3& vector) {
    const double length = glm::length(vector);
    return length > 0 ? vector / length : Vec3(0);
}

double angleBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// A side of a facet, which leads to a vertex from one with a smaller index.
struct SideTo {
    std::uint32_t to;
    std::uint32_t facet;
    std::uint32_t side;
};

/// The sides of a mesh by the smaller index of their vertices.
class SidesByVertex {
public:
    SidesByVertex(std::size_t vertices, std::span<const FacetTree::Facet> facets)
        : m_begins(vertices + 1), m_sides(3 * facets.size()) {
        const auto eachSide = [&](const auto& visit) {
            for (std::size_t k = 0; k < facets.size(); ++k)
                for (std::uint32_t side = 0; side < 3; ++side) {
                    const auto [low, high] = std::minmax({facets[k][side], facets[k][(side + 1) % 3]});
                    visit(low, SideTo{high, static_cast<std::uint32_t>(k), side});
                }
        };
        eachSide([&](std::uint32_t from, const SideTo&) { ++m_begins[from + 1]; });
        std::partial_sum(m_begins.begin(), m_begins.end(), m_begins.begin());
        std::vector<std::size_t> next(m_begins.begin(), m_begins.end() - 1);
        eachSide([&](std::uint32_t from, const SideTo& side) { m_sides[next[from]++] = side; });
    }

    /// Those from a vertex, sorted by where they lead, then by facets.
    [[nodiscard]] std::span<const SideTo> from(std::size_t vertex) {
        const std::span<SideTo> sides(m_sides.data() + m_begins[vertex],
                                      m_sides.data() + m_begins[vertex + 1]);
        std::ranges::stable_sort(sides, {}, &SideTo::to);
        return sides;
    }

private:
    std::vector<std::size_t> m_begins;
    std::vector<SideTo> m_sides;
};

} // namespace

PartDistance::PartDistance(std::span<const Vec3> vertices, std::span<const Facet> facets)
    : m_tree(vertices, facets), m_facets(facets.begin(), facets.end()), m_normals(facets.size()),
      m_atVertices(vertices.size(), Vec3(0)), m_isOpenVertex(vertices.size()), m_sides(facets.size()) {
    for (std::size_t k = 0; k < facets.size(); ++k) {
        const std::array<Vec3, 3> at{vertices[facets[k][0]], vertices[facets[k][1]], vertices[facets[k][2]]};
        m_normals[k] = unit(glm::cross(at[1] - at[0], at[2] - at[0]));
        for (std::size_t corner = 0; corner < 3; ++corner)
            m_atVertices[facets[k][corner]] +=
                angleBetween(at[(corner + 1) % 3] - at[corner], at[(corner + 2) % 3] - at[corner]) *
                m_normals[k];
    }
    addSides(facets);
}

void PartDistance::addSides(std::span<const Facet> facets) {
    SidesByVertex sides(m_atVertices.size(), facets);
    for (std::size_t vertex = 0; vertex < m_atVertices.size(); ++vertex) {
        const std::span<const SideTo> all = sides.from(vertex);
        for (auto first = all.begin(); first != all.end();) {
            const std::uint32_t to = first->to;
            const auto last =
                std::find_if(first, all.end(), [to](const SideTo& other) { return other.to != to; });
            SideNormal normal;
            for (auto side = first; side != last; ++side)
                normal.normal += m_normals[side->facet];
            normal.isOpen = last - first != 2;
            for (; first != last; ++first)
                m_sides[first->facet][first->side] = normal;
            if (normal.isOpen) {
                m_isOpenVertex[vertex] = true;
                m_isOpenVertex[to] = true;
            }
        }
    }
}

PartDistance::Place PartDistance::placeOf(const Vec3& point, const FacetTree::Nearest& nearest) const {
    Vec3 normal(0);
    bool isOpen = false;
    const auto feature = static_cast<std::size_t>(nearest.at.feature);
    const auto corner = static_cast<std::size_t>(FacetFeature::corner0);
    if (nearest.at.feature == FacetFeature::inside) {
        normal = m_normals[nearest.facet];
    } else if (feature >= corner) {
        const std::uint32_t vertex = m_facets[nearest.facet][feature - corner];
        normal = m_atVertices[vertex];
        isOpen = m_isOpenVertex[vertex];
    } else {
        const SideNormal& side =
            m_sides[nearest.facet][feature - static_cast<std::size_t>(FacetFeature::side0)];
        normal = side.normal;
        isOpen = side.isOpen;
    }
    const double distance = std::sqrt(nearest.distance2);
    const double ahead = glm::dot(point - nearest.at.place, normal);
    return {ahead < 0 ? -distance : distance, nearest.at.place, nearest.facet,
            !isOpen && (ahead != 0 || distance == 0)};
}

std::optional<PartDistance::Place> PartDistance::at(const Vec3& point, double within) const {
    const auto nearest = m_tree.nearest(point, within);
    return nearest ? std::optional(placeOf(point, *nearest)) : std::nullopt;
}

std::vector<std::optional<PartDistance::Place>> PartDistance::at(std::span<const Vec3> points,
                                                                 const WorkContext& context) const {
    std::vector<std::optional<Place>> places(points.size());
    inParallelRanges(points.size(), kPointsOfTask, [&](std::size_t first, std::size_t last) {
        double within = std::numeric_limits<double>::infinity();
        for (std::size_t k = first; k < last && !context.stopped(); ++k) {
            if (k > first) // no farther than by way of the last point, and a little more for rounding
                within = (within + glm::distance(points[k - 1], points[k])) * (1 + 1e-9) + 1e-9;
            const auto nearest = m_tree.nearest(points[k], within);
            if (!nearest)
                continue;
            within = std::sqrt(nearest->distance2);
            places[k] = placeOf(points[k], *nearest);
        }
    });
    return places;
}

} // namespace proveout
