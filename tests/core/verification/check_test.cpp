// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/check/check.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/verification/findings/check_findings.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

constexpr auto kAnyMemory = std::numeric_limits<std::uint64_t>::max();
const std::set<std::string> kAll{"holder-not-given", "shank-not-given",   "fixtures-not-given",
                                 "travel-not-given", "machine-not-given", "tool-limits-not-given"};
const std::string kHead = "G21 G90 G17\nT1 M6\nS1000 M3\nG0 X5 Y5 Z5\n";
const std::string kClean = kHead + "G1 Z-2 F100\nX20\nG0 Z5\nM5\nM30\n";

CheckSubject subjectOf(const std::string& text) {
    return {.program = programOf(text), .setup = smallSetup()};
}

CheckReport reportOf(const std::string& text, const CheckRules& rules = {.accepted = kAll}) {
    const auto report = check(subjectOf(text), rules, kAnyMemory);
    EXPECT_TRUE(report.has_value());
    return report ? **report : CheckReport();
}

TEST(Check, OfACleanProgramIsSafeOnceAllIsAccepted) {
    const CheckReport all = reportOf(kClean);
    EXPECT_EQ(all.verdict(), Verdict::safe);
    EXPECT_TRUE(all.findings.empty());
    EXPECT_EQ(all.accepting({}).verdict(), Verdict::unverified);
    EXPECT_EQ(reportOf(kClean, {}).verdict(), Verdict::unverified);
    EXPECT_EQ(reportOf(kClean, {}).accepting(kAll).verdict(), Verdict::safe);
}

TEST(Check, HasTheBlocksOfAFault) {
    // The rapids are in lines 7 and 9, the 4th and the 6th block that moves; they cut 2 and 3 mm deep.
    const CheckReport report = reportOf(kHead + "G1 Z-2 F100\nX10\nG0 X20\nG1 Y10 Z-3\nG0 X8\nZ5\nM30\n");
    ASSERT_EQ(report.findings.size(), 1U);
    const CheckFinding& rapid = report.findings.front();
    EXPECT_STREQ(rapid.diagnostic.id, "rapid-cuts");
    EXPECT_EQ(rapid.diagnostic.where.line, 7);
    EXPECT_EQ(rapid.lastLine, 9);
    EXPECT_EQ(rapid.block, 4U);
    EXPECT_EQ(rapid.count, 2U);
    EXPECT_EQ(rapid.tool, 1);
    EXPECT_NEAR(rapid.value, 3, 1e-3);
    EXPECT_STREQ(rapid.unit, "mm");
    EXPECT_EQ(report.faults(), 1U);
    EXPECT_EQ(report.verdict(), Verdict::faults);
}

TEST(Check, OfAProgramWithAnUnknownWordIsUnverified) {
    const CheckReport report = reportOf(kHead + "G1 Z-2 F100\nG987\nX20\nG0 Z5\nM30\n");
    EXPECT_EQ(report.verdict(), Verdict::unverified);
    EXPECT_TRUE(report.programUnverified);
}

TEST(Check, IsRefusedWithoutTheMemoryForIt) {
    const CheckSubject subject = subjectOf(kClean);
    const double needed = checkBytes(subject).value();
    EXPECT_GT(needed, 81 * 61 * 4) << "a height of 4 bytes per grid point at least";
    const auto refused = check(subject, {}, static_cast<std::uint64_t>(needed) - 1);
    ASSERT_FALSE(refused.has_value());
    EXPECT_TRUE(hasIdOf(refused.error().front(), check_finding::kCheckNeedsMemory));
    EXPECT_TRUE(check(subject, {}, static_cast<std::uint64_t>(needed) + 1).has_value());
}

TEST(Check, IsStoppedWithin200Milliseconds) {
    std::stop_source stop;
    const CheckSubject subject{.program = programOfOneLongBlock(), .setup = wideSetup()};
    using Clock = std::chrono::steady_clock;
    Clock::time_point asked;
    std::jthread user([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        asked = Clock::now();
        stop.request_stop();
    });
    const auto report = check(subject, {}, kAnyMemory, {stop.get_token(), {}});
    const auto ended = Clock::now();
    user.join();
    ASSERT_TRUE(report.has_value());
    EXPECT_EQ(*report, nullptr) << "it ended before it was stopped";
    EXPECT_LT(ended - asked, std::chrono::milliseconds(200));
}

TEST(Check, SaysWhatAnEditHasChanged) {
    const CheckReport rapid = reportOf(kHead + "G1 Z-2 F100\nX10\nG0 X20\nZ5\nM30\n");
    const CheckReport laterRapid = reportOf(kHead + "(A)\nG1 Z-2 F100\nX10\nG0 X20\nZ5\nM30\n");
    const CheckReport stopped = reportOf(kHead + "G1 Z-2 F100\nM5\nX10\nG0 Z5\nM30\n");
    EXPECT_EQ(changeBetween(rapid, laterRapid), CheckChange()) << "only its line is another one";
    EXPECT_EQ(changeBetween(rapid, stopped), (CheckChange{1, 1}));
    EXPECT_EQ(changeBetween(reportOf(kClean), stopped), (CheckChange{1, 0}));
}

TEST(Check, ReportsItsProgress) {
    std::vector<double> done;
    const auto report = check(subjectOf(randomProgram(1, 400)), {}, kAnyMemory,
                              {{}, [&](double part) { done.push_back(part); }});
    ASSERT_TRUE(report.has_value());
    ASSERT_FALSE(done.empty());
    EXPECT_TRUE(std::ranges::is_sorted(done));
    EXPECT_EQ(done.back(), 1.0);
}

TEST(Check, WithoutAStockJudgesTheTextOnly) {
    CheckSubject subject = subjectOf(kHead + "G1 Z-2 F100\nX10\nG0 X20\nM30\n");
    subject.hasStock = false;
    const auto report = check(subject, {}, 0);
    ASSERT_TRUE(report.has_value());
    EXPECT_EQ((*report)->faults(), 0U);
    EXPECT_EQ((*report)->verdict(), Verdict::unverified);
    EXPECT_STREQ((*report)->notChecked.front().row->id, "stock-not-given");
}

} // namespace
} // namespace proveout
