// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"

#include <gtest/gtest.h>
#include <set>
#include <string>

#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

TEST(Formats, RowsAreWhole) {
    std::set<std::string> keys;
    for (const FileFormat& row : fileFormats()) {
        EXPECT_TRUE(keys.insert(row.key).second) << "twice: " << row.key;
        EXPECT_EQ(findFormat(row.key), &row);
        EXPECT_TRUE(row.reads() || row.writes()) << row.key;
        EXPECT_NE(std::string(row.label), "");
        EXPECT_NE(std::string(row.holds), "");
        ASSERT_FALSE(row.extensions.empty());
        for (const char* extension : row.extensions)
            EXPECT_EQ(extension[0], '.');
    }
    EXPECT_EQ(findFormat("no such format"), nullptr);
}

TEST(Formats, TheEndingOfAMeshFileNamesItsFormat) {
    const auto keyOf = [](const char* file) {
        const auto row = meshFormatOf(file);
        return row ? std::string((*row)->key) : std::string("none");
    };
    EXPECT_EQ(keyOf("a.stl"), "stl") << "binary where nothing else is said";
    EXPECT_EQ(keyOf("folder.obj/A.STL"), "stl");
    EXPECT_EQ(keyOf("a.b.Obj"), "obj");
    EXPECT_EQ(keyOf("a.ply"), "ply");
    EXPECT_EQ(keyOf("a.3MF"), "3mf");
    EXPECT_EQ(keyOf("a.glb"), "glb");
    for (const char* other : {"", "a", ".stl", "stl", "a.npy", "a.proveout", "a.stl.gz", "a.stl "})
        EXPECT_EQ(keyOf(other), "none") << other;
    EXPECT_EQ(oneLine(meshFormatOf("a.step").error().front()),
              "a.step: error: The extension of this name is not that of a mesh format; there are .stl .obj "
              ".ply .3mf .glb. "
              "[export-format-unknown]");
}

TEST(Formats, StlAndGlbRoundCoordinates) {
    for (const FileFormat& row : fileFormats()) {
        if (row.meshWriter() == nullptr)
            continue;
        const bool rounds = row.meshWriter()->coordinates == CoordinateType::float32;
        EXPECT_EQ(rounds, std::string(row.key).starts_with("stl") || row.key == std::string("glb"))
            << row.key;
    }
}

/// Every format that can be read and written preserves its content.
TEST(Formats, MeshFormatsReadWhatTheyWrite) {
    const TemporaryFolder folder;
    const TriangleMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    for (const FileFormat& row : fileFormats()) {
        const auto* format = std::get_if<MeshFormat>(&row.handlers);
        if (format == nullptr || !row.reads() || !row.writes())
            continue;
        const auto file = folder / (std::string(row.key) + row.extensions.front());
        ASSERT_TRUE(format->write(file, tetrahedron, {})) << row.key;
        const auto back = format->read(file);
        ASSERT_TRUE(back) << row.key;
        EXPECT_EQ(back->vertices.size(), 4U) << row.key;
        EXPECT_EQ(back->triangles.size(), 4U) << row.key;
    }
}

} // namespace
} // namespace proveout
