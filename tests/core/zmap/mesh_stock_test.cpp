// SPDX-License-Identifier: GPL-3.0-or-later
// Compares meshes with the slowest method: every vertical line with every triangle.
#include "core/zmap/mesh_stock.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "tests/core/zmap/mesh_bodies.h"

namespace proveout {
namespace {

constexpr double kPi = std::numbers::pi;

/// The z of a triangle's plane at a position that it covers in plan.
std::optional<double> hit(const StockMesh& mesh, const std::array<std::uint32_t, 3>& triangle, double x,
                          double y) {
    const Vec3 a = mesh.vertices[triangle[0]];
    const Vec3 b = mesh.vertices[triangle[1]];
    const Vec3 c = mesh.vertices[triangle[2]];
    const auto cross = [](const Vec2& u, const Vec2& v) { return u.x * v.y - u.y * v.x; };
    const Vec2 p(x, y);
    const double area = cross(Vec2(b - a), Vec2(c - a));
    if (area == 0)
        return {};
    const double u = cross(Vec2(b) - p, Vec2(c) - p) / area;
    const double v = cross(Vec2(c) - p, Vec2(a) - p) / area;
    const double w = cross(Vec2(a) - p, Vec2(b) - p) / area;
    if (std::min({u, v, w}) < 0)
        return {};
    return u * a.z + v * b.z + w * c.z;
}

struct Cast {
    double top = -1e30;
    double air = 0; ///< below the top, down to the floor
};

Cast castRay(const StockMesh& mesh, double x, double y, double floorZ) {
    std::vector<double> at;
    for (const auto& triangle : mesh.triangles)
        if (const auto z = hit(mesh, triangle, x, y))
            at.push_back(*z);
    std::ranges::sort(at, std::greater{});
    Cast cast;
    if (at.empty())
        return cast;
    cast.top = at.front();
    for (std::size_t k = 1; k < at.size(); k += 2)
        cast.air += at[k] - (k + 1 < at.size() ? at[k + 1] : floorZ);
    return cast;
}

UncutStock uncutOf(const StockMesh& mesh, double spacing, std::optional<Vec3> corner = {}) {
    const auto body = meshStock(mesh).value();
    StockBox box = body->box();
    if (corner)
        box.corner = *corner;
    return body->uncut(box, makeGrid(box, spacing).value());
}

std::string idsOf(const Diagnostics& findings) {
    std::string ids;
    for (const Diagnostic& finding : findings)
        ids += std::string(finding.id) + ' ';
    return ids;
}

TEST(MeshStock, BoxIsABoxWithItsRims) {
    for (const double size : {10.0, 33.3, 0.1}) {
        StockMesh mesh;
        addBox(mesh, {1.1, -2.2, 3.3}, Vec3(1.1, -2.2, 3.3) + Vec3(size, 2 * size, size / 3));
        const UncutStock uncut = uncutOf(mesh, size / 37);
        EXPECT_NEAR(uncut.zmap.snapshot().volume(), size * 2 * size * size / 3, 1e-6 * size * size * size);
        EXPECT_EQ(idsOf(uncut.findings), "") << size;
    }
}

TEST(MeshStock, RandomBodiesAgreeWithRays) {
    for (std::uint_fast32_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(fmt::format("seed {}", seed));
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> radius(4, 10);
        const StockMesh mesh = starBody({3, -7, 20}, 7, 9, [&] { return radius(random); });
        const UncutStock uncut = uncutOf(mesh, 0.25);
        const ZMapSnapshot map = uncut.zmap.snapshot();
        const StockBox& stock = map.stock();
        double air = 0;
        for (int j = 0; j < map.grid().ny; ++j)
            for (int i = 0; i < map.grid().nx; ++i) {
                const Cast cast = castRay(mesh, map.grid().x(i), map.grid().y(j), stock.floorZ());
                const double expected = std::max(cast.top, stock.floorZ()) - stock.topZ();
                ASSERT_NEAR(map.height(i, j), expected, 1e-5) << i << ' ' << j;
                air += cast.air * map.grid().hx * map.grid().hy;
            }
        ASSERT_EQ(idsOf(uncut.findings), "stock-undercut ");
        EXPECT_NEAR(std::stod(uncut.findings.front().arguments[0]), air, air * 0.01);
        EXPECT_TRUE(uncut.findings.front().unverified);
    }
}

TEST(MeshStock, SphereHasItsVolumeAboveAndItsUndercutBelow) {
    const double r = 10;
    const StockMesh mesh = starBody({0, 0, 0}, 120, 240, [&] { return r; });
    const UncutStock uncut = uncutOf(mesh, 0.1);
    // Material in the z-map: the upper half and the cylinder down to the floor.
    const double held = 2.0 / 3 * kPi * r * r * r + kPi * r * r * r;
    EXPECT_NEAR(uncut.zmap.snapshot().volume() / held, 1, 0.003);
    ASSERT_EQ(idsOf(uncut.findings), "stock-undercut ");
    EXPECT_NEAR(std::stod(uncut.findings.front().arguments[0]) / (kPi / 3 * r * r * r), 1, 0.01);
}

TEST(MeshStock, CavityIsReportedWithItsVolumeHeightAndPlace) {
    StockMesh mesh;
    addBox(mesh, {0, 0, 0}, {40, 30, 20});
    StockMesh cavity;
    addBox(cavity, {10, 10, 5}, {20, 15, 12});
    const auto shift = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), cavity.vertices.begin(), cavity.vertices.end());
    for (const auto& t : cavity.triangles) // turned inside out
        mesh.triangles.push_back({t[0] + shift, t[2] + shift, t[1] + shift});
    const UncutStock uncut = uncutOf(mesh, 0.1, Vec3(100, 200, 0));
    ASSERT_EQ(idsOf(uncut.findings), "stock-undercut ");
    const auto& reported = uncut.findings.front().arguments;
    EXPECT_NEAR(std::stod(reported[0]), 10 * 5 * 7, 10);
    EXPECT_NEAR(std::stod(reported[1]), 7, 1e-9);
    EXPECT_NEAR(std::stod(reported[4]), 12 - 20, 1e-9);
    EXPECT_GE(std::stod(reported[2]), 110);
    EXPECT_LE(std::stod(reported[2]), 120);
}

/// Walls of files lean by rounding and by their tolerance, and often are at points of the grid.
TEST(MeshStock, WallsThatLeanByATenthOfACellAreNoUndercuts) {
    for (const double lean : {1e-6, 0.04, 0.7}) {
        for (const double turned : {0.0, 45.0, 17.0}) {
            StockMesh mesh;
            addBox(mesh, {-10, -10, -5}, {10, 10, 0});
            const double angle = turned * kPi / 180;
            for (Vec3& vertex : mesh.vertices) {
                vertex.x += vertex.z < 0 ? 0 : lean; // the top overhangs
                vertex = {std::cos(angle) * vertex.x - std::sin(angle) * vertex.y,
                          std::sin(angle) * vertex.x + std::cos(angle) * vertex.y, vertex.z};
            }
            addBox(mesh, {-20, -20, -8}, {20, 20, -4}); // and it stands on a plate
            const UncutStock uncut = uncutOf(mesh, 0.5);
            EXPECT_EQ(idsOf(uncut.findings), lean > 0.1 ? "stock-undercut " : "") << lean << " " << turned;
        }
    }
}

TEST(MeshStock, ShellsThatOverlapAreOneBody) {
    StockMesh mesh;
    addBox(mesh, {0, 0, 0}, {40, 30, 12});
    addBox(mesh, {10, 10, 0}, {30, 20, 20});
    const UncutStock uncut = uncutOf(mesh, 0.5);
    EXPECT_EQ(idsOf(uncut.findings), "");
    EXPECT_EQ(uncut.zmap.snapshot().height(40, 30), 0.0F);
    EXPECT_EQ(uncut.zmap.snapshot().height(2, 2), -8.0F);
}

TEST(MeshStock, InsideOutIsTheSame) {
    StockMesh mesh = starBody({0, 0, 0}, 12, 16, [] { return 8.0; });
    const UncutStock uncut = uncutOf(mesh, 0.3);
    for (auto& t : mesh.triangles)
        std::swap(t[1], t[2]);
    const UncutStock turned = uncutOf(mesh, 0.3);
    EXPECT_EQ(turned.zmap.snapshot().volume(), uncut.zmap.snapshot().volume());
    EXPECT_EQ(turned.findings, uncut.findings);
}

TEST(MeshStock, OpenMeshIsReportedAndUnverified) {
    StockMesh mesh;
    addBox(mesh, {0, 0, 0}, {40, 30, 20});
    mesh.triangles.erase(mesh.triangles.begin()); // opens the bottom
    const UncutStock uncut = uncutOf(mesh, 0.5);
    ASSERT_FALSE(uncut.findings.empty());
    EXPECT_EQ(uncut.findings.front().id, std::string("stock-mesh-open"));
    EXPECT_TRUE(uncut.findings.front().unverified);
}

TEST(MeshStock, WarningsOfTheFileStay) {
    StockMesh mesh;
    addBox(mesh, {0, 0, 0}, {4, 3, 2});
    Diagnostic warning;
    warning.id = "w";
    const auto body = meshStock(mesh, {warning}).value();
    const auto uncut = body->uncut(body->box(), makeGrid(body->box(), 0.5).value());
    EXPECT_EQ(idsOf(uncut.findings), "w ");
}

/// Tiles are filled in bands of some thousand columns.
TEST(MeshStock, AWideGridAgreesWithRays) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> radius(4, 10);
    const StockMesh mesh = starBody({3, -7, 20}, 7, 9, [&] { return radius(random); });
    const auto body = meshStock(mesh).value();
    const StockBox box = body->box();
    Grid grid = makeGrid(box, 1).value();
    grid.nx = 9001;
    grid.hx = box.width / (grid.nx - 1);
    const UncutStock uncut = body->uncut(box, grid);
    const ZMapSnapshot map = uncut.zmap.snapshot();
    double air = 0;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; i += 7) {
            const Cast cast = castRay(mesh, grid.x(i), grid.y(j), box.floorZ());
            ASSERT_NEAR(map.height(i, j), std::max(cast.top, box.floorZ()) - box.topZ(), 1e-5)
                << i << ' ' << j;
            air += 7 * cast.air * grid.hx * grid.hy;
        }
    EXPECT_NEAR(std::stod(uncut.findings.front().arguments[0]), air, air * 0.01);
}

TEST(MeshStock, RefusesLayersWithoutEnd) {
    StockMesh mesh;
    for (int k = 0; k < 150; ++k)
        addBox(mesh, {0, 0, 0}, {40, 30, 1.0 + k});
    EXPECT_EQ(meshStock(mesh).error().front().id, std::string("stock-mesh-layers"));
    mesh.triangles.resize(mesh.triangles.size() / 2);
    EXPECT_TRUE(meshStock(mesh));
}

TEST(MeshStock, RefusesWhatHasNoVolume) {
    EXPECT_FALSE(meshStock({}));
    EXPECT_EQ(meshStock({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}).error().front().id,
              std::string("stock-mesh-flat"));
    EXPECT_EQ(meshStock({{{0, 0, 0}, {1e9, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}).error().front().id,
              std::string("stock-mesh-far"));
}

/// The warnings may be the reason: a part in metres has no volume on any grid.
TEST(MeshStock, KeepsTheWarningsOfAMeshThatItRefuses) {
    Diagnostic suspect;
    suspect.id = "stl-size-suspect";
    const auto refused = meshStock({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, {suspect});
    ASSERT_EQ(refused.error().size(), 2U);
    EXPECT_EQ(refused.error().back().id, std::string("stl-size-suspect"));
}

} // namespace
} // namespace proveout
