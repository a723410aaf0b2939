// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/cutting/random_motion.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "core/cutting/cutting.h"
#include "tests/core/cutting/oracle.h"

namespace proveout {

double uniform(Random& random, double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
}

Cutter cutterOf(const std::string& spec) {
    return parseCutter(spec).value();
}

Cutter randomCutter(Random& random, const std::string& shape) {
    const double d = uniform(random, 2, 12);
    if (shape == "bull")
        return cutterOf(fmt::format("bull:d={},r={}", d, d * uniform(random, 0.02, 0.5)));
    if (shape == "cone")
        return cutterOf(fmt::format("cone:d={},angle={},tip={}", d, uniform(random, 15, 160),
                                    random() % 2 == 0 ? 0.0 : d * uniform(random, 0.05, 0.9)));
    return cutterOf(fmt::format("{}:d={}", shape, d));
}

Motion straightMotion(const Vec3& start, const Vec3& end) {
    Motion motion;
    motion.kind = MotionKind::feed;
    motion.startKnown = kAllAxes;
    motion.endKnown = kAllAxes;
    motion.start = start;
    motion.end = end;
    return motion;
}

Motion arcMotion(Plane plane, const Vec3& centre, double radius, double angle, double sweep, double climb,
                 double endRadius) {
    static constexpr int kAxes[3][3] = {{0, 1, 2}, {2, 0, 1}, {1, 2, 0}};
    const auto& [u, v, n] = kAxes[static_cast<int>(plane)];
    Motion motion = straightMotion(centre, centre);
    motion.kind = MotionKind::arc;
    motion.plane = plane;
    motion.centre = centre;
    motion.sweep = sweep;
    motion.start[u] += radius * std::cos(angle);
    motion.start[v] += radius * std::sin(angle);
    motion.end[u] += endRadius * std::cos(angle + sweep);
    motion.end[v] += endRadius * std::sin(angle + sweep);
    motion.end[n] += climb;
    return motion;
}

namespace {

Vec3 randomPlace(Random& random, const StockBox& stock) {
    return {uniform(random, stock.corner.x - 4, stock.corner.x + stock.width + 4),
            uniform(random, stock.corner.y - 4, stock.corner.y + stock.depth + 4),
            uniform(random, stock.topZ() - 10, stock.topZ() - 0.5)};
}

} // namespace

Motion randomStraight(Random& random, const StockBox& stock, StraightKind kind) {
    const Vec3 start = randomPlace(random, stock);
    Vec3 end = randomPlace(random, stock);
    switch (kind) {
    case StraightKind::level:
        end.z = start.z;
        break;
    case StraightKind::sloped:
        break;
    case StraightKind::steep: {
        const double part = std::pow(10.0, uniform(random, -13, -1));
        end.x = start.x + (end.x - start.x) * part;
        end.y = start.y + (end.y - start.y) * part;
        break;
    }
    case StraightKind::plunge:
        end.x = start.x;
        end.y = start.y;
        break;
    case StraightKind::still:
        end = start;
        break;
    }
    // Every fourth runs along an axis or a diagonal, where special cases lie.
    if (random() % 4 == 0) {
        if (random() % 2 == 0)
            end.x = start.x;
        else
            end.y = start.y + (end.x - start.x);
    }
    return straightMotion(start, end);
}

Motion randomArc(Random& random, const StockBox& stock, Plane plane, ArcKind kind) {
    const Vec3 centre = randomPlace(random, stock);
    const double radius = std::pow(10.0, uniform(random, -1, 1.4));
    const double sign = random() % 2 == 0 ? 1.0 : -1.0;
    double sweep = sign * uniform(random, 0.1, 2 * std::numbers::pi);
    if (random() % 5 == 0)
        sweep = sign * 2 * std::numbers::pi;
    if (kind == ArcKind::turns)
        sweep = sign * uniform(random, 2 * std::numbers::pi, 20);
    const double climb = kind == ArcKind::level ? 0 : uniform(random, -8, 8);
    double endRadius = radius;
    if (kind == ArcKind::spiral || (kind == ArcKind::turns && random() % 2 == 0))
        endRadius =
            random() % 2 == 0 ? radius * uniform(random, 0.5, 1.5) : radius + uniform(random, -1e-3, 1e-3);
    return arcMotion(plane, centre, radius, uniform(random, -4, 4), sweep, climb, endRadius);
}

std::string told(const Cutter& cutter, const Motion& m) {
    return fmt::format("{} kind {} plane {} start {:.17g},{:.17g},{:.17g} end {:.17g},{:.17g},{:.17g} centre "
                       "{:.17g},{:.17g},{:.17g} sweep {:.17g}",
                       cutter.spec(), static_cast<int>(m.kind), static_cast<int>(m.plane), m.start.x,
                       m.start.y, m.start.z, m.end.x, m.end.y, m.end.z, m.centre.x, m.centre.y, m.centre.z,
                       m.sweep);
}

double largestError(const Cutter& cutter, const Motion& motion, const StockBox& stock, double spacing,
                    int samples, int stride) {
    const Grid grid = makeGrid(stock, spacing).value();
    ZMap zmap(stock, grid);
    (void)cut(zmap, cutter, motion);
    const ZMapSnapshot moment = zmap.snapshot();
    double largest = 0;
    for (int j = 0; j < grid.ny; j += stride) {
        for (int i = 0; i < grid.nx; i += stride) {
            const OracleHeight truth = oracleEnvelope(cutter, motion, grid.x(i), grid.y(j), samples);
            if (truth.onRim)
                continue;
            const double expected = std::clamp(truth.z - stock.topZ(), -stock.height, 0.0);
            largest = std::max(largest, std::abs(static_cast<double>(moment.height(i, j)) - expected));
        }
    }
    return largest;
}

} // namespace proveout
