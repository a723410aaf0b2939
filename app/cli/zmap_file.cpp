// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/zmap_file.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <span>
#include <utility>
#include <vector>

#include "app/cli/option_error.h"
#include "core/formats/npy.h"
#include "core/verification/findings/command_line_findings.h"

namespace proveout::cli {

namespace {

constexpr double kDefaultThickness = 5; ///< mm below the lowest height

Result<StockBox> stockOf(const NpyArray& array, double spacing, Vec2 origin, std::optional<double> floor) {
    if (array.rows < 2 || array.columns < 2)
        return failure(command_line_finding::kZmapTooSmall,
                       {std::to_string(array.rows), std::to_string(array.columns)});
    const auto bad = std::ranges::find_if(array.values, [](double z) { return !std::isfinite(z); });
    if (bad != array.values.end()) {
        const auto index = static_cast<std::size_t>(std::distance(array.values.begin(), bad));
        const auto columns = static_cast<std::size_t>(array.columns);
        return failure(command_line_finding::kZmapNotFinite,
                       {std::to_string(index / columns), std::to_string(index % columns)});
    }
    const auto [least, most] = std::ranges::minmax(array.values);
    const double bottom = floor.value_or(least - kDefaultThickness);
    if (!(bottom <= least && bottom < most))
        return aboutOption(
            "--floor", failure(command_line_finding::kFloorTooHigh,
                               {fmt::format("{}", bottom), fmt::format("{}", least), fmt::format("{}", most)})
                           .value());
    StockBox stock;
    stock.corner = {origin, most};
    stock.width = spacing * (array.columns - 1);
    stock.depth = spacing * (array.rows - 1);
    stock.height = most - bottom;
    return stock;
}

ZMapSnapshot filled(const NpyArray& array, const StockBox& stock, const Grid& grid) {
    ZMap zmap(stock, grid);
    for (int tj = 0; tj < zmap.tilesY(); ++tj)
        for (int ti = 0; ti < zmap.tilesX(); ++ti) {
            Tile& tile = zmap.tileForWriting(static_cast<std::size_t>(tj * zmap.tilesX() + ti));
            const int i0 = ti * Tile::kSize;
            const int j0 = tj * Tile::kSize;
            for (int j = j0; j < std::min(grid.ny, j0 + Tile::kSize); ++j)
                for (int i = i0; i < std::min(grid.nx, i0 + Tile::kSize); ++i) {
                    const auto index = static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nx) +
                                       static_cast<std::size_t>(i);
                    tile.at(i - i0, j - j0) =
                        std::max(zmap.floor(), static_cast<float>(array.values[index] - stock.topZ()));
                }
            tile.refreshMaximum();
        }
    return zmap.snapshot();
}

tl::unexpected<Diagnostics> about(const std::filesystem::path& file, Diagnostics diagnostics) {
    for (Diagnostic& diagnostic : diagnostics)
        if (diagnostic.file.empty())
            diagnostic.file = file.string();
    return tl::unexpected(std::move(diagnostics));
}

} // namespace

std::uint64_t heightsBytes(int nx, int ny) {
    return static_cast<std::uint64_t>(nx) * static_cast<std::uint64_t>(ny) * sizeof(float);
}

Result<void> writeZMap(const std::filesystem::path& file, const ZMapSnapshot& zmap) {
    const Grid& grid = zmap.grid();
    return writeNpy(file, grid.ny, grid.nx, [&](int j, std::span<float> row) {
        zmap.read({0, j, grid.nx, j + 1}, row);
        for (float& height : row)
            height = static_cast<float>(zmap.stock().topZ() + static_cast<double>(height));
    });
}

Result<void> writeProvenance(const std::filesystem::path& file, const Grid& grid,
                             const Provenance& provenance, const Program& program) {
    return writeNpy(file, grid.ny, grid.nx, [&](int j, std::span<std::uint32_t> row) {
        for (int i = 0; i < grid.nx; ++i) {
            const std::uint32_t mark = provenance.at(i, j);
            row[static_cast<std::size_t>(i)] = mark == Provenance::kUncut ? 0 : program.blockLine(mark - 1);
        }
    });
}

Result<ZMapSnapshot> readZMap(const std::filesystem::path& file, double spacing, Vec2 origin,
                              std::optional<double> floor,
                              const std::function<Result<void>(const StockBox&, const Grid&)>& check) {
    if (auto fine = checkSpacing(spacing); !fine)
        return aboutOption("--grid", std::move(fine.error()));
    const auto array = readNpy(file);
    if (!array)
        return tl::unexpected(array.error());
    auto stock = stockOf(*array, spacing, origin, floor);
    if (!stock)
        return about(file, std::move(stock.error()));
    auto grid = makeGrid(*stock, spacing);
    if (!grid)
        return about(file, std::move(grid.error()));
    // Rounding of width / spacing must not add a point that the file does not have.
    grid->nx = array->columns;
    grid->ny = array->rows;
    grid->hx = spacing;
    grid->hy = spacing;
    if (auto fine = check(*stock, *grid); !fine)
        return about(file, std::move(fine.error()));
    return filled(*array, *stock, *grid);
}

} // namespace proveout::cli
