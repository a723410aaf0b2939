// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/zmap/stock.h"

namespace proveout {
namespace {

TEST(ParseStockSize, ReadsThreeSides) {
    EXPECT_EQ(parseStockSize("140x100x30.5").value(), Vec3(140, 100, 30.5));
    EXPECT_EQ(parseStockSize(" 1e2 X 80 x 5 ").value(), Vec3(100, 80, 5));
}

TEST(ParseStockSize, RefusesAnythingElse) {
    for (const char* text : {"", "140", "140x100", "140x100x", "140x100x30x1", "140x100x0", "-1x100x30",
                             "axbxc", "nanx1x1", "1x1xinf", "140,100,30", "1x1x1mm", "1e999x1x1"})
        EXPECT_FALSE(parseStockSize(text).has_value()) << text;
}

TEST(ParsePoint, ReadsThreeCoordinates) {
    EXPECT_EQ(parsePoint("-1.5,+2,0").value(), Vec3(-1.5, 2, 0));
    EXPECT_EQ(parsePoint(" 1 , 2 , 3 ").value(), Vec3(1, 2, 3));
}

TEST(ParsePoint, RefusesAnythingElse) {
    for (const char* text : {"", "1,2", "1,2,", "1,2,3,4", "1;2;3", "1,2,x", "+-1,2,3", "1,nan,3"})
        EXPECT_FALSE(parsePoint(text).has_value()) << text;
}

} // namespace
} // namespace proveout
