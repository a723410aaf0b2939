// SPDX-License-Identifier: GPL-3.0-or-later
// How a grid is divided into regions, and the borders between them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/index_rect.h"

namespace proveout {

/// The sides of a region, in the order of its four borders. Borders run along rising i (south, north) or
/// rising j (west, east).
enum class Side : std::uint8_t { south, north, west, east };
inline constexpr std::array kSides{Side::south, Side::north, Side::west, Side::east};

/// Regions of cells × cells over nx × ny points; the last column and row of regions may be smaller.
/// Neighbours share the points of their border. Value type.
class RegionGrid {
public:
    RegionGrid() = default;
    RegionGrid(int nx, int ny, int cells);

    [[nodiscard]] int nx() const { return m_nx; }
    [[nodiscard]] int ny() const { return m_ny; }
    [[nodiscard]] int cells() const { return m_cells; }
    /// The most points that so many regions have, those on borders counted for each.
    [[nodiscard]] std::size_t pointsOf(std::size_t regions) const {
        const auto along = static_cast<std::size_t>(m_cells) + 1;
        return regions * along * along;
    }
    [[nodiscard]] int regionsX() const { return m_regionsX; }
    [[nodiscard]] int regionsY() const { return m_regionsY; }
    [[nodiscard]] std::size_t regionCount() const;
    [[nodiscard]] std::size_t borderCount() const;

    /// The points of a region, border points included.
    [[nodiscard]] IndexRect points(std::size_t region) const;
    /// Index of the border on a side of a region; the neighbour across the border has the same one.
    [[nodiscard]] std::size_t border(std::size_t region, Side side) const;
    /// The four borders, in the order of kSides.
    [[nodiscard]] std::array<std::size_t, 4> borders(std::size_t region) const;
    /// The one or two regions at a border; the second is kNoRegion at the edge of the map.
    static constexpr std::size_t kNoRegion = static_cast<std::size_t>(-1);
    [[nodiscard]] std::array<std::size_t, 2> sharers(std::size_t border) const;
    /// The points of a border as a rectangle that is one point wide.
    [[nodiscard]] IndexRect borderPoints(std::size_t border) const;
    /// Index ranges [rx0, rx1) × [ry0, ry1) of the regions that contain a point of `rect`.
    [[nodiscard]] IndexRect regionsTouching(const IndexRect& rect) const;
    [[nodiscard]] std::size_t regionAt(int rx, int ry) const {
        return static_cast<std::size_t>(ry) * static_cast<std::size_t>(m_regionsX) +
               static_cast<std::size_t>(rx);
    }

    /// Lattice index of a grid point: j * nx + i. Vertices of all meshes are such indices.
    [[nodiscard]] std::uint32_t lattice(int i, int j) const {
        return static_cast<std::uint32_t>(j) * static_cast<std::uint32_t>(m_nx) +
               static_cast<std::uint32_t>(i);
    }

    friend bool operator==(const RegionGrid&, const RegionGrid&) = default;

private:
    int m_nx = 2;
    int m_ny = 2;
    int m_cells = 1;
    int m_regionsX = 1;
    int m_regionsY = 1;
};

/// The points of a border that its simplified polyline keeps, as offsets 0 … n from the border's first point,
/// ascending, both ends (the corners) always kept. Immutable, shared by both regions.
struct BorderLine {
    std::vector<std::uint32_t> kept;
    std::vector<std::uint32_t> extras{}; ///< those of them that a region needed beyond the border's own rule
};
using BorderLinePtr = std::shared_ptr<const BorderLine>;

/// Of the offsets between two kept ones a < b of a border 0 … n, the first that moves to b when the border is
/// drawn as its polyline; b if all move to a.
[[nodiscard]] std::uint32_t firstSnappedUp(std::uint32_t a, std::uint32_t b, std::uint32_t n);

/// Where each of the offsets 0 … n of a border moves when the border is drawn as `kept`: a kept one stays,
/// any other moves to the kept neighbour on its nearer side (next to a corner: to the corner). Replacing the
/// border vertices of a full region mesh by this map and dropping the triangles that collapse gives a valid
/// mesh that meets the polyline: that is how a region drawn from the z-map meets a decimated neighbour
/// without a crack. A border of two cells must keep its middle: it is next to both corners at once.
[[nodiscard]] std::vector<std::uint32_t> snapToKept(const BorderLine& line, std::uint32_t n);

} // namespace proveout
