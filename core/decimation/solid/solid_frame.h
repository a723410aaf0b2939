// SPDX-License-Identifier: GPL-3.0-or-later
// Converts lattice to program coordinates, and answers what a solid needs to know about its floor. Internal
// to this library.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/geometry.h"
#include "core/decimation/regions/region_mesh.h"
#include "core/decimation/solid/corners.h"
#include "core/decimation/solid/solid.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Holds a reference to the z-map.
class SolidFrame {
public:
    /// `coordinates`: in which the solid must be sound.
    explicit SolidFrame(const ZMapSnapshot& zmap, CoordinateType coordinates = CoordinateType::float32);

    [[nodiscard]] CoordinateType coordinates() const { return m_coordinates; }

    [[nodiscard]] int nx() const { return m_zmap->grid().nx; }
    [[nodiscard]] int ny() const { return m_zmap->grid().ny; }
    [[nodiscard]] std::size_t points() const {
        return static_cast<std::size_t>(nx()) * static_cast<std::size_t>(ny());
    }
    /// The number of points on the four sides of the map, corners counted twice.
    [[nodiscard]] std::size_t outlinePoints() const {
        return 2 * (static_cast<std::size_t>(nx()) + static_cast<std::size_t>(ny()));
    }
    [[nodiscard]] int column(std::uint32_t lattice) const {
        return static_cast<int>(lattice % static_cast<std::uint32_t>(nx()));
    }
    [[nodiscard]] int row(std::uint32_t lattice) const {
        return static_cast<int>(lattice / static_cast<std::uint32_t>(nx()));
    }
    [[nodiscard]] std::uint32_t lattice(int i, int j) const {
        return static_cast<std::uint32_t>(j) * static_cast<std::uint32_t>(nx()) +
               static_cast<std::uint32_t>(i);
    }

    [[nodiscard]] const ZMapSnapshot& zmap() const { return *m_zmap; }
    /// Whether it is on one of the four sides of the map.
    [[nodiscard]] bool onOutline(std::uint32_t lattice) const;
    [[nodiscard]] bool isBesideWall(std::uint32_t lattice) const {
        return !m_isBesideWall.empty() && m_isBesideWall[lattice];
    }
    /// Whether one of its points is.
    [[nodiscard]] bool isBesideWall(const LatticeTriangle& triangle) const;
    /// That of the wall which a point is beside, over ground from its low to its high side; 0: none.
    [[nodiscard]] Vec2 wallNormal(std::uint32_t lattice) const;
    /// The larger spacing of the grid, mm.
    [[nodiscard]] double cell() const;

    /// Of the vertex that is this grid point: beside a wall, it is on the wall.
    [[nodiscard]] Vec2 plan(std::uint32_t lattice) const;
    /// The point of the surface over a grid point.
    [[nodiscard]] Vec3 top(std::uint32_t lattice) const;
    [[nodiscard]] Corners top(const LatticeTriangle& triangle) const;
    [[nodiscard]] double floorZ() const { return m_zmap->stock().floorZ(); }
    /// Whether the surface is so near the floor here that the two could not be distinguished.
    [[nodiscard]] bool onFloor(std::uint32_t lattice) const;

    /// kPinchGap, or more if float32 (which STL uses) could not hold it: in height, and in plan.
    [[nodiscard]] double gapZ() const { return m_gapZ; }
    [[nodiscard]] double gapXY() const { return m_gapXY; }

private:
    const ZMapSnapshot* m_zmap;
    std::vector<bool> m_isBesideWall; ///< by point; empty: none is
    CoordinateType m_coordinates;
    double m_gapZ;
    double m_gapXY;
};

} // namespace proveout
