// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/part_file.h"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <utility>

#include "core/base/memory.h"
#include "core/formats/stl.h"
#include "core/part/part_findings.h"
#include "tests/core/formats/meshes.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

class PartFile : public ::testing::Test {
protected:
    PartContents read(const TriangleMesh& mesh, PartSpec spec = {}) {
        spec.file = m_folder / "part.stl";
        EXPECT_TRUE(writeStl(spec.file, mesh, StlEncoding::binary).has_value());
        return readPart(spec, memoryLimitBytes());
    }
    PartContents readText(const std::string& name, const std::string& text) {
        m_folder.put(name, text);
        return readPart(specOf(name), memoryLimitBytes());
    }
    [[nodiscard]] PartSpec specOf(const std::string& name) const {
        PartSpec spec;
        spec.file = m_folder / name;
        return spec;
    }
    static std::string said(const PartContents& contents) {
        std::string all;
        for (const Diagnostic& diagnostic : contents.findings)
            all += std::string(diagnostic.id) + ": " + message(diagnostic) + '\n';
        return all;
    }
    TemporaryFolder m_folder;
};

TEST_F(PartFile, IsScaledThenTurnedThenPlaced) {
    const PartContents contents = read(test::tetrahedron(1), {{}, 10, 20, -5, 90, 25.4, {}});
    ASSERT_NE(contents.part, nullptr) << said(contents);
    EXPECT_TRUE(contents.findings.empty() || said(contents).starts_with("stl-size")) << said(contents);
    const Box3& box = contents.part->box();
    EXPECT_NEAR(box.lo.x, 10 - 25.4, 1e-5);
    EXPECT_NEAR(box.hi.x, 10, 1e-5);
    EXPECT_NEAR(box.lo.y, 20, 1e-5);
    EXPECT_NEAR(box.hi.y, 20 + 25.4, 1e-5);
    EXPECT_NEAR(box.lo.z, -5, 1e-5);
    EXPECT_NEAR(box.hi.z, -5 + 25.4, 1e-5);
}

TEST_F(PartFile, WhatIsSafeIsRepairedAndTold) {
    TriangleMesh mesh = test::tetrahedron(10);
    for (auto& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    mesh.triangles.push_back(mesh.triangles.front());
    const PartContents contents = read(mesh);
    ASSERT_NE(contents.part, nullptr) << said(contents);
    EXPECT_NE(said(contents).find("part-repaired: 1 facets of the part are there twice"), std::string::npos)
        << said(contents);
    EXPECT_NE(said(contents).find("part-repaired: The part is inside out; all 4 facets"), std::string::npos)
        << said(contents);
    const auto inside = contents.part->distance().at({1, 1, 1});
    EXPECT_LT(inside->distance, 0);
    EXPECT_TRUE(inside->hasSide);
}

TEST_F(PartFile, AnOpenMeshIsUsedAndTold) {
    TriangleMesh mesh = test::tetrahedron(10);
    mesh.triangles.pop_back();
    const PartContents contents = read(mesh);
    ASSERT_NE(contents.part, nullptr);
    EXPECT_NE(said(contents).find("part-not-closed: The part is not closed at 3 edges"), std::string::npos)
        << said(contents);
    EXPECT_FALSE(contents.part->distance().at({-4, 5, 5})->hasSide) << "its nearest place is on an open edge";
}

TEST_F(PartFile, WhatCannotBeUsedIsRefusedWithTheReason) {
    TriangleMesh flipped = test::tetrahedron(10);
    std::swap(flipped.triangles[0][1], flipped.triangles[0][2]);
    const PartContents winding = read(flipped);
    EXPECT_EQ(winding.part, nullptr);
    EXPECT_NE(said(winding).find("opposite sides at 3 edges"), std::string::npos) << said(winding);

    const PartContents step = readText("part.step", "ISO-10303-21;");
    EXPECT_EQ(step.part, nullptr);
    EXPECT_NE(said(step).find("ends in \".step\""), std::string::npos) << said(step);
    EXPECT_EQ(readText("broken.stl", "solid x\nfacet normal 0 0 1\n").part, nullptr);
    EXPECT_EQ(readText("empty.stl", "").part, nullptr);
    EXPECT_EQ(readPart(specOf("none.stl"), memoryLimitBytes()).part, nullptr);

    (void)read(test::tetrahedron(10));
    const PartContents large = readPart(specOf("part.stl"), 1000);
    EXPECT_EQ(large.part, nullptr);
    EXPECT_NE(said(large).find("The part needs"), std::string::npos) << said(large);
    for (const PartContents& one : {winding, step, large}) {
        ASSERT_EQ(one.findings.size(), 1U);
        EXPECT_TRUE(one.findings[0].unverified);
    }
}

TEST(PartSpec, ReadsAFileAloneOrWithItsPlace) {
    EXPECT_EQ(parsePart("a=b,c.stl")->file, "a=b,c.stl");
    const PartSpec placed =
        *parsePart("x=1,y=-2,z=3.5,turn=90,scale=25.4,below=0.02,above=0.3,allowance=0.2,file=a,b.stl");
    EXPECT_EQ(placed, (PartSpec{"a,b.stl", 1, -2, 3.5, 90, 25.4, {0.02, 0.3, 0.2}}));
    EXPECT_EQ(parsePart("file=c.stl", placed)->turn, 90) << "values of the job stay";
    EXPECT_FALSE(parsePart("w=1,file=c.stl").has_value());
    EXPECT_FALSE(parsePart("below=-1,file=c.stl").has_value());
    EXPECT_FALSE(parsePart("").has_value());
    EXPECT_EQ(*parseTolerance("0.05"), (PartTolerance{0.05, 0.05, 0}));
    EXPECT_EQ(*parseTolerance("0.05,0.2", {1, 1, 0.5}), (PartTolerance{0.05, 0.2, 0.5}));
    for (const char* wrong : {"", "a", "0.1,", "0.1,b", "-0.1", "0.1,0.2,0.3", "nan", "inf"})
        EXPECT_FALSE(parseTolerance(wrong).has_value()) << wrong;
}

} // namespace
} // namespace proveout
