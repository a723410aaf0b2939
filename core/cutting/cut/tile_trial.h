// SPDX-License-Identifier: GPL-3.0-or-later
// What one sweep would lower in a map that stays as it is.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/cutting/cut/lower_tile.h"
#include "core/cutting/kernels/tile_kernel.h"

namespace proveout {

/// Lowers copies of tiles by one sweep. Keeps references; one thread.
class TileTrial {
public:
    TileTrial(const ZMap& zmap, const PreparedSweep& prepared) : m_zmap(zmap), m_prepared(prepared) {}

    /// Calls `visit(i, j, height, lowered)` for each point of tile `index` that the sweep would lower, row by
    /// row; heights from the top of the stock.
    template<class Visit>
    void lower(std::size_t index, const Visit& visit) {
        const Lowered lowered = tryToLower(index);
        const IndexRect rect = m_zmap.tileRect(index);
        const Tile& tile = m_zmap.tile(index);
        for (std::uint64_t rows = lowered.rows; rows != 0; rows &= rows - 1) {
            const int row = std::countr_zero(rows);
            for (std::uint64_t columns = lowered.columns; columns != 0; columns &= columns - 1) {
                const int column = std::countr_zero(columns);
                if (m_copy.at(column, row) < tile.at(column, row))
                    visit(rect.i0 + column, rect.j0 + row, tile.at(column, row), m_copy.at(column, row));
            }
        }
    }

private:
    /// One bit for each row and column with a point that was lowered in the copy.
    struct Lowered {
        std::uint64_t rows = 0;
        std::uint64_t columns = 0;
    };

    [[nodiscard]] Lowered tryToLower(std::size_t index);
    [[nodiscard]] Lowered lowerRows(const IndexRect& rect);

    const ZMap& m_zmap;
    const PreparedSweep& m_prepared;
    std::vector<TilePass> m_passes;
    Tile m_copy;
};

} // namespace proveout
