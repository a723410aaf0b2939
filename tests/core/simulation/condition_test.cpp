// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/thread/condition.h"

#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>

#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
// X Y Z F S T N L
constexpr ConditionValues kValues{10, -5, -21.5, 800, 6000, 3, 42, 17};

TEST(Condition, HoldsOrNot) {
    const std::pair<const char*, bool> kCases[] = {
        {"Z < -20 && T == 3", true},
        {"z<-20&&t==3", true},
        {"Z < -22", false},
        {"X >= 10", true},
        {"X > 10", false},
        {"X <= 9.999", false},
        {"T != 3", false},
        {"10 == X", true},
        {"Y < X", true},
        {"!(T == 3)", false},
        {"!!T == 3", true}, // negates the comparison
        {"T == 1 || T == 3 && N == 42", true},
        {"(T == 1 || T == 3) && N == 41", false},
        {"T == 1 && N == 42 || L == 17", true},
        {"((((F == 8e2))))", true},
        {"S==+6000", true},
        {"X == .1 || Y == -5.", true},
        {"1 < 2", true},
    };
    for (const auto& [text, holds] : kCases) {
        const auto condition = Condition::parse(text);
        ASSERT_TRUE(condition) << text;
        EXPECT_EQ(condition->holds(kValues), holds) << text;
    }
}

TEST(Condition, NothingHoldsOfWhatIsNotKnown) {
    ConditionValues values = kValues;
    values[2] = kUnknown;
    for (const char* text : {"Z < 0", "Z >= 0", "Z == 0", "Z != 0", "0 != Z"})
        EXPECT_FALSE(Condition::parse(text).value().holds(values)) << text;
    EXPECT_FALSE(Condition().holds(values));
}

TEST(Condition, ReportsWhereItCannotBeRead) {
    const std::pair<const char*, const char*> kCases[] = {
        {"", "Column 1: a number"},          {"Z", "Column 2: one of <"},
        {"Z <", "Column 4: a number"},       {"Z < -20 T == 3", "Column 9: && or ||"},
        {"Z = 3", "Column 3: one of <"},     {"Z < -20 & T == 3", "Column 9: && or ||"},
        {"(Z < 1", "Column 7: a closing"},   {"Q == 1", "Column 1: a number"},
        {"Z < nan", "Column 6: && or ||"},   {"Z < inf", "Column 5: a number"},
        {"Z < --1", "Column 5: a number"},   {"Z < 1e999", "Column 5: a number"},
        {"1 < X < 2", "Column 7: && or ||"}, {"&& Z < 1", "Column 1: a number"},
        {"Z < 1 &&", "Column 9: a number"},  {"Z < 1)", "Column 6: && or ||"},
        {"Z < 1,5", "Column 6: && or ||"},
    };
    for (const auto& [text, begin] : kCases) {
        const auto condition = Condition::parse(text);
        ASSERT_FALSE(condition) << text;
        EXPECT_TRUE(message(condition.error().front()).starts_with(begin))
            << text << ": " << message(condition.error().front());
    }
}

TEST(Condition, IsBounded) {
    const auto nested = [](int depth) {
        return std::string(static_cast<std::size_t>(depth), '(') + "Z < 0" +
               std::string(static_cast<std::size_t>(depth), ')');
    };
    EXPECT_TRUE(Condition::parse(nested(Condition::kDeepest)));
    EXPECT_FALSE(Condition::parse(nested(Condition::kDeepest + 1)));
    EXPECT_FALSE(Condition::parse(std::string(Condition::kLongest + 1, '(')));
    EXPECT_TRUE(Condition::parse(std::string(900, '!') + "Z < 0").value().holds(kValues));
    // The maximum number of pending operands.
    std::string deep;
    for (int level = 0; level < Condition::kDeepest; ++level)
        deep += "T==3||T==3&&(";
    deep += "T==3||T==3&&T==3" + std::string(Condition::kDeepest, ')');
    EXPECT_TRUE(Condition::parse(deep).value().holds(kValues));
}

TEST(Condition, AnyBytesAreSafe) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const std::string tokens = "XYZFSTNL<>=!&|()0123456789.-+e \t\n\xff";
    int read = 0;
    for (int text = 0; text < 20000; ++text) {
        std::string bytes;
        for (std::size_t length = random() % 40; length > 0; --length)
            bytes += tokens[random() % tokens.size()];
        if (const auto condition = Condition::parse(bytes)) {
            (void)condition->holds(kValues);
            ++read;
        }
    }
    EXPECT_GE(read, 0);
}

} // namespace
} // namespace proveout
