// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles of a mesh may be over a place in plan. Internal to this library.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/zmap/mesh_stock.h"
#include "core/zmap/stock_facet.h"

namespace proveout {

inline FacetCorners cornersOf(const StockMesh& mesh, std::uint32_t triangle) {
    const auto& t = mesh.triangles[triangle];
    return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

/// A grid of buckets in plan, about one for two triangles that are not upright, or fewer if those are long:
/// its memory is proportional to the number of triangles. Immutable; any thread.
class FacetIndex {
public:
    /// `lo` and `hi`: the mesh's box in plan.
    FacetIndex(const StockMesh& mesh, const Vec2& lo, const Vec2& hi);

    /// The average number of triangles in a bucket.
    [[nodiscard]] double meanOfBuckets() const {
        return static_cast<double>(m_triangles.size()) / static_cast<double>(m_ends.size());
    }
    /// Those that may be over a place, or as near to it as kOnRim; others too.
    [[nodiscard]] std::span<const std::uint32_t> at(const Vec2& place) const {
        return bucket(m_columns.of(place.x), m_rows.of(place.y));
    }
    /// Calls `visit` with those of at() for all places of a box, some of them repeatedly.
    template<class Visit>
    void eachWithin(const Vec2& lo, const Vec2& hi, const Visit& visit) const {
        for (int row = m_rows.of(lo.y); row <= m_rows.of(hi.y); ++row)
            for (int column = m_columns.of(lo.x); column <= m_columns.of(hi.x); ++column)
                std::ranges::for_each(bucket(column, row), visit);
    }

private:
    /// The buckets along one axis; the outer ones have what is beyond them too.
    struct Axis {
        double from = 0;
        double size = 1; ///< of a bucket, mm
        int count = 1;

        [[nodiscard]] int of(double at) const {
            return static_cast<int>(std::clamp(std::floor((at - from) / size), 0.0, count - 1.0));
        }
        void resize(double length, double wanted, int most);
    };

    [[nodiscard]] std::span<const std::uint32_t> bucket(int column, int row) const {
        const std::size_t index = indexOf(column, row);
        const std::uint32_t first = index == 0 ? 0 : m_ends[index - 1];
        return std::span(m_triangles).subspan(first, m_ends[index] - first);
    }
    [[nodiscard]] std::size_t indexOf(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns.count) +
               static_cast<std::size_t>(column);
    }
    /// Calls `visit` with the row and the first and last column of the buckets that a triangle reaches.
    template<class Visit>
    void eachRow(const FacetCorners& corners, const Visit& visit) const;
    /// Counts the triangles of each bucket; false if all together are more than `most` in several buckets.
    [[nodiscard]] bool count(const StockMesh& mesh, std::size_t most);
    void fill(const StockMesh& mesh);

    Axis m_columns;
    Axis m_rows;
    std::vector<std::uint32_t> m_ends; ///< of the buckets, row by row, within the next one
    std::vector<std::uint32_t> m_triangles;
};

} // namespace proveout
