// SPDX-License-Identifier: GPL-3.0-or-later
// The time of the signed distances of the points of a map from a part, and of the comparison in both
// directions: `part_table [RUNS]` prints a table in Markdown. The surfaces are those of a sphere, whose
// facets are all equally near to its middle: far from it there is no harder part.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <memory>
#include <string_view>
#include <thread>
#include <vector>

#include "core/part/deviation.h"
#include "tests/core/part/part_meshes.h"

namespace proveout::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kRadius = 100; // mm

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Over the inner square of a half sphere that is larger by `offset`.
ZMapSnapshot stockOf(int side, double offset) {
    const double half = 0.7 * kRadius;
    const StockBox stock{{-half, -half, kRadius + offset}, 2 * half, 2 * half, kRadius};
    const Grid grid = *makeGrid(stock, 2 * half / (side - 1));
    ZMap zmap(stock, grid);
    const double radius = kRadius + offset;
    for (std::size_t index = 0; index < zmap.tileCount(); ++index) {
        const IndexRect rect = zmap.tileRect(index);
        Tile& tile = zmap.tileForWriting(index);
        for (int j = rect.j0; j < rect.j1; ++j)
            for (int i = rect.i0; i < rect.i1; ++i)
                tile.at(i - rect.i0, j - rect.j0) = static_cast<float>(
                    std::sqrt(radius * radius - grid.x(i) * grid.x(i) - grid.y(j) * grid.y(j)) - radius);
        tile.refreshMaximum();
    }
    return zmap.snapshot();
}

std::vector<Vec3> pointsOf(const ZMapSnapshot& stock) {
    std::vector<Vec3> points;
    const Grid& grid = stock.grid();
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i)
            points.emplace_back(grid.x(i), grid.y(j),
                                stock.stock().topZ() + static_cast<double>(stock.height(i, j)));
    return points;
}

int run(int runs) {
    fmt::print("{} threads\n\n| facets | points | offset, mm | s, part | s, points | s, comparison "
               "|\n|--:|--:|--:|--:|--:|--:|\n",
               std::thread::hardware_concurrency());
    const test::Mesh mesh = test::sphereMesh(kRadius, 708);
    const TriangleMesh facets{mesh.vertices, mesh.facets};
    for (const double offset : {0.0, 0.05, 0.5, 5.0}) {
        const ZMapSnapshot stock = stockOf(1414, offset);
        const std::vector<Vec3> points = pointsOf(stock);
        double made = 1e9;
        double distances = 1e9;
        double compared = 1e9;
        for (int k = 0; k < runs; ++k) {
            const Clock::time_point start = Clock::now();
            const auto part = std::make_shared<const DesignPart>(facets);
            made = std::min(made, secondsSince(start));
            const Clock::time_point begin = Clock::now();
            (void)part->distance().at(points);
            distances = std::min(distances, secondsSince(begin));
            const Clock::time_point whole = Clock::now();
            (void)Deviation::of(stock, part, {});
            compared = std::min(compared, secondsSince(whole));
        }
        fmt::print("| {} | {} | {} | {:.3f} | {:.3f} | {:.3f} |\n", mesh.facets.size(), points.size(), offset,
                   made, distances, compared);
        std::fflush(stdout);
    }
    return 0;
}

} // namespace
} // namespace proveout::bench

int main(int count, char** words) {
    int runs = 3;
    if (count > 1) {
        const std::string_view word(words[1]);
        std::from_chars(word.data(), word.data() + word.size(), runs);
    }
    return proveout::bench::run(std::max(runs, 1));
}
