// SPDX-License-Identifier: GPL-3.0-or-later
// Saved stocks: exact to the last bit, and other content that a file with that extension may have.
#include "core/formats/stock_file.h"

#include <array>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "core/base/atomic_file.h"
#include "core/formats/npy_header.h"
#include "core/formats/zip_file.h"
#include "core/formats/zip_reader.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

ZMapSnapshot randomMap(std::uint_fast32_t seed, const StockBox& stock, double spacing) {
    std::mt19937 random(seed);
    ZMap zmap(stock, makeGrid(stock, spacing).value());
    std::uniform_real_distribution<float> height(zmap.floor(), 0);
    for (std::size_t index = 0; index < zmap.tileCount(); ++index) {
        Tile& tile = zmap.tileForWriting(index);
        const IndexRect rect = zmap.tileRect(index);
        for (int j = 0; j < rect.height(); ++j)
            for (int i = 0; i < rect.width(); ++i)
                tile.at(i, j) = random() % 3 == 0 ? zmap.floor() : height(random);
        tile.refreshMaximum();
    }
    return zmap.snapshot();
}

bool sameBits(const ZMapSnapshot& a, const ZMapSnapshot& b) {
    if (!(a.stock() == b.stock() && a.grid() == b.grid() && a.tileCount() == b.tileCount()))
        return false;
    for (std::size_t index = 0; index < a.tileCount(); ++index)
        if (std::memcmp(a.tile(index)->heights.data(), b.tile(index)->heights.data(),
                        sizeof(a.tile(index)->heights)) != 0 ||
            a.tile(index)->maximum < *std::ranges::max_element(b.tile(index)->heights))
            return false;
    return true;
}

class StockFile : public testing::Test {
protected:
    [[nodiscard]] static std::string idOf(const std::filesystem::path& from) {
        const auto read = readStock(from);
        if (read)
            return {};
        EXPECT_EQ(read.error().front().file, from.string());
        return read.error().front().id;
    }
    /// An archive of these entries with valid checksums.
    void writeZip(const std::vector<std::pair<const char*, std::string>>& entries) const {
        ZipFile zip(file, false);
        for (const auto& [name, bytes] : entries) {
            zip.beginEntry(name);
            zip.write(bytes);
        }
        ASSERT_TRUE(zip.commit());
    }
    /// Writes without the flush of writeFile(), which is slow.
    void put(const std::string& bytes) const { std::ofstream(file, std::ios::binary) << bytes; }
    static std::string description(const std::string& size = "\"width\":4,\"depth\":3,\"height\":2",
                                   const std::string& points = "\"nx\":5,\"ny\":4",
                                   const std::string& head = "\"proveoutStock\":2",
                                   const std::string& position = "\"minX\":0,\"minY\":0,\"topZ\":0") {
        return "{" + head + "," + position + "," + size + ",\"spacing\":1," + points + "}";
    }
    static std::string heights(int nx, int ny, float value) {
        std::string bytes = npyHeader(ny, nx, "<f4");
        for (int k = 0; k < nx * ny; ++k)
            bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
        return bytes;
    }

    TemporaryFolder folder;
    std::filesystem::path file = folder.path() / "a.pvstock";
};

TEST_F(StockFile, ComesBackToTheLastBit) {
    for (std::uint_fast32_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(fmt::format("seed {}", seed));
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> side(1, 90);
        const StockBox stock{
            {side(random) - 45, side(random), -side(random)}, side(random), side(random), side(random)};
        const double spacing = 0.2 + side(random) / 200;
        const ZMapSnapshot map = randomMap(seed, stock, spacing);
        const StockProvenance provenance{"teil ä.nc", seed * 1'000'000'007U, 12345, seed % 2 == 0};
        ASSERT_TRUE(writeStock(file, map, spacing, provenance));
        const auto read = readStock(file);
        ASSERT_TRUE(read) << message(read.error().front());
        EXPECT_TRUE(sameBits(read->zmap, map));
        EXPECT_EQ(read->spacing, spacing);
        EXPECT_EQ(read->provenance, provenance);
        const std::string bytes = readFile(file).value();
        ASSERT_TRUE(writeStock(file, read->zmap, read->spacing, read->provenance));
        EXPECT_EQ(readFile(file).value(), bytes);
    }
}

TEST_F(StockFile, ThePositionHasFieldsOfItsOwnNames) {
    const ZMapSnapshot map = randomMap(3, {{-7, 4.5, 12}, 20, 10, 5}, 1);
    ASSERT_TRUE(writeStock(file, map, 1, {}));
    ZipReader zip;
    ASSERT_TRUE(zip.open(file));
    ASSERT_EQ(zip.nextEntry(), "stock.json");
    std::string text(1000, '\0');
    text.resize(zip.read(text.data(), text.size()));
    for (const char* field : {"\"minX\": -7.0", "\"minY\": 4.5", "\"topZ\": 12.0"})
        EXPECT_NE(text.find(field), std::string::npos) << text;
    EXPECT_EQ(text.find("corner"), std::string::npos) << text;
}

TEST_F(StockFile, FilesOfFormat1HaveThePositionAsACorner) {
    const auto described = [&](const std::string& position) {
        writeZip({{"stock.json", description("\"width\":4,\"depth\":3,\"height\":2", "\"nx\":5,\"ny\":4",
                                             "\"proveoutStock\":1", position)},
                  {"heights.npy", heights(5, 4, -1)}});
    };
    described("\"corner\":[-7,4.5,12]");
    const auto read = readStock(file);
    ASSERT_TRUE(read) << message(read.error().front());
    EXPECT_EQ(read->zmap.stock().corner, Vec3(-7, 4.5, 12));
    for (const char* wrong : {"\"corner\":[0,0,0],\"topZ\":0", "\"minX\":0,\"minY\":0", "\"comment\":0"}) {
        described(wrong);
        EXPECT_EQ(idOf(file), "job-field") << wrong;
    }
}

TEST_F(StockFile, EveryCutIsNoticed) {
    const ZMapSnapshot map = randomMap(3, {{0, 0, 0}, 20, 10, 5}, 1);
    ASSERT_TRUE(writeStock(file, map, 1, {}));
    const std::string whole = readFile(file).value();
    for (std::size_t length = 0; length < whole.size(); length += 7) {
        put(whole.substr(0, length));
        EXPECT_NE(idOf(file), "") << length;
    }
}

TEST_F(StockFile, DamageIsNoticedOrHarmless) {
    const ZMapSnapshot map = randomMap(4, {{0, 0, 0}, 20, 10, 5}, 1);
    ASSERT_TRUE(writeStock(file, map, 1, {}));
    const std::string whole = readFile(file).value();
    std::mt19937 random(11);
    int noticed = 0;
    for (int k = 0; k < 3000; ++k) {
        std::string damaged = whole;
        const auto place = random() % damaged.size();
        damaged[place] = static_cast<char>(damaged[place] ^ (1 << random() % 8));
        put(damaged);
        const auto read = readStock(file);
        noticed += read ? 0 : 1;
        // Data outside the entries, e.g. their times, has no effect.
        if (read) {
            EXPECT_TRUE(sameBits(read->zmap, map)) << place;
        }
    }
    EXPECT_GT(noticed, 2000);
}

TEST_F(StockFile, OtherFilesAreNamedWhatTheyAre) {
    ASSERT_TRUE(writeFile(file, "hello"));
    EXPECT_EQ(idOf(file), "file-not-zip");
    ASSERT_TRUE(writeFile(file, ""));
    EXPECT_EQ(idOf(file), "file-not-zip");
    EXPECT_EQ(idOf(folder.path()), "file-not-regular");
    EXPECT_EQ(idOf(folder.path() / "none"), "file-unreadable");
    writeZip({{"other.json", "{}"}});
    EXPECT_EQ(idOf(file), "not-a-stock");
    writeZip({{"stock.json", "{"}});
    EXPECT_NE(idOf(file), "");
    writeZip({{"stock.json", std::string(1'000'000, ' ')}});
    EXPECT_EQ(idOf(file), "stock-file-broken"); // more than any valid description has
}

TEST_F(StockFile, WhatDoesNotFitIsRefused) {
    const std::string good = heights(5, 4, -1);
    writeZip({{"stock.json", description()}, {"heights.npy", good}});
    EXPECT_EQ(idOf(file), "");
    writeZip({{"stock.json", description()}});
    EXPECT_EQ(idOf(file), "stock-file-broken");
    writeZip({{"stock.json", description()}, {"heights.npy", heights(4, 5, -1)}});
    EXPECT_EQ(idOf(file), "stock-heights-form");
    writeZip({{"stock.json", description()}, {"heights.npy", good.substr(0, good.size() - 1)}});
    EXPECT_EQ(idOf(file), "stock-file-broken");
    writeZip({{"stock.json", description()}, {"heights.npy", good + "x"}});
    EXPECT_EQ(idOf(file), "stock-file-broken");
    writeZip({{"stock.json", description("\"width\":4,\"depth\":3,\"height\":2", "\"nx\":6,\"ny\":4")},
              {"heights.npy", good}});
    EXPECT_EQ(idOf(file), "stock-grid-differs");
    writeZip({{"stock.json", description("\"width\":4,\"depth\":3,\"height\":2", "\"nx\":5,\"ny\":4",
                                         "\"proveoutStock\":5")},
              {"heights.npy", good}});
    EXPECT_EQ(idOf(file), "stock-newer");
    for (const char* size :
         {"\"width\":-4,\"depth\":3,\"height\":2", "\"width\":1e9,\"depth\":3,\"height\":2",
          "\"width\":\"4\",\"depth\":3,\"height\":2", "\"depth\":3,\"height\":2"}) {
        writeZip({{"stock.json", description(size)}, {"heights.npy", good}});
        EXPECT_EQ(idOf(file), "job-field") << size;
    }
}

TEST_F(StockFile, HeightsThatAreNoneAreRefused) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(), 0.001F, -2.001F}) {
        std::string bytes = heights(5, 4, -1);
        std::memcpy(bytes.data() + bytes.size() - sizeof bad, &bad, sizeof bad);
        writeZip({{"stock.json", description()}, {"heights.npy", bytes}});
        const auto read = readStock(file);
        ASSERT_FALSE(read) << bad;
        EXPECT_EQ(read.error().front().id, std::string("stock-height-bad"));
        EXPECT_EQ(read.error().front().arguments, (std::vector<Argument>{"3", "4"}));
    }
}

TEST_F(StockFile, MemoryIsAskedForFirst) {
    // Inflating the zeros would give as many points as an index can address; their z-map needs more memory
    // than is available.
    writeZip({{"stock.json",
               description("\"width\":46000,\"depth\":46000,\"height\":2", "\"nx\":46001,\"ny\":46001")},
              {"heights.npy", heights(5, 4, -1)}});
    const std::string id = idOf(file);
    EXPECT_TRUE(id == "grid-needs-too-much-memory" || id == "stock-heights-form") << id;
    // A decompression bomb: the entry contains much more than the description states.
    writeZip(
        {{"stock.json", description()}, {"heights.npy", heights(5, 4, -1) + std::string(40'000'000, '\0')}});
    EXPECT_EQ(idOf(file), "stock-file-broken");
}

TEST_F(StockFile, AnUnwritablePlaceLeavesNothing) {
    const ZMapSnapshot map = randomMap(3, {{0, 0, 0}, 20, 10, 5}, 1);
    EXPECT_FALSE(writeStock(folder.path() / "no" / "a.pvstock", map, 1, {}));
    EXPECT_EQ(writeStock(file, map, 1, {"\xff.nc"}).error().front().id, std::string("stock-not-utf8"));
    EXPECT_FALSE(std::filesystem::exists(file));
}

} // namespace
} // namespace proveout
