// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/cutting/random_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <numbers>
#include <ostream>
#include <utility>

#include "core/cutting/cut/cutting.h"
#include "tests/core/cutter/default_spec.h"
#include "tests/core/cutting/oracle.h"

namespace proveout {

double uniform(Random& random, double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
}

namespace {

/// The rest of a spec for a cutter of width `d` mm.
struct RandomSpec {
    const char* shape;
    std::string (*keys)(Random& random, double d);
};

bool oneIn(Random& random, unsigned chances) {
    return random() % chances == 0;
}

std::string onlyDiameter(Random& /*random*/, double d) {
    return fmt::format("d={}", d);
}

/// A tip or corner, often none.
double partOf(Random& random, double whole, double most) {
    return oneIn(random, 2) ? 0.0 : whole * uniform(random, 0.05, most);
}

std::string bullKeys(Random& random, double d) {
    return fmt::format("d={},r={}", d, d * uniform(random, 0.02, 0.5));
}

std::string coneKeys(Random& random, double d) {
    const double angle = uniform(random, 15, 160);
    return fmt::format("d={},angle={},tip={}", d, angle, partOf(random, d, 0.9));
}

std::string drillKeys(Random& random, double d) {
    return fmt::format("d={},angle={}", d, uniform(random, 15, 160));
}

std::string taperKeys(Random& random, double d) {
    const double angle = uniform(random, 0.5, 50);
    const double corner = partOf(random, d / 4, 0.9);
    return fmt::format("d={},angle={},h={},r={}", d / 2, angle, corner + uniform(random, 0.5, 6), corner);
}

std::string taperBallKeys(Random& random, double d) {
    return fmt::format("d={},angle={},h={}", d / 2, uniform(random, 0.5, 50),
                       d / 4 + uniform(random, 0.5, 6));
}

std::string faceKeys(Random& random, double d) {
    const double corner = partOf(random, d / 2, 0.9);
    const double angle = oneIn(random, 4) ? 90 : uniform(random, 20, 90);
    return fmt::format("d={},angle={},h={},r={}", d, angle, corner + uniform(random, 0.5, 3), corner);
}

std::string centreKeys(Random& random, double d) {
    const double pilot = d * uniform(random, 0.1, 0.8);
    return fmt::format("d={},pilot={},pl={},angle={}", d, pilot, pilot * uniform(random, 0.4, 2),
                       uniform(random, 30, 120));
}

std::string reamerKeys(Random& random, double d) {
    return fmt::format("d={},lead={},angle={}", d, d * uniform(random, 0, 0.25), uniform(random, 5, 60));
}

std::string threadKeys(Random& random, double d) {
    return fmt::format("d={},tip={},lead={}", d, d * uniform(random, 0, 0.9), d * uniform(random, 0, 0.8));
}

std::string neckKeys(Random& random, double d) {
    return fmt::format("d={},neck={}", d, d * uniform(random, 0.2, 0.9));
}

std::string slotKeys(Random& random, double d) {
    const double width = uniform(random, 0.5, 5);
    return fmt::format("d={},w={},neck={},r={}", d, width, d * uniform(random, 0.1, 0.3),
                       std::min(width / 2, d * partOf(random, 0.3, 1)));
}

std::string dovetailKeys(Random& random, double d) {
    const double angle = uniform(random, 40, 85);
    return fmt::format("d={},angle={},h={},r={}", d, angle, d * 0.3, partOf(random, d, 0.12));
}

/// Adds a point to a profile in one of the possible ways, and moves `last` to it.
std::string randomFormPoint(Random& random, double size, Vec2& last) {
    const double radius = size * std::pow(10.0, uniform(random, -0.5, 1));
    double from = uniform(random, 0, std::numbers::pi / 2);
    double to = uniform(random, 0, std::numbers::pi / 2);
    if (from > to)
        std::swap(from, to);
    if (oneIn(random, 3))
        from = 0;
    if (oneIn(random, 3))
        to = std::numbers::pi / 2;
    // Complete large arcs would make large cutters.
    const double width = std::min(1.0, size / radius);
    to = from + (to - from) * width;
    Vec2 step(uniform(random, 0.1, 1) * size, uniform(random, 0, 1) * size);
    std::string round;
    switch (random() % 5) {
    case 0:
        step.y = 0;
        break;
    case 1:
        step.x = 0;
        break;
    case 2:
        step = radius * Vec2(std::sin(to) - std::sin(from), std::cos(from) - std::cos(to));
        round = fmt::format("@{}", radius);
        break;
    case 3:
        step = radius * Vec2(std::cos(from) - std::cos(to), std::sin(to) - std::sin(from));
        round = fmt::format("@{}", -radius);
        break;
    default:
        break;
    }
    if (std::min(step.x, step.y) < 1e-3)
        round.clear();
    last += step;
    return fmt::format(":{}/{}{}", last.x, last.y, round);
}

std::string formKeys(Random& random, double d) {
    const auto count = 1 + random() % 4;
    const double size = d / 2 / static_cast<double>(count + 1);
    Vec2 last(uniform(random, 0.02, 1) * size, 0);
    std::string points = fmt::format("p=0/0:{}/0", last.x);
    for (unsigned k = 0; k < count; ++k)
        points += randomFormPoint(random, size, last);
    return points;
}

constexpr RandomSpec kSpecs[] = {
    {"flat", onlyDiameter},       {"ball", onlyDiameter},     {"bull", bullKeys},
    {"cone", coneKeys},           {"drill", drillKeys},       {"taper", taperKeys},
    {"taperball", taperBallKeys}, {"chamfer", coneKeys},      {"face", faceKeys},
    {"spot", drillKeys},          {"centre", centreKeys},     {"reamer", reamerKeys},
    {"tap", threadKeys},          {"threadmill", threadKeys}, {"lollipop", neckKeys},
    {"tslot", slotKeys},          {"dovetail", dovetailKeys}, {"form", formKeys},
};

} // namespace

Cutter cutterOf(const std::string& spec) {
    return parseCutter(spec).value();
}

Cutter randomCutter(Random& random, const std::string& shape) {
    const auto row =
        std::ranges::find_if(kSpecs, [&](const RandomSpec& spec) { return shape == spec.shape; });
    const double d = uniform(random, 2, 12);
    if (row == std::end(kSpecs)) { // for a new shape, uses the values that dialogs propose
        const auto known = std::ranges::find(cutterShapes(), shape, &CutterShape::key);
        return cutterOf(known == cutterShapes().end() ? shape : defaultSpecOf(*known));
    }
    return cutterOf(shape + ':' + row->keys(random, d));
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
    // Every fourth motion is parallel to an axis or a diagonal, which are special cases.
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

std::string reported(const Cutter& cutter, const Motion& m) {
    return fmt::format("{} kind {} plane {} start {:.17g},{:.17g},{:.17g} end {:.17g},{:.17g},{:.17g} centre "
                       "{:.17g},{:.17g},{:.17g} sweep {:.17g}",
                       cutter.spec(), static_cast<int>(m.kind), static_cast<int>(m.plane), m.start.x,
                       m.start.y, m.start.z, m.end.x, m.end.y, m.end.z, m.centre.x, m.centre.y, m.centre.z,
                       m.sweep);
}

namespace {

/// The difference between a height of the map and that of the oracle; 0 if they are not comparable.
double errorAt(const ZMapSnapshot& moment, int i, int j, const Cutter& cutter, const OraclePath& path) {
    const Grid& grid = moment.grid();
    const StockBox& stock = moment.stock();
    const OracleHeight truth = oracleEnvelope(cutter, path, grid.x(i), grid.y(j));
    if (truth.onRim)
        return 0;
    const double expected = std::clamp(truth.z - stock.topZ(), -stock.height, 0.0);
    return std::abs(static_cast<double>(moment.height(i, j)) - expected);
}

ZMapSnapshot cutOnce(const Cutter& cutter, const Motion& motion, const StockBox& stock, double spacing) {
    ZMap zmap(stock, makeGrid(stock, spacing).value());
    (void)cut(zmap, cutter, motion);
    return zmap.snapshot();
}

} // namespace

double largestError(const Cutter& cutter, const Motion& motion, const StockBox& stock, double spacing,
                    int samples, int stride) {
    const ZMapSnapshot moment = cutOnce(cutter, motion, stock, spacing);
    const OraclePath path(motion, samples);
    double largest = 0;
    for (int j = 0; j < moment.grid().ny; j += stride) {
        for (int i = 0; i < moment.grid().nx; i += stride)
            largest = std::max(largest, errorAt(moment, i, j, cutter, path));
    }
    return largest;
}

double largestErrorNear(Random& random, const Cutter& cutter, const Motion& motion, const StockBox& stock,
                        double spacing, int samples, int points) {
    const ZMapSnapshot moment = cutOnce(cutter, motion, stock, spacing);
    const OraclePath path(motion, samples);
    const Grid& grid = moment.grid();
    const auto index = [](double at, double from, double step, int count) {
        return std::clamp(static_cast<int>(std::lround((at - from) / step)), 0, count - 1);
    };
    double largest = 0;
    for (int k = 0; k < points; ++k) {
        const Vec3 tip = path.at(uniform(random, 0, 1));
        const double away = cutter.radius() * uniform(random, 0, 1.05);
        const double angle = uniform(random, 0, 2 * std::numbers::pi);
        const int i = index(tip.x + away * std::cos(angle), grid.x0, grid.hx, grid.nx);
        const int j = index(tip.y + away * std::sin(angle), grid.y0, grid.hy, grid.ny);
        largest = std::max(largest, errorAt(moment, i, j, cutter, path));
    }
    return largest;
}

namespace {

template<StraightKind kind>
Motion straight(Random& random, const StockBox& stock) {
    return randomStraight(random, stock, kind);
}

template<Plane plane, ArcKind kind>
Motion arc(Random& random, const StockBox& stock) {
    return randomArc(random, stock, plane, kind);
}

constexpr std::array kMotionRows = {
    MotionRow{"level", straight<StraightKind::level>, 300},
    MotionRow{"sloped", straight<StraightKind::sloped>, 300},
    MotionRow{"steep", straight<StraightKind::steep>, 300},
    MotionRow{"plunge", straight<StraightKind::plunge>, 300},
    MotionRow{"still", straight<StraightKind::still>, 300},
    MotionRow{"arcXy", arc<Plane::xy, ArcKind::level>, 1000},
    MotionRow{"arcZx", arc<Plane::zx, ArcKind::level>, 1000},
    MotionRow{"arcYz", arc<Plane::yz, ArcKind::level>, 1000},
    MotionRow{"helixXy", arc<Plane::xy, ArcKind::helix>, 1000},
    MotionRow{"helixZx", arc<Plane::zx, ArcKind::helix>, 1000},
    MotionRow{"helixYz", arc<Plane::yz, ArcKind::helix>, 1000},
    MotionRow{"spiralXy", arc<Plane::xy, ArcKind::spiral>, 1000},
    MotionRow{"spiralZx", arc<Plane::zx, ArcKind::spiral>, 1000},
    MotionRow{"spiralYz", arc<Plane::yz, ArcKind::spiral>, 1000},
    MotionRow{"turnsXy", arc<Plane::xy, ArcKind::turns>, 1000},
};

} // namespace

std::span<const MotionRow> motionRows() {
    return kMotionRows;
}

void PrintTo(const MotionRow& row, std::ostream* out) {
    *out << row.name;
}

} // namespace proveout
