// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/solid_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/decimation/regions/canonical_surface.h"

namespace proveout {

namespace {

/// Triangles between two checks of the context: a few milliseconds of work.
constexpr std::size_t kBatch = 8192;

using Corners = std::array<Vec3, 3>;
using Weights = std::array<double, 3>;

/// Stored in memory on purpose: g++ 12 at -O2 drops a pair of vectorised conversions to float and back.
double inFloat(double value) {
    const volatile float rounded = static_cast<float>(value);
    return static_cast<double>(rounded);
}

/// Twice the area of the triangle (p, a, b) in plan; nothing if p is on the wrong side of the edge by more
/// than the error of this sum. So no point falls between two triangles.
std::optional<double> weightOpposite(const Vec2& p, const Vec3& a, const Vec3& b) {
    constexpr double kErr = 4 * std::numeric_limits<double>::epsilon();
    const double plus = (a.x - p.x) * (b.y - p.y);
    const double minus = (a.y - p.y) * (b.x - p.x);
    const double weight = plus - minus;
    if (weight < -kErr * (std::abs(plus) + std::abs(minus)))
        return std::nullopt;
    return weight;
}

std::optional<Weights> weightsAt(const Vec2& p, const Corners& at) {
    const auto a = weightOpposite(p, at[1], at[2]);
    const auto b = a ? weightOpposite(p, at[2], at[0]) : std::nullopt;
    const auto c = b ? weightOpposite(p, at[0], at[1]) : std::nullopt;
    if (!c)
        return std::nullopt;
    return Weights{*a, *b, *c};
}

/// The positions of the grid points along one axis, and which of them an interval of it may contain.
class Axis {
public:
    /// `outline`: the ends as the file holds them. Points beyond the ends are moved to them.
    Axis(int count, double start, double spacing, const Vec2& outline)
        : m_start(start), m_spacing(spacing), m_positions(static_cast<std::size_t>(count)) {
        for (std::size_t i = 0; i < m_positions.size(); ++i)
            m_positions[i] = std::clamp(start + spacing * static_cast<double>(i), outline.x,
                                        std::max(outline.x, outline.y));
    }

    [[nodiscard]] double operator[](std::size_t i) const { return m_positions[i]; }
    [[nodiscard]] std::size_t size() const { return m_positions.size(); }
    /// One more than needed on each side: rounding has moved ends and points by less than a step.
    [[nodiscard]] std::size_t firstFrom(double position) const {
        return index(std::floor(cells(position)) - 1);
    }
    [[nodiscard]] std::size_t lastTo(double position) const { return index(std::ceil(cells(position)) + 1); }

private:
    [[nodiscard]] double cells(double position) const { return (position - m_start) / m_spacing; }
    [[nodiscard]] std::size_t index(double at) const {
        return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(m_positions.size() - 1)));
    }

    double m_start;
    double m_spacing;
    std::vector<double> m_positions;
};

/// The part of the line at `y` that a triangle covers in plan; empty (x > y) if there is none.
Vec2 stretchAt(double y, const Corners& at) {
    Vec2 stretch(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < at.size(); ++k) {
        const Vec3& a = at[k];
        const Vec3& b = at[(k + 1) % at.size()];
        if (y < std::min(a.y, b.y) || y > std::max(a.y, b.y))
            continue;
        const double x = a.y == b.y ? a.x : a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
        stretch = {std::min(stretch.x, x), std::max(stretch.y, x)};
    }
    return stretch;
}

class Measurement {
public:
    Measurement(const ZMapSnapshot& zmap, CoordinateType type, ErrorLevel level, const std::stop_token& stop)
        : m_zmap(zmap), m_full(zmap), m_type(type), m_level(level), m_stop(stop),
          m_columns(zmap.grid().nx, zmap.grid().x0, zmap.grid().hx, ends().first),
          m_rows(zmap.grid().ny, zmap.grid().y0, zmap.grid().hy, ends().second),
          m_covered(m_columns.size() * m_rows.size()) {}

    void add(const TriangleMesh& solid, const std::array<std::uint32_t, 3>& triangle) {
        Corners at;
        std::transform(triangle.begin(), triangle.end(), at.begin(),
                       [&](std::uint32_t vertex) { return roundedTo(m_type, solid.vertices[vertex]); });
        const Vec2 one = at[1] - at[0];
        const Vec2 other = at[2] - at[0];
        if (one.x * other.y <= one.y * other.x)
            return; // a wall, or the floor
        if (m_level == ErrorLevel::surface)
            for (std::size_t k = 0; k < at.size(); ++k)
                m_largest =
                    std::max(m_largest, m_full.distanceAlong(inCells(at[k]), inCells(at[(k + 1) % 3])));
        const auto [low, high] = std::minmax({at[0].y, at[1].y, at[2].y});
        // Checked in every row, because two triangles may cover the whole map.
        for (std::size_t j = m_rows.firstFrom(low); j <= m_rows.lastTo(high) && !m_stop.stop_requested();
             ++j) {
            const Vec2 stretch = stretchAt(m_rows[j], at);
            if (stretch.x > stretch.y)
                continue;
            const std::size_t last = m_columns.lastTo(stretch.y);
            for (std::size_t i = m_columns.firstFrom(stretch.x); i <= last; ++i)
                addPoint(i, j, at);
        }
    }

    [[nodiscard]] double largest() const {
        double largest = m_largest;
        const double floor = m_zmap.stock().topZ() + static_cast<double>(m_zmap.floor());
        for (std::size_t j = 0; j < m_rows.size(); ++j)
            for (std::size_t i = 0; i < m_columns.size(); ++i)
                if (!m_covered[j * m_columns.size() + i])
                    largest = std::max(largest, height(i, j) - floor);
        return largest;
    }

private:
    /// The ends of both axes.
    [[nodiscard]] std::pair<Vec2, Vec2> ends() const {
        const Grid& grid = m_zmap.grid();
        const Vec3 low = roundedTo(m_type, {grid.x(0), grid.y(0), 0});
        const Vec3 high = roundedTo(m_type, {grid.x(grid.nx - 1), grid.y(grid.ny - 1), 0});
        return {{low.x, high.x}, {low.y, high.y}};
    }

    [[nodiscard]] double height(std::size_t i, std::size_t j) const {
        return m_zmap.stock().topZ() +
               static_cast<double>(m_zmap.height(static_cast<int>(i), static_cast<int>(j)));
    }

    /// In the coordinates of CanonicalSurface.
    [[nodiscard]] Vec3 inCells(const Vec3& at) const {
        const Grid& grid = m_zmap.grid();
        return {(at.x - grid.x0) / grid.hx, (at.y - grid.y0) / grid.hy, at.z - m_zmap.stock().topZ()};
    }

    void addPoint(std::size_t i, std::size_t j, const Corners& at) {
        const auto weights = weightsAt({m_columns[i], m_rows[j]}, at);
        if (!weights)
            return;
        const auto& [a, b, c] = *weights;
        const double area = a + b + c;
        if (area <= 0)
            return;
        m_covered[j * m_columns.size() + i] = true;
        // Divided first: at a corner one share is exactly 1, so that the surface is exactly its height.
        const double surface = a / area * at[0].z + b / area * at[1].z + c / area * at[2].z;
        m_largest = std::max(m_largest, std::abs(surface - height(i, j)));
    }

    const ZMapSnapshot& m_zmap;
    CanonicalSurface m_full;
    CoordinateType m_type;
    ErrorLevel m_level;
    const std::stop_token& m_stop;
    Axis m_columns;
    Axis m_rows;
    std::vector<bool> m_covered; ///< per grid point
    double m_largest = 0;
};

} // namespace

Vec3 roundedTo(CoordinateType type, const Vec3& point) {
    return type == CoordinateType::float64 ? point
                                           : Vec3(inFloat(point.x), inFloat(point.y), inFloat(point.z));
}

double measureSolidError(const ZMapSnapshot& zmap, const TriangleMesh& solid, CoordinateType type,
                         ErrorLevel level, const WorkContext& context) {
    Measurement measurement(zmap, type, level, context.stop);
    for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
        if (t % kBatch == 0) {
            if (context.stopped())
                break;
            context.report(static_cast<double>(t) / static_cast<double>(solid.triangles.size()));
        }
        measurement.add(solid, solid.triangles[t]);
    }
    return measurement.largest();
}

} // namespace proveout
