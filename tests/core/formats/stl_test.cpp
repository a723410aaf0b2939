// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/stl.h"

#include <algorithm>
#include <chrono>
#include <clocale>
#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iostream>
#include <limits>
#include <random>

#include "core/base/atomic_file.h"
#include "core/formats/formats.h"
#include "tests/core/formats/meshes.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

using testing::HasSubstr;

using test::randomSoup;
using test::tetrahedron;

/// Stored in memory on purpose, because g++ 12 at -O2 removes a pair of vectorised conversions to float and
/// back.
double inFloat(double value) {
    const volatile float rounded = static_cast<float>(value);
    return static_cast<double>(rounded);
}

Vec3 inFloat(const Vec3& point) {
    return {inFloat(point.x), inFloat(point.y), inFloat(point.z)};
}

/// Compares corner by corner: the file contains the triangles in the same sequence.
void expectSameTriangles(const TriangleMesh& got, const TriangleMesh& wanted) {
    ASSERT_EQ(got.triangles.size(), wanted.triangles.size());
    for (std::size_t t = 0; t < got.triangles.size(); ++t)
        for (std::size_t corner = 0; corner < 3; ++corner)
            ASSERT_EQ(got.vertices[got.triangles[t][corner]],
                      inFloat(wanted.vertices[wanted.triangles[t][corner]]));
}

class Stl : public testing::TestWithParam<StlEncoding> {
protected:
    TemporaryFolder m_folder;
};

INSTANTIATE_TEST_SUITE_P(Encodings, Stl, testing::Values(StlEncoding::binary, StlEncoding::ascii),
                         [](const auto& encoding) {
                             return encoding.param == StlEncoding::binary ? "binary" : "ascii";
                         });

TEST_P(Stl, ReadsWhatItWrites) {
    const auto mesh = randomSoup(20'000, 1); // more than one batch
    const auto written = writeStl(m_folder / "a.stl", mesh, GetParam());
    ASSERT_TRUE(written);
    EXPECT_EQ(written->triangles, 20'000U);
    EXPECT_EQ(written->bytes, std::filesystem::file_size(m_folder / "a.stl"));
    const auto back = readStlContents(m_folder / "a.stl");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->encoding, GetParam());
    EXPECT_EQ(back->notFinite + back->degenerate + back->opposedNormals, 0U);
    expectSameTriangles(back->mesh, mesh);
}

TEST_P(Stl, WeldsByExactCoordinates) {
    TriangleMesh mesh = tetrahedron();
    mesh.vertices[0].x = -0.0; // equal to 0 though its bits differ
    for (std::uint32_t i = 0; i < 3; ++i) {
        mesh.vertices.push_back(mesh.vertices[mesh.triangles[3][i]]);
        mesh.triangles[3][i] = 4 + i; // the last face has vertices of its own
    }
    mesh.vertices[4].x = 0.0;
    ASSERT_TRUE(writeStl(m_folder / "a.stl", mesh, GetParam()));
    EXPECT_EQ(readStl(m_folder / "a.stl")->vertices.size(), 4U);
}

TEST_P(Stl, RefusesWhatTheFormatCannotHold) {
    const auto idOf = [this](const TriangleMesh& mesh) {
        const auto result = writeStl(m_folder / "a.stl", mesh, GetParam());
        return result ? std::string("written") : std::string(result.error().front().id);
    };
    EXPECT_EQ(idOf({}), "nothing-left");
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e39, -1e39}) {
        for (int axis = 0; axis < 3; ++axis) {
            auto mesh = tetrahedron();
            mesh.vertices[2][axis] = bad;
            EXPECT_EQ(idOf(mesh), "stl-coordinate") << bad << " on axis " << axis;
        }
    }
    EXPECT_EQ(m_folder.entries(), 0U);
}

TEST_P(Stl, RefusesMeshesThatRoundingCollapses) {
    const auto written = writeStl(m_folder / "a.stl", tetrahedron(0.01, Vec3(1e6, 0, 0)), GetParam());
    ASSERT_FALSE(written);
    EXPECT_STREQ(written.error().front().id, "stl-too-coarse");
    EXPECT_EQ(written.error().front().arguments.front(), "2"); // the two faces with the edge along x
    EXPECT_EQ(m_folder.entries(), 0U);
}

TEST_P(Stl, RefusesTrianglesThatRoundingTurnsOver) {
    // The step of float32 is 1/128 mm there. The second point is left of the line between the others, and
    // right of it after all three are rounded.
    const TriangleMesh mesh{{{1e5 + 0.0038, 0, 0}, {1e5 + 0.0055, 25, 0}, {1e5 + 0.0118, 100, 0}},
                            {{0, 2, 1}}};
    const auto written = writeStl(m_folder / "a.stl", mesh, GetParam());
    ASSERT_FALSE(written);
    EXPECT_STREQ(written.error().front().id, "stl-too-coarse");
    EXPECT_THAT(written.error().front().arguments, testing::ElementsAre("1", "0", exactMeshEndings()));
    EXPECT_EQ(m_folder.entries(), 0U);
}

TEST_P(Stl, RefusesVerticesThatRoundingMakesOne) {
    TriangleMesh two = tetrahedron(1, {1e5, 0, 0});
    const TriangleMesh other = tetrahedron(-1, {1e5 + 0.001, 0, 0});
    two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& [a, b, c] : other.triangles)
        two.triangles.push_back({a + 4, b + 4, c + 4});
    const auto written = writeStl(m_folder / "a.stl", two, GetParam());
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().front().arguments, testing::ElementsAre("0", "1", exactMeshEndings()));
    two.vertices[4].x = 1e5; // an identical point is not a rounding effect
    EXPECT_TRUE(writeStl(m_folder / "a.stl", two, GetParam()));
}

TEST(StlBinary, HasTheBytesOfTheFormat) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeStl(folder / "a.stl", tetrahedron(2), StlEncoding::binary));
    const auto bytes = readFile(folder / "a.stl").value();
    ASSERT_EQ(bytes.size(), 84U + 4 * 50);
    EXPECT_FALSE(bytes.starts_with("solid"));
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, 4);
    EXPECT_EQ(count, 4U);
    std::array<float, 12> first{};
    std::memcpy(first.data(), bytes.data() + 84, sizeof first);
    EXPECT_THAT(first, testing::ElementsAre(0, 0, -1, 0, 0, 0, 0, 2, 0, 2, 0, 0))
        << "normal outwards, then corners";
    EXPECT_EQ(bytes.substr(84 + 48, 2), std::string(2, '\0'));
}

TEST(StlAscii, HasADecimalPointInEveryLocale) {
    const TemporaryFolder folder;
    const std::string old = std::setlocale(LC_ALL, nullptr);
    const char* comma = nullptr;
    for (const char* wanted : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE"})
        comma = comma != nullptr ? comma : std::setlocale(LC_ALL, wanted);
    const auto written = writeStl(folder / "a.stl", tetrahedron(0.1), StlEncoding::ascii);
    const auto back = readStl(folder / "a.stl");
    std::setlocale(LC_ALL, old.c_str());
    ASSERT_TRUE(written);
    EXPECT_EQ(readFile(folder / "a.stl").value().substr(0, 99), "solid proveout\n"
                                                                "facet normal 0 0 -1\n"
                                                                " outer loop\n"
                                                                "  vertex 0 0 0\n"
                                                                "  vertex 0 0.1 0\n"
                                                                "  vertex 0.1 0 0\n"
                                                                " en");
    ASSERT_TRUE(back);
    expectSameTriangles(*back, tetrahedron(0.1));
    if (comma == nullptr)
        GTEST_SKIP() << "no locale with a decimal comma is installed; checked in \"C\" only";
}

/// Reports the speed, which is far too high to delay an export noticeably.
TEST(StlBinary, WritesMillionsOfTrianglesASecond) {
    const TemporaryFolder folder;
    const auto mesh = randomSoup(1'000'000, 4);
    const auto start = std::chrono::steady_clock::now();
    ASSERT_TRUE(writeStl(folder / "a.stl", mesh, StlEncoding::binary));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const auto readStart = std::chrono::steady_clock::now();
    ASSERT_TRUE(readStl(folder / "a.stl"));
    const std::chrono::duration<double> readSeconds = std::chrono::steady_clock::now() - readStart;
    std::cout << "binary STL: " << 1 / seconds.count() << " M triangles/s written, "
              << 1 / readSeconds.count() << " read\n";
    RecordProperty("writtenMillionPerSecond", std::to_string(1 / seconds.count()));
    EXPECT_LT(seconds.count(), 5) << "two orders slower than measured at rest";
}

} // namespace
} // namespace proveout
