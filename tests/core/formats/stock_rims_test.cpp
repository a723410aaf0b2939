// SPDX-License-Identifier: GPL-3.0-or-later
// Rims of saved stock: exact to the last bit, and other bytes in their place.
#include "core/formats/stock_rims.h"

#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/formats/npy_header.h"
#include "core/formats/stock_file.h"
#include "tests/core/random_rims.h"
#include "tests/core/random_test.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

class StockRims : public RandomTest {
protected:
    TemporaryFolder folder;
    std::filesystem::path file = folder.path() / "a.pvstock";

    static ZMapSnapshot mapOf(const StockBox& stock) {
        return ZMap(stock, makeGrid(stock, 1).value()).snapshot();
    }
    /// A stock of 5 × 4 points with these bytes as rims.
    void put(const std::string& bytes, std::size_t count, const char* schema = "3") const {
        const std::string described = fmt::format(
            R"({{"proveoutStock":{},"minX":0,"minY":0,"topZ":0,"width":4,"depth":3,"height":2,"spacing":1,"nx":5,"ny":4,"rims":{}}})",
            schema, count);
        ZipFile zip(file, false);
        zip.beginEntry("stock.json");
        zip.write(described);
        zip.beginEntry("heights.npy");
        zip.write(npyHeader(4, 5, "<f4") + std::string(80, '\0'));
        zip.beginEntry("rims.npy");
        zip.write(npyHeader(static_cast<int>(count), 1, "|V24") + bytes);
        ASSERT_TRUE(zip.commit());
    }
    [[nodiscard]] std::string idOf() const {
        const auto read = readStock(file);
        return read ? std::string() : read.error().front().id;
    }
    template<class Value>
    static std::string with(std::string bytes, std::size_t at, Value value) {
        std::memcpy(bytes.data() + at, &value, sizeof value);
        return bytes;
    }
    /// Edge 3 of tile 0, and a wall from 0 to -1.
    static std::string aRim() {
        std::string bytes(24, '\0');
        bytes = with(bytes, 4, std::uint16_t{3});
        return with(bytes, 16, -1.0F);
    }
    /// On the same edge.
    static std::string aRib() { return with(with(std::string(24, '\0'), 4, std::uint16_t{3}), 10, '\3'); }
    static std::string anUnknownTile() { return with(std::string(24, '\0'), 10, '\4'); }
};

TEST_F(StockRims, ComeBackToTheLastBit) {
    for (int k = 0; k < roundsOf(6); ++k) {
        ZMapSnapshot map = mapOf({{-7, 3, 1}, 60.0 + 40 * k, 150.0 - 20 * k, 7});
        RimMap rims = randomRims(random, map);
        for (std::size_t tile = 0; tile < map.tileCount(); ++tile) {
            if (random() % 2 == 0)
                continue;
            RimTile unknown = rims[tile] == nullptr ? RimTile() : *rims[tile];
            unknown.areUnknown = true;
            rims.edit(tile) = std::make_shared<const RimTile>(std::move(unknown));
        }
        map.setRims(rims);
        ASSERT_TRUE(writeStock(file, map, 1, {}));
        const auto read = readStock(file);
        ASSERT_TRUE(read) << message(read.error().front());
        EXPECT_TRUE(sameRims(read->zmap.rims(), map.rims()));
        const std::string bytes = readFile(file).value();
        ASSERT_TRUE(writeStock(file, read->zmap, 1, {}));
        EXPECT_EQ(readFile(file).value(), bytes);
    }
}

/// The least that the file needs, so that an older Proveout reads it if it can.
TEST_F(StockRims, TheFormatIsTheOldestThatHasAll) {
    ZMapSnapshot map = mapOf({{0, 0, 0}, 80, 30, 7});
    const auto schemaOf = [&](const RimTile& tile) {
        RimMap rims(map.tileCount());
        rims.edit(1) = std::make_shared<const RimTile>(tile);
        map.setRims(std::move(rims));
        EXPECT_TRUE(writeStock(file, map, 1, {}));
        const auto read = readStock(file);
        EXPECT_TRUE(read && (tile.empty() || sameRims(read->zmap.rims(), map.rims())));
        ZipReader zip;
        EXPECT_TRUE(zip.open(file) && zip.nextEntry() == "stock.json");
        std::string text(4096, '\0');
        text.resize(zip.read(text.data(), text.size()));
        return text.substr(0, text.find(','));
    };
    const Rim rim{RimEdge{3, 2, true}.index(), 5, 5, RimSides::both, 0, -1, 0, 32767};
    EXPECT_NE(schemaOf({}).find(": 2"), std::string::npos);
    EXPECT_NE(schemaOf({{rim}}).find(": 3"), std::string::npos);
    EXPECT_NE(schemaOf({{rim}, false, {rim.edge}}).find(": 4"), std::string::npos);
    EXPECT_NE(schemaOf({{}, true}).find(": 4"), std::string::npos);
}

TEST_F(StockRims, WithoutThemTheFileIsAsBefore) {
    ZMapSnapshot map = mapOf({{0, 0, 0}, 80, 30, 7});
    ASSERT_TRUE(writeStock(file, map, 1, {}));
    const std::string before = readFile(file).value();
    EXPECT_TRUE(readStock(file)->zmap.rims().empty());
    map.setRims(RimMap(map.tileCount()));
    ASSERT_TRUE(writeStock(file, map, 1, {}));
    EXPECT_EQ(readFile(file).value(), before);
}

TEST_F(StockRims, EveryCutIsNoticed) {
    ZMapSnapshot map = mapOf({{0, 0, 0}, 20, 10, 5});
    map.setRims(RimMap(1, randomRims(random, map, 0)));
    ASSERT_TRUE(writeStock(file, map, 1, {}));
    const std::string whole = readFile(file).value();
    for (std::size_t length = 0; length < whole.size(); length += 7) {
        std::ofstream(file, std::ios::binary) << whole.substr(0, length);
        EXPECT_NE(idOf(), "") << length;
    }
}

TEST_F(StockRims, WhatIsNoRimOfTheStockIsRefused) {
    const std::string good = aRim();
    put(good, 1);
    EXPECT_EQ(idOf(), "");
    put(good + with(good, 4, std::uint16_t{4}), 2);
    EXPECT_EQ(idOf(), "");
    put(good + aRib(), 2, "4");
    EXPECT_EQ(idOf(), "");
    put(anUnknownTile() + aRib(), 2, "4");
    EXPECT_EQ(idOf(), "");
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    const std::vector<std::pair<const char*, std::string>> bad{
        {"tile", with(good, 0, std::uint32_t{1})},
        {"far tile", with(good, 0, std::uint32_t{0xffffffff})},
        {"edge beyond a side", with(good, 4, std::uint16_t{2 * 4})}, // from the last point of a row
        {"edge beyond the last row", with(good, 4, std::uint16_t{(3 * 64) * 2 + 1})},
        {"edge outside", with(good, 4, std::uint16_t{2 * 5 + 1})},
        {"edge of no tile", with(good, 4, std::uint16_t{0xffff})},
        {"sides", with(good, 10, std::uint8_t{5})},
        {"rib with a height", with(good, 10, std::uint8_t{3})},
        {"rib with a place", with(aRib(), 6, std::uint16_t{1})},
        {"rib with a normal", with(aRib(), 22, std::int16_t{1})},
        {"rib with a height that is none", with(aRib(), 12, kNaN)},
        {"rib of no tile", with(aRib(), 0, std::uint32_t{1})},
        {"rib on no edge", with(aRib(), 4, std::uint16_t{2 * 4})},
        {"rib, unused", with(aRib(), 11, std::uint8_t{1})},
        {"unknown tile with a height", with(good, 10, std::uint8_t{4})},
        {"unknown tile with an edge", with(anUnknownTile(), 4, std::uint16_t{3})},
        {"unknown tile that is none", with(anUnknownTile(), 0, std::uint32_t{1})},
        {"unused", with(good, 11, std::uint8_t{1})},
        {"high top", with(good, 12, 0.01F)},
        {"no top", with(good, 12, kNaN)},
        {"low bottom", with(good, 16, -2.01F)},
        {"no bottom", with(good, 16, -std::numeric_limits<float>::infinity())},
        {"normal", with(good, 20, std::int16_t{-32768})},
        {"normal", with(good, 22, std::int16_t{-32768})}};
    for (const auto& [what, bytes] : bad) {
        put(bytes, 1);
        EXPECT_EQ(idOf(), "stock-file-broken") << what;
    }
}

TEST_F(StockRims, WhatIsNotInOrderOrNotAsManyIsRefused) {
    const std::string good = aRim();
    const std::string next = with(good, 4, std::uint16_t{4});
    for (const std::string& bytes :
         {next + good, good + good, good, good + next + "x", good + next + next, aRib() + good,
          aRib() + aRib(), good + anUnknownTile(), anUnknownTile() + anUnknownTile()}) {
        put(bytes, 2);
        EXPECT_EQ(idOf(), "stock-file-broken");
    }
    put(good, 101); // more than the edges of 20 points have
    EXPECT_EQ(idOf(), "stock-file-broken");
    put(good, 3'000'000'000);
    EXPECT_EQ(idOf(), "job-field");
    put(good, 1, "5");
    EXPECT_EQ(idOf(), "stock-newer");
}

TEST_F(StockRims, DamageIsNoticedOrHarmless) {
    ZMapSnapshot map = mapOf({{0, 0, 0}, 20, 10, 5});
    map.setRims(RimMap(1, randomRims(random, map, 0)));
    ASSERT_TRUE(writeStock(file, map, 1, {}));
    const std::string whole = readFile(file).value();
    for (int k = 0; k < roundsOf(200); ++k) {
        std::string damaged = whole;
        const auto place = random() % damaged.size();
        damaged[place] = static_cast<char>(damaged[place] ^ (1 << random() % 8));
        std::ofstream(file, std::ios::binary) << damaged;
        if (const auto read = readStock(file)) {
            EXPECT_TRUE(sameRims(read->zmap.rims(), map.rims())) << place;
        }
    }
}

} // namespace
} // namespace proveout
