// SPDX-License-Identifier: GPL-3.0-or-later
// Ribs between the points of a map, compared with dense samples of the oracle on every edge.
#include "core/cutting/cut/unseen_ribs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "tests/core/cutting/oracle.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kFloor = -2;
constexpr double kDeeper = -3.5;
const StockBox kStock{{0, 0, 10}, 24, 20, 10};

/// The motions of one cutter in a box, and its map.
struct Floors {
    Cutter cutter;
    double radius;
    double corner;
    std::vector<Motion> paths;
    double spacing = 1;
    std::vector<CutterMotion> motions = {};
    ZMapSnapshot map = {};

    /// The height of the cutter above its tip, from the formula of a bull-nose.
    [[nodiscard]] double profile(double distance) const {
        const double out = distance - (radius - corner);
        if (out > corner)
            return std::numeric_limits<double>::infinity();
        return out <= 0 ? 0 : corner - std::sqrt(corner * corner - out * out);
    }

    void cutAll() {
        motions.clear();
        for (const Motion& path : paths)
            motions.push_back({&cutter, path});
        ZMap zmap(kStock, makeGrid(kStock, spacing).value());
        EXPECT_TRUE(cutHeights(zmap, motions, {}));
        map = zmap.snapshot();
    }
};

struct Edge {
    int i;
    int j;
    bool alongY;
    friend auto operator<=>(const Edge&, const Edge&) = default;
};

std::vector<Edge> found(const Floors& floors) {
    std::vector<Edge> edges;
    for (std::size_t tile = 0; tile < floors.map.tileCount(); ++tile) {
        UnseenRibs ribs(floors.map, tile);
        for (const CutterMotion& motion : floors.motions)
            ribs.add(motion);
        if (!ribs.suspects(nullptr))
            continue;
        for (const CutterMotion& motion : floors.motions)
            ribs.lower(motion);
        const IndexRect rect = floors.map.tileRect(tile);
        for (const std::uint16_t index : ribs.edges()) {
            const RimEdge edge = RimEdge::of(index);
            edges.push_back({rect.i0 + edge.i, rect.j0 + edge.j, edge.alongY});
        }
    }
    std::ranges::sort(edges);
    return edges;
}

/// The distance over ground from a path that is a line, or an arc about Z.
double distanceFrom(const Motion& path, const Vec2& place) {
    if (path.kind != MotionKind::arc) {
        const Vec2 way = Vec2(path.end) - Vec2(path.start);
        const Vec2 to = place - Vec2(path.start);
        const double part = std::clamp(glm::dot(to, way) / glm::dot(way, way), 0.0, 1.0);
        return glm::length(to - part * way);
    }
    const Vec2 from = Vec2(path.start) - Vec2(path.centre);
    const Vec2 to = place - Vec2(path.centre);
    double turned = std::atan2(to.y, to.x) - std::atan2(from.y, from.x);
    const double direction = path.sweep < 0 ? -1 : 1;
    for (turned *= direction; turned < 0;)
        turned += kTurn;
    const bool isBeside = std::fmod(turned, kTurn) <= std::abs(path.sweep);
    return isBeside ? std::abs(glm::length(to) - glm::length(from))
                    : std::min(glm::distance(place, Vec2(path.start)), glm::distance(place, Vec2(path.end)));
}

/// By dense samples of each edge.
class Oracle {
public:
    explicit Oracle(const Floors& floors) : m_floors(floors) {}

    /// The part of an edge between level floors that a rib covers; 0 if its ends are not on such floors.
    [[nodiscard]] double ribOn(const Edge& edge) const {
        const int toI = edge.i + (edge.alongY ? 0 : 1);
        const int toJ = edge.j + (edge.alongY ? 1 : 0);
        if (!isOnFloor(edge.i, edge.j) || !isOnFloor(toI, toJ))
            return 0;
        const double higher = std::max(heightOf(edge.i, edge.j), heightOf(toI, toJ));
        constexpr int kPlaces = 400;
        const Grid& grid = m_floors.map.grid();
        int above = 0;
        for (int k = 1; k < kPlaces; ++k) {
            const double part = static_cast<double>(k) / kPlaces;
            const Vec2 place(grid.x(edge.i) + (edge.alongY ? 0 : part * grid.hx),
                             grid.y(edge.j) + (edge.alongY ? part * grid.hy : 0));
            above += heightAt(place) - higher > 0.125 * m_floors.spacing ? 1 : 0;
        }
        return static_cast<double>(above) / kPlaces;
    }

private:
    [[nodiscard]] double heightOf(int i, int j) const {
        return static_cast<double>(m_floors.map.height(i, j));
    }
    /// Whether a cell at the point is level, and cut.
    [[nodiscard]] bool isOnFloor(int i, int j) const {
        const Grid& grid = m_floors.map.grid();
        const auto isCell = [&](int x, int y) {
            if (x < 0 || y < 0 || x + 1 >= grid.nx || y + 1 >= grid.ny)
                return false;
            const std::array<double, 4> at{heightOf(x, y), heightOf(x + 1, y), heightOf(x, y + 1),
                                           heightOf(x + 1, y + 1)};
            const auto [low, high] = std::ranges::minmax(at);
            return high - low < 1e-4 && high < -1e-4;
        };
        return isCell(i, j) || isCell(i - 1, j) || isCell(i, j - 1) || isCell(i - 1, j - 1);
    }
    [[nodiscard]] double heightAt(const Vec2& place) const {
        double height = 0;
        for (const Motion& path : m_floors.paths) {
            if (path.start.z == path.end.z)
                height = std::min(height,
                                  path.start.z - kStock.topZ() + m_floors.profile(distanceFrom(path, place)));
            else // rare and few
                height = std::min(height,
                                  oracleEnvelope(m_floors.cutter, OraclePath(path, 400), place.x, place.y).z -
                                      kStock.topZ());
        }
        return height;
    }

    const Floors& m_floors;
};

/// Compares all edges; returns how many have ribs.
std::size_t compare(const Floors& floors) {
    const std::vector<Edge> ribs = found(floors);
    const Oracle oracle(floors);
    const Grid& grid = floors.map.grid();
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            for (const bool alongY : {false, true}) {
                const Edge edge{i, j, alongY};
                if (alongY ? j + 1 == grid.ny : i + 1 == grid.nx)
                    continue;
                const bool isFound = std::ranges::binary_search(ribs, edge);
                const double part = oracle.ribOn(edge);
                // Thinner than two samples, they may not see it.
                EXPECT_TRUE(isFound ? part > 0 || part < 0.01 : part < 0.01)
                    << i << " " << j << (alongY ? " along Y " : " along X ") << part << isFound;
            }
        }
    }
    return ribs.size();
}

double depth() {
    return kStock.topZ() + kFloor;
}

TEST(UnseenRibs, AreFoundBetweenPassesThatLeaveLessThanACell) {
    Floors floors{cutterOf("flat:d=4"), 2, 0, {}};
    // Beside rows of points at whole millimetres: 0.3 mm are left from y = 8.35 to 8.65, and nothing
    // at 12.65.
    for (const double y : {6.35, 10.65, 14.65})
        floors.paths.push_back(straightMotion({6.2, y, depth()}, {17.9, y, depth()}));
    floors.cutAll();
    compare(floors);
    const std::vector<Edge> ribs = found(floors);
    for (int i = 7; i <= 17; ++i) {
        EXPECT_TRUE(std::ranges::binary_search(ribs, Edge{i, 8, true})) << i;
        EXPECT_FALSE(std::ranges::binary_search(ribs, Edge{i, 12, true})) << i;
    }
}

TEST(UnseenRibs, ThatAnotherMotionHasCutAreNone) {
    Floors floors{cutterOf("flat:d=4"), 2, 0, {}};
    for (const double y : {6.35, 10.65})
        floors.paths.push_back(straightMotion({6.2, y, depth()}, {17.9, y, depth()}));
    floors.paths.push_back(straightMotion({2, 8.5, depth() + 0.5}, {21, 8.5, depth() - 1e-7}));
    floors.cutAll();
    const std::size_t left = compare(floors);
    EXPECT_GT(left, 0U); // where the ramp is high
    EXPECT_LT(left, 11U);
}

/// A ball that goes below the floor of the stock covers points there with more than its tip.
TEST(UnseenRibs, AreFoundBetweenSlotsThroughTheStock) {
    Floors floors{cutterOf("ball:d=4"), 2, 2, {}};
    for (const double y : {6.35, 10.65})
        floors.paths.push_back(straightMotion({6.2, y, -3}, {17.9, y, -3}));
    floors.cutAll();
    const std::vector<Edge> ribs = found(floors);
    for (int i = 7; i <= 17; ++i)
        EXPECT_TRUE(std::ranges::binary_search(ribs, Edge{i, 8, true})) << i;
}

TEST(UnseenRibs, ArePillarsInCirclesToo) {
    for (const double radius : {0.02, 0.1, 0.3}) {
        for (const double cutter : {3.0, 10.0}) {
            Floors floors{cutterOf("flat:d=" + std::to_string(2 * cutter)), cutter, 0, {}};
            floors.paths.push_back(
                arcMotion(Plane::xy, {12.5, 10, depth()}, cutter + radius, 0.3, kTurn, 0, cutter + radius));
            floors.cutAll();
            EXPECT_EQ(found(floors), (std::vector<Edge>{{12, 10, false}})) << radius << " " << cutter;
        }
    }
}

TEST(UnseenRibs, OfRandomPassesAreThoseOfTheOracle) {
    const std::uint32_t first = randomSeed();
    std::size_t all = 0;
    for (std::uint32_t round = 0; round < 24; ++round) {
        SCOPED_TRACE("seed " + std::to_string(first + round));
        Random random(first + round);
        Floors floors = round % 3 == 0 ? Floors{cutterOf("bull:d=5,r=0.5"), 2.5, 0.5, {}}
                                       : Floors{cutterOf("flat:d=3.3"), 1.65, 0, {}};
        floors.spacing = uniform(random, 0.3, 1.2);
        const auto depthOf = [&] { return kStock.topZ() + (random() % 3 == 0 ? kDeeper : kFloor); };
        const auto place = [&] { return Vec3(uniform(random, 0, 24), uniform(random, 0, 20), depthOf()); };
        for (int k = 0; k < 7; ++k) {
            const bool isArc = random() % 3 == 0;
            if (isArc) {
                const double radius = uniform(random, 0.5, 6);
                floors.paths.push_back(arcMotion(Plane::xy, place(), radius, uniform(random, 0, kTurn),
                                                 uniform(random, -kTurn, kTurn), 0, radius));
                continue;
            }
            const Vec3 from = place();
            Vec3 to = place();
            to.z = from.z;
            floors.paths.push_back(straightMotion(from, to));
            // One beside it, with little between them.
            const Vec3 along = glm::normalize(to - from);
            const double width = round % 3 == 0 ? 4 : 3.3;
            const Vec3 beside = Vec3(-along.y, along.x, 0) * (width + uniform(random, -0.2, 0.6));
            const Vec3 other(beside.x, beside.y, depthOf() - from.z);
            floors.paths.push_back(straightMotion(from + other, to + other));
        }
        floors.cutAll();
        all += compare(floors);
    }
    EXPECT_GT(all, 40U);
}

} // namespace
} // namespace proveout
