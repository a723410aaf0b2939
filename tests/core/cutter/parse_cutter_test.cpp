// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/cutter/shapes.h"
#include "core/cutter/tool_table.h"

namespace proveout {
namespace {

using testing::HasSubstr;

TEST(ParseCutter, ReadsTheCommonKeys) {
    const Cutter cutter = parseCutter("ball:d=11,l=50,sd=12,sl=40").value();
    EXPECT_EQ(cutter.fluteLength(), 50);
    EXPECT_EQ(cutter.shankRadius(), 6);
    EXPECT_EQ(cutter.shankLength(), 40);
    EXPECT_EQ(cutter.spec(), "ball:d=11,l=50,sd=12,sl=40");
}

TEST(ParseCutter, GivesAShankOfTheCuttersDiameterWhereNoneIsGiven) {
    EXPECT_EQ(parseCutter("flat:d=8").value().shankRadius(), 4);
}

TEST(ParseCutter, ToleratesSpaces) {
    EXPECT_TRUE(parseCutter(" bull : d = 8 , r = 1 ").has_value());
}

TEST(ParseCutter, NeverMakesFlutesShorterThanTheProfileByDefault) {
    const Cutter cutter = parseCutter("cone:d=20,angle=10").value();
    EXPECT_GE(cutter.fluteLength(), cutter.rimHeight());
}

struct Bad {
    const char* spec;
    const char* id;
    const char* says; ///< a part of the sentence
};

class BadCutters : public testing::TestWithParam<Bad> {};

TEST_P(BadCutters, AreRefusedWithASentenceThatNamesTheKey) {
    const auto cutter = parseCutter(GetParam().spec);
    ASSERT_FALSE(cutter.has_value());
    ASSERT_EQ(cutter.error().size(), 1U);
    EXPECT_STREQ(cutter.error()[0].id, GetParam().id);
    EXPECT_THAT(message(cutter.error()[0]), HasSubstr(GetParam().says));
}

INSTANTIATE_TEST_SUITE_P(Specs, BadCutters,
                         testing::Values(Bad{"", "cutter-shape-unknown", "flat, ball, bull, cone, drill"},
                                         Bad{"drum:d=3", "cutter-shape-unknown", "“drum”"},
                                         Bad{"ball", "cutter-key-missing", "key d"},
                                         Bad{"ball:", "cutter-key-missing", "0.001 to 10000 mm"},
                                         Bad{"ball:d", "cutter-value-not-a-number", "of d"},
                                         Bad{"ball:d=", "cutter-value-not-a-number", "of d"},
                                         Bad{"ball:d=ten", "cutter-value-not-a-number", "“ten”"},
                                         Bad{"ball:d=10mm", "cutter-value-not-a-number", "“10mm”"},
                                         Bad{"ball:d=nan", "cutter-value-not-a-number", "“nan”"},
                                         Bad{"ball:d=inf", "cutter-value-not-a-number", "“inf”"},
                                         Bad{"ball:d=1e999", "cutter-value-not-a-number", "“1e999”"},
                                         Bad{"ball:d=0", "cutter-value-out-of-range", "d=0"},
                                         Bad{"ball:d=-3", "cutter-value-out-of-range", "0.001 to 10000 mm"},
                                         Bad{"ball:d=10,d=11", "cutter-key-twice", "key d"},
                                         Bad{"ball:d=10,r=2", "cutter-key-unknown", "there are d, l, sd, sl"},
                                         Bad{"ball:d=10,,l=3", "cutter-key-unknown", "“”"},
                                         Bad{"ball:d=10,l=0", "cutter-value-out-of-range", "l=0"},
                                         Bad{"ball:d=10,l=4", "flutes-too-short", "l=4"},
                                         Bad{"bull:d=10", "cutter-key-missing", "key r"},
                                         Bad{"bull:d=10,r=6", "corner-radius-too-large", "r=6"},
                                         Bad{"cone:d=10,angle=0", "cutter-value-out-of-range", "1 to 179 °"},
                                         Bad{"cone:d=10,angle=180", "cutter-value-out-of-range", "angle=180"},
                                         Bad{"cone:d=10,angle=90,tip=10", "tip-too-large", "tip=10"},
                                         Bad{"drill:d=10", "cutter-key-missing", "key angle"},
                                         Bad{"drill:d=10,angle=118,tip=1", "cutter-key-unknown",
                                             "there are d, angle, l, sd, sl"}));

TEST(ParseCutter, MakesACutterOfEveryRowFromItsProposedValues) {
    for (const CutterShape& shape : cutterShapes()) {
        std::string spec = std::string(shape.key) + ":";
        for (const ShapeKey& key : shape.keys)
            spec += fmt::format("{}={},", key.key, key.standard);
        SCOPED_TRACE(spec);
        EXPECT_TRUE(parseCutter(spec).has_value());
    }
}

TEST(ParseToolOption, TakesANumberWithOrWithoutT) {
    for (const char* option : {"3=flat:d=6", "T3=flat:d=6", "t3=flat:d=6", " 3 = flat:d=6"}) {
        const auto tool = parseToolOption(option);
        ASSERT_TRUE(tool.has_value()) << option;
        EXPECT_EQ(tool->first, 3);
        EXPECT_EQ(tool->second.radius(), 3);
    }
}

TEST(ParseToolOption, RefusesWhatHasNoNumberOrNoCutter) {
    for (const char* option : {"", "flat:d=6", "T=flat:d=6", "0=flat:d=6", "-1=flat:d=6", "1.5=flat:d=6",
                               "99999999999=flat:d=6", "1=", "1=flat"})
        EXPECT_FALSE(parseToolOption(option).has_value()) << option;
}

TEST(ToolTable, FindsWhatWasSet) {
    ToolTable table;
    EXPECT_EQ(table.find(1), nullptr);
    table.set(1, parseCutter("flat:d=6").value());
    table.set(1, parseCutter("flat:d=8").value());
    ASSERT_NE(table.find(1), nullptr);
    EXPECT_EQ(table.find(1)->radius(), 4);
    table.remove(1);
    EXPECT_EQ(table.find(1), nullptr);
}

} // namespace
} // namespace proveout
