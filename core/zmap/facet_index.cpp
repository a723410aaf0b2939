// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/facet_index.h"

#include <numeric>

namespace proveout {

namespace {

/// A triangle is in the buckets that it is this near to, mm: more than kOnRim by what coordinates are
/// rounded.
constexpr double kNear = 2 * kOnRim;
/// The most entries for each triangle, and for small meshes; more if there is only one bucket.
constexpr std::size_t kMostEntries = 32;
constexpr std::size_t kFewEntries = 4096;
constexpr std::size_t kMostBuckets = 4'000'000;
constexpr std::size_t kOfBucket = 2; ///< triangles

/// Where a triangle is between two horizontal lines.
FacetRange rangeBetween(const FacetCorners& c, double lo, double hi) {
    FacetRange range;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& a = c[k];
        const Vec3& b = c[(k + 1) % 3];
        if (a.y >= lo && a.y <= hi)
            range.add(a.x);
        for (const double y : {lo, hi})
            if (std::min(a.y, b.y) < y && y < std::max(a.y, b.y))
                range.add(crossingOf(a, b, y));
    }
    return range;
}

} // namespace

void FacetIndex::Axis::resize(double length, double wanted, int most) {
    count = static_cast<int>(std::clamp(std::ceil(length / wanted), 1.0, double(most)));
    size = length / count;
}

template<class Visit>
void FacetIndex::eachRow(const FacetCorners& corners, const Visit& visit) const {
    if (areaInPlan(corners) == 0)
        return;
    const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
    const int first = m_columns.of(left - kNear);
    const int last = m_columns.of(right + kNear);
    const int top = m_rows.of(high + kNear);
    for (int row = m_rows.of(low - kNear); row <= top; ++row) {
        if (last - first < 2) { // most triangles of a fine mesh: closer limits would take longer
            visit(row, first, last);
            continue;
        }
        const double from = m_rows.from + row * m_rows.size;
        const FacetRange range = rangeBetween(corners, from - kNear, from + m_rows.size + kNear);
        if (range.from <= range.to)
            visit(row, m_columns.of(range.from - kNear), m_columns.of(range.to + kNear));
    }
}

FacetIndex::FacetIndex(const StockMesh& mesh, const Vec2& lo, const Vec2& hi) {
    std::size_t flat = 0;
    for (std::uint32_t k = 0; k < mesh.triangles.size(); ++k)
        flat += areaInPlan(cornersOf(mesh, k)) != 0 ? 1 : 0;
    const Vec2 extent = hi - lo;
    const auto buckets = static_cast<int>(std::clamp<std::size_t>(flat / kOfBucket, 1, kMostBuckets));
    const double size = std::sqrt(extent.x * extent.y / buckets);
    m_columns.from = lo.x;
    m_rows.from = lo.y;
    m_columns.resize(extent.x, size, buckets);
    m_rows.resize(extent.y, size, buckets);
    const std::size_t most = kMostEntries * flat + kFewEntries;
    while (!count(mesh, most)) {
        m_columns.resize(extent.x, 2 * m_columns.size, buckets);
        m_rows.resize(extent.y, 2 * m_rows.size, buckets);
    }
    fill(mesh);
}

bool FacetIndex::count(const StockMesh& mesh, std::size_t most) {
    m_ends.assign(indexOf(0, m_rows.count) + 1, 0);
    std::size_t entries = 0;
    for (std::uint32_t k = 0; k < mesh.triangles.size() && entries <= most; ++k)
        eachRow(cornersOf(mesh, k), [&](int row, int first, int last) {
            entries += static_cast<std::size_t>(last - first + 1);
            for (int column = first; column <= last; ++column)
                ++m_ends[indexOf(column, row) + 1];
        });
    return entries <= most || m_ends.size() == 2;
}

void FacetIndex::fill(const StockMesh& mesh) {
    // Each bucket's place is where it begins while it is filled, and then where it ends.
    std::partial_sum(m_ends.begin(), m_ends.end(), m_ends.begin());
    m_triangles.resize(m_ends.back());
    for (std::uint32_t k = 0; k < mesh.triangles.size(); ++k)
        eachRow(cornersOf(mesh, k), [&](int row, int first, int last) {
            for (int column = first; column <= last; ++column)
                m_triangles[m_ends[indexOf(column, row)]++] = k;
        });
    m_ends.pop_back();
}

} // namespace proveout
