// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/regions/error_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "core/base/parallel.h"
#include "core/decimation/regions/canonical_surface.h"
#include "core/decimation/regions/row_bands.h"

namespace proveout {

namespace {

/// Twice the signed area of the triangle (a, b, p), exact.
std::int64_t cross(const std::array<std::int64_t, 2>& a, const std::array<std::int64_t, 2>& b,
                   const std::array<std::int64_t, 2>& p) {
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

class Measurement {
public:
    Measurement(const ZMapSnapshot& zmap, const IndexRect& rect)
        : m_zmap(zmap), m_rect(rect), m_width(static_cast<std::size_t>(rect.width())),
          m_heights(m_width * static_cast<std::size_t>(rect.height())), m_distance(m_heights.size(), -1.0) {
        zmap.read(rect, m_heights);
    }

    void add(const LatticeTriangle& triangle) {
        const auto nx = static_cast<std::uint32_t>(m_zmap.grid().nx);
        std::array<std::array<std::int64_t, 2>, 3> corner{};
        std::array<double, 3> z{};
        for (std::size_t k = 0; k < 3; ++k) {
            const int i = static_cast<int>(triangle[k] % nx);
            const int j = static_cast<int>(triangle[k] / nx);
            corner[k] = {i, j};
            z[k] = m_zmap.height(i, j);
        }
        const std::int64_t area = cross(corner[0], corner[1], corner[2]);
        if (area == 0)
            return; // a vertical triangle, which covers no point by itself
        const auto [j0, j1] = std::minmax({corner[0][1], corner[1][1], corner[2][1]});
        const std::int64_t first = std::max<std::int64_t>(j0, m_rect.j0);
        const std::int64_t last = std::min<std::int64_t>(j1, m_rect.j1 - 1);
        for (std::int64_t j = first; j <= last; ++j) {
            const auto [from, to] = rowSpan(corner, j);
            for (std::int64_t i = from; i <= to; ++i) {
                const std::array<std::int64_t, 2> p{i, j};
                const std::array<std::int64_t, 3> weight{cross(corner[1], corner[2], p),
                                                         cross(corner[2], corner[0], p),
                                                         cross(corner[0], corner[1], p)};
                const bool inside = area > 0 ? weight[0] >= 0 && weight[1] >= 0 && weight[2] >= 0
                                             : weight[0] <= 0 && weight[1] <= 0 && weight[2] <= 0;
                if (!inside)
                    continue;
                const double surface =
                    (static_cast<double>(weight[0]) * z[0] + static_cast<double>(weight[1]) * z[1] +
                     static_cast<double>(weight[2]) * z[2]) /
                    static_cast<double>(area);
                const std::size_t at = static_cast<std::size_t>(j - m_rect.j0) * m_width +
                                       static_cast<std::size_t>(i - m_rect.i0);
                m_distance[at] = std::max(m_distance[at], std::abs(surface - double{m_heights[at]}));
            }
        }
    }

    [[nodiscard]] VerticalError result(double allowance) const {
        VerticalError error;
        for (const double distance : m_distance) {
            if (distance < 0)
                ++error.uncovered;
            else
                error.largest = std::max(error.largest, distance);
            error.beyond += distance < 0 || distance > allowance ? 1 : 0;
        }
        if (error.uncovered > 0)
            error.largest = std::numeric_limits<double>::infinity();
        return error;
    }

private:
    /// Columns of the rectangle that contain every point of the triangle in row j, and at most two more on
    /// each side: a thin triangle's bounding box would be mostly empty.
    [[nodiscard]] std::array<std::int64_t, 2>
    rowSpan(const std::array<std::array<std::int64_t, 2>, 3>& corner, std::int64_t j) const {
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& a = corner[k];
            const auto& b = corner[(k + 1) % 3];
            if (j < std::min(a[1], b[1]) || j > std::max(a[1], b[1]))
                continue;
            const double t =
                a[1] == b[1] ? 0 : static_cast<double>(j - a[1]) / static_cast<double>(b[1] - a[1]);
            const double x = static_cast<double>(a[0]) + t * static_cast<double>(b[0] - a[0]);
            low = std::min({low, x, a[1] == b[1] ? static_cast<double>(b[0]) : x});
            high = std::max({high, x, a[1] == b[1] ? static_cast<double>(b[0]) : x});
        }
        return {std::max<std::int64_t>(static_cast<std::int64_t>(std::floor(low)) - 1, m_rect.i0),
                std::min<std::int64_t>(static_cast<std::int64_t>(std::ceil(high)) + 1, m_rect.i1 - 1)};
    }

    const ZMapSnapshot& m_zmap;
    IndexRect m_rect;
    std::size_t m_width;
    std::vector<float> m_heights;
    std::vector<double> m_distance; ///< per point of the rectangle; negative: not covered yet
};

VerticalError sumOf(const VerticalError& a, const VerticalError& b) {
    return {std::max(a.largest, b.largest), a.beyond + b.beyond, a.uncovered + b.uncovered};
}

VerticalError errorOfBand(const ZMapSnapshot& zmap, const IndexRect& rect, const RowBands& bands,
                          std::size_t band, std::span<const LatticeTriangle> triangles, double allowance) {
    const auto [first, last] = bands.rows(band);
    const IndexRect own =
        intersection(rect, {0, static_cast<int>(first), zmap.grid().nx, static_cast<int>(last) + 1});
    if (own.empty())
        return {};
    Measurement measurement(zmap, own);
    for (const std::uint32_t triangle : bands.trianglesOf(band))
        measurement.add(triangles[triangle]);
    return measurement.result(allowance);
}

} // namespace

VerticalError measureVerticalError(const ZMapSnapshot& zmap, const IndexRect& rect,
                                   std::span<const LatticeTriangle> triangles, double allowance) {
    const IndexRect inside = intersection(rect, {0, 0, zmap.grid().nx, zmap.grid().ny});
    if (inside.empty())
        return {};
    const auto nx = static_cast<std::uint32_t>(zmap.grid().nx);
    const RowBands bands(static_cast<std::size_t>(zmap.grid().ny), triangles.size(), [&](std::size_t t) {
        const auto& [a, b, c] = triangles[t];
        return RowBands::Rows{std::min({a, b, c}) / nx, std::max({a, b, c}) / nx};
    });
    std::vector<VerticalError> errors(bands.count());
    inParallel(errors.size(), [&](std::size_t band) {
        errors[band] = errorOfBand(zmap, inside, bands, band, triangles, allowance);
    });
    return std::accumulate(errors.begin(), errors.end(), VerticalError(), sumOf);
}

double measureSurfaceError(const ZMapSnapshot& zmap, std::span<const LatticeTriangle> triangles) {
    const IndexRect all{0, 0, zmap.grid().nx, zmap.grid().ny};
    const CanonicalSurface full(zmap);
    const auto nx = static_cast<std::uint32_t>(zmap.grid().nx);
    const auto corner = [&](std::uint32_t lattice) {
        const auto i = static_cast<int>(lattice % nx);
        const auto j = static_cast<int>(lattice / nx);
        return Vec3(i, j, static_cast<double>(zmap.height(i, j)));
    };
    constexpr std::size_t kTrianglesOfTask = 256;
    const double alongEdges = largestInParallel(triangles.size(), kTrianglesOfTask, [&](std::size_t t) {
        double largest = 0;
        for (std::size_t k = 0; k < 3; ++k)
            largest = std::max(
                largest, full.distanceAlong(corner(triangles[t][k]), corner(triangles[t][(k + 1) % 3])));
        return largest;
    });
    return std::max(alongEdges, measureVerticalError(zmap, all, triangles, 0).largest);
}

} // namespace proveout
