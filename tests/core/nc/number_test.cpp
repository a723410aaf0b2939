// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/text/number.h"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>
#include <string>

namespace proveout {

namespace {

double valueOf(const std::string& text) {
    const NumberRead read = readNumber(text, 0);
    EXPECT_EQ(read.status, NumberStatus::good) << text;
    EXPECT_EQ(read.end, text.size()) << text;
    return read.value;
}

} // namespace

TEST(Number, ReadsTheFormsOfNcPrograms) {
    EXPECT_EQ(valueOf("12.5"), 12.5);
    EXPECT_EQ(valueOf(".5"), 0.5);
    EXPECT_EQ(valueOf("5."), 5);
    EXPECT_EQ(valueOf("+3"), 3);
    EXPECT_EQ(valueOf("-0.25"), -0.25);
    EXPECT_EQ(valueOf(" - 1 2 . 3\t4"), -12.34) << "blanks may stand anywhere";
    EXPECT_FALSE(std::signbit(valueOf("-0.000")));
}

TEST(Number, EndsBeforeWhatIsNotPartOfIt) {
    const NumberRead read = readNumber("X10 Y5", 1);
    EXPECT_EQ(read.value, 10);
    EXPECT_EQ(read.end, 3U) << "the blank before the next word does not belong to it";
}

TEST(Number, ReportsWhatIsWrong) {
    struct Case {
        const char* text;
        NumberStatus status;
        std::size_t place;
    };
    for (const Case& c : {Case{"", NumberStatus::missing, 0}, Case{"-", NumberStatus::missing, 1},
                          Case{".", NumberStatus::missing, 0}, Case{"nan", NumberStatus::missing, 0},
                          Case{"--1", NumberStatus::doubleSign, 0}, Case{"1.2.3", NumberStatus::twoPoints, 3},
                          Case{"[1]", NumberStatus::expression, 0}, Case{"-#5", NumberStatus::expression, 1},
                          Case{"1000000000001", NumberStatus::outOfRange, 0}}) {
        const NumberRead read = readNumber(c.text, 0);
        EXPECT_EQ(read.status, c.status) << c.text;
        EXPECT_EQ(read.place, c.place) << c.text;
    }
}

TEST(Number, RoundsAsTheStandardLibraryDoes) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        for (int i = 0; i < 5000; ++i) {
            std::string text = random() % 2 == 0 ? "-" : "";
            const auto whole = random() % 13;
            const auto decimals = 1 + random() % 30;
            for (unsigned d = 0; d < whole; ++d)
                text += static_cast<char>('0' + random() % 10);
            text += '.';
            for (unsigned d = 0; d < decimals; ++d)
                text += static_cast<char>('0' + random() % 10);
            const double expected = std::strtod(text.c_str(), nullptr);
            if (std::abs(expected) > kLargestNumber)
                continue;
            ASSERT_EQ(valueOf(text), expected) << text;
        }
    }
}

TEST(Number, StaysFiniteHoweverLong) {
    const std::string nines(1'000'000, '9');
    EXPECT_EQ(readNumber(nines, 0).status, NumberStatus::outOfRange);
    EXPECT_EQ(valueOf("0." + std::string(1'000'000, '0') + "1"), 0);
    EXPECT_EQ(valueOf(std::string(1'000'000, '0') + "7"), 7);
    EXPECT_EQ(valueOf("1." + std::string(1'000'000, '0')), 1);
}

} // namespace proveout
