// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/solid_error.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "core/decimation/regions/error_measure.h"
#include "core/decimation/surface/surface.h"
#include "tests/core/decimation/maps.h"
#include "tests/core/decimation/random_triangulation.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr float kFloor = -100; // of zmapOf()

/// The same heights on a stock whose upper corner at min X and min Y is elsewhere.
ZMapSnapshot movedTo(const Vec3& corner, const ZMapSnapshot& zmap) {
    StockBox stock = zmap.stock();
    stock.corner = corner;
    Grid grid = zmap.grid();
    grid.x0 = corner.x;
    grid.y0 = corner.y;
    ZMap moved(stock, grid);
    for (std::size_t t = 0; t < zmap.tileCount(); ++t)
        moved.adoptTile(t, std::make_shared<Tile>(*zmap.tile(t)));
    return moved.snapshot();
}

Vec3 inFloat(const Vec3& point) {
    const volatile float x = static_cast<float>(point.x);
    const volatile float y = static_cast<float>(point.y);
    const volatile float z = static_cast<float>(point.z);
    return {x, y, z};
}

/// Each point against each triangle, in long double, without any tolerance at edges: a point is measured at
/// the triangle that contains it best.
double bruteForce(const ZMapSnapshot& zmap, TriangleMesh solid) {
    using Real = long double;
    const Grid& grid = zmap.grid();
    for (Vec3& vertex : solid.vertices)
        vertex = inFloat(vertex);
    const Vec3 low = inFloat({grid.x(0), grid.y(0), 0});
    const Vec3 high = inFloat({grid.x(grid.nx - 1), grid.y(grid.ny - 1), 0});
    Real largest = 0;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            const Real x = std::clamp(grid.x(i), low.x, high.x);
            const Real y = std::clamp(grid.y(j), low.y, high.y);
            Real surface = zmap.stock().topZ() + static_cast<double>(zmap.floor());
            Real best = -1e-12L;
            for (const auto& triangle : solid.triangles) {
                std::array<Real, 3> weight{};
                for (std::size_t k = 0; k < 3; ++k) {
                    const Vec3& a = solid.vertices[triangle[(k + 1) % 3]];
                    const Vec3& b = solid.vertices[triangle[(k + 2) % 3]];
                    weight[k] = (a.x - x) * (b.y - y) - (a.y - y) * (b.x - x);
                }
                const Real area = weight[0] + weight[1] + weight[2];
                const Real inside = *std::ranges::min_element(weight) / area;
                if (area <= 0 || inside < best)
                    continue;
                best = inside;
                surface = 0;
                for (std::size_t k = 0; k < 3; ++k)
                    surface += weight[k] / area * Real(solid.vertices[triangle[k]].z);
            }
            const Real height = zmap.stock().topZ() + static_cast<double>(zmap.height(i, j));
            largest = std::max(largest, std::abs(surface - height));
        }
    return static_cast<double>(largest);
}

TEST(SolidError, ofAFullMeshInDoubleIsZero) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (const unsigned percentOnFloor : {0U, 30U}) {
        test::Heights heights(33 * 21);
        for (float& height : heights)
            height = random() % 100 < percentOnFloor ? kFloor : -static_cast<float>(random() % 1000) / 31;
        const ZMapSnapshot zmap = movedTo({-1000.03, 77.7, 33.3}, test::zmapOf(33, 21, 0.1, heights));
        const TriangleMesh solid = closeSolid(zmap, test::fullTriangulation(33, 21));
        EXPECT_EQ(measureSolidError(zmap, solid, CoordinateType::float64, ErrorLevel::sample), 0)
            << percentOnFloor;
    }
}

TEST(SolidError, inDoubleIsThatOfTheSurface) {
    for (const char* name : {"terrain", "spheres", "walls", "noise"}) {
        const ZMapSnapshot zmap = test::zmapOf(70, 55, 0.5, test::mapKind(name).make(70, 55, 0.5, 3));
        DecimationParameters parameters;
        parameters.regionCells = 30;
        parameters.allowance = 0.2;
        parameters.certify = false;
        Surface surface(70, 55, parameters);
        surface.decimateDirty(zmap);
        const auto triangles = surface.snapshot().triangles();
        const double wanted = measureVerticalError(zmap, {0, 0, 70, 55}, triangles, 0).largest;
        EXPECT_NEAR(
            measureSolidError(zmap, closeSolid(zmap, triangles), CoordinateType::float64, ErrorLevel::sample),
            wanted, 1e-9)
            << name;
    }
}

TEST(SolidError, ofRoundedCoordinatesAgreesWithBruteForce) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto anywhere = [&random](double size) {
        return std::uniform_real_distribution<double>(-size, size)(random);
    };
    for (int round = 0; round < 60; ++round) {
        SCOPED_TRACE(round);
        const int nx = 2 + static_cast<int>(random() % 20);
        const int ny = 2 + static_cast<int>(random() % (round % 4 == 0 ? 70 : 20)); // also several bands
        test::Heights heights;
        for (int v = 0; v < nx * ny; ++v)
            heights.push_back(-static_cast<float>(random() % 100'000) / 1024);
        const double far = round % 3 == 0 ? 100 : 5000;
        const ZMapSnapshot zmap =
            movedTo({anywhere(far), anywhere(far), anywhere(far)}, test::zmapOf(nx, ny, 0.11, heights));
        const TriangleMesh solid =
            closeSolid(zmap, test::randomTriangulation(nx, ny, random() % 300, random));
        // Rounding may put a point on an edge on either side of it; with triangles as steep as these, that
        // changes the result by 1e-6 mm.
        EXPECT_NEAR(measureSolidError(zmap, solid, CoordinateType::float32, ErrorLevel::sample),
                    bruteForce(zmap, solid), 1e-6);
    }
}

/// A ramp along x far from the origin: its points stay, its vertices move to the nearest float32.
TEST(SolidError, growsWithTheDistanceFromTheOrigin) {
    constexpr double kSlope = 50;
    for (const double far : {100.0, 3000.0, 40000.0}) {
        test::Heights heights;
        for (int v = 0; v < 9 * 5; ++v)
            heights.push_back(static_cast<float>(-90 + kSlope * 0.125 * (v % 9)));
        const ZMapSnapshot zmap = movedTo({far + 0.013, 0, 0}, test::zmapOf(9, 5, 0.125, heights));
        const TriangleMesh solid = closeSolid(zmap, test::fullTriangulation(9, 5));
        double moved = 0;
        for (int i = 1; i < 8; ++i) // the ends are measured against the rounded outline
            moved = std::max(moved, std::abs(inFloat({zmap.grid().x(i), 0, 0}).x - zmap.grid().x(i)));
        const double error = measureSolidError(zmap, solid, CoordinateType::float32, ErrorLevel::sample);
        EXPECT_NEAR(error, kSlope * moved, 0.03 * kSlope * moved) << far;
    }
}

TEST(SolidError, whereNothingIsTheFloorIsTheTop) {
    test::Heights heights(25, -1.0F);
    const ZMapSnapshot zmap = test::zmapOf(5, 5, 1, heights);
    TriangleMesh solid = closeSolid(zmap, test::fullTriangulation(5, 5));
    EXPECT_EQ(measureSolidError(zmap, solid, CoordinateType::float32, ErrorLevel::sample), 0);
    std::erase_if(solid.triangles, [&solid](const auto& triangle) {
        return std::ranges::all_of(triangle, [&solid](std::uint32_t v) { return solid.vertices[v].x < 1.5; });
    });
    EXPECT_EQ(measureSolidError(zmap, solid, CoordinateType::float32, ErrorLevel::sample), 99);
}

TEST(SolidError, canBeStopped) {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1); // so all progress is seen
    const ZMapSnapshot zmap = test::zmapOf(150, 150, 1, test::mapKind("noise").make(150, 150, 1, 1));
    const TriangleMesh solid = closeSolid(zmap, test::fullTriangulation(150, 150));
    std::stop_source stop;
    std::vector<double> reported;
    WorkContext context;
    context.stop = stop.get_token();
    context.progress = [&](double done) {
        reported.push_back(done);
        if (done > 0.3)
            stop.request_stop();
    };
    static_cast<void>(measureSolidError(zmap, solid, CoordinateType::float32, ErrorLevel::sample, context));
    EXPECT_TRUE(std::ranges::is_sorted(reported));
    EXPECT_LT(reported.back(), 0.6);
}

} // namespace
} // namespace proveout
