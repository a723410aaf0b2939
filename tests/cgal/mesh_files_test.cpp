// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files written by us and read by CGAL: the same mesh, and still a solid.
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <algorithm>
#include <gtest/gtest.h>

#include "core/decimation/surface/surface.h"
#include "core/formats/mesh_files.h"
#include "core/formats/stl.h"
#include "tests/cgal/sample_maps.h"
#include "tests/cgal/solid_oracle.h"
#include "tests/cgal/surface_mesh.h"
#include "tests/core/decimation/closed_mesh.h"
#include "tests/core/decimation/maps.h"
#include "tests/core/temporary_folder.h"

namespace proveout::test {
namespace {

struct Case {
    std::string name;
    ZMapSnapshot zmap;
    TriangleMesh solid;
};

TriangleMesh decimatedSolid(const ZMapSnapshot& zmap) {
    Surface surface(zmap.grid().nx, zmap.grid().ny, DecimationParameters());
    surface.decimateDirty(zmap);
    return closeSolid(zmap, surface.snapshot().triangles());
}

/// A sample of the product, and stock that is cut through to the floor in places, where surfaces were
/// separated.
std::vector<Case> cases() {
    std::vector<Case> out;
    const ZMapSnapshot sample = sampleMap("core-insert");
    out.push_back({"core-insert", sample, decimatedSolid(sample)});
    for (const char* name : {"spheres", "noise"}) {
        Heights heights = mapKind(name).make(61, 47, 0.7, 7);
        const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
        const float through = *low + (*high - *low) / 3;
        for (float& height : heights)
            height = height <= through ? -100.0F : height;
        const ZMapSnapshot zmap = zmapOf(61, 47, 0.7, heights);
        out.push_back({name, zmap, decimatedSolid(zmap)});
    }
    return out;
}

using Points = std::vector<Kernel::Point_3>;
using Faces = std::vector<std::vector<std::size_t>>;

TriangleMesh ours(const Points& points, const Faces& faces) {
    TriangleMesh mesh;
    for (const auto& point : points)
        mesh.vertices.emplace_back(point.x(), point.y(), point.z());
    for (const auto& face : faces)
        mesh.triangles.push_back({static_cast<std::uint32_t>(face.at(0)),
                                  static_cast<std::uint32_t>(face.at(1)),
                                  static_cast<std::uint32_t>(face.at(2))});
    return mesh;
}

void expectTheSame(const TriangleMesh& got, const TriangleMesh& wanted) {
    EXPECT_TRUE(got.vertices == wanted.vertices) << "bit by bit";
    EXPECT_TRUE(got.triangles == wanted.triangles);
    EXPECT_EQ(whatCgalFindsWrong(got, Intersections::skip), "");
}

TEST(MeshFiles, ObjIsTheSameMeshToCgal) {
    const TemporaryFolder folder;
    for (const Case& of : cases()) {
        SCOPED_TRACE(of.name);
        ASSERT_TRUE(writeObj(folder / "a.obj", of.solid));
        Points points;
        Faces faces;
        ASSERT_TRUE(CGAL::IO::read_OBJ((folder / "a.obj").string(), points, faces));
        expectTheSame(ours(points, faces), of.solid);
        SurfaceMesh mesh;
        ASSERT_TRUE(CGAL::IO::read_OBJ((folder / "a.obj").string(), mesh));
        EXPECT_TRUE(CGAL::is_closed(mesh));
    }
}

TEST(MeshFiles, PlyIsTheSameMeshToCgal) {
    const TemporaryFolder folder;
    for (const Case& of : cases()) {
        SCOPED_TRACE(of.name);
        ASSERT_TRUE(writePly(folder / "a.ply", of.solid));
        Points points;
        Faces faces;
        ASSERT_TRUE(CGAL::IO::read_PLY((folder / "a.ply").string(), points, faces));
        expectTheSame(ours(points, faces), of.solid);
        EXPECT_NEAR(signedVolume(ours(points, faces)), of.zmap.volume(), 0.02 * of.zmap.volume());
    }
}

/// STL stores separate triangles; joined by their float32 coordinates they must form a solid without
/// intersections.
TEST(MeshFiles, StlIsASolidAgainToCgal) {
    namespace pmp = CGAL::Polygon_mesh_processing;
    const TemporaryFolder folder;
    for (const Case& of : cases()) {
        SCOPED_TRACE(of.name);
        ASSERT_TRUE(writeStl(folder / "a.stl", of.solid, StlEncoding::binary));
        Points points;
        Faces faces;
        ASSERT_TRUE(CGAL::IO::read_STL((folder / "a.stl").string(), points, faces));
        pmp::merge_duplicate_points_in_polygon_soup(points, faces);
        EXPECT_EQ(points.size(), of.solid.vertices.size());
        EXPECT_EQ(faces.size(), of.solid.triangles.size());
        EXPECT_EQ(whatCgalFindsWrong(ours(points, faces), Intersections::look), "");
    }
}

} // namespace
} // namespace proveout::test
