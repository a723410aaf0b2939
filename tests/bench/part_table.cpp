// SPDX-License-Identifier: GPL-3.0-or-later
// The time of the signed distances of the points of a map from a part: `part_table [RUNS]` prints a table in
// Markdown. The surfaces are those of a sphere, whose facets are all equally near to its middle: far from it
// there is no harder part.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <string_view>
#include <thread>
#include <vector>

#include "tests/core/part/part_meshes.h"

namespace proveout::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kRadius = 100; // mm

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Over the inner square of a half sphere that is larger by `offset`.
std::vector<Vec3> pointsOf(int side, double offset) {
    std::vector<Vec3> points;
    const double radius = kRadius + offset;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const double x = kRadius * (1.4 * i / (side - 1) - 0.7);
            const double y = kRadius * (1.4 * j / (side - 1) - 0.7);
            points.emplace_back(x, y, std::sqrt(radius * radius - x * x - y * y));
        }
    return points;
}

int run(int runs) {
    fmt::print(
        "{} threads\n\n| facets | points | offset, mm | s, part | s, points |\n|--:|--:|--:|--:|--:|\n",
        std::thread::hardware_concurrency());
    const test::Mesh mesh = test::sphereMesh(kRadius, 708);
    for (const double offset : {0.0, 0.05, 0.5, 5.0}) {
        const std::vector<Vec3> points = pointsOf(1414, offset);
        double part = 1e9;
        double distances = 1e9;
        for (int k = 0; k < runs; ++k) {
            const Clock::time_point start = Clock::now();
            const PartDistance distance(mesh.vertices, mesh.facets);
            part = std::min(part, secondsSince(start));
            const Clock::time_point made = Clock::now();
            (void)distance.at(points);
            distances = std::min(distances, secondsSince(made));
        }
        fmt::print("| {} | {} | {} | {:.3f} | {:.3f} |\n", mesh.facets.size(), points.size(), offset, part,
                   distances);
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
