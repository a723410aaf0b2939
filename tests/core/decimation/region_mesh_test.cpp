// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/regions/region_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "core/decimation/lee/region_half_edges.h"
#include "tests/core/decimation/topology.h"

namespace proveout {
namespace {

LatticeTriangle turnedToLeast(LatticeTriangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

std::set<LatticeTriangle> asSet(const std::vector<LatticeTriangle>& triangles) {
    std::set<LatticeTriangle> set;
    for (const LatticeTriangle& t : triangles)
        set.insert(turnedToLeast(t));
    return set;
}

/// Borders that keep a random subset of their points.
std::vector<BorderLinePtr> randomLines(const RegionGrid& grid, std::mt19937& random) {
    std::vector<BorderLinePtr> lines(grid.borderCount());
    const auto keepOneIn = 1 + random() % 5;
    for (std::size_t border = 0; border < lines.size(); ++border) {
        const IndexRect rect = grid.borderPoints(border);
        const auto n = static_cast<std::uint32_t>(rect.width() * rect.height() - 1);
        if (random() % 4 == 0)
            continue;
        BorderLine line;
        for (std::uint32_t k = 0; k <= n; ++k)
            if (k == 0 || k == n || n == 2 || random() % keepOneIn == 0)
                line.kept.push_back(k);
        lines[border] = std::make_shared<const BorderLine>(std::move(line));
    }
    return lines;
}

std::array<BorderLinePtr, 4> linesOf(const RegionGrid& grid, std::size_t region,
                                     const std::vector<BorderLinePtr>& lines) {
    const auto indices = grid.borders(region);
    return {lines[indices[0]], lines[indices[1]], lines[indices[2]], lines[indices[3]]};
}

TEST(FullRegionMesh, hasTheCanonicalDiagonals) {
    const RegionGrid grid(4, 2, 1);
    // Cell 0 has "/", cell 1 has "\", cell 2 has "/".
    EXPECT_EQ(asSet(fullRegionMesh(grid, 0)), asSet({{0, 1, 5}, {0, 5, 4}}));
    EXPECT_EQ(asSet(fullRegionMesh(grid, 1)), asSet({{1, 2, 5}, {2, 6, 5}}));
    EXPECT_EQ(asSet(fullRegionMesh(grid, 2)), asSet({{2, 3, 7}, {2, 7, 6}}));
}

TEST(FullRegionMesh, withRandomPolylinesCoversTheMapAsCounted) {
    for (unsigned seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const int nx = 2 + static_cast<int>(random() % 30);
        const int ny = 2 + static_cast<int>(random() % 30);
        const RegionGrid grid(nx, ny, 1 + static_cast<int>(random() % 9));
        const std::vector<BorderLinePtr> lines = randomLines(grid, random);
        std::vector<LatticeTriangle> all;
        for (std::size_t region = 0; region < grid.regionCount(); ++region) {
            const auto triangles = fullRegionMesh(grid, region, linesOf(grid, region, lines));
            EXPECT_EQ(triangles.size(), fullRegionFaces(grid, region, linesOf(grid, region, lines)));
            all.insert(all.end(), triangles.begin(), triangles.end());
        }
        test::expectCoversMap(nx, ny, all);
        if (HasFailure())
            return;
    }
}

TEST(RegionHalfEdges, isTheFullRegionMeshWhateverTheBorders) {
    RegionHalfEdges mesh; // reused for all, as in the product, so that it contains storage of larger regions
    for (unsigned seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const int nx = 2 + static_cast<int>(random() % 20);
        const int ny = 2 + static_cast<int>(random() % 20);
        const RegionGrid grid(nx, ny, 1 + static_cast<int>(random() % 9));
        const std::vector<BorderLinePtr> lines = randomLines(grid, random);
        for (std::size_t region = 0; region < grid.regionCount(); ++region) {
            const IndexRect rect = grid.points(region);
            const auto borders = linesOf(grid, region, lines);
            const std::vector<float> heights(static_cast<std::size_t>(rect.width() * rect.height()), -1.0F);
            mesh.build(rect, heights);
            for (const Side side : kSides)
                if (const auto& line = borders[static_cast<std::size_t>(side)])
                    mesh.drawBorder(side, *line);
            std::vector<LatticeTriangle> triangles;
            const auto lattice = [&](OpenMesh::VertexHandle v) {
                return grid.lattice(rect.i0 + v.idx() % rect.width(), rect.j0 + v.idx() / rect.width());
            };
            mesh.forEachFace([&](auto a, auto b, auto c) {
                triangles.push_back({lattice(a), lattice(b), lattice(c)});
            });
            EXPECT_EQ(asSet(triangles), asSet(fullRegionMesh(grid, region, borders)));
        }
        if (HasFailure())
            return;
    }
}

TEST(RegionHalfEdges, starsAreCounterClockwiseAndBeginAndEndOnTheBorder) {
    RegionHalfEdges mesh;
    const IndexRect rect{3, 4, 9, 8};
    const std::vector<float> heights(24, 0.0F);
    mesh.build(rect, heights);
    for (int j = 0; j < rect.height(); ++j) {
        for (int i = 0; i < rect.width(); ++i) {
            const bool onBorder = i == 0 || j == 0 || i + 1 == rect.width() || j + 1 == rect.height();
            EXPECT_EQ(mesh.onBorder(mesh.vertex(i, j)), onBorder);
            const Star& star = mesh.star(mesh.vertex(i, j));
            EXPECT_EQ(star.closed, !onBorder);
            for (std::size_t k = 0; k < star.faceCount(); ++k) {
                const auto& a = star.spokes[k].offset;
                const auto& b = star.spokes[star.nextSpoke(k)].offset;
                EXPECT_GT(a[0] * b[1] - a[1] * b[0], 0);
            }
            if (onBorder) {
                EXPECT_TRUE(mesh.onBorder(star.spokes.front().tip));
                EXPECT_TRUE(mesh.onBorder(star.spokes.back().tip));
            }
        }
    }
}

} // namespace
} // namespace proveout
