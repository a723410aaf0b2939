// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/npy.h"

#include <cstring>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "core/base/atomic_file.h"
#include "core/formats/npy_header.h"
#include "tests/core/formats/random_bytes.h"
#include "tests/core/temporary_folder.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

using testing::HasSubstr;

/// An NPY file assembled byte by byte, independently of the writer.
std::string npyFile(int version, const std::string& dictionary, const std::string& data) {
    std::string out = "\x93NUMPY";
    out += static_cast<char>(version);
    out += '\0';
    for (int byte = 0; byte < (version == 1 ? 2 : 4); ++byte)
        out += static_cast<char>(dictionary.size() >> (8 * byte) & 0xff);
    return out + dictionary + data;
}

template<class Value>
std::string bytesOf(const std::vector<Value>& values) {
    std::string out(values.size() * sizeof(Value), '\0');
    std::memcpy(out.data(), values.data(), out.size());
    return out;
}

std::string dictionary(const std::string& type, const std::string& shape,
                       const std::string& order = "False") {
    return "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }\n";
}

class Npy : public testing::Test {
protected:
    Result<NpyArray> read(const std::string& bytes) {
        m_folder.put("a.npy", bytes);
        return readNpy(m_folder / "a.npy");
    }
    /// The message for `bytes`, without the file's name.
    std::string error(const std::string& bytes) {
        const auto array = read(bytes);
        if (array)
            return "read";
        EXPECT_EQ(array.error().front().file, (m_folder / "a.npy").string());
        return message(array.error().front()) + " [" + array.error().front().id + "]";
    }

    TemporaryFolder m_folder;
};

TEST_F(Npy, ReadsBothTypesInEveryVersion) {
    for (int version = 1; version <= 3; ++version) {
        const auto singles =
            read(npyFile(version, dictionary("<f4", "(2, 3)"), bytesOf<float>({1, 2, 3, 4, 5.5F, -6})));
        ASSERT_TRUE(singles) << version;
        EXPECT_EQ(singles->rows, 2);
        EXPECT_EQ(singles->columns, 3);
        EXPECT_EQ(singles->values, (std::vector<double>{1, 2, 3, 4, 5.5, -6}));
        const auto doubles =
            read(npyFile(version, dictionary("<f8", "(1L, 2L)"), bytesOf<double>({0.1, -3e30})));
        ASSERT_TRUE(doubles) << version;
        EXPECT_EQ(doubles->values, (std::vector<double>{0.1, -3e30}));
    }
}

TEST_F(Npy, ReadsDictionariesInAnyOrderAndSpacing) {
    EXPECT_TRUE(
        read(npyFile(1, "{\"shape\":(1,1),\"descr\":\"<f4\",\"fortran_order\":False}", bytesOf<float>({1}))));
}

TEST_F(Npy, NamesWhatItCannotRead) {
    const std::string one = bytesOf<float>({1});
    EXPECT_THAT(error("PK\3\4"), HasSubstr("This is not an NPY file. [not-npy]"));
    EXPECT_THAT(error(""), HasSubstr("[not-npy]"));
    EXPECT_THAT(error("\x93NUMPY"), HasSubstr("cannot be read at byte 6. [npy-header]"));
    EXPECT_THAT(error(npyFile(4, dictionary("<f4", "(1, 1)"), one)), HasSubstr("version 4"));
    EXPECT_THAT(error(npyFile(1, dictionary(">f4", "(1, 1)"), one)), HasSubstr("\">f4\""));
    EXPECT_THAT(error(npyFile(1, dictionary("<i4", "(1, 1)"), one)), HasSubstr("\"<i4\""));
    EXPECT_THAT(error(npyFile(1, dictionary("<f4", "(1, 1)", "True"), one)), HasSubstr("Fortran order"));
    EXPECT_THAT(error(npyFile(1, dictionary("<f4", "(1,)"), one)), HasSubstr("(1,)"));
    EXPECT_THAT(error(npyFile(1, dictionary("<f4", "()"), one)), HasSubstr("()"));
    EXPECT_THAT(error(npyFile(1, dictionary("<f4", "(1, 1, 1)"), one)), HasSubstr("(1, 1, 1)"));
    EXPECT_THAT(error(npyFile(1, dictionary("<f4", "(0, 5)"), one)), HasSubstr("(0, 5)"));
    EXPECT_THAT(error(npyFile(1, dictionary("<f4", "(-1, 5)"), one)), HasSubstr("[npy-header]"));
    EXPECT_THAT(error(npyFile(1, dictionary("<f4", "(2, 2)"), one)), HasSubstr("specifies (2, 2) values"));
    EXPECT_THAT(error(npyFile(1, "{'descr': '<f4'}", one)), HasSubstr("[npy-header]"));
    EXPECT_THAT(error(npyFile(1, "{'descr': [('a', '<f4')], 'fortran_order': False, 'shape': (1, 1)}", one)),
                HasSubstr("byte 20. [npy-header]"));
}

TEST_F(Npy, SizesBeyondSixtyFourBitsAreRefused) {
    const std::string one = bytesOf<float>({1});
    // 2^32 × 2^32 values is 0 modulo 2^64.
    EXPECT_THAT(error(npyFile(1, dictionary("<f4", "(4294967296, 4294967296)"), one)),
                HasSubstr("[npy-cut-off]"));
    EXPECT_THAT(error(npyFile(1, dictionary("<f4", "(99999999999999999999, 1)"), one)),
                HasSubstr("[npy-header]"));
    EXPECT_THAT(error(npyFile(2, dictionary("<f4", "(1, 1)"), one).substr(0, 40)),
                HasSubstr("[npy-cut-off]"));
}

TEST_F(Npy, NamesThePlaceOfAValueThatIsNoHeight) {
    const auto nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(error(npyFile(1, dictionary("<f4", "(2, 2)"), bytesOf<float>({1, 2, 3, nan}))),
                HasSubstr("row 1, column 1 (counted from 0) is nan"));
    EXPECT_THAT(error(npyFile(1, dictionary("<f8", "(1, 2)"), bytesOf<double>({1, 1e39}))),
                HasSubstr("row 0, column 1 (counted from 0) is 1e+39"));
}

TEST_F(Npy, WritesWhatItReads) {
    NpyArray array{3, 4, {}};
    for (int i = 0; i < 12; ++i)
        array.values.push_back(static_cast<double>(static_cast<float>(i) * -1.7F));
    ASSERT_TRUE(writeNpy(m_folder / "b.npy", array));
    const auto back = readNpy(m_folder / "b.npy");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->rows, 3);
    EXPECT_EQ(back->columns, 4);
    EXPECT_EQ(back->values, array.values);
    const auto bytes = readFile(m_folder / "b.npy").value();
    EXPECT_EQ(bytes.size() % 64, 48U) << "the values start at a multiple of 64";
    EXPECT_EQ(bytes.substr(10, 64), "{'descr': '<f4', 'fortran_order': False, 'shape': (3, 4), }     ");
    EXPECT_FALSE(writeNpy(m_folder / "missing/b.npy", array));
}

/// A damaged file is refused or read; if read, it has the announced size and only finite values.
TEST_F(Npy, SurvivesDamage) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const std::string good = npyFile(1, dictionary("<f4", "(2, 3)"), bytesOf<float>({1, 2, 3, 4, 5, 6}));
    for (int round = 0; round < 2000; ++round) {
        const auto array = read(damaged(good, random));
        if (!array)
            continue;
        ASSERT_EQ(array->values.size(), static_cast<std::size_t>(array->rows) * std::size_t(array->columns));
        for (const double value : array->values)
            ASSERT_TRUE(std::isfinite(value));
    }
}

TEST(NpyMaps, ReadsTheMapsThatNumPyWrote) {
    const std::filesystem::path maps = std::filesystem::path(PROVEOUT_SHARED_DIR) / "maps";
    if (!std::filesystem::exists(maps / "mo01.npy"))
        GTEST_SKIP() << maps << " is not there";
    const auto map = readNpy(maps / "mo01.npy");
    ASSERT_TRUE(map) << oneLine(map.error().front());
    EXPECT_EQ(map->columns, 1401);
    EXPECT_EQ(map->rows, 1001);
    EXPECT_LE(*std::max_element(map->values.begin(), map->values.end()), 0);
}

} // namespace
} // namespace proveout
