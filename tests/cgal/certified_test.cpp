// SPDX-License-Identifier: GPL-3.0-or-later
// Checks with CGAL what the certified method guarantees: at the surface level the surfaces themselves are
// within the allowance of each other, in both directions, and the exported mesh is a solid. The same checks
// must fail for the sample level and the paper's method at walls.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/decimation/surface/refined_surface.h"
#include "tests/cgal/distance_oracle.h"
#include "tests/cgal/sample_maps.h"
#include "tests/cgal/solid_oracle.h"
#include "tests/core/decimation/maps.h"

namespace proveout::test {
namespace {

constexpr double kAllowance = 0.05;
constexpr double kError = 2e-4; // accuracy of CGAL's result

DecimationParameters certified(int region, ErrorLevel level) {
    return certifiedParameters(region, kAllowance, level);
}

/// A surface as an open mesh, in mm.
TriangleMesh meshOf(const ZMapSnapshot& zmap, const std::vector<LatticeTriangle>& triangles) {
    const Grid& grid = zmap.grid();
    TriangleMesh mesh;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i)
            mesh.vertices.emplace_back(grid.x(i), grid.y(j), static_cast<double>(zmap.height(i, j)));
    mesh.triangles.assign(triangles.begin(), triangles.end());
    return mesh;
}

TriangleMesh fullMesh(const ZMapSnapshot& zmap) {
    return meshOf(zmap, Surface(zmap.grid().nx, zmap.grid().ny, {}).snapshot().triangles());
}

bool isFartherThanAllowed(const ZMapSnapshot& zmap, const DecimationParameters& parameters) {
    const TriangleMesh mesh = meshOf(zmap, decimatedWhole(zmap, parameters).triangles());
    return isHausdorffLarger(fullMesh(zmap), mesh, parameters.allowance + 2 * kError, kError);
}

ZMapSnapshot crop(const std::string& kind, double spacing) {
    const int size = kind == "walls" ? 13 : 41; // on walls CGAL takes minutes
    return zmapOf(size, size, spacing, mapKind(kind).make(size, size, spacing, 21));
}

class CertifiedCrop : public testing::TestWithParam<std::string> {};

TEST_P(CertifiedCrop, isWithinTheAllowanceBothWays) {
    for (const double spacing : {0.1, 0.5, 2.0})
        for (const int region : {8, 16, 64})
            EXPECT_FALSE(
                isFartherThanAllowed(crop(GetParam(), spacing), certified(region, ErrorLevel::surface)))
                << "spacing " << spacing << ", region " << region;
}

TEST_P(CertifiedCrop, hasTheHausdorffDistanceThatTheBoundAllows) {
    constexpr int kSize = 17; // CGAL needs long for the true distance
    const ZMapSnapshot zmap = zmapOf(kSize, kSize, 0.5, mapKind(GetParam()).make(kSize, kSize, 0.5, 3));
    const auto parameters = certified(8, ErrorLevel::surface);
    const TriangleMesh mesh = meshOf(zmap, decimatedWhole(zmap, parameters).triangles());
    EXPECT_LE(symmetricHausdorff(fullMesh(zmap), mesh, 2e-3), kAllowance + 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Maps, CertifiedCrop, testing::Values("flat", "terrain", "walls", "spheres", "noise"),
                         [](const auto& name) { return name.param; });

TEST(CertifiedControl, theSampleLevelAndThePapersMethodAreSeenToBeFartherAtWalls) {
    for (const char* kind : {"walls", "spheres"}) {
        const ZMapSnapshot zmap = crop(kind, 1.0);
        EXPECT_TRUE(isFartherThanAllowed(zmap, certified(64, ErrorLevel::sample))) << kind;
        DecimationParameters paper = leeParameters();
        paper.certify = false;
        EXPECT_TRUE(isFartherThanAllowed(zmap, paper)) << kind;
    }
}

TEST(CertifiedSample, mouseCaseIsWithinTheAllowanceBothWays) {
    const ZMapSnapshot zmap = sampleMap("mouse-case");
    ASSERT_GT(zmap.tileCount(), 0U);
    EXPECT_FALSE(isFartherThanAllowed(zmap, certified(16, ErrorLevel::surface)));
}

TEST(CertifiedSample, exportsAreSolidsAndEveryPointIsWithinTheAllowance) {
    for (const char* name : {"mouse-case", "core-insert"}) {
        const ZMapSnapshot zmap = sampleMap(name);
        ASSERT_GT(zmap.tileCount(), 0U);
        std::vector<Vec3> points;
        for (int j = 0; j < zmap.grid().ny; ++j)
            for (int i = 0; i < zmap.grid().nx; ++i)
                points.emplace_back(zmap.grid().x(i), zmap.grid().y(j),
                                    zmap.stock().topZ() + static_cast<double>(zmap.height(i, j)));
        for (const int region : {8, 16, 64}) {
            const auto triangles = decimatedWhole(zmap, certified(region, ErrorLevel::surface)).triangles();
            const TriangleMesh solid = closeSolid(zmap, triangles);
            EXPECT_EQ(whatCgalFindsWrong(solid, Intersections::look), "") << name << ", region " << region;
            EXPECT_LE(distancesToTop(points, solid).vertical, kAllowance + 1e-9)
                << name << ", region " << region;
        }
    }
}

} // namespace
} // namespace proveout::test
