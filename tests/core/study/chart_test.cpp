// SPDX-License-Identifier: GPL-3.0-or-later
// Ticks, images and tables.
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <regex>

#include "core/study/axis_ticks.h"
#include "core/study/study_csv.h"
#include "core/study/svg_chart.h"
#include "core/study/svg_text.h"

namespace proveout {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(AxisTicks, AreRound) {
    EXPECT_THAT(linearTicks(0, 0.1, 6).labels, ElementsAre("0.00", "0.02", "0.04", "0.06", "0.08", "0.10"));
    EXPECT_THAT(linearTicks(-3, 12, 4).labels, ElementsAre("-5", "0", "5", "10", "15"));
    EXPECT_THAT(linearTicks(0, 39200, 4).labels, ElementsAre("0", "10,000", "20,000", "30,000", "40,000"));
    EXPECT_THAT(logarithmicTicks(1, 200).labels, ElementsAre("1", "2", "5", "10", "20", "50", "100", "200"));
}

RC_GTEST_PROP(AxisTicks, HoldTheRangeInEvenSteps, ()) {
    const double lo = *rc::gen::inRange(-100000, 100000) * 1e-3;
    const double hi = lo + *rc::gen::inRange(1, 1000000) * 1e-3;
    const AxisTicks ticks = linearTicks(lo, hi, *rc::gen::inRange(2, 12));
    RC_ASSERT(ticks.places.size() >= 2U && ticks.places.size() <= 14U);
    RC_ASSERT(ticks.lo <= lo + 1e-9 && ticks.hi >= hi - 1e-9);
    const double step = ticks.places[1] - ticks.places[0];
    const double digit = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
    RC_ASSERT(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6);
    for (std::size_t k = 1; k < ticks.places.size(); ++k)
        RC_ASSERT(std::abs(ticks.places[k] - ticks.places[k - 1] - step) <
                  1e-9 * std::max(1.0, std::abs(hi)));
    RC_ASSERT(ticks.labels.size() == ticks.places.size());
}

Chart twoCurves() {
    Chart chart;
    chart.title = "Faces & \"time\" <all>";
    chart.xLabel = "Step";
    chart.yLabel = "Faces";
    chart.curves.push_back({"one", CurveLook::marked, 0, false, {{0, 0}, {10, 10}}});
    chart.curves.push_back({"two", CurveLook::plain, 1, false, {{0, 5}, {10, 5}}});
    return chart;
}

/// The points of the k-th polyline.
std::vector<Vec2> polyline(const std::string& svg, std::size_t k) {
    std::size_t at = 0;
    for (std::size_t found = 0; found <= k; ++found)
        at = svg.find("<polyline", at) + 1;
    const std::string points = svg.substr(svg.find("points=\"", at) + 8);
    static const std::regex kPair("(-?[0-9.]+),(-?[0-9.]+)");
    std::vector<Vec2> out;
    const std::string own = points.substr(0, points.find('"'));
    for (std::sregex_iterator pair(own.begin(), own.end(), kPair), end; pair != end; ++pair)
        out.emplace_back(std::stod((*pair)[1]), std::stod((*pair)[2]));
    return out;
}

TEST(SvgChart, PutsPointsOnTheirPlaces) {
    const std::string svg = svgChart(twoCurves());
    const auto one = polyline(svg, 0);
    const auto two = polyline(svg, 1);
    ASSERT_EQ(one.size(), 2U);
    ASSERT_EQ(two.size(), 2U);
    EXPECT_LT(one[0].x, one[1].x);
    EXPECT_GT(one[0].y, one[1].y) << "y grows downwards in a picture";
    EXPECT_NEAR(two[0].y, (one[0].y + one[1].y) / 2, 0.11) << "5 lies in the middle of 0 and 10";
    EXPECT_DOUBLE_EQ(one[0].x, two[0].x);
}

TEST(SvgChart, EscapesText) {
    const std::string svg = svgChart(twoCurves());
    EXPECT_THAT(svg, HasSubstr("Faces &amp; &quot;time&quot; &lt;all&gt;"));
    EXPECT_THAT(svg, Not(HasSubstr("<all>")));
}

TEST(SvgChart, LeavesOutWhatIsNotFinite) {
    Chart chart = twoCurves();
    const double none = std::numeric_limits<double>::quiet_NaN();
    chart.curves[0].points.insert(chart.curves[0].points.begin() + 1, {5, none});
    const std::string svg = svgChart(chart);
    EXPECT_EQ(polyline(svg, 0).size(), 2U);
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(SvgChart, ThinsLongCurvesButKeepsPeaks) {
    Chart chart = twoCurves();
    std::vector<Vec2> points;
    for (int k = 0; k < 100000; ++k)
        points.emplace_back(k, k == 54321 ? 99.0 : 1.0);
    chart.curves = {{"peak", CurveLook::plain, 0, false, points}};
    const auto drawn = polyline(svgChart(chart), 0);
    EXPECT_LT(drawn.size(), 4U * kChartWidth);
    const auto [high, low] = std::minmax_element(drawn.begin(), drawn.end(),
                                                 [](const Vec2& a, const Vec2& b) { return a.y < b.y; });
    EXPECT_GT(low->y - high->y, 300) << "the one peak of 99 stands";
    EXPECT_EQ(chartCsv(chart).size() > 100000, true) << "the table has every point";
}

TEST(SvgChart, KeepsCurvesAndWordsWithinALowPicture) {
    Chart chart = twoCurves();
    chart.rightLabel = "Other faces";
    const std::string svg = svgChart(chart, 1200, 160);
    EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 1200 160\""));
    EXPECT_THAT(svg, Not(HasSubstr("rotate"))) << "words along an axis of 100 would be cut off";
    static const std::regex kY(" y=\"(-?[0-9.]+)\"");
    for (std::sregex_iterator place(svg.begin(), svg.end(), kY), end; place != end; ++place)
        EXPECT_LE(std::stod((*place)[1]), 160) << place->str();
    for (const Vec2& point : polyline(svg, 0)) {
        EXPECT_GE(point.y, 0);
        EXPECT_LE(point.y, 160);
    }
    EXPECT_GT(polyline(svg, 0)[0].y - polyline(svg, 0)[1].y, 60) << "most of the height is for the curves";
}

TEST(SvgChart, DrawsAnEmptyChart) {
    EXPECT_THAT(svgChart({}), HasSubstr("</svg>"));
}

TEST(ChartCsv, HasARowAPoint) {
    EXPECT_EQ(chartCsv(twoCurves()),
              "curve,\"Step\",\"Faces\"\n\"one\",0,0\n\"one\",10,10\n\"two\",0,5\n\"two\",10,5\n");
}

} // namespace
TEST(Chart, KeepsTheWordsOfTheRightAxisClearOfItsNumbers) {
    Chart chart = twoCurves();
    chart.rightLabel = "Faces shown";
    chart.curves.back().rightAxis = true;
    for (Vec2& point : chart.curves.back().points)
        point.y += 12'345'678;
    const std::string svg = svgChart(chart);
    std::smatch words;
    ASSERT_TRUE(
        std::regex_search(svg, words, std::regex(R"re(<text x="(\d+)"[^>]*rotate[^>]*>Faces shown)re")));
    std::smatch number;
    ASSERT_TRUE(
        std::regex_search(svg, number, std::regex(R"re(<text x="(\d+)" y="[\d.]+">(1\d,000,000)<)re")));
    const double end = std::stod(number[1]) + textWidth(number[2].str());
    constexpr double kHalfOfALine = 7;
    EXPECT_GT(std::stod(words[1]) - kHalfOfALine, end);
}

} // namespace proveout
