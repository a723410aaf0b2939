// SPDX-License-Identifier: GPL-3.0-or-later
// Triangle counts estimated from another region size, compared with regions whose triangles are known.
#include <gtest/gtest.h>

#include "core/study/region_faces.h"

namespace proveout {
namespace {

RegionMeshPtr meshOf(std::size_t triangles) {
    RegionMesh mesh;
    mesh.triangles.resize(triangles);
    return std::make_shared<const RegionMesh>(std::move(mesh));
}

/// A surface with the given number of triangles per region; 0: not decimated.
SurfaceSnapshot surfaceOf(const RegionGrid& grid, const std::vector<std::size_t>& triangles) {
    SurfaceSnapshot surface;
    surface.grid = grid;
    surface.meshes = PersistentArray<RegionMeshPtr>(grid.regionCount());
    for (std::size_t region = 0; region < triangles.size(); ++region)
        if (triangles[region] > 0)
            surface.meshes.edit(region) = meshOf(triangles[region]);
    return surface;
}

// 16 × 4 cells: sixteen regions of 2 × 2, and four of 4 × 4 that cover them.
const RegionGrid kSmall(17, 5, 2);
const RegionGrid kLarge(17, 5, 4);

/// The small regions have 2 triangles when uncut; each of the four within a large one has the given number
/// more.
RegionFaces referenceWith(const std::vector<std::size_t>& beyondPerLarge) {
    std::vector<std::size_t> triangles;
    std::vector<std::size_t> touched;
    for (std::size_t region = 0; region < kSmall.regionCount(); ++region) {
        triangles.push_back(2 + beyondPerLarge[region % 8 / 2]);
        touched.push_back(region);
    }
    RegionFaces reference(kSmall, std::vector<double>(kSmall.regionCount(), 2));
    (void)reference.update(touched, touched, surfaceOf(kSmall, triangles), reference);
    return reference;
}

TEST(RegionFaces, CountsTheShareOfAnAreaByItsCells) {
    const RegionFaces reference = referenceWith({4, 0, 8, 0});
    EXPECT_DOUBLE_EQ(reference.beyondUncut(kLarge.points(0)), 16);
    EXPECT_DOUBLE_EQ(reference.beyondUncut(kLarge.points(1)), 0);
    EXPECT_DOUBLE_EQ(reference.beyondUncut({0, 0, 2, 5}), 4);  // half of two regions
    EXPECT_DOUBLE_EQ(reference.beyondUncut({0, 0, 2, 2}), 1);  // one cell
    EXPECT_DOUBLE_EQ(reference.beyondUncut({7, 0, 10, 3}), 4); // half of a region with 8, half of one with 0
}

TEST(RegionFaces, ReportsRegionsThatWereNotDecimated) {
    // Half as many as the small regions have: one region shows it, and the others are scaled accordingly.
    const RegionFaces reference = referenceWith({4, 1, 6, 0});
    RegionFaces faces(kLarge, {2, 2, 2, 2});
    const std::vector<std::size_t> touched{0, 1, 2, 3};
    const std::vector<std::size_t> drawn{0};
    EXPECT_EQ(faces.update(touched, drawn, surfaceOf(kLarge, {2 + 8}), reference),
              (std::vector<double>{10, 4, 14, 2}));
}

TEST(RegionFaces, LearnsTheFactorFromTheRegionsThatChanceChose) {
    // Region 1 was decimated because the last block touched it, so it does not represent others.
    const RegionFaces reference = referenceWith({4, 4, 4, 4});
    RegionFaces faces(kLarge, {2, 2, 2, 2});
    const std::vector<std::size_t> touched{0, 1, 2};
    const std::vector<std::size_t> drawn{0};
    EXPECT_EQ(faces.update(touched, drawn, surfaceOf(kLarge, {2 + 16, 30}), reference),
              (std::vector<double>{18, 30, 18}));
    EXPECT_EQ(faces.now()[3], 2); // not touched
}

TEST(RegionFaces, NeverHaveMoreTrianglesThanTheFullMesh) {
    const RegionFaces reference = referenceWith({1, 6, 0, 0});
    RegionFaces faces(kLarge, {2, 2, 2, 2});
    const std::vector<std::size_t> touched{0, 1};
    const std::vector<std::size_t> drawn{0};
    EXPECT_EQ(faces.update(touched, drawn, surfaceOf(kLarge, {30}), reference),
              (std::vector<double>{30, 32}));
}

} // namespace
} // namespace proveout
