// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/zmap/zmap.h"

namespace proveout {

/// Which motion lowered each point of a z-map last; of several that reach equally low, the first. Four bytes
/// per point, including those outside the grid. Owned by one thread; parallel work may write different tiles
/// at once. Movable.
class Provenance {
public:
    using Marks =
        std::array<std::uint32_t, std::size_t{Tile::kSize} * Tile::kSize>; ///< row by row, as a Tile
    static constexpr std::uint32_t kUncut = 0;

    /// For an uncut map; allocates the memory.
    explicit Provenance(const ZMap& zmap) : m_tilesX(zmap.tilesX()) {
        for (std::size_t index = 0; index < zmap.tileCount(); ++index)
            m_tiles.push_back(std::make_unique<Marks>());
    }

    [[nodiscard]] Marks& tile(std::size_t index) { return *m_tiles[index]; }
    /// CutterMotion::mark of the motion that lowered point (i, j) last; kUncut if none did.
    [[nodiscard]] std::uint32_t at(int i, int j) const {
        const auto tile = static_cast<std::size_t>((j / Tile::kSize) * m_tilesX + i / Tile::kSize);
        return (*m_tiles[tile])[static_cast<std::size_t>(j % Tile::kSize * Tile::kSize + i % Tile::kSize)];
    }

    /// Bytes needed for a grid.
    [[nodiscard]] static double bytes(const Grid& grid) {
        const auto tiles = [](int points) {
            return static_cast<std::size_t>((points + Tile::kSize - 1) / Tile::kSize);
        };
        return static_cast<double>(tiles(grid.nx) * tiles(grid.ny)) * sizeof(Marks);
    }

private:
    int m_tilesX;
    std::vector<std::unique_ptr<Marks>> m_tiles;
};

} // namespace proveout
