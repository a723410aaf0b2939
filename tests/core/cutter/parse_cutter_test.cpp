// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

#include "core/cutter/shapes.h"
#include "core/cutter/tool_table.h"
#include "tests/core/cutter/default_spec.h"
#include "tests/random_seed.h"

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

TEST(ParseCutter, ReadsStickOutAndHolder) {
    const Cutter cutter = parseCutter("ball:d=10,so=42.5,holder=40x30+40-60.5x15+20x1e1").value();
    EXPECT_EQ(cutter.spec(), "ball:d=10,so=42.5,holder=40x30+40-60.5x15+20x1e1");
    EXPECT_EQ(cutter.body().stickOut, 42.5);
    const auto& holder = cutter.body().holder;
    ASSERT_EQ(holder.size(), 3U);
    const double expected[][3] = {{20, 20, 30}, {20, 30.25, 15}, {10, 10, 10}};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(holder[k].lowerRadius, expected[k][0]) << k;
        EXPECT_EQ(holder[k].upperRadius, expected[k][1]) << k;
        EXPECT_EQ(holder[k].height, expected[k][2]) << k;
    }
    EXPECT_FALSE(cutter.body().shankGiven);
    EXPECT_TRUE(parseCutter("ball:d=10,sd=8").value().body().shankGiven);
    EXPECT_EQ(parseCutter("form:p=0/0:5/1,so=9,holder=20x5").value().body().holder.size(), 1U)
        << "beside another text";
    EXPECT_TRUE(parseCutter("flat:d=10").value().body().holder.empty());
}

TEST(ParseCutter, TakesAStickOutWithoutAHolder) {
    EXPECT_EQ(parseCutter("bull:d=10,r=2,so=2").value().body().stickOut, 2)
        << "as long as the profile is high";
}

TEST(ParseCutter, ReadsHowAToolMayBeUsed) {
    const Cutter cutter = parseCutter("flat:d=10,z=4,centre=0,ramp=3.5,maxap=5,maxae=2.5,maxchip=0.05,"
                                      "maxrpm=12000,maxfeed=2000,maxvc=180,maxmrr=40")
                              .value();
    const CuttingData& data = cutter.data();
    EXPECT_EQ(data.teeth, 4);
    EXPECT_FALSE(data.centreCutting);
    EXPECT_EQ(data.steepestRamp, 3.5);
    EXPECT_EQ(data.mostDepth, 5);
    EXPECT_EQ(data.mostEngagement, 2.5);
    EXPECT_EQ(data.mostChip, 0.05);
    EXPECT_EQ(data.mostSpindle, 12000);
    EXPECT_EQ(data.mostFeed, 2000);
    EXPECT_EQ(data.mostSurfaceSpeed, 180);
    EXPECT_EQ(data.mostRemoval, 40);
    EXPECT_EQ(parseCutter("tap:d=8,tip=6,lead=3,pitch=1.25").value().data().pitch, 1.25);
    const CuttingData none = parseCutter("ball:d=10").value().data();
    EXPECT_FALSE(none.limitsCut() || none.limitsLoad());
    EXPECT_EQ(none.steepestRamp, 90);
}

TEST(ParseCutter, KnowsWhichShapesAreCentreCutting) {
    std::string notCentreCutting;
    for (const CutterShape& shape : cutterShapes()) {
        const Cutter cutter = parseCutter(defaultSpecOf(shape)).value();
        if (!cutter.data().centreCutting)
            notCentreCutting += std::string(shape.key) + ' ';
        EXPECT_TRUE(parseCutter(defaultSpecOf(shape) + ",centre=1").value().data().centreCutting);
    }
    EXPECT_EQ(notCentreCutting, "face reamer tap threadmill tslot dovetail ");
}

TEST(ParseCutter, BoundsTheLoadByChipsVolumeOrDepthAndWidth) {
    for (const auto& [limits, bounded] :
         {std::pair{"maxchip=0.1,z=2", true}, std::pair{"maxmrr=9", true}, std::pair{"maxap=2", false},
          std::pair{"maxae=2", false}, std::pair{"maxap=2,maxae=2", true}, std::pair{"maxrpm=9000", false}})
        EXPECT_EQ(parseCutter(std::string("flat:d=10,") + limits).value().data().limitsLoad(), bounded)
            << limits;
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
    const char* says; ///< part of the sentence
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
                                         Bad{"ball:d=10,r=2", "cutter-key-unknown",
                                             "there are d, l, sd, sl, so, holder, z, centre, ramp, "},
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
                                             "there are d, angle, l, sd, sl, so, holder, z, "}));

INSTANTIATE_TEST_SUITE_P(Uses, BadCutters,
                         testing::Values(Bad{"flat:d=6,maxchip=0.1", "chip-without-teeth", "key z"},
                                         Bad{"flat:d=6,z=2.5", "cutter-value-not-a-number",
                                             "“2.5”, is not a whole number"},
                                         Bad{"flat:d=6,centre=2", "cutter-value-out-of-range", "centre=2"},
                                         Bad{"flat:d=6,ramp=91", "cutter-value-out-of-range", "0 to 90 °"},
                                         Bad{"flat:d=6,maxap=-1", "cutter-value-out-of-range", "maxap=-1"},
                                         Bad{"flat:d=6,pitch=1", "cutter-key-unknown", "“pitch”"}));

INSTANTIATE_TEST_SUITE_P(
    Holders, BadCutters,
    testing::Values(
        Bad{"flat:d=6,holder=40x30", "holder-without-stick-out", "key so"},
        Bad{"flat:d=6,so=0,holder=40x30", "holder-without-stick-out", "stick-out"},
        Bad{"flat:d=6,so=-1", "cutter-value-out-of-range", "so=-1"},
        Bad{"ball:d=6,so=2.9", "stick-out-too-short", "so=2.9"},
        Bad{"tslot:d=20,w=4,neck=8,so=3", "stick-out-too-short", "4 mm"},
        Bad{"flat:d=6,so=9,so=9", "cutter-key-twice", "key so"},
        Bad{"flat:d=6,so=9,holder=", "holder-unreadable", "“”"},
        Bad{"flat:d=6,so=9,holder=40", "holder-unreadable", "“40”"},
        Bad{"flat:d=6,so=9,holder=40x", "holder-unreadable", "“40x”"},
        Bad{"flat:d=6,so=9,holder=x30", "holder-unreadable", "“x30”"},
        Bad{"flat:d=6,so=9,holder=40x30+", "holder-unreadable", "“”"},
        Bad{"flat:d=6,so=9,holder=40x30mm", "holder-unreadable", "“40x30mm”"},
        Bad{"flat:d=6,so=9,holder=40x30x20", "holder-unreadable", "“40x30x20”"},
        Bad{"flat:d=6,so=9,holder=40-x30", "holder-unreadable", "“40-x30”"},
        Bad{"flat:d=6,so=9,holder=40-50-60x30", "holder-unreadable", "“40-50-60x30”"},
        Bad{"flat:d=6,so=9,holder=40 x30", "holder-unreadable", "40x30, a cone as 20-40x15"},
        Bad{"flat:d=6,so=9,holder=0x30", "holder-size", "0x30"},
        Bad{"flat:d=6,so=9,holder=-40x30", "holder-size", "-40x30"},
        Bad{"flat:d=6,so=9,holder=40-1001x30", "holder-size", "0.001 to 1000 mm"},
        Bad{"flat:d=6,so=9,holder=40x0", "holder-size", "40x0"},
        Bad{"flat:d=6,so=9,holder=40x1000.1", "holder-size", "40x1000.1"},
        Bad{"flat:d=6,so=9,holder=nanxinf", "holder-size", "nanxinf"},
        Bad{"flat:d=6,so=9,holder=1x1+1x1+1x1+1x1+1x1+1x1+1x1+1x1+1x1+1x1+1x1+1x1+1x1+1x1+1x1+1x1+1x1",
            "holder-too-long", "16 segments"}));

INSTANTIATE_TEST_SUITE_P(
    Shapes, BadCutters,
    testing::Values(Bad{"taper:d=6,angle=3", "cutter-key-missing", "key h"},
                    Bad{"taper:d=6,angle=0.1,h=5", "cutter-value-out-of-range", "0.5 to 89 °"},
                    Bad{"taper:d=6,angle=30,h=5,r=6", "corner-radius-too-large", "5.196 mm"},
                    Bad{"taper:d=6,angle=30,h=0.5,r=1", "taper-too-low", "0.5 mm"},
                    Bad{"taperball:d=6,angle=30,h=1.5", "taper-too-low", "1.5 mm"},
                    Bad{"chamfer:d=6,angle=90", "cutter-key-missing", "key tip"},
                    Bad{"chamfer:d=6,angle=90,tip=6", "tip-too-large", "tip=6"},
                    Bad{"face:d=50,angle=5,h=6", "cutter-value-out-of-range", "10 to 90 °"},
                    Bad{"face:d=50,angle=90,h=6,r=30", "corner-radius-too-large", "25 mm"},
                    Bad{"centre:d=4,pilot=4,pl=3", "pilot-too-large", "pilot=4"},
                    Bad{"centre:d=10,pilot=4,pl=1", "pilot-too-short", "1.202 mm"},
                    Bad{"reamer:d=4,lead=3", "lead-too-long", "2 mm"},
                    Bad{"tap:d=4", "cutter-key-missing", "key tip"},
                    Bad{"tap:d=4,tip=4,lead=1", "tip-too-large", "tip=4"},
                    Bad{"lollipop:d=6,neck=6", "neck-too-thick", "6 mm"},
                    Bad{"tslot:d=20,w=4,neck=8,r=3", "corner-radius-too-large", "2 mm"},
                    Bad{"tslot:d=20,w=4,neck=18,r=1", "neck-too-thick", "18 mm"},
                    Bad{"tslot:d=20,w=4,neck=8,l=3", "flutes-too-short", "4 mm"},
                    Bad{"dovetail:d=20,angle=45,h=10", "head-too-high", "10 mm"},
                    Bad{"dovetail:d=20,angle=45,h=5,neck=11", "neck-too-thick", "10 mm"},
                    Bad{"dovetail:d=20,angle=60,h=1,r=1", "corner-radius-too-large", "0.6667 mm"}));

INSTANTIATE_TEST_SUITE_P(Profiles, BadCutters,
                         testing::Values(Bad{"form:", "cutter-key-missing", "0/0:3/0"},
                                         Bad{"form:p=", "form-unreadable", "At character 1, “”"},
                                         Bad{"form:p=0/0", "form-no-width", "character 1"},
                                         Bad{"form:p=0/0:0/5", "form-no-width", "character 5"},
                                         Bad{"form:p=1/0:5/0", "form-start", "At character 1"},
                                         Bad{"form:p=0/1:5/1", "form-start", "“0/1”"},
                                         Bad{"form:p=0/0@1:5/0", "form-start", "“0/0@1”"},
                                         Bad{"form:p=0/0:0/1:3/2", "form-no-tip", "character 9"},
                                         Bad{"form:p=0/0:5", "form-unreadable", "At character 5, “5”"},
                                         Bad{"form:p=0/0:5/0:", "form-unreadable", "At character 9, “”"},
                                         Bad{" form:p=0/0:5/x", "form-unreadable", "At character 5, “5/x”"},
                                         Bad{"form:p=0/0:nan/0", "form-unreadable", "“nan/0”"},
                                         Bad{"form:p=0/0:5/inf", "form-unreadable", "“5/inf”"},
                                         Bad{"form:p=0/0:5/1e9", "form-unreadable", "“5/1e9”"},
                                         Bad{"form:p=0/0:5/0:4/1", "form-turns-back", "At character 9"},
                                         Bad{"form:p=0/0:-5/0", "form-turns-back", "At character 5"},
                                         Bad{"form:p=0/0:5/2:6/1", "form-falls", "At character 9"},
                                         Bad{"form:p=0/0:5/-1", "form-falls", "At character 5"},
                                         Bad{"form:p=0/0:5/2@", "form-unreadable", "“5/2@”"},
                                         Bad{"form:p=0/0:5/2@1/", "form-unreadable", "“5/2@1/”"},
                                         Bad{"form:p=0/0:5/2@2", "form-arc-radius", "5.38516 mm apart"},
                                         Bad{"form:p=0/0:5/2@0", "form-arc-radius", "radius 0 mm"},
                                         Bad{"form:p=0/0:5/2@nan", "form-unreadable", "“5/2@nan”"},
                                         Bad{"form:p=0/0:5/5@1/5", "form-arc-centre", "5.09902 mm and 4 mm"},
                                         Bad{"form:p=0/0:5/2@3", "form-arc-turns", "character 5"},
                                         Bad{"form:p=0/0:5/0@3", "form-arc-turns", "level to upright"},
                                         Bad{"form:p=0/0:5/0:5/5@4", "form-arc-turns", "character 9"},
                                         Bad{"form:p=0/0:3/0:9000/8997@-8997:9000/8998:9999/9997@-1000",
                                             "form-too-fine", "1000 lines"},
                                         Bad{"form:p=0/0:3/0,p=0/0", "cutter-key-twice", "key p"},
                                         Bad{"form:p=0/0:3/0,d=6", "cutter-key-unknown",
                                             "there are p, l, sd, sl, so, holder"}));

TEST(ParseCutter, RefusesAProfileOfThousandsOfPoints) {
    std::string spec = "form:p=0/0";
    for (int k = 1; k <= 5000; ++k)
        spec += fmt::format(":{}/{}", k, k);
    const auto cutter = parseCutter(spec);
    ASSERT_FALSE(cutter.has_value());
    EXPECT_STREQ(cutter.error()[0].id, "form-too-long");
    EXPECT_THAT(message(cutter.error()[0]), HasSubstr("200 points"));
}

TEST(ParseCutter, AnyTextIsAProfileOrAMessage) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937 random(seed);
    const std::string start = "form:p=0/0:3/0:4/1@3/1:6/3@-2:6/8:7/9@1";
    const std::string letters = "0123456789/:@.-+e,= x";
    int taken = 0;
    for (int k = 0; k < 20'000; ++k) {
        std::string spec = start;
        for (unsigned change = 0; change <= random() % 4; ++change) {
            const std::size_t at = 7 + random() % (spec.size() - 7);
            if (random() % 3 == 0)
                spec.erase(at, 1);
            else
                spec.insert(at, 1, letters[random() % letters.size()]);
        }
        const auto cutter = parseCutter(spec);
        if (!cutter) {
            ASSERT_FALSE(cutter.error().empty()) << spec;
            continue;
        }
        ++taken;
        double last = 0;
        for (const ProfilePiece& piece : cutter->solvablePieces()) {
            ASSERT_TRUE(piece.r1 > piece.r0 && std::isfinite(piece.z0) && std::isfinite(piece.z1)) << spec;
            ASSERT_GE(piece.z1, last - 2e-3) << spec;
            last = piece.z1;
        }
    }
    EXPECT_GT(taken, 100);
}

TEST(ParseCutter, TakesProfilesThatAreWrittenWithThreeDecimals) {
    // A corner of 1.5 mm that continues at its tangent point as a side of 10°.
    EXPECT_TRUE(parseCutter("form:p=0/0:4/0:5.477/1.240@4/1.5:7/9.878").has_value());
}

TEST(ParseCutter, GivesAHeadAShankAsThickAsItsNeck) {
    EXPECT_DOUBLE_EQ(parseCutter("dovetail:d=20,angle=45,h=5").value().shankRadius(), 5) << "as the neck";
    EXPECT_EQ(parseCutter("dovetail:d=20,angle=45,h=5,sd=12").value().shankRadius(), 6);
}

TEST(ParseCutter, MakesACutterOfEveryRowFromItsProposedValues) {
    for (const CutterShape& shape : cutterShapes()) {
        const std::string spec = defaultSpecOf(shape);
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
    for (const char* option : {"", "flat:d=6", "T=flat:d=6", "-1=flat:d=6", "1.5=flat:d=6",
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
