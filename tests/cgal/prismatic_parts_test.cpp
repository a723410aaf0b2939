// SPDX-License-Identifier: GPL-3.0-or-later
// Files of prismatic parts, as flat cutters leave them, against their exact shape: in one direction by closed
// formulas, in the other by CGAL.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "core/decimation/solid/solid.h"
#include "core/decimation/solid/solid_error.h"
#include "core/decimation/surface/refined_surface.h"
#include "tests/cgal/distance_oracle.h"
#include "tests/cgal/solid_oracle.h"
#include "tests/core/cutting/moment_with_walls.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/core/decimation/closed_mesh.h"
#include "tests/random_seed.h"

namespace proveout::test {
namespace {

constexpr double kDepth = 4;
constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kSpacing = 0.1;
constexpr double kNear = 0.01;    ///< mm, faces and vertices
constexpr double kCorner = 0.02;  ///< mm, where two walls meet sharply
constexpr double kFillet = 0.022; ///< mm, where a wall becomes round within a cell of 1 mm
constexpr double kCone = 0.013;   ///< mm, between points of 0.5 mm on a cone
const StockBox kStock{{0, 0, 0}, 30.03, 26.07, 8};
const Vec2 kMiddle(15.137, 12.911);

Vec2 towards(double degrees) {
    return {std::cos(degrees * kTurn / 360), std::sin(degrees * kTurn / 360)};
}

/// A level cut by a flat cutter: along a segment, or around a circle.
struct Cut {
    double radius; ///< of the cutter
    Vec2 from;     ///< or the centre of the circle
    Vec2 to;
    double around = 0; ///< the radius of the circle; 0: a segment
    double angle = 0;  ///< where it begins, and how far it leads
    double sweep = kTurn;

    [[nodiscard]] bool isCircle() const { return around > 0; }

    /// Of a place from the area that is cut; negative inside.
    [[nodiscard]] double distance(const Vec2& place) const {
        if (!isCircle()) {
            const Vec2 way = to - from;
            const double length2 = glm::dot(way, way);
            const double part = length2 > 0 ? std::clamp(glm::dot(place - from, way) / length2, 0.0, 1.0) : 0;
            return glm::distance(place, from + part * way) - radius;
        }
        const Vec2 out = place - from;
        double turn = std::atan2(out.y, out.x) - angle;
        turn -= kTurn * std::floor(turn / kTurn);
        const double ofPath = turn <= sweep
                                  ? std::abs(glm::length(out) - around)
                                  : std::min(glm::distance(place, end(0)), glm::distance(place, end(1)));
        return ofPath - radius;
    }

    [[nodiscard]] Motion motion() const {
        if (isCircle())
            return arcMotion(Plane::xy, Vec3(from, -kDepth), around, angle, sweep, 0, around);
        if (from == to) // a plunge
            return straightMotion(Vec3(from, 5), Vec3(to, -kDepth));
        return straightMotion(Vec3(from, -kDepth), Vec3(to, -kDepth));
    }

    /// Places all along the outline of the area.
    void addOutline(std::vector<Vec2>& outline, double wider = 0) const {
        const double reach = radius + wider;
        constexpr double kStep = 0.03; // mm
        const auto addArc = [&](const Vec2& centre, double r, double start, double turn) {
            const int steps = static_cast<int>(std::ceil(std::abs(turn) * r / kStep));
            for (int k = 0; k <= steps; ++k) {
                const double at = start + turn * k / steps;
                outline.push_back(centre + r * Vec2(std::cos(at), std::sin(at)));
            }
        };
        if (isCircle()) {
            for (const double r : {around - reach, around + reach}) {
                if (r > 0)
                    addArc(from, r, angle, sweep);
            }
            addArc(end(0), reach, 0, kTurn);
            addArc(end(1), reach, 0, kTurn);
            return;
        }
        addArc(from, reach, 0, kTurn);
        addArc(to, reach, 0, kTurn);
        const double length = glm::distance(from, to);
        const Vec2 along = length > 0 ? (to - from) / length : Vec2(1, 0);
        const Vec2 across = reach * Vec2(-along.y, along.x);
        for (double at = 0; at < length; at += kStep) {
            outline.push_back(from + at * along + across);
            outline.push_back(from + at * along - across);
        }
    }

private:
    [[nodiscard]] Vec2 end(int which) const {
        const double at = angle + which * sweep;
        return from + around * Vec2(std::cos(at), std::sin(at));
    }
};

struct Part {
    std::string name;
    std::vector<Cut> cuts;
    double allowed = kNear;
    double degrees = 0; ///< of the taper of the cutter
    double spacing = kSpacing;
    bool isCutThrough = false;

    [[nodiscard]] double distance(const Vec2& place) const {
        double least = std::numeric_limits<double>::infinity();
        for (const Cut& cut : cuts)
            least = std::min(least, cut.distance(place));
        return least;
    }
    /// At the top of the stock.
    [[nodiscard]] double wider() const { return kDepth * std::tan(degrees * kTurn / 360); }
    /// Of a point from the surface of the exact part; the outside of the stock is not looked at. Where two
    /// cuts meet, it may be too small: CGAL looks at these places from the other side.
    [[nodiscard]] double distance(const Vec3& point) const {
        // From the foot of the wall, across it and up.
        const Vec2 at(distance(Vec2(point)), point.z + kDepth);
        const Vec2 rim(wider(), kDepth);
        const double top = at.x >= rim.x ? std::abs(at.y - rim.y) : glm::distance(at, rim);
        const double floor = isCutThrough ? std::numeric_limits<double>::infinity()
                             : at.x <= 0  ? std::abs(at.y)
                                          : glm::length(at);
        const double part = std::clamp(glm::dot(at, rim) / glm::dot(rim, rim), 0.0, 1.0);
        return std::min({top, floor, glm::distance(at, part * rim)});
    }
};

Cut slot(double radius, double degrees, double half) {
    return {radius, kMiddle - half * towards(degrees), kMiddle + half * towards(degrees)};
}

Cut circle(double radius, double around, double degrees = 0, double sweep = 360) {
    return {radius, kMiddle, kMiddle, around, degrees * kTurn / 360, sweep * kTurn / 360};
}

Part rectangle(const std::string& name, double degrees) {
    constexpr double kHalfLength = 6.3;
    constexpr double kHalfWidth = 4.1;
    const Vec2 along = towards(degrees);
    const Vec2 across(-along.y, along.x);
    const auto at = [&](double x, double y) { return kMiddle + x * along + y * across; };
    Part part{name, {}};
    for (const double y : {-kHalfWidth, 0.0, kHalfWidth})
        part.cuts.push_back({3, at(-kHalfLength, y), at(kHalfLength, y)});
    for (const double x : {-kHalfLength, kHalfLength})
        part.cuts.push_back({3, at(x, -kHalfWidth), at(x, kHalfWidth)});
    return part;
}

std::vector<Part> parts() {
    return {
        {"slot at 17 degrees", {slot(3, 17, 60)}},
        {"slot at 45 degrees", {slot(3, 45, 60)}},
        {"short slot at 73 degrees", {slot(3, 73, 5.5)}},
        {"hole of 6", {slot(3, 0, 0)}},
        {"hole of 7.3", {slot(3.65, 0, 0)}},
        {"pocket of 20", {circle(3, 7), circle(3, 2.5)}},
        {"boss of 10", {circle(3, 8)}},
        {"groove around 200 degrees", {circle(1.5, 8, 31, 200)}},
        rectangle("rectangle along the axes", 0),
        rectangle("rectangle at 30 degrees", 30),
        {"crossing slots", {slot(2.5, 20, 60), slot(2.5, 107, 60)}, kCorner},
        {"keyhole", {slot(5, 0, 0), {2, kMiddle, kMiddle + 9.0 * towards(62)}}, kCorner},
        {"tapered slot at 17 degrees", {slot(3, 17, 60)}, kNear, 3},
        {"tapered slot at 45 degrees", {slot(3, 45, 60)}, kNear, 10},
        {"tapered hole", {slot(3, 0, 0)}, kNear, 3},
        {"tapered pocket", {circle(3, 7), circle(3, 2.5)}, kNear, 5},
        {"steeply tapered boss", {circle(3, 8)}, kNear, 1},
        {"slot through", {slot(3, 17, 60)}, kNear, 0, kSpacing, true},
        {"oblong hole through", {slot(3, 73, 5.5)}, kNear, 0, kSpacing, true},
        {"disc that is cut out", {circle(3, 8)}, kNear, 0, kSpacing, true},
        {"tapered hole through", {slot(3, 0, 0)}, kNear, 3, kSpacing, true},
        {"crossing slots through", {slot(2.5, 20, 60), slot(2.5, 107, 60)}, kCorner, 0, kSpacing, true},
        {"slot at 17 degrees, 0.5 mm", {slot(3, 17, 60)}, kNear, 0, 0.5},
        {"pocket of 20, 0.5 mm", {circle(3, 7), circle(3, 2.5)}, kNear, 0, 0.5},
        {"boss of 10, 0.5 mm", {circle(3, 8)}, kNear, 0, 0.5},
        {"rectangle, 0.5 mm", rectangle("", 30).cuts, kNear, 0, 0.5},
        {"tapered pocket, 0.5 mm", {circle(3, 7), circle(3, 2.5)}, kCone, 5, 0.5},
        {"slot at 17 degrees, 1 mm", {slot(3, 17, 60)}, kNear, 0, 1},
        {"pocket of 20, 1 mm", {circle(3, 7), circle(3, 2.5)}, kNear, 0, 1},
        {"boss of 10, 1 mm", {circle(3, 8)}, kNear, 0, 1},
        {"hole of 6, 1 mm", {slot(3, 0, 0)}, kNear, 0, 1},
        {"rectangle, 1 mm", rectangle("", 30).cuts, kFillet, 0, 1},
        {"tapered slot, 1 mm", {slot(3, 17, 60)}, kNear, 5, 1},
    };
}

/// The map of a part with its walls.
ZMapSnapshot cutOut(const Part& part) {
    std::vector<Cutter> mills;
    mills.reserve(part.cuts.size());
    std::vector<CutterMotion> motions;
    for (const Cut& cut : part.cuts) {
        const std::string size = std::to_string(2 * cut.radius);
        mills.push_back(cutterOf(part.degrees > 0
                                     ? "taper:d=" + size + ",angle=" + std::to_string(part.degrees) + ",h=20"
                                     : "flat:d=" + size));
        motions.push_back({&mills.back(), cut.motion()});
    }
    StockBox stock = kStock;
    if (part.isCutThrough)
        stock.height = kDepth;
    ZMap zmap(stock, makeGrid(stock, part.spacing).value());
    EXPECT_TRUE(cutHeights(zmap, motions, {}));
    return withWalls(zmap.snapshot(), motions);
}

/// Whether it is so far inside of the stock that points beside walls may move.
bool isInside(const Part& part, const Vec2& place) {
    const Vec2 in = glm::min(place - Vec2(kStock.corner),
                             Vec2(kStock.width, kStock.depth) - (place - Vec2(kStock.corner)));
    return std::min(in.x, in.y) > 2 * part.spacing;
}

/// The largest distance of vertices, middles of edges and centres of faces from the part.
double farthestOfFaces(const Part& part, const TriangleMesh& solid) {
    double farthest = 0;
    const double underside = part.isCutThrough ? -kDepth : -kStock.height;
    for (const auto& triangle : solid.triangles) {
        const Vec3& a = solid.vertices[triangle[0]];
        const Vec3& b = solid.vertices[triangle[1]];
        const Vec3& c = solid.vertices[triangle[2]];
        for (const Vec3& point : {a, b, c, (a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0, (a + b + c) / 3.0}) {
            if (isInside(part, Vec2(point)) && point.z > underside)
                farthest = std::max(farthest, part.distance(point));
        }
    }
    return farthest;
}

std::vector<Vec3> pointsOfWalls(const Part& part) {
    std::vector<Vec3> points;
    for (const double up : {0.0, 0.37, 1.0}) { // of the wall
        std::vector<Vec2> outline;
        for (const Cut& cut : part.cuts)
            cut.addOutline(outline, up * part.wider());
        for (const Vec2& place : outline) {
            constexpr double kRounding = 1e-9;
            if (part.distance(place) >= up * part.wider() - kRounding && isInside(part, place))
                points.emplace_back(place, (up - 1) * kDepth); // else another cut has taken it away
        }
    }
    return points;
}

TEST(PrismaticParts, AreInFilesAsTheyWereCut) {
    for (const Part& part : parts()) {
        SCOPED_TRACE(part.name);
        ZMapSnapshot moment = cutOut(part);
        DecimationParameters parameters;
        parameters.allowance = 0.01;
        SurfaceSnapshot surface = decimatedWhole(moment, parameters);
        const std::size_t walls = moment.walls().count();
        const auto solid =
            closeWithWalls(moment, surface.releaseTriangles(), parameters, CoordinateType::float32);
        ASSERT_TRUE(solid.has_value());
        EXPECT_EQ(moment.walls().count(), walls);
        EXPECT_EQ(whatIsWrong(solid->mesh), "");
        EXPECT_EQ(whatCgalFindsWrong(solid->mesh, Intersections::look), "");
        EXPECT_LE(farthestOfFaces(part, solid->mesh), part.allowed);
        EXPECT_LE(farthestFrom(solid->mesh, pointsOfWalls(part)), part.allowed);
    }
}

/// Slots, holes and arcs anywhere, also across the border of the stock: ribs and corners that the grid does
/// not resolve, and holes that touch each other.
Part randomPart(Random& random) {
    Part part{"random", {}};
    part.spacing = uniform(random, 0.15, 0.9);
    part.isCutThrough = random() % 3 != 0;
    part.degrees = random() % 3 == 0 ? uniform(random, 0.6, 30) : 0;
    const auto place = [&] { return Vec2(uniform(random, -3, 33), uniform(random, -3, 29)); };
    for (auto cuts = 1 + random() % 8; cuts > 0; --cuts) {
        Cut cut{uniform(random, 0.6, 4), place(), place()};
        if (random() % 3 == 0)
            cut.around = uniform(random, 1, 10);
        else if (random() % 3 == 0)
            cut.to = cut.from;
        cut.angle = uniform(random, 0, kTurn);
        cut.sweep = uniform(random, 0.2, kTurn);
        part.cuts.push_back(cut);
    }
    return part;
}

TEST(PrismaticParts, OfRandomCutsAreSound) {
    const std::uint32_t first = randomSeed();
    int walled = 0;
    const int rounds = roundsOf(60);
    for (int k = 0; k < rounds; ++k) {
        const std::uint32_t seed = first + static_cast<std::uint32_t>(k);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        ZMapSnapshot moment = cutOut(randomPart(random));
        DecimationParameters parameters;
        parameters.allowance = uniform(random, 0.002, 0.05);
        SurfaceSnapshot surface = decimatedWhole(moment, parameters);
        const auto solid =
            closeWithWalls(moment, surface.releaseTriangles(), parameters, CoordinateType::float32);
        if (!solid)
            continue;
        ++walled;
        EXPECT_EQ(whatIsWrong(solid->mesh), "");
        EXPECT_EQ(whatCgalFindsWrong(solid->mesh, Intersections::skip), "");
        EXPECT_LE(measureSolidError(moment, solid->mesh, CoordinateType::float32, ErrorLevel::surface),
                  parameters.allowance);
    }
    EXPECT_GT(walled, rounds * 9 / 10);
}

} // namespace
} // namespace proveout::test
