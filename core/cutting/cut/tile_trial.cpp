// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/tile_trial.h"

#include <algorithm>
#include <limits>

namespace proveout {

TileTrial::Lowered TileTrial::tryToLower(std::size_t index) {
    const Tile& tile = m_zmap.tile(index);
    const IndexRect rect = m_zmap.tileRect(index);
    if (m_prepared.passes.empty()) {
        m_copy = tile;
        return lowerRows(rect);
    }
    const Grid& grid = m_zmap.grid();
    constexpr double kMiddle = (Tile::kSize - 1) / 2.0;
    const Vec2 first(grid.x(rect.i0), grid.y(rect.j0));
    const Vec2 middle = first + kMiddle * Vec2(grid.hx, grid.hy) - m_prepared.sweep.origin();
    m_passes.clear();
    m_prepared.passes.addOverTile(middle.x, middle.y, {grid.hx, grid.hy}, m_passes);
    if (m_passes.empty() || !mayLower(m_passes, tile, m_zmap.floor()))
        return {};
    m_copy = tile;
    TileUnderWork work(m_copy, m_zmap.floor());
    const TileLoss loss = lowerByMotion(m_passes, work, nullptr, {});
    return {loss.rows, loss.columns};
}

TileTrial::Lowered TileTrial::lowerRows(const IndexRect& rect) {
    const Grid& grid = m_zmap.grid();
    Lowered lowered;
    std::array<float, Tile::kSize> envelope{};
    for (int row = 0; row < rect.height(); ++row) {
        envelope.fill(std::numeric_limits<float>::infinity());
        const RowPoints points{grid.x(rect.i0), grid.hx, grid.y(rect.j0 + row), rect.width()};
        (void)m_prepared.sweep.row(points, &m_copy.at(0, row), envelope.data());
        for (int column = 0; column < rect.width(); ++column) {
            const float height = std::max(envelope[static_cast<std::size_t>(column)], m_zmap.floor());
            if (!(height < m_copy.at(column, row)))
                continue;
            m_copy.at(column, row) = height;
            lowered.rows |= std::uint64_t{1} << static_cast<unsigned>(row);
            lowered.columns |= std::uint64_t{1} << static_cast<unsigned>(column);
        }
    }
    return lowered;
}

} // namespace proveout
