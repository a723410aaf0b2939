// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/surface_pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {
namespace {

struct Interval {
    double from;
    double to;
};

/// The part of a ray inside the box [lo, hi]; empty if from > to.
Interval clip(const Ray& ray, const Vec3& lo, const Vec3& hi) {
    Interval inside{0, std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        const double start = ray.origin[axis];
        const double step = ray.direction[axis];
        if (std::abs(step) < 1e-15) {
            if (start < lo[axis] || start > hi[axis])
                return {1, 0};
            continue;
        }
        const double a = (lo[axis] - start) / step;
        const double b = (hi[axis] - start) / step;
        inside.from = std::max(inside.from, std::min(a, b));
        inside.to = std::min(inside.to, std::max(a, b));
    }
    return inside;
}

/// Follows a ray in grid units: x and y count cells, z is the height above the floor in mm.
class Walk {
public:
    Walk(const ZMapSnapshot& zmap, const Ray& ray) : m_zmap(zmap) {
        const Grid& grid = zmap.grid();
        m_ray.origin = {(ray.origin.x - grid.x0) / grid.hx, (ray.origin.y - grid.y0) / grid.hy,
                        ray.origin.z - zmap.stock().floorZ()};
        m_ray.direction = {ray.direction.x / grid.hx, ray.direction.y / grid.hy, ray.direction.z};
    }

    /// The ray parameter of the first hit.
    [[nodiscard]] std::optional<double> firstHit() const {
        const Grid& grid = m_zmap.grid();
        const Interval box =
            clip(m_ray, {0, 0, 0}, {grid.nx - 1.0, grid.ny - 1.0, m_zmap.stock().height + 1e-9});
        if (box.from > box.to)
            return std::nullopt;
        const Vec3 entry = at(box.from);
        if (inside(entry))
            return box.from; // a wall or the underside
        return walk(box);
    }

private:
    [[nodiscard]] Vec3 at(double t) const { return m_ray.origin + m_ray.direction * t; }

    [[nodiscard]] double height(int i, int j) const {
        return double{m_zmap.height(i, j)} - double{m_zmap.floor()};
    }

    [[nodiscard]] int cellOf(double coordinate, int points) const {
        return std::clamp(static_cast<int>(std::floor(coordinate)), 0, points - 2);
    }

    /// Height of the canonical surface at a point in plan.
    [[nodiscard]] double surface(double x, double y) const {
        const int i = cellOf(x, m_zmap.grid().nx);
        const int j = cellOf(y, m_zmap.grid().ny);
        const double u = x - i;
        const double v = y - j;
        const double sw = height(i, j);
        const double se = height(i + 1, j);
        const double nw = height(i, j + 1);
        const double ne = height(i + 1, j + 1);
        if ((i + j) % 2 == 0)
            return u > v ? sw + (se - sw) * u + (ne - se) * v : sw + (ne - nw) * u + (nw - sw) * v;
        return u + v < 1 ? sw + (se - sw) * u + (nw - sw) * v
                         : ne + (nw - ne) * (1 - u) + (se - ne) * (1 - v);
    }

    [[nodiscard]] bool inside(const Vec3& point) const {
        const double top = surface(point.x, point.y);
        return top > 1e-9 && point.z <= top;
    }

    /// Visits cell by cell. In one cell the surface consists of two planes, so the ray's height above it is
    /// linear on each side of the diagonal: checking both ends and the crossing of the diagonal is
    /// sufficient.
    [[nodiscard]] std::optional<double> walk(const Interval& box) const {
        double t = box.from;
        const int limit = 2 * (m_zmap.grid().nx + m_zmap.grid().ny) + 8;
        for (int step = 0; step < limit && t <= box.to; ++step) {
            const Vec3 probe = at(t + 1e-9);
            const int i = cellOf(probe.x, m_zmap.grid().nx);
            const int j = cellOf(probe.y, m_zmap.grid().ny);
            const double leave = std::min(box.to, std::min(crossing(0, i), crossing(1, j)));
            if (const auto hit = hitInCell(t, leave, i, j))
                return hit;
            if (leave <= t && leave >= box.to)
                break;
            t = std::max(leave, t + 1e-9);
        }
        return std::nullopt;
    }

    /// The ray parameter at which the ray leaves the cell along an axis.
    [[nodiscard]] double crossing(int axis, int cell) const {
        const double step = m_ray.direction[axis];
        if (std::abs(step) < 1e-15)
            return std::numeric_limits<double>::infinity();
        return (cell + (step > 0 ? 1 : 0) - m_ray.origin[axis]) / step;
    }

    [[nodiscard]] double above(double t) const {
        const Vec3 point = at(t);
        return point.z - surface(point.x, point.y);
    }

    [[nodiscard]] std::optional<double> hitInCell(double from, double to, int i, int j) const {
        const bool rising = (i + j) % 2 == 0;
        const double slope =
            rising ? m_ray.direction.x - m_ray.direction.y : m_ray.direction.x + m_ray.direction.y;
        const Vec3& o = m_ray.origin;
        const double value = rising ? (o.x - i) - (o.y - j) : (o.x - i) + (o.y - j) - 1;
        double middle = std::abs(slope) < 1e-15 ? to : -value / slope;
        if (!(middle > from && middle < to))
            middle = to;
        for (const auto& [a, b] : {std::pair{from, middle}, std::pair{middle, to}}) {
            const double atA = above(a);
            const double atB = above(b);
            if (atA > 0 && atB <= 0) {
                const double t = a + (b - a) * atA / (atA - atB);
                const Vec3 point = at(t);
                if (point.z > 1e-9) // otherwise the floor of a hole
                    return t;
            }
        }
        return std::nullopt;
    }

    const ZMapSnapshot& m_zmap;
    Ray m_ray;
};

} // namespace

std::optional<Vec3> pickStock(const ZMapSnapshot& zmap, const Ray& ray) {
    if (zmap.tileCount() == 0)
        return std::nullopt;
    const auto t = Walk(zmap, ray).firstHit();
    if (!t)
        return std::nullopt;
    return ray.origin + ray.direction * *t;
}

std::optional<MapPoint> mapPointAt(const ZMapSnapshot& zmap, const Vec3& place) {
    constexpr double kLevel = 1e-6; // mm, for rounding errors
    const Grid& grid = zmap.grid();
    const int i0 = std::clamp(static_cast<int>(std::floor((place.x - grid.x0) / grid.hx)), 0, grid.nx - 2);
    const int j0 = std::clamp(static_cast<int>(std::floor((place.y - grid.y0) / grid.hy)), 0, grid.ny - 2);
    std::optional<MapPoint> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const MapPoint corner :
         {MapPoint{i0, j0}, MapPoint{i0 + 1, j0}, MapPoint{i0, j0 + 1}, MapPoint{i0 + 1, j0 + 1}}) {
        const double z = zmap.stock().topZ() + double{zmap.height(corner.i, corner.j)};
        const double distance = std::hypot(grid.x(corner.i) - place.x, grid.y(corner.j) - place.y);
        if (z <= place.z + kLevel && distance < least) {
            nearest = corner;
            least = distance;
        }
    }
    return nearest;
}

namespace {

bool isOver(const StockBox& box, const Vec3& place) {
    return place.x >= box.corner.x && place.x <= box.corner.x + box.width && place.y >= box.corner.y &&
           place.y <= box.corner.y + box.depth;
}

} // namespace

std::optional<SurfacePlace> pickSurface(const FramePtr& whole, const FramePtr& closer, const Ray& ray) {
    if (whole == nullptr)
        return std::nullopt;
    const auto hit = pickStock(whole->zmap, ray);
    if (closer != nullptr) {
        const auto fine = pickStock(closer->zmap, ray);
        const auto point = fine ? mapPointAt(closer->zmap, *fine) : std::nullopt;
        const bool hidden = hit && fine && !isOver(closer->zmap.stock(), *hit) &&
                            glm::distance(ray.origin, *hit) < glm::distance(ray.origin, *fine);
        if (point && !hidden)
            return SurfacePlace{{closer, point}, *fine};
    }
    if (!hit)
        return std::nullopt;
    return SurfacePlace{{whole, mapPointAt(whole->zmap, *hit)}, *hit};
}

PickedPlace pickPlace(const FramePtr& whole, const FramePtr& closer, const Ray& ray) {
    const auto place = pickSurface(whole, closer, ray);
    return place ? place->picked : PickedPlace();
}

bool isInStock(const ZMapSnapshot& zmap, const Vec3& point) {
    if (zmap.tileCount() == 0)
        return false;
    const Grid& grid = zmap.grid();
    const double i = (point.x - grid.x0) / grid.hx;
    const double j = (point.y - grid.y0) / grid.hy;
    const bool above = i >= 0 && j >= 0 && i <= grid.nx - 1 && j <= grid.ny - 1;
    if (!above || point.z <= zmap.stock().floorZ() || point.z >= zmap.stock().topZ())
        return false;
    const float height = zmap.height(static_cast<int>(std::lround(i)), static_cast<int>(std::lround(j)));
    return point.z - zmap.stock().topZ() < double{height};
}

} // namespace proveout
