// SPDX-License-Identifier: GPL-3.0-or-later
// scale_bench [SPACING [WORKLOAD]]: seconds for four workloads of growing size, compared with a plain loop of
// the same formula over the same points, in one run.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <string>
#include <vector>

#include "core/base/stop_watch.h"
#include "core/cutting/profiles/vector_clones.h"
#include "tests/bench/workloads.h"

namespace proveout::bench {
namespace {

/// The straightforward implementation: motion by motion, row by row, in single precision, as vector code.
class PlainLoop {
public:
    PlainLoop(const Grid& grid, float floor)
        : m_grid(grid), m_floor(floor),
          m_heights(static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny)) {}

    void cutBall(const Motion& motion, double radius) {
        const Vec2 over = Vec2(motion.end) - Vec2(motion.start);
        const double length = std::max(1e-9, glm::length(over));
        const auto rows = rangeOf(motion.start.y, motion.end.y, radius, m_grid.y0, m_grid.hy, m_grid.ny);
        const auto columns = rangeOf(motion.start.x, motion.end.x, radius, m_grid.x0, m_grid.hx, m_grid.nx);
        for (int j = rows.first; j <= rows.second; ++j) {
            const Vec2 first = Vec2(m_grid.x(columns.first), m_grid.y(j)) - Vec2(motion.start);
            lowerRow(&m_heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(m_grid.nx) +
                                static_cast<std::size_t>(columns.first)],
                     columns.second - columns.first + 1, first, over / length, length, motion, radius);
        }
    }

    [[nodiscard]] double sum() const {
        double sum = 0;
        for (const float height : m_heights)
            sum += static_cast<double>(height);
        return sum;
    }

private:
    static std::pair<int, int> rangeOf(double a, double b, double reach, double origin, double spacing,
                                       int count) {
        const double lo = std::ceil((std::min(a, b) - reach - origin) / spacing);
        const double hi = std::floor((std::max(a, b) + reach - origin) / spacing);
        return {static_cast<int>(std::max(0.0, lo)), static_cast<int>(std::min(count - 1.0, hi))};
    }

    PROVEOUT_VECTOR_CLONES void lowerRow(float* heights, int count, const Vec2& first, const Vec2& along,
                                         double length, const Motion& motion, double radius) const {
        const auto s0 = static_cast<float>(glm::dot(first, along));
        const auto w0 = static_cast<float>(first.y * along.x - first.x * along.y);
        const auto sStep = static_cast<float>(m_grid.hx * along.x);
        const auto wStep = static_cast<float>(-m_grid.hx * along.y);
        const auto end = static_cast<float>(length);
        const auto slope = static_cast<float>((motion.end.z - motion.start.z) / length);
        const float lead = slope / std::sqrt(1 + slope * slope);
        const auto z0 = static_cast<float>(motion.start.z + radius);
        const auto r2 = static_cast<float>(radius * radius);
        for (int k = 0; k < count; ++k) {
            const float s = s0 + sStep * static_cast<float>(k);
            const float w = w0 + wStep * static_cast<float>(k);
            const float c2 = r2 - w * w;
            const float ahead = s - std::sqrt(c2 > 0 ? c2 : 0) * lead;
            const float low = ahead > 0 ? ahead : 0;
            const float u = low < end ? low : end;
            const float under = c2 - (s - u) * (s - u);
            const float z = z0 + slope * u - std::sqrt(under > 0 ? under : 0);
            const float cut = z < m_floor ? m_floor : z;
            heights[k] = under >= 0 && cut < heights[k] ? cut : heights[k];
        }
    }

    Grid m_grid;
    float m_floor;
    std::vector<float> m_heights;
};

double sumOf(const ZMap& zmap) {
    std::vector<float> row(static_cast<std::size_t>(zmap.grid().nx));
    const ZMapSnapshot moment = zmap.snapshot();
    double sum = 0;
    for (int j = 0; j < zmap.grid().ny; ++j) {
        moment.read({0, j, zmap.grid().nx, j + 1}, row);
        for (const float height : row)
            sum += static_cast<double>(height);
    }
    return sum;
}

struct Timed {
    double seconds = 0;
    double sum = 0; ///< sum of all heights, to check that the results agree
    double points = 0;
};

Timed timeSequence(const Grid& grid, const Workload& workload, const std::vector<CutterMotion>& motions,
                   std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    ZMap zmap(stockOf(workload), grid); // touches its memory here
    const StopWatch watch;
    const auto records = cut(zmap, motions, {});
    Timed timed{watch.seconds(), 0, 0};
    for (const CutRecord& record : *records)
        timed.points += static_cast<double>(record.points);
    timed.sum = sumOf(zmap);
    return timed;
}

Timed timeOneByOne(const Grid& grid, const Workload& workload, const std::vector<CutterMotion>& motions) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
    ZMap zmap(stockOf(workload), grid);
    const StopWatch watch;
    for (const CutterMotion& one : motions)
        (void)cut(zmap, one, {});
    return {watch.seconds(), sumOf(zmap), 0};
}

Timed timePlain(const Grid& grid, const Workload& workload, const std::vector<CutterMotion>& motions) {
    PlainLoop loop(grid, -static_cast<float>(stockOf(workload).height));
    const StopWatch watch;
    for (const CutterMotion& one : motions)
        loop.cutBall(one.motion, workload.diameter / 2);
    return {watch.seconds(), loop.sum(), 0};
}

Timed timeHeights(const Grid& grid, const Workload& workload, const std::vector<CutterMotion>& motions,
                  std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    ZMap zmap(stockOf(workload), grid);
    const StopWatch watch;
    (void)cutHeights(zmap, motions, {});
    return {watch.seconds(), sumOf(zmap), 0};
}

void measure(const Workload& workload, double spacing) {
    const Cutter cutter = parseCutter(fmt::format("ball:d={}", workload.diameter)).value();
    const std::vector<CutterMotion> motions = motionsOf(workload, cutter);
    const Grid grid = makeGrid(stockOf(workload), spacing).value();
    const Timed heights = timeHeights(grid, workload, motions, 1);
    const Timed heightsOnTwo = timeHeights(grid, workload, motions, 2);
    const Timed records = timeSequence(grid, workload, motions, 1);
    const Timed recordsOnTwo = timeSequence(grid, workload, motions, 2);
    const Timed steps = timeOneByOne(grid, workload, motions);
    const Timed plain = timePlain(grid, workload, motions);
    const double points = static_cast<double>(grid.nx) * grid.ny;
    double differ = 0;
    for (const Timed& other : {heightsOnTwo, records, recordsOnTwo, steps, plain})
        differ = std::max(differ, std::abs(other.sum - heights.sum) / points);
    std::puts(fmt::format("{:<8}{:>9}{:>9.1f}{:>9.3f}{:>9.3f}{:>7.2f}{:>9.3f}{:>9.3f}{:>7.2f}{:>9.3f}{:>9.3f}"
                          "{:>8.1f}{:>11.0f}{:>9.0f}{:>10.1e}",
                          workload.name, motions.size(), points / 1e6, heights.seconds, heightsOnTwo.seconds,
                          heights.seconds / heightsOnTwo.seconds, records.seconds, recordsOnTwo.seconds,
                          records.seconds / recordsOnTwo.seconds, steps.seconds, plain.seconds,
                          plain.seconds / heights.seconds,
                          static_cast<double>(motions.size()) / records.seconds,
                          records.points / records.seconds / 1e6, differ)
                  .c_str());
    std::fflush(stdout);
}

} // namespace
} // namespace proveout::bench

int main(int argc, char** argv) {
    using namespace proveout::bench;
    const double spacing = argc > 1 ? std::strtod(argv[1], nullptr) : 0.1;
    const std::string only = argc > 2 ? argv[2] : "";
    std::puts(fmt::format("cutting at {} mm: seconds for heights alone and with a record each motion, on one "
                          "thread and on two;\none by one; and of the plain loop, which makes heights alone\n"
                          "{:<8}{:>9}{:>9}{:>9}{:>9}{:>7}{:>9}{:>9}{:>7}{:>9}{:>9}{:>8}{:>11}{:>9}{:>10}",
                          spacing, "", "motions", "Mpoints", "heights", "on 2", "ratio", "records", "on 2",
                          "ratio", "single", "plain", "ratio", "motions/s", "M/s", "differ")
                  .c_str());
    for (const Workload& workload : workloads()) {
        if (only.empty() || only == workload.name)
            measure(workload, spacing);
    }
    return 0;
}
