// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the choice with an exhaustive sweep of counts.
#include <algorithm>
#include <gtest/gtest.h>

#include "core/study/optimiser.h"
#include "tests/core/simulation/programs.h"
#include "tests/core/study/rehearsed.h"

namespace proveout {
namespace {

StudyJob randomJob(std::uint_fast32_t seed) {
    return {programOf(randomProgram(seed, 220)), smallSetup()};
}

DecimationParameters lee() {
    DecimationParameters base;
    base.method = DecimationMethod::lee;
    return base;
}

const Forecast& pointOf(const std::vector<Forecast>& points, const Forecast& wanted) {
    return *std::ranges::find_if(points, [&](const Forecast& point) {
        return point.regionCells == wanted.regionCells && point.period == wanted.period;
    });
}

class Choice : public testing::TestWithParam<Rehearsed> {
protected:
    const StudyJob m_job = randomJob(GetParam().seed);
    DecimationParameters m_base;

    Choice() { m_base.method = GetParam().method; }
};

TEST_P(Choice, CostsAtMostFivePercentMoreThanTheBestOfAll) {
    RatedDrawing drawing;
    const auto rehearsal = rehearse(m_job, m_base, {{5, 8, 12, 20, 30}, {-1, 1, 2, 5, 20, 50}, 16}, drawing);
    ASSERT_TRUE(rehearsal);
    const auto counted = countAll(m_job, m_base, *rehearsal);
    ASSERT_TRUE(counted);
    const double best = std::ranges::min_element(*counted, {}, &Forecast::seconds)->seconds;
    const Forecast& chosen = cheapest(*rehearsal);
    EXPECT_LE(pointOf(*counted, chosen).seconds, 1.05 * best)
        << "region " << chosen.regionCells << " period " << chosen.period << " seed " << GetParam().seed;
}

TEST_P(Choice, OrdersThePointsAsTheirCountsDo) {
    RatedDrawing drawing;
    const auto rehearsal = rehearse(m_job, m_base, {{5, 12, 30}, {-1, 1, 5, 50}, 16}, drawing);
    ASSERT_TRUE(rehearsal);
    const auto counted = countAll(m_job, m_base, *rehearsal);
    ASSERT_TRUE(counted);
    // Points that differ by more than a tenth must be ranked correctly.
    for (const Forecast& a : rehearsal->forecasts)
        for (const Forecast& b : rehearsal->forecasts) {
            const double costA = pointOf(*counted, a).seconds;
            const double costB = pointOf(*counted, b).seconds;
            if (costA < 0.9 * costB) {
                EXPECT_LT(a.seconds, b.seconds)
                    << a.regionCells << "/" << a.period << " against " << b.regionCells << "/" << b.period;
            }
        }
}

INSTANTIATE_TEST_SUITE_P(Lee, Choice, testing::ValuesIn(rehearsed(DecimationMethod::lee, 11, 3)));
INSTANTIATE_TEST_SUITE_P(Certified, Choice, testing::ValuesIn(rehearsed(DecimationMethod::certified, 11, 2)));

TEST(Rehearse, LeavesDecimationAloneWhereDrawingIsFree) {
    RatedDrawing drawing(1e15);
    const auto rehearsal = rehearse(randomJob(3), lee(), {{8, 20}, {-1, 1, 20}, 16}, drawing);
    ASSERT_TRUE(rehearsal);
    EXPECT_EQ(cheapest(*rehearsal).period, -1);
    EXPECT_LT(rehearsal->undecimated.seconds, cheapest(*rehearsal).seconds);
}

TEST(Rehearse, DecimatesEveryBlockWhereDrawingIsDear) {
    RatedDrawing drawing(1e3);
    const auto rehearsal = rehearse(randomJob(3), lee(), {{8, 20}, {-1, 1, 20}, 16}, drawing);
    ASSERT_TRUE(rehearsal);
    EXPECT_EQ(cheapest(*rehearsal).period, 1);
}

TEST(Rehearse, StopsAndSaysSo) {
    RatedDrawing drawing;
    std::stop_source stop;
    int reported = 0;
    const WorkContext context{stop.get_token(), [&](double) {
                                  if (++reported == 5)
                                      stop.request_stop();
                              }};
    const auto rehearsal = rehearse(randomJob(3), lee(), {{8}, {20}, 16}, drawing, context);
    ASSERT_FALSE(rehearsal);
    EXPECT_STREQ(rehearsal.error().front().id, "study-stopped");
    EXPECT_EQ(reported, 5);
}

TEST(Rehearse, RefusesMethodsWithoutRegions) {
    RatedDrawing drawing;
    DecimationParameters global;
    global.method = DecimationMethod::global;
    DecimationParameters none;
    none.method = DecimationMethod::none;
    DecimationParameters exact;
    exact.allowance = 0;
    for (const DecimationParameters& base : {global, none, exact}) {
        const auto rehearsal = rehearse(randomJob(3), base, {{8}, {20}, 16}, drawing);
        ASSERT_FALSE(rehearsal);
        EXPECT_STREQ(rehearsal.error().front().id, "nothing-to-optimise");
    }
}

TEST(Rehearse, TakesAProgramWithoutMotions) {
    RatedDrawing drawing;
    const StudyJob job{programOf("M30\n"), smallSetup()};
    const auto rehearsal = rehearse(job, lee(), rehearsalFor(job), drawing);
    ASSERT_TRUE(rehearsal);
    EXPECT_FALSE(rehearsal->forecasts.empty());
}

TEST(RehearsalFor, FitsMapAndProgram) {
    const RehearsalOptions options = rehearsalFor(randomJob(3)); // 80 × 60 cells, 220 blocks
    EXPECT_EQ(options.regions.front(), 5);
    EXPECT_EQ(options.regions.back(), 64);
    EXPECT_EQ(options.periods.front(), -1);
    EXPECT_EQ(options.periods.back(), 200);
}

} // namespace
} // namespace proveout
