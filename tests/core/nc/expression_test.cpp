// SPDX-License-Identifier: GPL-3.0-or-later
// Compares random expressions with a tree that is evaluated without any text; and checks what must be
// refused.
#include "core/nc/codes/dialects.h"
#include "core/nc/text/expression.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>
#include <string>

#include "tests/random_seed.h"

namespace proveout {

namespace {

struct NoValues : SystemValues {
    [[nodiscard]] const FindingRow* refusal(int /*number*/) const override { return nullptr; }
    [[nodiscard]] std::optional<double> numbered(int /*number*/) const override { return {}; }
    [[nodiscard]] std::optional<double> named(std::string_view /*name*/) const override { return {}; }
};

tl::expected<double, ReadError> valueOf(const std::string& text) {
    const Parameters parameters;
    const NoValues values;
    std::size_t at = 0;
    return ExpressionReader(text, {parameters, values, dialect(DialectId::linuxcnc)}).value(at, "X");
}

/// A text with redundant brackets wherever precedence or association does not need them, and its value.
struct Sample {
    std::string text;
    double value;
};

class Grower {
public:
    explicit Grower(unsigned seed) : m_random(seed) {}

    Sample grow(int depth) {
        if (depth == 0 || pick(4) == 0) {
            const int number = pick(200) - 100;
            return {fmt::format("{:.1f}", number / 10.0), number / 10.0};
        }
        const Sample left = grow(depth - 1);
        const Sample right = grow(depth - 1);
        switch (pick(6)) {
        case 0:
            return {blank(fmt::format("[{}+{}]", left.text, right.text)), left.value + right.value};
        case 1:
            return {blank(fmt::format("[{} - {}]", left.text, right.text)), left.value - right.value};
        case 2:
            return {blank(fmt::format("[{}*{}]", left.text, right.text)), left.value * right.value};
        case 3:
            return {blank(fmt::format("[{} gt {}]", left.text, right.text)),
                    left.value > right.value ? 1.0 : 0.0};
        case 4:
            return {blank(fmt::format("abs[{}]", left.text)), std::abs(left.value)};
        default:
            return {blank(fmt::format("Fix [{}]", left.text)), std::floor(left.value)};
        }
    }

private:
    int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(m_random); }
    std::string blank(const std::string& text) {
        return pick(3) == 0 ? fmt::format("{} {}", text.substr(0, 1), text.substr(1)) : text;
    }

    std::mt19937 m_random;
};

} // namespace

TEST(Expression, AgreesWithTheTreeItWasWrittenFrom) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Grower grower(seed);
    for (int i = 0; i < 3000; ++i) {
        const Sample sample = grower.grow(6);
        const auto value = valueOf(sample.text);
        if (std::abs(sample.value) > 1e12)
            continue;
        ASSERT_TRUE(value) << sample.text << ": " << value.error().message->id;
        ASSERT_EQ(*value, sample.value) << sample.text;
    }
}

TEST(Expression, BindsAsTheControlDoes) {
    EXPECT_EQ(valueOf("[1+2*3]"), 7.0);
    EXPECT_EQ(valueOf("[2**3**2]"), 64.0);
    EXPECT_EQ(valueOf("[-2**2]"), 4.0);
    EXPECT_EQ(valueOf("[10/4-1]"), 1.5);
    EXPECT_EQ(valueOf("[10-4-3]"), 3.0);
    EXPECT_EQ(valueOf("[-7 MOD 4]"), 1.0);
    EXPECT_EQ(valueOf("[1 LT 2 AND 2 LT 1]"), 0.0);
    EXPECT_EQ(valueOf("[1 EQ 1.00005]"), 1.0);
}

TEST(Expression, RefusesWhatHasNoResult) {
    for (const char* text : {"[1/0]", "[1 MOD 0]", "SQRT[-1]", "ASIN[1.1]", "ACOS[-1.1]", "LN[0]",
                             "[[0-2]**0.5]", "EXP[1000]", "[0**-1]"}) {
        const auto value = valueOf(text);
        ASSERT_FALSE(value) << text;
        EXPECT_STREQ(value.error().message->id, "no-result") << text;
    }
}

TEST(Expression, RefusesToNestWithoutEnd) {
    for (const std::string& text : {std::string(100'000, '['), std::string(100'000, '#') + "1",
                                    fmt::format("-{}1", std::string(100'000, '['))}) {
        const auto value = valueOf(text);
        ASSERT_FALSE(value);
        EXPECT_STREQ(value.error().message->id, "nested-too-deep");
    }
}

} // namespace proveout
