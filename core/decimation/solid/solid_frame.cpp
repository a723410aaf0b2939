// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/solid_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

/// A gap that remains after both its ends are rounded to float32.
double gapAt(double a, double b) {
    constexpr double kSteps = 4;
    const double step =
        std::max(std::abs(a), std::abs(b)) * static_cast<double>(std::numeric_limits<float>::epsilon());
    return std::max(kPinchGap, kSteps * step);
}

} // namespace

SolidFrame::SolidFrame(const ZMapSnapshot& zmap, CoordinateType coordinates)
    : m_zmap(&zmap), m_coordinates(coordinates), m_gapZ(gapAt(zmap.stock().topZ(), zmap.stock().floorZ())) {
    const Grid& grid = zmap.grid();
    m_gapXY = std::max(gapAt(grid.x(0), grid.x(grid.nx - 1)), gapAt(grid.y(0), grid.y(grid.ny - 1)));
    if (zmap.walls().empty())
        return;
    m_isBesideWall.resize(points());
    for (const std::uint32_t point : zmap.walls().offsetsIn({0, 0, grid.nx, grid.ny}))
        m_isBesideWall[point] = true;
}

bool SolidFrame::onOutline(std::uint32_t lattice) const {
    const int i = column(lattice);
    const int j = row(lattice);
    return i == 0 || j == 0 || i == nx() - 1 || j == ny() - 1;
}

bool SolidFrame::isBesideWall(const LatticeTriangle& triangle) const {
    return std::ranges::any_of(triangle, [this](std::uint32_t point) { return isBesideWall(point); });
}

Vec2 SolidFrame::wallNormal(std::uint32_t lattice) const {
    if (!isBesideWall(lattice))
        return Vec2(0);
    const auto* wall = m_zmap->walls().find(column(lattice), row(lattice));
    return normalInRimUnits(wall->normalX, wall->normalY);
}

double SolidFrame::cell() const {
    return std::max(m_zmap->grid().hx, m_zmap->grid().hy);
}

Vec2 SolidFrame::plan(std::uint32_t lattice) const {
    return Vec2(top(lattice));
}

Vec3 SolidFrame::top(std::uint32_t lattice) const {
    const int i = column(lattice);
    const int j = row(lattice);
    if (isBesideWall(lattice))
        return vertexAt(*m_zmap, i, j);
    const Grid& grid = m_zmap->grid();
    return {grid.x(i), grid.y(j), m_zmap->stock().topZ() + static_cast<double>(m_zmap->height(i, j))};
}

Corners SolidFrame::top(const LatticeTriangle& triangle) const {
    return {top(triangle[0]), top(triangle[1]), top(triangle[2])};
}

bool SolidFrame::onFloor(std::uint32_t lattice) const {
    return top(lattice).z < floorZ() + m_gapZ;
}

} // namespace proveout
