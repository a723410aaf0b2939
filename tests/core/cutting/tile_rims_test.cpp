// SPDX-License-Identifier: GPL-3.0-or-later
// Rims, compared with closed formulas and with a brute-force search by the oracle.
// PROVEOUT_MOTIONS sets the number of random cases for each kind of motion; PROVEOUT_SEED sets the seed,
// which is printed.
#include "core/cutting/cut/tile_rims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/cutter/shapes.h"
#include "core/cutting/cut/cutting.h"
#include "core/zmap/extruded_stock.h"
#include "tests/core/cutting/oracle.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr double kStep = 0.25; ///< of the definition
constexpr double kTurn = 2 * std::numbers::pi;

/// A map after some motions, and its rims.
struct CutMap {
    ZMapSnapshot map;
    std::vector<CutterMotion> motions;

    CutMap(const StockBox& stock, double spacing, std::vector<CutterMotion> all)
        : CutMap(ZMap(stock, makeGrid(stock, spacing).value()), std::move(all)) {}
    CutMap(ZMap zmap, std::vector<CutterMotion> all) : motions(std::move(all)) {
        EXPECT_TRUE(cutHeights(zmap, motions, {}));
        map = zmap.snapshot();
    }

    [[nodiscard]] RimTilePtr rims(std::size_t tile, const StockTop* uncut = nullptr,
                                  RimEdges wanted = RimEdges::all) const {
        return rimsOfTile(map, tile, uncut, motions, {}, wanted);
    }
};

/// A rim in program coordinates.
struct Wall {
    Vec2 at;
    Vec2 normal;
    double top;
    double bottom;
};

std::vector<Wall> wallsOf(const CutMap& cut, const StockTop* uncut = nullptr,
                          RimEdges wanted = RimEdges::all) {
    std::vector<Wall> walls;
    const Grid& grid = cut.map.grid();
    for (std::size_t tile = 0; tile < cut.map.tileCount(); ++tile) {
        const RimTilePtr rims = cut.rims(tile, uncut, wanted);
        if (rims == nullptr)
            continue;
        const IndexRect rect = cut.map.tileRect(tile);
        for (const Rim& rim : rims->rims) {
            const RimEdge edge = RimEdge::of(rim.edge);
            const double along = rim.fraction(true);
            const Vec2 at(grid.x(rect.i0 + edge.i) + (edge.alongY ? 0 : along * grid.hx),
                          grid.y(rect.j0 + edge.j) + (edge.alongY ? along * grid.hy : 0));
            walls.push_back({at, rim.normal(), double{rim.top}, double{rim.bottom}});
        }
    }
    return walls;
}

/// Places are stored in 65 536ths of an edge of up to 0.5 mm.
constexpr double kPlace = 1e-5;
constexpr double kNormal = 1e-3;

TEST(TileRims, AreNoneOfABoxThatIsNotCut) {
    const CutMap cut({{-3, 5, 2}, 40, 30, 12}, 0.5, {});
    EXPECT_TRUE(wallsOf(cut).empty());
}

TEST(TileRims, OfAnObliqueSlotAreOnItsTwoLines) {
    const Cutter mill = cutterOf("flat:d=6");
    const Vec2 along(std::cos(17 * kTurn / 360), std::sin(17 * kTurn / 360));
    const Vec2 across(-along.y, along.x);
    const Vec2 middle(17.2, 20.3);
    const Vec2 from = middle - along * 60.0;
    const Vec2 to = middle + along * 60.0;
    const CutMap cut({{-3, 5, 2}, 40, 30, 12}, 0.5, {{&mill, straightMotion(Vec3(from, -2), Vec3(to, -2))}});
    const std::vector<Wall> walls = wallsOf(cut);
    EXPECT_GT(walls.size(), 200);
    for (const Wall& wall : walls) {
        const double beside = glm::dot(wall.at - middle, across);
        EXPECT_NEAR(std::abs(beside), 3, kPlace);
        EXPECT_NEAR(glm::distance(wall.normal, beside > 0 ? across : -across), 0, kNormal);
        EXPECT_FLOAT_EQ(static_cast<float>(wall.top), 0);
        EXPECT_FLOAT_EQ(static_cast<float>(wall.bottom), -4);
    }
}

/// The deeper pass of a contour is beside the upper one by the rounding of the program.
TEST(TileRims, OfPassesAtSeveralDepthsAreOfOneWall) {
    const Cutter mill = cutterOf("flat:d=8");
    const CutMap cut({{0, 0, 0}, 40, 30, 12}, 0.7,
                     {{&mill, straightMotion({-10, 10.1, -3}, {60, 10.1, -3})},
                      {&mill, straightMotion({-10, 10.1004, -6}, {60, 10.0996, -6})}});
    const std::vector<Wall> walls = wallsOf(cut, nullptr, RimEdges::atLevels);
    EXPECT_GT(walls.size(), 100U);
    for (const Wall& wall : walls) {
        EXPECT_NEAR(std::abs(wall.at.y - 10.1), 4, 1e-3);
        EXPECT_NEAR(wall.top, 0, 1e-6);
        EXPECT_NEAR(wall.bottom, -6, 1e-6);
    }
}

struct Crease {
    Vec2 at;
    bool high;
    double z;
};

/// Both sides of all rims at levels.
std::vector<Crease> creasesOf(const CutMap& cut) {
    std::vector<Crease> creases;
    const Grid& grid = cut.map.grid();
    for (std::size_t tile = 0; tile < cut.map.tileCount(); ++tile) {
        const RimTilePtr rims = cut.rims(tile, nullptr, RimEdges::atLevels);
        for (const Rim& rim : rims == nullptr ? std::vector<Rim>{} : rims->rims) {
            const RimEdge edge = RimEdge::of(rim.edge);
            const IndexRect rect = cut.map.tileRect(tile);
            for (const bool high : {false, true}) {
                if (!rim.has(high))
                    continue;
                const double along = rim.fraction(high);
                const Vec2 at(grid.x(rect.i0 + edge.i) + (edge.alongY ? 0 : along * grid.hx),
                              grid.y(rect.j0 + edge.j) + (edge.alongY ? along * grid.hy : 0));
                creases.push_back({at, high, double{high ? rim.top : rim.bottom}});
            }
        }
    }
    return creases;
}

/// From a cutter's path, where a tapered wall from the floor of 6 mm to the top of the stock has its creases.
/// Within an edge or over several.
TEST(TileRims, OfTaperedWallsAreAtTheirCreases) {
    for (const double degrees : {0.6, 3.0, 12.0, 40.0}) {
        for (const double spacing : {0.5, 0.13}) {
            SCOPED_TRACE(fmt::format("{} degrees, {} mm", degrees, spacing));
            const Cutter mill = cutterOf(fmt::format("taper:d=6,angle={},h=20", degrees));
            const Vec2 along(std::cos(17 * kTurn / 360), std::sin(17 * kTurn / 360));
            const Vec2 across(-along.y, along.x);
            const Vec2 middle(17.2, 20.3);
            const CutMap cut(
                {{-3, 5, 2}, 40, 30, 12}, spacing,
                {{&mill, straightMotion(Vec3(middle - along * 60.0, -2), Vec3(middle + along * 60.0, -2))}});
            const double wider = 4 * std::tan(degrees * kTurn / 360);
            std::array<std::size_t, 2> count{};
            for (const Crease& crease : creasesOf(cut)) {
                const double beside = std::abs(glm::dot(crease.at - middle, across));
                const Vec2 inside = glm::min(crease.at - Vec2(-3, 5), Vec2(37, 35) - crease.at);
                if (std::min(inside.x, inside.y) < spacing)
                    continue; // what follows beyond the border is not known
                EXPECT_NEAR(beside, crease.high ? 3 + wider : 3,
                            2e-3 * spacing * std::tan(degrees * kTurn / 360) + kPlace)
                    << crease.at.x << ' ' << crease.at.y;
                EXPECT_NEAR(crease.z, crease.high ? 0 : -4, 2e-3 * spacing);
                ++count[crease.high ? 1 : 0];
            }
            for (const std::size_t ofSide : count)
                EXPECT_GT(ofSide, 60 / spacing);
        }
    }
}

/// The wall of a ball goes on below its rim, and has no crease at its floor.
TEST(TileRims, OfABallAreWhereItLeavesTheTop) {
    const Cutter ball = cutterOf("ball:d=8");
    const CutMap cut({{0, 0, 0}, 40, 30, 12}, 0.3,
                     {{&ball, straightMotion({-10, 15.1, -3.5}, {60, 15.1, -3.5})}});
    std::size_t high = 0;
    for (const Crease& crease : creasesOf(cut)) {
        if (!crease.high)
            continue;
        EXPECT_NEAR(std::abs(crease.at.y - 15.1), std::sqrt(16 - 0.25), 1e-4);
        EXPECT_FLOAT_EQ(static_cast<float>(crease.z), 0);
        ++high;
    }
    EXPECT_EQ(high, 2U * static_cast<std::size_t>(cut.map.grid().nx));
}

/// Two cuts beside each other at different depths: the wall between them, and the step in the outer walls.
TEST(TileRims, OfAStepAreBetweenItsFloors) {
    const Cutter mill = cutterOf("flat:d=8");
    const CutMap cut({{0, 0, 0}, 40, 30, 12}, 0.7,
                     {{&mill, straightMotion({-10, 10.1, -3}, {60, 10.1, -3})},
                      {&mill, straightMotion({-10, 15.1, -5}, {60, 15.1, -5})}});
    int steps = 0;
    for (const Wall& wall : wallsOf(cut)) {
        const bool step = std::abs(wall.at.y - 11.1) < kPlace;
        EXPECT_TRUE(step || std::abs(wall.at.y - 6.1) < kPlace || std::abs(wall.at.y - 19.1) < kPlace);
        EXPECT_NEAR(wall.top, step ? -3 : 0, 1e-6);
        EXPECT_NEAR(wall.bottom, wall.at.y < 11 ? -3 : -5, 1e-6);
        steps += step ? 1 : 0;
    }
    EXPECT_EQ(steps, cut.map.grid().nx);
}

/// The edges between a point that was cut and one that was not.
template<class IsCut>
std::size_t edgesAcross(const Grid& grid, const IsCut& isCut) {
    std::size_t count = 0;
    const auto cutAt = [&](int i, int j) { return isCut(Vec2(grid.x(i), grid.y(j))); };
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            count += i + 1 < grid.nx && cutAt(i, j) != cutAt(i + 1, j) ? 1 : 0;
            count += j + 1 < grid.ny && cutAt(i, j) != cutAt(i, j + 1) ? 1 : 0;
        }
    return count;
}

/// A ring with a boss of radius 10 within a pocket of radius 16, into which a helix leads.
void expectRing(const Vec3& centre, double widening, const char* spec = "flat:d=6") {
    const Cutter mill = cutterOf(spec);
    const auto turn = [&](double height) {
        const Vec3 from = centre + Vec3(0, 0, height);
        return CutterMotion{&mill, arcMotion(Plane::xy, from, 13, 0.3, kTurn, -height, 13 + widening)};
    };
    const CutMap cut({{0, 0, 0}, 42, 33, 12}, 0.5, {turn(0), turn(3)});
    const std::vector<Wall> walls = wallsOf(cut);
    EXPECT_EQ(walls.size(), edgesAcross(cut.map.grid(), [&](const Vec2& place) {
                  return std::abs(glm::distance(place, Vec2(centre)) - 13) < 3 + 1e-8;
              }));
    for (const Wall& wall : walls) {
        const Vec2 off = wall.at - Vec2(centre);
        const bool boss = glm::length(off) < 13;
        EXPECT_NEAR(glm::length(off), boss ? 10 : 16, kPlace);
        const Vec2 outwards = off / glm::length(off) * (boss ? -1.0 : 1.0);
        EXPECT_NEAR(glm::distance(wall.normal, outwards), 0, kNormal);
        EXPECT_NEAR(wall.top, 0, 1e-6);
        EXPECT_NEAR(wall.bottom, -4 + mill.rimHeight(), 1e-3);
    }
}

TEST(TileRims, OfAPocketAndABossByArcsAreOnTheirCircles) {
    expectRing({20.03, 15.01, -4}, 0);
    expectRing({20.03, 15.01, -4}, 1e-6); // a spiral, which has no closed form
    expectRing({20.03, 15.01, -4}, 0, "ball:d=6");
}

/// Points of the grid are on the circles, and rows of it touch them.
TEST(TileRims, OfAPocketAtPointsOfTheGridAreOnItsCircles) {
    expectRing({20, 16, -4}, 0);
    expectRing({20.5, 16.5, -4}, 0);
}

/// A rib narrower than a cell stands between two slots: the plateau is one point wide.
TEST(TileRims, OfANarrowRibAreOnBothSides) {
    const Cutter mill = cutterOf("flat:d=6");
    const CutMap cut({{0, 0, 0}, 40, 30, 12}, 0.5,
                     {{&mill, straightMotion({-10, 11.85, -3}, {60, 11.85, -3})},
                      {&mill, straightMotion({-10, 18.3, -3}, {60, 18.3, -3})}});
    for (const double side : {14.85, 15.3}) {
        const auto walls = wallsOf(cut);
        EXPECT_EQ(std::ranges::count_if(
                      walls, [&](const Wall& wall) { return std::abs(wall.at.y - side) < kPlace; }),
                  cut.map.grid().nx);
    }
}

TEST(TileRims, OfARoundStockAreOnItsCircle) {
    const auto body = extrudedStock({circleOutline(30)}, 10).value();
    const StockBox stock{{-15, -15, 3}, 30, 30, 10};
    ZMap zmap = body->uncut(stock, makeGrid(stock, 0.45).value()).zmap;
    const std::unique_ptr<StockTop> top = body->top(stock);
    const std::vector<Wall> walls = wallsOf(CutMap(std::move(zmap), {}), top.get());
    EXPECT_GT(walls.size(), 200);
    for (const Wall& wall : walls) {
        const double radius = glm::length(wall.at);
        EXPECT_NEAR(radius, 15, kPlace);
        EXPECT_NEAR(glm::distance(wall.normal, -wall.at / radius), 0, kNormal);
        EXPECT_NEAR(wall.top, 0, 1e-6);
        EXPECT_NEAR(wall.bottom, -10, 1e-6);
    }
}

TEST(TileRims, OfASlotThroughARoundStockAreOnBoth) {
    const auto body = extrudedStock({circleOutline(30)}, 10).value();
    const StockBox stock{{-15, -15, 3}, 30, 30, 10};
    ZMap zmap = body->uncut(stock, makeGrid(stock, 0.45).value()).zmap;
    const Cutter mill = cutterOf("flat:d=8");
    const CutMap cut(std::move(zmap), {{&mill, straightMotion({-30, 0.1, 0}, {30, 0.1, 0})}});
    int onSlot = 0;
    for (const Wall& wall : wallsOf(cut, body->top(stock).get())) {
        const bool outline = std::abs(glm::length(wall.at) - 15) < kPlace;
        const double beside = std::abs(wall.at.y - 0.1);
        EXPECT_TRUE(outline || std::abs(beside - 4) < kPlace);
        onSlot += outline ? 0 : 1;
        EXPECT_NEAR(wall.top, outline && beside < 4 ? -3 : 0, 1e-6);
        EXPECT_NEAR(wall.bottom, outline ? -10 : -3, 1e-6);
    }
    EXPECT_GT(onSlot, 100);
}

TEST(TileRims, AreNoneOfAFinishedSurface) {
    const Cutter ball = cutterOf("ball:d=6");
    const StockBox stock{{0, 0, 0}, 30, 20, 12};
    const auto waves = [](double x, double y) { return -5 + 1.5 * std::sin(x / 3) * std::cos(y / 4); };
    std::vector<CutterMotion> motions;
    for (double y = -4; y < 24; y += 0.3)
        for (double x = -4; x < 34; x += 0.5)
            motions.push_back({&ball, straightMotion({x, y, waves(x, y)}, {x + 0.5, y, waves(x + 0.5, y)})});
    EXPECT_TRUE(wallsOf(CutMap(stock, 0.2, motions)).empty());
}

const StockBox kStock{{-3, 5, 2}, 24, 18, 30};

/// Some motions of random cutters on a random grid.
struct RandomCase {
    std::vector<Cutter> cutters;
    std::vector<OraclePath> paths;
    std::vector<CutterMotion> motions;
    double spacing;

    RandomCase(Random& random, const std::string& shape, const MotionRow& first, unsigned count)
        : spacing(uniform(random, 0.3, 2)) {
        cutters.reserve(count);
        for (unsigned k = 0; k < count; ++k) {
            const MotionRow& row = k == 0 ? first : motionRows()[random() % motionRows().size()];
            cutters.push_back(randomCutter(random, shape));
            const Motion motion = row.make(random, kStock);
            paths.emplace_back(motion, row.samples);
            motions.push_back({&cutters.back(), motion});
        }
    }

    [[nodiscard]] double height(const Vec2& place) const {
        double lowest = 0;
        for (std::size_t k = 0; k < motions.size(); ++k) {
            const double z = oracleEnvelope(cutters[k], paths[k], place.x, place.y).z - kStock.topZ();
            lowest = std::min(lowest, z);
        }
        return std::max(lowest, -kStock.height);
    }

    [[nodiscard]] std::string text() const {
        std::string text = fmt::format("spacing {}", spacing);
        for (std::size_t k = 0; k < motions.size(); ++k)
            text += "\n  " + reported(cutters[k], motions[k].motion);
        return text;
    }
};

/// An edge that is much steeper than the one before it, by the definition of a rim.
struct SteepEdge {
    std::uint16_t index; ///< of its tile
    bool reversed;
    Vec2 high;
    Vec2 low;
    double length;
    double line;      ///< below the plateau, at the high end
    double lineAtLow; ///< at the low end

    [[nodiscard]] Vec2 at(double part) const { return high + (low - high) * part; }
    [[nodiscard]] double lineAt(double part) const { return line + (lineAtLow - line) * part; }
};

double heightAt(const ZMapSnapshot& map, int i, int j) {
    const Grid& grid = map.grid();
    return double{map.height(std::clamp(i, 0, grid.nx - 1), std::clamp(j, 0, grid.ny - 1))};
}

/// By how much an edge, seen from one of its ends, exceeds the limit.
std::optional<SteepEdge> steepEdge(const ZMapSnapshot& map, int i, int j, bool alongY, bool reversed,
                                   double limit) {
    const Grid& grid = map.grid();
    const auto point = [&](int k) { // 0 high, 1 low
        const int steps = reversed ? 1 - k : k;
        return std::array{i + (alongY ? 0 : steps), j + (alongY ? steps : 0)};
    };
    const auto height = [&](int k) { return heightAt(map, point(k)[0], point(k)[1]); };
    const auto place = [&](int k) { return Vec2(grid.x(point(k)[0]), grid.y(point(k)[1])); };
    const double length = alongY ? grid.hy : grid.hx;
    const auto [previousI, previousJ] = point(-1);
    const bool outside = previousI < 0 || previousI >= grid.nx || previousJ < 0 || previousJ >= grid.ny;
    const double before = outside ? height(1) - height(2) : height(-1) - height(0);
    const double fall = height(0) - height(1);
    if (!(fall - std::max(0.0, before) > limit * length))
        return std::nullopt;
    SteepEdge edge{RimEdge{i % 64, j % 64, alongY}.index(), reversed, place(0), place(1), length, 0, 0};
    edge.line = height(0) - kStep / 4 * length;
    edge.lineAtLow = edge.line - std::max(before, 0.0);
    return edge;
}

std::vector<SteepEdge> steepEdges(const ZMapSnapshot& map, double limit) {
    std::vector<SteepEdge> edges;
    for (int j = 0; j < map.grid().ny; ++j)
        for (int i = 0; i < map.grid().nx; ++i)
            for (const bool alongY : {false, true})
                for (const bool reversed : {false, true})
                    if ((alongY ? j + 1 < map.grid().ny : i + 1 < map.grid().nx))
                        if (const auto edge = steepEdge(map, i, j, alongY, reversed, limit))
                            edges.push_back(*edge);
    return edges;
}

/// Where the oracle's surface first falls below the line, as a part of the edge, known to be not below at
/// `lo` and below at `hi`.
double oracleFall(const RandomCase& random, const SteepEdge& edge, double lo, double hi) {
    while (hi - lo > 1e-9) {
        const double middle = (lo + hi) / 2;
        (random.height(edge.at(middle)) < edge.lineAt(middle) ? hi : lo) = middle;
    }
    return lo;
}

/// Heights beside a wall, and what they may differ by: a surface may be vertical beside it.
struct Beside {
    double height;
    double tolerance;
};
Beside oracleBeside(const RandomCase& random, const SteepEdge& edge, double wall, double aside) {
    const auto height = [&](double times) { return random.height(edge.at(wall + aside * times)); };
    return {height(1), 1e-3 + 2 * std::abs(height(0.25) - height(4))};
}

constexpr double kAside = 2e-8; ///< mm

/// The direction from the low to the high side by the oracle, from the places where the wall crosses lines on
/// both sides of the edge; nothing where it bends or is too steep to the edge.
std::optional<Vec2> oracleNormal(const RandomCase& random, const SteepEdge& edge, double wall) {
    constexpr double kBeside = 1e-3; // mm
    const Vec2 along = (edge.low - edge.high) / edge.length;
    const Vec2 aside(-along.y, along.x);
    const double around = 4 * kBeside / edge.length;
    std::array<double, 2> places{};
    for (const int side : {0, 1}) {
        SteepEdge beside = edge;
        const Vec2 step = aside * (side == 0 ? -kBeside : kBeside);
        beside.high += step;
        beside.low += step;
        const auto below = [&](double part) { return random.height(beside.at(part)) < beside.lineAt(part); };
        if (below(wall - around) || !below(wall + around))
            return std::nullopt;
        places[static_cast<std::size_t>(side)] =
            (oracleFall(random, beside, wall - around, wall + around) - wall) * edge.length;
    }
    if (std::abs(places[0] + places[1]) > 0.01 * kBeside)
        return std::nullopt;
    const Vec2 line = along * (places[1] - places[0]) + aside * (2 * kBeside);
    return Vec2(-line.y, line.x) / glm::length(line);
}

void expectRim(const RandomCase& random, const SteepEdge& edge, const Rim& rim) {
    const double place = edge.reversed ? 1 - rim.fraction(true) : rim.fraction(true);
    constexpr double kNear = 1e-3;
    const auto below = [&](double part) { return random.height(edge.at(part)) < edge.lineAt(part) + 1e-6; };
    const double before = place - kNear;
    for (int k = 0; k < 16 && before > 0; ++k) {
        const double part = before * (1 - k / 16.0);
        ASSERT_GE(random.height(edge.at(part)), edge.lineAt(part) - 1e-3)
            << "at " << part << " before " << place;
    }
    // It may be below for less than that.
    const double after = place + kNear < 1 && !below(place + kNear) ? place + kNear / 50 : place + kNear;
    ASSERT_TRUE(after >= 1 || below(after)) << place;
    if (before < 0 || after > 1)
        return;
    const double wall = oracleFall(random, edge, before, after);
    EXPECT_NEAR(place, wall, 1.0 / 20000);
    const double aside = kAside / edge.length;
    const Beside top = oracleBeside(random, edge, wall, -aside);
    EXPECT_NEAR(double{rim.top}, top.height, top.tolerance);
    const Beside bottom = oracleBeside(random, edge, wall, aside);
    EXPECT_NEAR(double{rim.bottom}, bottom.height, bottom.tolerance);
    if (const auto normal = oracleNormal(random, edge, wall)) {
        EXPECT_LT(glm::distance(*normal, rim.normal()), 0.02) << normal->x << ' ' << normal->y;
    }
}

void expectNoRim(const RandomCase& random, const SteepEdge& edge) {
    constexpr int kSamples = 24;
    for (int k = 1; k <= kSamples; ++k) {
        const double part = static_cast<double>(k) / kSamples;
        if (random.height(edge.at(part)) >= edge.lineAt(part))
            continue;
        const double wall = oracleFall(random, edge, part - 1.0 / kSamples, part);
        const double aside = kAside / edge.length;
        const double jump = random.height(edge.at(wall - aside)) - random.height(edge.at(wall + aside));
        EXPECT_LT(jump, 1.01 * kStep / 2 * edge.length) << "at " << wall;
        return;
    }
}

/// Returns the number of rims that were compared.
int compare(Random& random, const RandomCase& made, int edgesEach) {
    const CutMap cut(kStock, made.spacing, made.motions);
    std::vector<RimTilePtr> tiles;
    for (std::size_t tile = 0; tile < cut.map.tileCount(); ++tile)
        tiles.push_back(cut.rims(tile));
    // Rounding decides which edges exceed the limit exactly.
    std::vector<SteepEdge> edges = steepEdges(cut.map, kStep + 1e-5);
    std::size_t rims = 0;
    for (const RimTilePtr& tile : tiles)
        rims += tile == nullptr ? 0 : tile->rims.size();
    EXPECT_LE(rims, steepEdges(cut.map, kStep - 1e-5).size());
    std::shuffle(edges.begin(), edges.end(), random);
    edges.resize(std::min(edges.size(), static_cast<std::size_t>(edgesEach)));
    int compared = 0;
    for (const SteepEdge& edge : edges) {
        const Grid& grid = cut.map.grid();
        const Vec2 first = edge.reversed ? edge.low : edge.high;
        const auto i = static_cast<int>(std::lround((first.x - grid.x0) / grid.hx)) / Tile::kSize;
        const auto j = static_cast<int>(std::lround((first.y - grid.y0) / grid.hy)) / Tile::kSize;
        const RimTilePtr& tile = tiles[static_cast<std::size_t>(j * cut.map.tilesX() + i)];
        const Rim* rim = nullptr;
        if (tile != nullptr)
            if (const auto at = std::ranges::find(tile->rims, edge.index, &Rim::edge); at != tile->rims.end())
                rim = &*at;
        SCOPED_TRACE(fmt::format("edge {},{} to {},{} line {} {} rim {}", edge.high.x, edge.high.y,
                                 edge.low.x, edge.low.y, edge.line, edge.lineAtLow, rim != nullptr));
        if (rim != nullptr)
            expectRim(made, edge, *rim);
        else
            expectNoRim(made, edge);
        compared += rim != nullptr ? 1 : 0;
    }
    return compared;
}

int casesOf(int all) {
    const char* chosen = std::getenv("PROVEOUT_MOTIONS");
    return chosen == nullptr ? roundsOf(all) : std::stoi(chosen);
}

TEST(TileRims, AgreeWithTheOracle) {
    const std::uint32_t first = randomSeed();
    int compared = 0;
    for (const CutterShape& shape : cutterShapes())
        for (const MotionRow& row : motionRows())
            for (int k = 0; k < casesOf(1); ++k) {
                const std::uint32_t seed = first + static_cast<std::uint32_t>(k);
                Random random(seed);
                const RandomCase made(random, std::string(shape.key), row, 1);
                SCOPED_TRACE(fmt::format("seed {} {} {} {}", seed, shape.key, row.name, made.text()));
                compared += compare(random, made, 2);
            }
    EXPECT_GT(compared, 50);
}

TEST(TileRims, OfSeveralMotionsAgreeWithTheOracle) {
    const std::uint32_t first = randomSeed();
    int compared = 0;
    for (const MotionRow& row : motionRows())
        for (int k = 0; k < casesOf(2); ++k) {
            const std::uint32_t seed = first + static_cast<std::uint32_t>(k);
            Random random(seed);
            const auto shapes = cutterShapes();
            const std::string shape(shapes[random() % shapes.size()].key);
            const RandomCase made(random, shape, row, 2 + static_cast<unsigned>(random() % 4));
            SCOPED_TRACE(fmt::format("seed {} {} {}", seed, row.name, made.text()));
            compared += compare(random, made, 3);
        }
    EXPECT_GT(compared, 10);
}

bool sameRims(const RimTilePtr& a, const RimTilePtr& b) {
    return a == nullptr || b == nullptr ? a == b : *a == *b;
}

TEST(TileRims, DoNotDependOnTheOrderOfMotionsNorOnThoseFarAway) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Random random(seed);
    const auto shapes = cutterShapes();
    for (int k = 0; k < roundsOf(4); ++k) {
        const std::string shape(shapes[random() % shapes.size()].key);
        const RandomCase made(random, shape, motionRows()[random() % motionRows().size()], 5);
        CutMap cut(kStock, made.spacing / 5, made.motions);
        // The same walls at other depths, as of a pocket cut in steps.
        for (const CutterMotion& motion : made.motions) {
            cut.motions.push_back(motion);
            for (Vec3 Motion::*place : {&Motion::start, &Motion::end, &Motion::centre})
                (cut.motions.back().motion.*place).z += 0.5;
        }
        for (std::size_t tile = 0; tile < cut.map.tileCount(); ++tile) {
            const RimTilePtr rims = cut.rims(tile);
            std::vector<CutterMotion> others = cut.motions;
            std::shuffle(others.begin(), others.end(), random);
            EXPECT_TRUE(sameRims(rims, rimsOfTile(cut.map, tile, nullptr, others)));
            const IndexRect rect = cut.map.tileRect(tile);
            const Grid& grid = cut.map.grid();
            std::erase_if(others, [&](const CutterMotion& motion) {
                const Box3 box = bounds(motion.motion);
                const double reach = motion.cutter->radius() + 1e-3;
                return box.lo.x - reach > grid.x(rect.i1) || box.hi.x + reach < grid.x(rect.i0) ||
                       box.lo.y - reach > grid.y(rect.j1) || box.hi.y + reach < grid.y(rect.j0);
            });
            EXPECT_TRUE(sameRims(rims, rimsOfTile(cut.map, tile, nullptr, others)));
        }
    }
}

TEST(TileRims, AreNoneAfterAStop) {
    const Cutter mill = cutterOf("flat:d=6");
    const CutMap cut({{0, 0, 0}, 40, 30, 12}, 0.5, {{&mill, straightMotion({5, 5, -2}, {35, 25, -2})}});
    std::stop_source stopped;
    stopped.request_stop();
    EXPECT_NE(rimsOfTile(cut.map, 0, nullptr, cut.motions), nullptr);
    EXPECT_EQ(rimsOfTile(cut.map, 0, nullptr, cut.motions, stopped.get_token()), nullptr);
}

} // namespace
} // namespace proveout
