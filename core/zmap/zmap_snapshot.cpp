// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cassert>
#include <vector>

#include "core/base/parallel.h"
#include "core/zmap/zmap.h"

namespace proveout {

std::size_t tileCountOf(const Grid& grid) {
    const auto tiles = [](int points) { return (points + Tile::kSize - 1) / Tile::kSize; };
    return static_cast<std::size_t>(tiles(grid.nx)) * static_cast<std::size_t>(tiles(grid.ny));
}

IndexRect tileRectOf(const Grid& grid, std::size_t index) {
    const int tilesX = (grid.nx + Tile::kSize - 1) / Tile::kSize;
    const int i0 = static_cast<int>(index % static_cast<std::size_t>(tilesX)) * Tile::kSize;
    const int j0 = static_cast<int>(index / static_cast<std::size_t>(tilesX)) * Tile::kSize;
    return {i0, j0, std::min(i0 + Tile::kSize, grid.nx), std::min(j0 + Tile::kSize, grid.ny)};
}

ZMapSnapshot::ZMapSnapshot(StockBox stock, Grid grid, PersistentArray<std::shared_ptr<const Tile>> tiles)
    : m_stock(stock), m_grid(grid), m_tiles(std::move(tiles)) {}

IndexRect ZMapSnapshot::tileRect(std::size_t index) const {
    return tileRectOf(m_grid, index);
}

void ZMapSnapshot::read(const IndexRect& rect, std::span<float> out) const {
    if (rect.empty())
        return;
    assert(out.size() >= static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height()));
    float* target = out.data();
    for (int j = rect.j0; j < rect.j1; ++j) {
        for (int i = rect.i0; i < rect.i1;) {
            const int end = std::min(rect.i1, (i / Tile::kSize + 1) * Tile::kSize);
            const auto index =
                static_cast<std::size_t>(j / Tile::kSize) * static_cast<std::size_t>(tilesX()) +
                static_cast<std::size_t>(i / Tile::kSize);
            const Tile& source = *m_tiles[index];
            const float* row =
                &source.heights[static_cast<std::size_t>(j % Tile::kSize * Tile::kSize + i % Tile::kSize)];
            target = std::copy_n(row, end - i, target);
            i = end;
        }
    }
}

namespace {

bool sameIn(const Tile& a, const Tile& b, const IndexRect& local) {
    for (int j = local.j0; j < local.j1; ++j) {
        for (int i = local.i0; i < local.i1; ++i) {
            if (a.at(i, j) != b.at(i, j))
                return false;
        }
    }
    return true;
}

} // namespace

bool ZMapSnapshot::sameHeights(const ZMapSnapshot& other, const IndexRect& rect) const {
    assert(m_grid == other.m_grid);
    if (rect.empty())
        return true;
    for (int tj = rect.j0 / Tile::kSize; tj <= (rect.j1 - 1) / Tile::kSize; ++tj) {
        for (int ti = rect.i0 / Tile::kSize; ti <= (rect.i1 - 1) / Tile::kSize; ++ti) {
            const auto index = static_cast<std::size_t>(tj) * static_cast<std::size_t>(tilesX()) +
                               static_cast<std::size_t>(ti);
            if (m_tiles[index] == other.m_tiles[index])
                continue;
            const IndexRect box = tileRect(index);
            const IndexRect part = intersection(rect, box);
            if (!sameIn(*m_tiles[index], *other.m_tiles[index],
                        {part.i0 - box.i0, part.j0 - box.j0, part.i1 - box.i0, part.j1 - box.j0}))
                return false;
        }
    }
    return true;
}

double ZMapSnapshot::volume() const {
    const double floorHeight = floor();
    std::vector<double> sums(m_tiles.size());
    inParallel(m_tiles.size(), [&](std::size_t index) {
        const IndexRect box = tileRect(index);
        double sum = 0;
        for (int j = box.j0; j < box.j1; ++j) {
            double row = 0;
            for (int i = box.i0; i < box.i1; ++i) {
                const double height = m_tiles[index]->at(i - box.i0, j - box.j0) - floorHeight;
                row += i == 0 || i == m_grid.nx - 1 ? height / 2 : height;
            }
            sum += j == 0 || j == m_grid.ny - 1 ? row / 2 : row;
        }
        sums[index] = sum;
    });
    double total = 0; // in the order of tiles, with any number of threads
    for (const double sum : sums)
        total += sum;
    return total * m_grid.hx * m_grid.hy;
}

} // namespace proveout
