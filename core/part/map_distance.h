// SPDX-License-Identifier: GPL-3.0-or-later
// How far places are from the surface of a stock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The surface of a stock: that between the points of its map, with walls where they stand, and its sides
/// down to the floor, which is not a part of it. Where nothing of the stock is left there is no surface.
/// Immutable; any thread.
class MapDistance {
public:
    struct Nearest {
        Vec3 place; ///< on the surface
        double distance;
        int i; ///< the first point of its cell
        int j;
        /// Whether the surface there is as exact as its points: no step of the grid without a rim, and no
        /// round foot of a wall between two points.
        bool isExact;
        bool isInside; ///< the point is within the stock
    };

    MapDistance() = default;
    /// Builds a pyramid of boxes, in parallel: about half a byte for each point.
    explicit MapDistance(ZMapSnapshot zmap);

    /// The nearest place within a distance, mm; nothing if there is none.
    [[nodiscard]] std::optional<Nearest> nearest(const Vec3& point, double within) const;

    [[nodiscard]] const ZMapSnapshot& zmap() const { return m_zmap; }

private:
    static constexpr int kCellsOfBlock = 4; ///< in both directions; also blocks in one of the next level

    struct Heights {
        float low = 1;
        float high = 0; ///< less than low: nothing is there
        void add(double lowest, double highest);
    };
    struct Level {
        int nx = 0; ///< blocks
        int ny = 0;
        std::vector<Heights> blocks;
        [[nodiscard]] const Heights& at(int i, int j) const {
            return blocks[static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) +
                          static_cast<std::size_t>(i)];
        }
    };
    class Search;

    [[nodiscard]] Heights heightsOf(int blockI, int blockJ) const;
    [[nodiscard]] double distance2(std::size_t level, int i, int j, const Vec3& point) const;

    ZMapSnapshot m_zmap;
    double m_moved = 0;          ///< no point is drawn farther beside its place in the grid, mm
    std::vector<Level> m_levels; ///< the finest first; the last has one block
};

} // namespace proveout
