// SPDX-License-Identifier: GPL-3.0-or-later
// Large maps of machined parts and a large terrain: every z-map point is within the allowance of the
// certified surface. CGAL computes the Euclidean distance, which does not exceed the guaranteed vertical one.
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/decimation/surface/refined_surface.h"
#include "core/formats/npy.h"
#include "tests/cgal/distance_oracle.h"
#include "tests/core/decimation/maps.h"

namespace proveout::test {
namespace {

constexpr double kAllowance = 0.05;
constexpr double kRounding = 1e-9; // of CGAL's distances, in double, one kilometre from the origin
constexpr int kTerrain = 1000;     // points along a side

struct LargeMap {
    std::string name;
    double spacing; ///< mm
};

/// Empty if the file does not exist.
ZMapSnapshot sharedMap(const LargeMap& map) {
    const auto file = std::filesystem::path(PROVEOUT_SHARED_DIR) / "maps" / (map.name + ".npy");
    if (!std::filesystem::exists(file))
        return {};
    const NpyArray array = readNpy(file).value();
    Heights heights;
    heights.reserve(array.values.size());
    for (const double height : array.values)
        heights.push_back(static_cast<float>(height));
    return zmapOf(array.columns, array.rows, map.spacing, heights);
}

std::vector<Vec3> pointsOf(const ZMapSnapshot& zmap) {
    const Grid& grid = zmap.grid();
    std::vector<Vec3> points;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i)
            points.emplace_back(grid.x(i), grid.y(j), static_cast<double>(zmap.height(i, j)));
    return points;
}

/// A surface in mm, with the points that it uses.
TriangleMesh meshOf(const std::vector<Vec3>& points, const SurfaceSnapshot& surface) {
    TriangleMesh mesh;
    std::unordered_map<std::uint32_t, std::uint32_t> places;
    for (const LatticeTriangle& triangle : surface.triangles()) {
        auto& out = mesh.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [place, isNew] =
                places.try_emplace(triangle[k], static_cast<std::uint32_t>(mesh.vertices.size()));
            if (isNew)
                mesh.vertices.push_back(points[triangle[k]]);
            out[k] = place->second;
        }
    }
    return mesh;
}

/// As shown on the screen at rest: regions merged up to 1024 cells.
SurfaceSnapshot onScreen(const ZMapSnapshot& zmap, double allowance) {
    RefinedSurface surface(zmap.grid().nx, zmap.grid().ny,
                           certifiedParameters(16, allowance, ErrorLevel::surface));
    EXPECT_TRUE(surface.follow(zmap, {}));
    return surface.snapshot();
}

void expectWithin(const ZMapSnapshot& zmap, const SurfaceSnapshot& surface) {
    const std::vector<Vec3> points = pointsOf(zmap);
    const TriangleMesh mesh = meshOf(points, surface);
    const double farthest = farthestFrom(mesh, points);
    EXPECT_LE(farthest, kAllowance + kRounding);
    EXPECT_GT(farthest, kAllowance / 10) << "nearer than any surface with so few triangles can be";
    EXPECT_LT(mesh.triangles.size(), surface.facesFull / 10);
}

class SharedMap : public testing::TestWithParam<LargeMap> {};

TEST_P(SharedMap, hasNoPointFartherThanTheAllowance) {
    const ZMapSnapshot zmap = sharedMap(GetParam());
    if (zmap.tileCount() == 0)
        GTEST_SKIP() << "there is no ../shared/maps/" << GetParam().name << ".npy beside this repository";
    expectWithin(zmap, onScreen(zmap, kAllowance));
}

INSTANTIATE_TEST_SUITE_P(LargeMaps, SharedMap,
                         testing::Values(LargeMap{"m01", 0.1}, LargeMap{"mo01", 0.1},
                                         LargeMap{"die025", 0.25}),
                         [](const auto& map) { return map.param.name; });

class LargeTerrain : public testing::Test {
protected:
    const ZMapSnapshot zmap =
        zmapOf(kTerrain, kTerrain, 0.1, mapKind("terrain").make(kTerrain, kTerrain, 0.1, 31));
};

TEST_F(LargeTerrain, hasNoPointFartherThanTheAllowanceOnTheScreen) {
    expectWithin(zmap, onScreen(zmap, kAllowance));
}

TEST_F(LargeTerrain, hasNoPointFartherThanTheAllowanceInFiles) {
    expectWithin(zmap, decimatedWhole(zmap, certifiedParameters(16, kAllowance, ErrorLevel::surface)));
}

TEST_F(LargeTerrain, isFoundGuiltyOfTwiceTheAllowanceAndOfOnePoint) {
    std::vector<Vec3> points = pointsOf(zmap);
    EXPECT_GT(farthestFrom(meshOf(points, onScreen(zmap, 2 * kAllowance)), points), kAllowance + kRounding);
    const TriangleMesh mesh = meshOf(points, onScreen(zmap, kAllowance));
    points[static_cast<std::size_t>(417 * kTerrain + 283)].z += 5 * kAllowance;
    EXPECT_GT(farthestFrom(mesh, points), kAllowance + kRounding);
}

} // namespace
} // namespace proveout::test
