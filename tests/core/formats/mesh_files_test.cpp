// SPDX-License-Identifier: GPL-3.0-or-later
// What every mesh format of the table must satisfy.
#include "core/formats/mesh_files.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/atomic_file.h"
#include "core/base/memory.h"
#include "core/formats/formats.h"
#include "tests/core/file_size_limit.h"
#include "tests/core/formats/meshes.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

using test::randomSoup;
using test::tetrahedron;
using testing::HasSubstr;

std::vector<std::string> writableKeys() {
    std::vector<std::string> keys;
    for (const FileFormat& row : fileFormats())
        if (row.meshWriter() != nullptr)
            keys.emplace_back(row.key);
    return keys;
}

class MeshFile : public testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] std::filesystem::path file() const { return m_folder / m_name; }
    Result<WrittenFile> write(const TriangleMesh& mesh, const WorkContext& context = {}) {
        return findFormat(GetParam())->meshWriter()->write(file(), mesh, context);
    }
    /// Writes to a target outside the test's folder.
    Result<WrittenFile> writeTo(const std::filesystem::path& target, const TriangleMesh& mesh) {
        return findFormat(GetParam())->meshWriter()->write(target, mesh, {});
    }

    TemporaryFolder m_folder;
    std::string m_name = std::string("a") + findFormat(GetParam())->extensions.front();
};

INSTANTIATE_TEST_SUITE_P(Formats, MeshFile, testing::ValuesIn(writableKeys()), [](const auto& key) {
    std::string name = key.param;
    std::erase(name, '-');
    return name;
});

TEST_P(MeshFile, ReportsItsTrianglesAndBytes) {
    const auto written = write(randomSoup(20'000, 1)); // more than one batch
    ASSERT_TRUE(written);
    EXPECT_EQ(written->triangles, 20'000U);
    EXPECT_EQ(written->bytes, std::filesystem::file_size(file()));
    EXPECT_EQ(m_folder.entries(), 1U);
}

TEST_P(MeshFile, EqualMeshesGiveEqualBytes) {
    ASSERT_TRUE(write(randomSoup(5'000, 2)));
    const std::string first = readFile(file()).value();
    ASSERT_TRUE(write(randomSoup(5'000, 2)));
    EXPECT_TRUE(readFile(file()).value() == first);
}

TEST_P(MeshFile, ACancelledExportLeavesTheOldFileAndNoOther) {
    ASSERT_TRUE(writeFile(file(), "old"));
    std::stop_source stop;
    WorkContext context;
    context.stop = stop.get_token();
    context.progress = [&stop](double done) {
        if (done > 0.3)
            stop.request_stop();
    };
    const auto result = write(randomSoup(50'000, 3), context);
    ASSERT_FALSE(result);
    EXPECT_STREQ(result.error().front().id, "cancelled");
    EXPECT_EQ(readFile(file()).value(), "old");
    EXPECT_EQ(m_folder.entries(), 1U);
}

TEST_P(MeshFile, ProgressRisesToOne) {
    std::vector<double> reported;
    WorkContext context;
    context.progress = [&reported](double done) { reported.push_back(done); };
    ASSERT_TRUE(write(randomSoup(30'000, 4), context));
    EXPECT_GT(reported.size(), 3U);
    EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
    EXPECT_EQ(reported.back(), 1);
}

TEST_P(MeshFile, AMeshWithoutTrianglesIsRefused) {
    for (const TriangleMesh& mesh : {TriangleMesh{}, TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}}}) {
        const auto result = write(mesh);
        ASSERT_FALSE(result);
        EXPECT_STREQ(result.error().front().id, "nothing-left");
        EXPECT_THAT(oneLine(result.error().front()), HasSubstr(m_name + ": error: "));
    }
    EXPECT_EQ(m_folder.entries(), 0U);
}

TEST_P(MeshFile, CoordinatesThatAreNotFiniteAreRefused) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        for (int axis = 0; axis < 3; ++axis) {
            TriangleMesh mesh = tetrahedron();
            mesh.vertices[2][axis] = bad;
            const auto result = write(mesh);
            ASSERT_FALSE(result);
            EXPECT_THAT(oneLine(result.error().front()), HasSubstr("The vertex "));
        }
    }
    EXPECT_EQ(m_folder.entries(), 0U);
}

TEST_P(MeshFile, AFullDiskReportsTheBytesNeededAndKeepsTheOldFile) {
    const TriangleMesh mesh = randomSoup(100'000, 5);
    const auto whole = write(mesh);
    ASSERT_TRUE(whole);
    ASSERT_TRUE(writeFile(file(), "old"));
    const FileSizeLimit limit(1'100'000);
    const auto result = write(mesh);
    ASSERT_FALSE(result);
    const Diagnostic& error = result.error().front();
    EXPECT_STREQ(error.id, "file-unwritable");
    EXPECT_EQ(error.file, file().string());
    EXPECT_THAT(message(error), HasSubstr("File too large"));
    EXPECT_EQ(error.arguments.front(), readableBytes(static_cast<double>(whole->bytes)));
    EXPECT_EQ(readFile(file()).value(), "old");
    EXPECT_EQ(m_folder.entries(), 1U);
}

TEST_P(MeshFile, PlacesThatCannotBeWrittenAreNamed) {
    const auto folder = m_folder / ("folder" + m_name);
    std::filesystem::create_directory(folder);
    for (const auto& [target, reason] :
         {std::pair{m_folder / ("no/" + m_name), "No such file or directory"},
          {folder, "Is a directory"},
          {std::filesystem::path("/dev/full"), "not a regular file"},
          {m_folder / (std::string(300, 'n') + m_name), "File name too long"}}) {
        const auto result = writeTo(target, tetrahedron());
        ASSERT_FALSE(result) << target;
        const std::string reported = oneLine(result.error().front());
        EXPECT_THAT(reported, HasSubstr(target.string() + ": error: The file cannot be written"));
        EXPECT_THAT(reported, HasSubstr(reason));
    }
    EXPECT_EQ(m_folder.entries(), 1U);
}

TEST(Obj, HasTheLinesOfTheFormat) {
    const TemporaryFolder folder;
    TriangleMesh mesh = tetrahedron(0.1, {-1e-9, 100000.002, 1.0 / 3});
    ASSERT_TRUE(writeObj(folder / "a.obj", mesh));
    EXPECT_EQ(readFile(folder / "a.obj").value(), "# Proveout, mm\n"
                                                  "v -1e-09 100000.002 0.3333333333333333\n"
                                                  "v 0.099999999 100000.002 0.3333333333333333\n"
                                                  "v -1e-09 100000.102 0.3333333333333333\n"
                                                  "v -1e-09 100000.002 0.43333333333333335\n"
                                                  "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
}

TEST(Obj, EveryCoordinateReadsBackAsTheSameDouble) {
    const TemporaryFolder folder;
    const TriangleMesh mesh = randomSoup(20'000, 6);
    ASSERT_TRUE(writeObj(folder / "a.obj", mesh));
    std::istringstream lines(readFile(folder / "a.obj").value());
    std::string line;
    std::getline(lines, line);
    for (const Vec3& vertex : mesh.vertices) {
        ASSERT_TRUE(std::getline(lines, line) && line.starts_with("v "));
        const char* at = line.c_str() + 1;
        for (int axis = 0; axis < 3; ++axis) {
            char* end = nullptr;
            ASSERT_EQ(std::strtod(at, &end), vertex[axis]);
            at = end;
        }
    }
}

TEST(Ply, HasTheBytesOfTheFormat) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writePly(folder / "a.ply", tetrahedron(2)));
    const std::string bytes = readFile(folder / "a.ply").value();
    const std::string header = "ply\n"
                               "format binary_little_endian 1.0\n"
                               "comment Proveout, mm\n"
                               "element vertex 4\n"
                               "property double x\n"
                               "property double y\n"
                               "property double z\n"
                               "element face 4\n"
                               "property list uchar int vertex_indices\n"
                               "end_header\n";
    ASSERT_EQ(bytes.size(), header.size() + 4 * 24 + 4 * 13);
    EXPECT_EQ(bytes.substr(0, header.size()), header);
    const std::string two("\0\0\0\0\0\0\0\x40", 8); // 2.0
    EXPECT_EQ(bytes.substr(header.size() + 24, 8), two) << "x of the second vertex";
    EXPECT_EQ(bytes.substr(header.size() + 96, 13), std::string("\3\0\0\0\0\2\0\0\0\1\0\0\0", 13));
}

template<class Value>
Value valueAt(const std::string& bytes, std::size_t at) {
    Value value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

TEST(Glb, HasTheChunksOfTheFormat) {
    const TemporaryFolder folder;
    const TriangleMesh mesh = randomSoup(3'000, 7);
    ASSERT_TRUE(writeGlb(folder / "a.glb", mesh));
    const std::string bytes = readFile(folder / "a.glb").value();
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(valueAt<std::uint32_t>(bytes, 4), 2U);
    EXPECT_EQ(valueAt<std::uint32_t>(bytes, 8), bytes.size());
    const auto textBytes = valueAt<std::uint32_t>(bytes, 12);
    EXPECT_EQ(textBytes % 4, 0U);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    const auto document = nlohmann::json::parse(bytes.substr(20, textBytes));
    const std::size_t binary = 20 + textBytes + 8;
    EXPECT_EQ(valueAt<std::uint32_t>(bytes, binary - 8), bytes.size() - binary);
    EXPECT_EQ(bytes.substr(binary - 4, 4), std::string("BIN\0", 4));
    EXPECT_EQ(document["buffers"][0]["byteLength"], bytes.size() - binary);
    const auto& primitive = document["meshes"][0]["primitives"][0];
    const auto& places = document["accessors"][primitive["attributes"]["POSITION"].get<int>()];
    const auto& indices = document["accessors"][primitive["indices"].get<int>()];
    ASSERT_EQ(places["count"], mesh.vertices.size());
    ASSERT_EQ(indices["count"], 3 * mesh.triangles.size());
    const std::size_t firstIndex =
        binary + document["bufferViews"][indices["bufferView"].get<int>()]["byteOffset"].get<std::size_t>();
    Vec3 low(1e30);
    Vec3 high(-1e30);
    for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto value = valueAt<float>(bytes, binary + 12 * k + 4 * static_cast<std::size_t>(axis));
            ASSERT_EQ(value, static_cast<float>(mesh.vertices[k][axis]));
            low[axis] = std::min(low[axis], static_cast<double>(value));
            high[axis] = std::max(high[axis], static_cast<double>(value));
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(places["min"][static_cast<std::size_t>(axis)].get<float>(), static_cast<float>(low[axis]));
        EXPECT_EQ(places["max"][static_cast<std::size_t>(axis)].get<float>(), static_cast<float>(high[axis]));
    }
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
        for (std::size_t corner = 0; corner < 3; ++corner)
            ASSERT_EQ(valueAt<std::uint32_t>(bytes, firstIndex + 12 * k + 4 * corner),
                      mesh.triangles[k][corner]);
}

/// Column by column: X stays, Z goes upwards, and the part is as large in metres.
TEST(Glb, StandsUprightInMetres) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeGlb(folder / "a.glb", tetrahedron(2)));
    const std::string bytes = readFile(folder / "a.glb").value();
    const auto document = nlohmann::json::parse(bytes.substr(20, valueAt<std::uint32_t>(bytes, 12)));
    const auto matrix = document["nodes"][0]["matrix"].get<std::vector<double>>();
    const auto placed = [&](const Vec3& point) {
        Vec3 at(matrix[12], matrix[13], matrix[14]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            at += point[static_cast<int>(axis)] *
                  Vec3(matrix[4 * axis], matrix[4 * axis + 1], matrix[4 * axis + 2]);
        return at;
    };
    EXPECT_EQ(placed({1000, 0, 0}), Vec3(1, 0, 0));
    EXPECT_EQ(placed({0, 1000, 0}), Vec3(0, 0, -1));
    EXPECT_EQ(placed({0, 0, 1000}), Vec3(0, 1, 0));
}

TEST(Glb, RefusesWhatSinglePrecisionCannotHold) {
    const TemporaryFolder folder;
    TriangleMesh mesh = tetrahedron();
    mesh.vertices[1].y = 1e39;
    const auto result = writeGlb(folder / "a.glb", mesh);
    ASSERT_FALSE(result);
    EXPECT_STREQ(result.error().front().id, "stl-coordinate");
}

} // namespace
} // namespace proveout
