// SPDX-License-Identifier: GPL-3.0-or-later
// Checks with CGAL what `certify` guarantees: for every map, region size and allowance the exported solid is
// a valid closed manifold, and every z-map point is within the allowance of it. Without the certificate the
// same measurements must exceed the allowance, which shows that these checks can fail.
#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <iomanip>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "core/decimation/regions/error_measure.h"
#include "core/decimation/surface/surface.h"
#include "core/formats/stl.h"
#include "tests/cgal/certificate_report.h"
#include "tests/cgal/distance_oracle.h"
#include "tests/cgal/sample_maps.h"
#include "tests/cgal/solid_oracle.h"
#include "tests/core/decimation/closed_mesh.h"
#include "tests/core/decimation/maps.h"
#include "tests/core/decimation/topology.h"
#include "tests/core/temporary_folder.h"

namespace proveout::test {
namespace {

constexpr std::array kRegions{5, 8, 13, 16, 30, 64};
constexpr std::array kAllowances{0.01, 0.05, 0.1};
/// Coordinates here are under 256 mm: half a step of float32 there, for the point and for the surface.
constexpr double kStlRounding = 2e-5;

SurfaceSnapshot decimated(const ZMapSnapshot& zmap, const DecimationParameters& parameters) {
    Surface surface(zmap.grid().nx, zmap.grid().ny, parameters);
    surface.decimateDirty(zmap);
    return surface.snapshot();
}

Heights heightsOf(const ZMapSnapshot& zmap) {
    const Grid& grid = zmap.grid();
    Heights heights(static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny));
    zmap.read({0, 0, grid.nx, grid.ny}, heights);
    return heights;
}

std::vector<Vec3> pointsOf(const ZMapSnapshot& zmap) {
    std::vector<Vec3> points;
    for (int j = 0; j < zmap.grid().ny; ++j)
        for (int i = 0; i < zmap.grid().nx; ++i)
            points.emplace_back(zmap.grid().x(i), zmap.grid().y(j),
                                zmap.stock().topZ() + static_cast<double>(zmap.height(i, j)));
    return points;
}

/// Expects that both regions at each border use the same border points.
void expectBordersAgree(const SurfaceSnapshot& surface) {
    const RegionGrid& grid = surface.grid;
    std::vector<std::set<std::uint32_t>> used(grid.regionCount());
    for (std::size_t region = 0; region < used.size(); ++region)
        for (const LatticeTriangle& triangle : surface.triangles(region))
            used[region].insert(triangle.begin(), triangle.end());
    for (std::size_t border = 0; border < grid.borderCount(); ++border) {
        const auto [a, b] = grid.sharers(border);
        if (b == RegionGrid::kNoRegion)
            continue;
        const IndexRect points = grid.borderPoints(border);
        for (int j = points.j0; j < points.j1; ++j)
            for (int i = points.i0; i < points.i1; ++i)
                ASSERT_EQ(used[a].contains(grid.lattice(i, j)), used[b].contains(grid.lattice(i, j)))
                    << "border " << border << ", point " << i << ", " << j;
    }
}

std::size_t pointsBeyond(const ZMapSnapshot& zmap, const std::vector<LatticeTriangle>& triangles,
                         double allowance) {
    return measureVerticalError(zmap, {0, 0, zmap.grid().nx, zmap.grid().ny}, triangles, allowance).beyond;
}

class Certificate : public testing::TestWithParam<std::string> {
protected:
    static ZMapSnapshot map(const std::string& name) {
        if (name == "core-insert" || name == "mouse-case")
            return sampleMap(name);
        constexpr int kNx = 71; // not a multiple of any region size
        constexpr int kNy = 54;
        return zmapOf(kNx, kNy, 1.0, mapKind(name).make(kNx, kNy, 1.0, 12345));
    }

    /// The certified half of a row, and all checks of it.
    void certify(const ZMapSnapshot& zmap, const DecimationParameters& parameters, CertificateRow& row) {
        const SurfaceSnapshot surface = decimated(zmap, parameters);
        const auto triangles = surface.triangles();
        expectCoversMap(zmap.grid().nx, zmap.grid().ny, triangles);
        expectBordersAgree(surface);
        row.facesFull = surface.facesFull;
        row.faces = triangles.size();
        row.vertical = bruteForceError(zmap.grid().nx, zmap.grid().ny, heightsOf(zmap), triangles);
        EXPECT_LE(row.vertical, parameters.allowance);

        const auto written = writeStl(m_folder / "a.stl", closeSolid(zmap, triangles), StlEncoding::binary);
        ASSERT_TRUE(written);
        const auto solid = readStlContents(m_folder / "a.stl");
        ASSERT_TRUE(solid);
        EXPECT_EQ(solid->mesh.triangles.size(), written->triangles);
        EXPECT_EQ(whatIsWrong(solid->mesh), "");
        EXPECT_EQ(whatCgalFindsWrong(solid->mesh, Intersections::look), "");
        const PointDistances distances = distancesToTop(pointsOf(zmap), solid->mesh);
        row.verticalStl = distances.vertical;
        row.nearestStl = distances.nearest;
        EXPECT_LE(row.verticalStl, parameters.allowance + kStlRounding);
        EXPECT_LE(row.nearestStl, row.verticalStl + kStlRounding);
    }

    /// The same without the certificate, measured for the report.
    static void measurePaper(const ZMapSnapshot& zmap, DecimationParameters parameters, CertificateRow& row) {
        parameters.certify = false;
        const auto triangles = decimated(zmap, parameters).triangles();
        expectCoversMap(zmap.grid().nx, zmap.grid().ny, triangles);
        row.facesPaper = triangles.size();
        row.verticalPaper = bruteForceError(zmap.grid().nx, zmap.grid().ny, heightsOf(zmap), triangles);
        row.beyondPaper = pointsBeyond(zmap, triangles, parameters.allowance);
    }

    TemporaryFolder m_folder;
};

TEST_P(Certificate, HoldsForEveryRegionSizeAndAllowance) {
    const ZMapSnapshot zmap = map(GetParam());
    ASSERT_GT(zmap.tileCount(), 0U);
    std::vector<CertificateRow> rows;
    for (const double allowance : kAllowances) {
        for (const int region : kRegions) {
            SCOPED_TRACE(testing::Message() << "region " << region << ", allowance " << allowance);
            DecimationParameters parameters = leeParameters();
            parameters.regionCells = region;
            parameters.allowance = allowance;
            CertificateRow row;
            row.map = GetParam();
            row.region = region;
            row.allowance = allowance;
            certify(zmap, parameters, row);
            measurePaper(zmap, parameters, row);
            rows.push_back(row);
        }
    }
    printReport(std::cout, rows);
    // The negative control: the paper's accumulated error, implemented literally, does not bound the
    // distance, and this test must detect that.
    EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [](const CertificateRow& row) {
        return row.verticalPaper > row.allowance && row.beyondPaper > 0;
    })) << "without the certificate the allowance was kept everywhere: does this test see anything?";
}

INSTANTIATE_TEST_SUITE_P(Maps, Certificate,
                         testing::Values("terrain", "walls", "spheres", "noise", "core-insert", "mouse-case"),
                         [](const auto& name) {
                             std::string out = name.param;
                             std::replace(out.begin(), out.end(), '-', '_');
                             return out;
                         });

/// Per-region borders cause cracks, which the checks must detect.
TEST(CertificateControl, SurfacesWithCracksAreSeen) {
    const ZMapSnapshot zmap = zmapOf(33, 33, 1.0, mapKind("walls").make(33, 33, 1.0, 1));
    DecimationParameters parameters = leeParameters();
    parameters.borders = BorderRule::paper;
    parameters.certify = false;
    const TriangleMesh solid = closeSolid(zmap, decimated(zmap, parameters).triangles());
    EXPECT_NE(whatIsWrong(solid), "");
    EXPECT_NE(whatCgalFindsWrong(solid, Intersections::skip), "");
}

/// The distance of the surfaces themselves, in both directions. The certificate applies to the z-map points,
/// so this distance is reported and not guaranteed; it cannot be smaller than the distance of those points.
TEST(Hausdorff, IsReportedForSmallMaps) {
    constexpr int kSize = 17;
    constexpr double kBound = 5e-3;
    std::cout << "two-sided Hausdorff distance to the full surface, mm (at most " << kBound << " too large); "
              << kSize << " x " << kSize << " points, region 8, allowance 0.05\n"
              << "map        certified     paper\n";
    for (const char* name : {"flat", "terrain", "walls", "spheres", "noise"}) {
        const ZMapSnapshot zmap = zmapOf(kSize, kSize, 1.0, mapKind(name).make(kSize, kSize, 1.0, 99));
        const TriangleMesh full = closeSolid(zmap, Surface(kSize, kSize, {}).snapshot().triangles());
        std::cout << std::left << std::setw(10) << name << std::right << std::fixed << std::setprecision(4);
        for (const bool certified : {true, false}) {
            DecimationParameters parameters = leeParameters();
            parameters.certify = certified;
            const TriangleMesh solid = closeSolid(zmap, decimated(zmap, parameters).triangles());
            const double distance = symmetricHausdorff(solid, full, kBound);
            std::cout << std::setw(10) << distance;
            EXPECT_GE(distance, distancesToTop(pointsOf(zmap), solid).nearest - 1e-9) << name;
            if (std::string(name) == "flat") {
                EXPECT_LE(distance, kBound);
            }
        }
        std::cout << '\n';
    }
}

} // namespace
} // namespace proveout::test
