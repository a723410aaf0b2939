// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/check/check.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <sstream>
#include <stop_token>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "core/cutting/fixtures/fixture_surface.h"
#include "core/verification/findings/check_findings.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr auto kAnyMemory = std::numeric_limits<std::uint64_t>::max();
const IdsWithReasons kAll{{"holder-not-given", {}}, {"shank-not-given", {}},   {"fixtures-not-given", {}},
                          {"travel-not-given", {}}, {"machine-not-given", {}}, {"tool-limits-not-given", {}}};
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
    EXPECT_EQ(all.answered({}, {}).verdict(), Verdict::unverified);
    EXPECT_EQ(reportOf(kClean, {}).verdict(), Verdict::unverified);
    EXPECT_EQ(reportOf(kClean, {}).answered(kAll, {}).verdict(), Verdict::safe);
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
}

// ---- waivers ----

const std::string kRapid = "G1 Z-2 F100\nX10\nG0 X20\nZ5\nM30\n";

/// The rules with a waiver of the only finding of a text.
CheckRules waiving(const std::string& text) {
    CheckRules rules{.accepted = kAll};
    const CheckReport report = reportOf(text);
    EXPECT_EQ(report.findings.size(), 1U);
    rules.waivers.push_back(report.waiverOf(report.findings.front(), "a hole is there", "M. Roth"));
    return rules;
}

TEST(Waivers, TakeAFindingOutOfTheVerdict) {
    const CheckRules rules = waiving(kHead + kRapid);
    const CheckReport report = reportOf(kHead + kRapid, rules);
    EXPECT_EQ(report.verdict(), Verdict::safe);
    EXPECT_EQ(report.faults(), 0U);
    ASSERT_EQ(report.findings.size(), 1U);
    ASSERT_TRUE(report.findings.front().waived);
    EXPECT_EQ(report.findings.front().waived->owner, "M. Roth");
    EXPECT_EQ(report.answered(kAll, {}).verdict(), Verdict::faults) << "withdrawn";
}

TEST(Waivers, StayWhereLinesAreInserted) {
    EXPECT_EQ(reportOf("(A)\n(B)\n" + kHead + kRapid, waiving(kHead + kRapid)).verdict(), Verdict::safe);
}

TEST(Waivers, EndWhereBlockSizeToolOrNumberChange) {
    const CheckRules rules = waiving(kHead + kRapid);
    const std::string otherTool = "G21 G90 G17\nT2 M6\nS1000 M3\nG0 X5 Y5 Z5\n" + kRapid;
    const std::string deeper = kHead + "G1 Z-2.01 F100\nX10\nG0 X20\nZ5\nM30\n";
    const std::string elsewhere = kHead + "G1 Z-2 F100\nX10\nG0 X21\nZ5\nM30\n";
    const std::string twice = kHead + "G1 Z-2 F100\nX10\nG0 X20\nG1 Y10\nG0 X10\nZ5\nM30\n";
    for (const std::string& text : {otherTool, deeper, elsewhere, twice}) {
        auto subject = subjectOf(text);
        subject.setup = setupWithTool(2, "ball:d=4");
        const auto report = check(subject, rules, kAnyMemory).value();
        EXPECT_EQ(report->verdict(), Verdict::faults) << text;
        const auto says = [](const CheckFinding& one) {
            return hasIdOf(one.diagnostic, check_finding::kWaiverUnused);
        };
        EXPECT_EQ(std::ranges::count_if(report->findings, says), 1) << text;
    }
}

/// What becomes of a waiver once T1 is another cutter.
struct Rewaived {
    std::size_t faults = 0;
    std::vector<std::string> unused = {}; ///< sentences
};

Rewaived afterChange(const std::string& text, const std::string& tool, const std::string& now,
                     const std::string& written = {}) {
    auto subject = subjectOf(text);
    subject.setup = setupWithTool(1, tool);
    CheckRules rules{.accepted = kAll};
    const auto before = check(subject, rules, kAnyMemory).value();
    const auto fault = std::ranges::find(before->findings, Severity::fault,
                                         [](const CheckFinding& one) { return one.diagnostic.severity; });
    EXPECT_NE(fault, before->findings.end()) << tool;
    rules.waivers.push_back(before->waiverOf(*fault, "a hole is there", "M. Roth"));
    EXPECT_FALSE(rules.waivers.front().cutter.empty());
    if (!written.empty())
        rules.waivers.front().cutter = written == "any" ? "" : written;
    subject.setup = setupWithTool(1, now);
    const auto after = check(subject, rules, kAnyMemory).value();
    Rewaived out{.faults = after->faults()};
    for (const CheckFinding& one : after->findings)
        if (hasIdOf(one.diagnostic, check_finding::kWaiverUnused))
            out.unused.push_back(message(one.diagnostic));
    return out;
}

TEST(Waivers, EndWhereTheCutterChanges) {
    // Both cut the same, straight down, to the depth of the tip.
    const std::string text = kHead + "G0 Z-2\nZ5\nM30\n";
    const Rewaived other = afterChange(text, "ball:d=4,l=20", "flat:d=4,l=20");
    EXPECT_EQ(other.faults, 1U);
    EXPECT_EQ(other.unused,
              std::vector<std::string>{"The waiver of rapid-cuts by M. Roth (a hole is there) has "
                                       "no effect: T1 is now “flat:d=4,l=20”, it was "
                                       "“ball:d=4,l=20”."});
    EXPECT_EQ(afterChange(text, "ball:d=4,l=20", "flat:d=4,l=20", "any").faults, 0U) << "of an older job";
    EXPECT_EQ(afterChange(text, "ball:d=4,l=20", "ball:d=4,l=20,z=2").faults, 1U);
}

TEST(Waivers, StayWhereTheFindingDoesNotDependOnTheChange) {
    const std::string text = kHead + "G0 Z-2\nZ5\nM30\n";
    const auto faults = [&](const std::string& now, const std::string& written = {}) {
        return afterChange(text, "ball:d=4,l=20", now, written).faults;
    };
    EXPECT_EQ(faults("ball:l=20.0,d=4"), 0U) << "another spelling";
    EXPECT_EQ(faults("ball:d=4,l=20,maxap=9"), 0U) << "a limit";
    EXPECT_EQ(faults("ball:d=4,l=20,so=60,holder=40x30"), 0U) << "a rapid is about the cutting edges";
    EXPECT_EQ(faults("ball:d=4,l=20", "ball: l=20, d=4, so=9, maxap=9"), 0U) << "as the tool table has it";
    EXPECT_EQ(faults("ball:d=4,l=20", "not a cutter"), 1U);
}

TEST(Waivers, OfTheHolderEndWithAnotherHolder) {
    const std::string text = kHead + "G1 Z-2 F100\nG0 Z5\nM30\n";
    const std::string tool = "flat:d=4,l=1,so=1.5,holder=20x10";
    EXPECT_EQ(afterChange(text, tool, tool).faults, afterChange(text, tool, tool + ",maxap=9").faults);
    EXPECT_GT(afterChange(text, tool, "flat:d=4,l=1,so=1.5,holder=20x11").faults,
              afterChange(text, tool, tool).faults);
}

TEST(Waivers, OfAnUnknownWordLeaveTheRestVerified) {
    const std::string text = kHead + "G1 Z-2 F100\nG987\nX20\nG0 Z5\nM30\n";
    EXPECT_EQ(reportOf(text, waiving(text)).verdict(), Verdict::safe);
    const std::string two = kHead + "G1 Z-2 F100\nG987\nX20\nG988\nG0 Z5\nM30\n";
    EXPECT_EQ(reportOf(two, waiving(text)).verdict(), Verdict::unverified);
}

TEST(Check, RulesAreTurnedOffForAllToolsOrOne) {
    const std::string text = kHead + "G1 Z-2 F100\nG0 X20\nZ5\nT2 M6\nS1000 M3\nG0 Y20\nZ-1\nZ5\nM30\n";
    auto subject = subjectOf(text);
    subject.setup = setupWithTool(2, "ball:d=4");
    const auto faults = [&](const IdsWithReasons& off) {
        return check(subject, {.off = off, .accepted = kAll}, kAnyMemory).value()->faults();
    };
    EXPECT_EQ(faults({}), 2U);
    EXPECT_EQ(faults({{"rapid-cuts:T1", {}}}), 1U);
    EXPECT_EQ(faults({{"rapid-cuts:T2", {}}}), 1U);
    EXPECT_EQ(faults({{"rapid-cuts", {}}}), 0U);
}

TEST(Check, AToolHasLimitsOfItsOwn) {
    // T1 goes 4 mm below the stock, T2 5 mm.
    const std::string text =
        kHead + "G1 Z-14 F100\nG0 Z5\nT2 M6\nS1000 M3\nG0 X9\nG1 Z-15 F100\nG0 Z5\nM30\n";
    auto subject = subjectOf(text);
    subject.setup = setupWithTool(2, "ball:d=4");
    const auto tools = [&](const RuleLimits& limits, const std::map<std::string, double>& own) {
        const auto report =
            check(subject, {.limits = limits, .accepted = kAll, .limitsOfTools = own}, kAnyMemory).value();
        std::vector<int> found;
        for (const CheckFinding& one : report->findings)
            if (one.diagnostic.id == std::string("table-collision"))
                found.push_back(one.tool);
        return found;
    };
    using Tools = std::vector<int>;
    EXPECT_EQ(tools({}, {}), (Tools{1, 2}));
    EXPECT_EQ(tools({}, {{"table-collision:T1.belowStock", 4}}), Tools{2});
    EXPECT_EQ(tools({}, {{"table-collision:T1.belowStock", 4}, {"table-collision:T2.belowStock", 5}}),
              Tools{});
    EXPECT_EQ(tools({.belowStock = 9}, {{"table-collision:T2.belowStock", 4.5}}), Tools{2});
    EXPECT_EQ(tools({}, {{"rapid-cuts:T1.belowStock", 9}}), (Tools{1, 2})) << "of another rule";
    const auto report =
        check(subject, {.accepted = kAll, .limitsOfTools = {{"rapid-cuts:T1.belowStock", 9}}}, kAnyMemory)
            .value();
    EXPECT_TRUE(std::ranges::any_of(report->findings, [](const CheckFinding& one) {
        return one.diagnostic.id == std::string("rule-setting-unknown");
    }));
}

TEST(Check, ARapidOfACycleMayBeTheDeepest) {
    // A cycle in G18 moves to its hole below it, long after the first contact.
    std::string text = "G1 Z-1 F100\nG0 Z5\n";
    for (int k = 0; k < 90; ++k)
        text += fmt::format("G1 X{} Z5 F9000\n", k % 2);
    text += "G0 X-10 Y20\nG0 Z-6\nG18 G99 G81 X15 Z-0.5 Y10 R25 F300\nG80\nG17\nM30\n";
    auto subject = subjectOf(kHead + text);
    subject.setup = setupWithTool(1, "flat:d=6,l=30,maxap=2");
    const auto isDeep = [](const CheckFinding& one) {
        return one.diagnostic.id == std::string("depth-limit");
    };
    const auto count = [&](const CheckRules& rules) {
        return std::ranges::count_if(check(subject, rules, kAnyMemory).value()->findings, isDeep);
    };
    CheckRules rules{.off = {{"full-slot", ""}}, .accepted = kAll};
    rules.limits.airSeconds = 0; // which needs all records
    EXPECT_EQ(count(rules), 1);
    rules.limits.airSeconds = 1000;
    EXPECT_EQ(count(rules), 1);
}

TEST(Check, AClearanceOfOneToolAloneIsJudged) {
    auto subject = subjectOf(kHead + "G1 Z-2 F100\nG0 Z0.5\nX20\nM30\n");
    const auto found = [&](const std::string& name) {
        const auto report =
            check(subject, {.accepted = kAll, .limitsOfTools = {{name, 1}}}, kAnyMemory).value();
        return std::ranges::any_of(report->findings, [](const CheckFinding& one) {
            return one.diagnostic.id == std::string("rapid-too-close");
        });
    };
    EXPECT_TRUE(found("rapid-too-close:T1.rapidClearance"));
    EXPECT_FALSE(found("rapid-too-close:T2.rapidClearance"));
}

TEST(Check, NamesUnknownIdsOfTheJob) {
    const CheckReport report =
        reportOf(kClean, {.off = {{"rapid-cut", {}}, {"full-slot:T3", {}}}, .accepted = {{"travel", {}}}});
    std::vector<std::string> unknown;
    for (const CheckFinding& one : report.findings)
        unknown.push_back(one.diagnostic.arguments.front().text());
    EXPECT_EQ(unknown, (std::vector<std::string>{"rapid-cut", "travel"}));
}

// ---- travel ----

/// The check of a text on a machine whose travel is that of the program coordinates given.
CheckReport onMachine(const std::string& text, const Box3& travel, const std::string& tool) {
    auto subject = subjectOf(text);
    subject.setup = setupWithTool(1, tool);
    Machine machine;
    machine.largestSpindle = 20'000;
    std::tie(machine.offsetX, machine.offsetY, machine.offsetZ) = std::tuple(-200.0, -100.0, -300.0);
    std::tie(machine.minX, machine.minY, machine.minZ) =
        std::tuple(travel.lo.x - 200, travel.lo.y - 100, travel.lo.z - 300);
    std::tie(machine.maxX, machine.maxY, machine.maxZ) =
        std::tuple(travel.hi.x - 200, travel.hi.y - 100, travel.hi.z - 300);
    subject.machine = machine;
    return *check(subject, {.accepted = kAll}, kAnyMemory).value();
}

bool leaves(const CheckReport& report, const std::string& id) {
    return std::ranges::any_of(report.notChecked, [&](const NotChecked& one) { return one.row->id == id; });
}

TEST(Travel, IsJudgedWithArcsAndTheLengthOfTheTool) {
    // The arc reaches X25, and the face of the spindle is 80 mm above the tip.
    const std::string text = kHead + "G1 Z-2 F100\nG3 X5 Y25 I10 J10\nG0 Z5\nM30\n";
    const double farX = 15 + std::sqrt(200.0);
    const std::string tool = "ball:d=4,l=20,so=50,holder=40x30";
    const auto report = [&](double x, double z) {
        return onMachine(text, {Vec3(0, 0, 78), Vec3(x, 40, z)}, tool);
    };
    EXPECT_EQ(report(farX, 85).faults(), 0U);
    EXPECT_FALSE(leaves(report(farX, 85), "travel-not-given"));
    EXPECT_FALSE(leaves(report(farX, 85), "tool-length-not-given"));
    const CheckReport beyondX = report(farX - 0.5, 85);
    ASSERT_EQ(beyondX.faults(), 1U);
    EXPECT_NEAR(beyondX.findings.front().value, 0.5, 1e-9);
    EXPECT_EQ(beyondX.findings.front().diagnostic.where.line, 6);
    EXPECT_EQ(report(farX, 84.5).findings.front().diagnostic.where.line, 4) << "the first of three blocks";
    EXPECT_EQ(report(farX, 84.5).findings.front().count, 3U);
}

TEST(Travel, OfZNeedsTheLengthOfTheTool) {
    const std::string text = kHead + "G1 Z-2 F100\nG0 Z5\nM30\n";
    const CheckReport report = onMachine(text, {Vec3(0), Vec3(40, 40, 4)}, "ball:d=4,l=20");
    EXPECT_EQ(report.faults(), 0U);
    EXPECT_TRUE(leaves(report, "tool-length-not-given"));
}

TEST(Travel, IsNotCheckedWithoutAPlaceOfThePart) {
    auto subject = subjectOf(kClean);
    Machine machine;
    std::tie(machine.maxX, machine.maxY, machine.maxZ) = std::tuple(1.0, 1.0, 1.0);
    subject.machine = machine;
    const auto report = check(subject, {.accepted = kAll}, kAnyMemory).value();
    EXPECT_EQ(report->faults(), 0U);
    EXPECT_TRUE(leaves(*report, "travel-not-given"));
}

// ---- tool changes ----

/// The findings of tool changes of a text on a machine that changes tools at these program coordinates of
/// the spindle, whose tools are 80 mm long.
std::vector<CheckFinding> changesOf(const std::string& text, std::optional<double> x, std::optional<double> z,
                                    const std::string& tool = "ball:d=4,l=20,so=50,holder=40x30") {
    auto subject = subjectOf(text);
    auto setup = std::make_shared<proveout::Setup>(*setupWithTool(1, tool));
    setup->tools.set(2, parseCutter("ball:d=4,l=20,so=50,holder=40x30").value());
    subject.setup = setup;
    Machine machine;
    std::tie(machine.offsetX, machine.offsetY, machine.offsetZ) = std::tuple(-200.0, -100.0, -300.0);
    if (x)
        machine.changeX = *x - 200;
    if (z)
        machine.changeZ = *z - 300;
    subject.machine = machine;
    const auto report = check(subject, {.accepted = kAll}, kAnyMemory).value();
    std::vector<CheckFinding> found;
    for (const CheckFinding& one : report->findings)
        if (one.diagnostic.id == std::string("tool-change-position"))
            found.push_back(one);
    return found;
}

TEST(ToolChanges, AreWhereTheMachineWantsThem) {
    const std::string text = kHead + "G1 Z-2 F100\nG0 Z20\n(A)\nT2 M6\nG0 X9\nZ21\nT1 M6\nM30\n";
    EXPECT_TRUE(changesOf(text, {}, {}).empty());
    const auto low = changesOf(text, {}, 101); // Z21 of a tool of 80 mm
    ASSERT_EQ(low.size(), 1U) << "the second one is there, and the first one of the program is anywhere";
    EXPECT_NEAR(low[0].value, 1, 1e-9);
    EXPECT_EQ(low[0].limit, -199);
    EXPECT_EQ(low[0].diagnostic.where.line, 8) << "the line of M6";
    EXPECT_EQ(low[0].lastLine, 8);
    EXPECT_EQ(low[0].tool, 1) << "the tool that is put away";
    const auto aside = changesOf(text, 0, {});
    ASSERT_EQ(aside.size(), 2U) << "of two tools";
    EXPECT_NEAR(aside[1].value, 9, 1e-9);
    EXPECT_EQ(aside[1].diagnostic.where.line, 11);
}

TEST(ToolChanges, InUnknownPositionsAreNotJudged) {
    EXPECT_TRUE(changesOf(kHead + "G1 Z-2 F100\nG28 Z5\nT2 M6\nM30\n", {}, 101).empty())
        << "the reference position";
    const std::string text = kHead + "G1 Z-2 F100\nG0 Z20\nT2 M6\nM30\n";
    EXPECT_EQ(changesOf(text, {}, 101).size(), 1U);
    EXPECT_TRUE(changesOf(text, {}, 101, "ball:d=4,l=20").empty()) << "the length is not known";
    EXPECT_TRUE(changesOf(kHead + "G1 Z-2 F100\nG0 Z20\nM61 Q2\nM30\n", {}, 101).empty()) << "no change";
}

// ---- clearance of holders ----

TEST(HolderClearance, IsNeverUnderestimatedAndByNoMoreThanTheGridTooLarge) {
    const std::uint32_t seed = randomSeed();
    std::mt19937 random(seed);
    const auto between = [&](double least, double most) {
        return std::uniform_real_distribution(least, most)(random);
    };
    for (int round = 0; round < roundsOf(200); ++round) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << " round " << round);
        // A round pocket, then a tool in it: its holder is `aside` narrower, `above` higher than the floor of
        // nothing that it could meet.
        const double pocket = between(6, 9);
        const double gap = between(0.3, 2.5);
        const double clearance = between(0.5, 2.5);
        auto setup =
            std::make_shared<proveout::Setup>(*setupWithTool(1, fmt::format("flat:d={}", 2 * pocket)));
        setup->tools.set(
            2, parseCutter(fmt::format("flat:d=4,l=5,so=5,holder={}x30", 2 * (pocket - gap))).value());
        const std::string text = fmt::format(
            "G21 G90\nT1 M6\nM3 S1000\nG0 X{0} Y{1} Z5\nG1 Z-4 F100\nG0 Z9\nT2 M6\nM3 S1000\nG0 X{0} "
            "Y{1} Z5\nG1 Z-7 F100\nG0 Z9\nM30\n",
            between(18, 22), between(13, 17));
        CheckRules rules{.accepted = kAll};
        rules.limits.holderClearance = clearance;
        const auto report = check({.program = programOf(text), .setup = setup}, rules, kAnyMemory).value();
        const auto found = std::ranges::find_if(report->findings, [](const CheckFinding& one) {
            return one.diagnostic.id == std::string("holder-near");
        });
        const double missing = found == report->findings.end() ? 0 : found->value;
        const double grid = std::hypot(0.5, 0.5);
        EXPECT_GE(missing, std::min(clearance, clearance - gap) - 2e-3);
        EXPECT_LE(missing, std::max(0.0, std::min(clearance, clearance - gap + grid)) + 2e-3);
        EXPECT_EQ(report->faults(), 0U) << "the holder goes down to 2 mm below the top, above the floor at 4";
    }
}

// ---- fixtures of files ----

TEST(Check, OfAFixtureThatCannotBeReadIsUnverified) {
    auto subject = subjectOf(kClean);
    auto setup = std::make_shared<proveout::Setup>(*smallSetup());
    const auto verdictWith = [&](std::shared_ptr<const FixtureSurface> surface) {
        setup->fixtures = {
            {"vice", FixtureMesh{.x = 100, .file = "/vice.stl", .surface = std::move(surface)}}};
        subject.setup = std::make_shared<const proveout::Setup>(*setup);
        return check(subject, {.accepted = kAll}, kAnyMemory).value();
    };
    const std::vector<FixtureFacet> facet{{glm::vec3(0), glm::vec3(9, 0, 0), glm::vec3(0, 9, 0)}};
    EXPECT_EQ(verdictWith(std::make_shared<const FixtureSurface>(facet))->verdict(), Verdict::safe);
    Diagnostic hole = diagnosticOf(check_finding::kCheckFailed, {"a hole"});
    hole.unverified = true;
    EXPECT_EQ(verdictWith(std::make_shared<const FixtureSurface>(facet, Diagnostics{hole}))->verdict(),
              Verdict::unverified);
    const auto missing =
        verdictWith(std::make_shared<const FixtureSurface>(std::vector<FixtureFacet>(), Diagnostics{hole}));
    EXPECT_EQ(missing->verdict(), Verdict::unverified);
    ASSERT_FALSE(missing->findings.empty());
    EXPECT_EQ(
        message(missing->findings.front().diagnostic),
        "The fixture \"vice\" is not checked, because its file cannot be used: The check failed: a hole.");
    EXPECT_EQ(missing->findings.front().diagnostic.file, "/vice.stl");
    EXPECT_EQ(missing->ofText, 0U) << "the window has no other source of it";
    EXPECT_EQ(verdictWith(nullptr)->verdict(), Verdict::unverified);
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

/// A version of a program: some lines changed, removed or inserted.
std::string edited(const std::string& text, std::mt19937& random) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    const std::size_t at = 4 + random() % (lines.size() - 5);
    const std::string cut =
        fmt::format("G{} X{} Y{} Z-{}", random() % 2, random() % 40, random() % 30, random() % 4);
    if (random() % 3 == 0)
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at));
    else if (random() % 2 == 0)
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at), cut);
    else
        lines[at] = cut;
    std::string out;
    for (const std::string& line : lines)
        out += line + '\n';
    return out;
}

bool alike(const CheckReport& a, const CheckReport& b) {
    const auto contact = [](const CheckedContact& one, const CheckedContact& other) {
        return one.line == other.line && one.of.block == other.of.block && one.of.start == other.of.start;
    };
    return a.findings == b.findings && a.verdict() == b.verdict() &&
           std::ranges::equal(a.firstContacts, b.firstContacts, contact);
}

TEST(Checker, OfAnEditedProgramFindsWhatACheckOfItAloneFinds) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    Checker checker(1'000'000);
    CheckRules rules{.accepted = kAll};
    std::string text = kHead + randomProgram(seed, 60);
    const auto setup = smallSetup();
    for (int round = 0; round < roundsOf(60); ++round) {
        rules.limits.rapidClearance = round % 7 == 0 ? 1 : 0;
        rules.limits.airSeconds = round % 5 == 0 ? 1 : 10; // which needs records that were not kept
        text = edited(text, random);
        const CheckSubject subject{.program = programOf(text), .setup = setup};
        std::stop_source stop;
        if (random() % 4 == 0) { // a check that was stopped somewhere must leave no trace
            const double until = static_cast<double>(random() % 100) / 100;
            (void)checker.check(subject, rules, kAnyMemory, {stop.get_token(), [&](double done) {
                                                                 if (done >= until)
                                                                     stop.request_stop();
                                                             }});
            text = edited(text, random);
        }
        const CheckSubject next{.program = programOf(text), .setup = setup};
        const auto continued = checker.check(next, rules, kAnyMemory).value();
        const auto alone = check(next, rules, kAnyMemory).value();
        ASSERT_TRUE(alike(*continued, *alone)) << "round " << round << '\n' << text;
    }
}

TEST(Checker, DoesNotCutAgainWhatAnEditHasNotChanged) {
    const std::string text = randomProgram(3, 400);
    const std::size_t last = text.rfind("G0", text.size() - 40);
    Checker checker(10'000'000);
    ASSERT_TRUE(checker.check(subjectOf(text), {}, kAnyMemory));
    const std::size_t all = checker.blocksCut();
    CheckSubject subject = subjectOf(text.substr(0, last) + "G0 Z9\n" + text.substr(last));
    ASSERT_TRUE(checker.check(subject, {}, kAnyMemory));
    EXPECT_LT(checker.blocksCut(), all / 2);
    ASSERT_TRUE(checker.check(subject, {}, 10'000'000)) << "in which there is no room to keep anything";
    ASSERT_TRUE(checker.check(subject, {}, kAnyMemory));
    EXPECT_GE(checker.blocksCut(), all);
    subject.setup = smallSetup(0.25);
    ASSERT_TRUE(checker.check(subject, {}, kAnyMemory));
    EXPECT_GE(checker.blocksCut(), all) << "another grid";
}

TEST(Check, SaysWhatAnEditHasChanged) {
    const CheckReport rapid = reportOf(kHead + "G1 Z-2 F100\nX10\nG0 X20\nZ5\nM30\n");
    const CheckReport laterRapid = reportOf(kHead + "(A)\nG1 Z-2 F100\nX10\nG0 X20\nZ5\nM30\n");
    const CheckReport stopped = reportOf(kHead + "G1 Z-2 F100\nM5\nX10\nG0 Z5\nM30\n");
    EXPECT_EQ(changeBetween(rapid, laterRapid), CheckChange()) << "only its line is another one";
    EXPECT_EQ(changeBetween(rapid, stopped), (CheckChange{1, 1}));
    EXPECT_EQ(changeBetween(reportOf(kClean), stopped), (CheckChange{1, 0}));
    ASSERT_EQ(missingFrom(stopped, rapid).size(), 1U);
    EXPECT_STREQ(missingFrom(stopped, rapid).front().diagnostic.id, "rapid-cuts");
    EXPECT_STREQ(missingFrom(rapid, stopped).front().diagnostic.id, "spindle-stopped");
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
