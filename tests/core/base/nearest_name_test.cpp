// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/nearest_name.h"

#include <array>
#include <gtest/gtest.h>
#include <string>

namespace proveout {
namespace {

constexpr std::array<std::string_view, 6> kNames{"grid", "stock", "tools", "blockDelete", "height", "l"};

TEST(NearestName, ForgivesOneSlipInAShortWord) {
    for (const char* grid : {"gri", "gridd", "gird", "grod", "GRID", "Grid"})
        EXPECT_EQ(nearestName(grid, kNames), "grid") << grid;
    EXPECT_EQ(nearestName("stack", kNames), "stock");
    EXPECT_EQ(nearestName("hight", kNames), "height");
    EXPECT_EQ(nearestName("block_delete", kNames), "blockDelete");
}

TEST(NearestName, TakesTheNearest) {
    constexpr std::array<std::string_view, 3> kAlike{"period1", "period", "periods"};
    EXPECT_EQ(nearestName("perio", kAlike), "period");
}

TEST(NearestName, NamesNothingThatIsFarOff) {
    for (const char* word : {"", "g", "k", "gr", "spacing", "dirg", "color"})
        EXPECT_EQ(nearestName(word, kNames), "") << word;
    EXPECT_EQ(nearestName(std::string(10'000'000, 'g'), kNames), "");
    EXPECT_EQ(nearestName("grid", {}), "");
}

} // namespace
} // namespace proveout
