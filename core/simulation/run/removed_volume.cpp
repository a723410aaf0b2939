// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/removed_volume.h"

#include <array>
#include <cstddef>

#include "core/base/parallel.h"

namespace proveout {

namespace {

/// The sum of a row in lanes, which the compiler may turn into vectors. Points beyond the map have no weight.
double sumOfRow(const float* heights, int count) {
    constexpr int kLanes = 8;
    std::array<double, kLanes> lanes{};
    int k = 0;
    for (; k + kLanes <= count; k += kLanes)
        for (int lane = 0; lane < kLanes; ++lane)
            lanes[static_cast<std::size_t>(lane)] += static_cast<double>(heights[k + lane]);
    double sum = 0;
    for (; k < count; ++k)
        sum += static_cast<double>(heights[k]);
    for (const double lane : lanes)
        sum += lane;
    return sum;
}

/// The heights of a tile, relative to the stock's top, each times its share of a cell.
double sumOfTile(const ZMap& zmap, std::size_t index) {
    const Grid& grid = zmap.grid();
    const IndexRect box = zmap.tileRect(index);
    const int width = box.width();
    double sum = 0;
    for (int j = box.j0; j < box.j1; ++j) {
        const float* row = &zmap.tile(index).heights[static_cast<std::size_t>((j - box.j0) * Tile::kSize)];
        double ofRow = sumOfRow(row, width);
        if (box.i0 == 0)
            ofRow -= static_cast<double>(row[0]) / 2;
        if (box.i1 == grid.nx)
            ofRow -= static_cast<double>(row[width - 1]) / 2;
        sum += j == 0 || j == grid.ny - 1 ? ofRow / 2 : ofRow;
    }
    return sum;
}

std::vector<double> sumsOf(const ZMap& zmap) {
    std::vector<double> sums(zmap.tileCount());
    inParallel(sums.size(), [&](std::size_t index) { sums[index] = sumOfTile(zmap, index); });
    return sums;
}

} // namespace

RemovedVolume::RemovedVolume(const ZMap& zmap) : m_sums(sumsOf(zmap)) {}

double RemovedVolume::removedFrom(const ZMap& zmap) const {
    const std::vector<double> now = sumsOf(zmap);
    double removed = 0;
    for (std::size_t index = 0; index < now.size(); ++index)
        removed += m_sums[index] - now[index];
    return removed * zmap.grid().hx * zmap.grid().hy;
}

} // namespace proveout
