// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/mesh_top.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/zmap/stock_facet.h"

namespace proveout {

namespace {

/// Whether a triangle may be within a box in plan: no line along a side of it is between them.
bool reaches(const FacetCorners& c, const std::array<Vec2, 4>& box) {
    const double out = areaInPlan(c) > 0 ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 a(c[k]);
        const Vec2 side = Vec2(c[(k + 1) % 3]) - a;
        const Vec2 away = Vec2(side.y, -side.x) * out;
        // Along an axis each, a place may be outside by kOnRim.
        const double near = 2 * kOnRim * (std::abs(away.x) + std::abs(away.y));
        if (std::ranges::all_of(box, [&](const Vec2& corner) { return glm::dot(corner - a, away) > near; }))
            return false;
    }
    return true;
}

/// The heights are those of the map, to the last bit but for the rounding of places.
class MeshTop final : public StockTop {
public:
    MeshTop(const StockMesh& mesh, const FacetIndex& index, double topZ, const Vec2& offset)
        : m_mesh(mesh), m_index(index), m_topZ(topZ), m_offset(offset) {}

    [[nodiscard]] double height(const Vec2& place) const override {
        const Vec2 at = place - m_offset;
        double top = kAbsent;
        for (const std::uint32_t triangle : m_index.at(at)) {
            const Facet facet(cornersOf(m_mesh, triangle));
            if (!(facet.highest() > top))
                continue;
            const FacetRange covered = facet.covered(at.y);
            if (at.x >= covered.from - kOnRim && at.x <= covered.to + kOnRim)
                top = std::max(top, facet.heightAt(at.x, at.y));
        }
        return relative(top);
    }

    [[nodiscard]] double highest(const Vec2& lo, const Vec2& hi) const override {
        const Vec2 from = lo - m_offset;
        const Vec2 to = hi - m_offset;
        const std::array<Vec2, 4> box{from, {to.x, from.y}, to, {from.x, to.y}};
        double highest = kAbsent;
        m_index.eachWithin(from, to, [&](std::uint32_t triangle) {
            const FacetCorners corners = cornersOf(m_mesh, triangle);
            const Facet facet(corners);
            const bool isApart = facet.leastX() > to.x + kOnRim || facet.largestX() < from.x - kOnRim ||
                                 facet.lowestY() > to.y + kOnRim || facet.highestY() < from.y - kOnRim;
            if (isApart || !reaches(corners, box))
                return;
            for (const Vec2& corner : box) {
                const double height = facet.heightAt(corner.x, corner.y);
                // The slope of a triangle that is nearly upright may not be finite.
                highest = std::max(highest, std::isnan(height) ? facet.highest() : height);
            }
        });
        return relative(highest);
    }

private:
    [[nodiscard]] double relative(double top) const { return top > kAbsent ? top - m_topZ : kAbsent; }

    const StockMesh& m_mesh; ///< of the body, which the setup holds
    const FacetIndex& m_index;
    double m_topZ;
    Vec2 m_offset;
};

} // namespace

std::unique_ptr<StockTop> MeshTops::top(const StockMesh& mesh, const Box3& box, const Vec2& offset) const {
    std::call_once(m_once, [&] { m_index.emplace(mesh, Vec2(box.lo), Vec2(box.hi)); });
    if (m_index->meanOfBuckets() > kMostOverPlace)
        return nullptr;
    return std::make_unique<MeshTop>(mesh, *m_index, box.hi.z, offset);
}

} // namespace proveout
