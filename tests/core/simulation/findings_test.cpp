// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/simulation/run/finding_log.h"
#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

using testing::HasSubstr;

Diagnostics findingsOf(const std::string& text, const std::shared_ptr<const Setup>& setup = smallSetup()) {
    const auto simulation = startedSimulation(programOf(text), setup, {});
    simulation->seek(simulation->blockCount());
    return simulation->frame().findings;
}

const Diagnostic* find(const Diagnostics& diagnostics, const std::string& id) {
    const auto found = std::ranges::find_if(diagnostics, [&](const Diagnostic& d) { return d.id == id; });
    return found == diagnostics.end() ? nullptr : &*found;
}

TEST(Findings, NoneInASoundProgram) {
    EXPECT_TRUE(findingsOf("T1 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX30 Y20\nG3 I-3\nG0 Z5\nX0 Y0\nM30\n").empty());
}

TEST(Findings, RapidThatCutsIsAFaultWithItsDepth) {
    const auto findings = findingsOf("T1 M6\nG0 X5 Y5 Z5\nZ-3\nX30\nG0 Z5\n");
    const auto* found = find(findings, "rapid-cuts");
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->severity, Severity::fault);
    EXPECT_EQ(found->where.line, 3);
    EXPECT_THAT(message(*found), HasSubstr("3.000 mm"));
    EXPECT_EQ(std::ranges::count_if(findings, [](const Diagnostic& d) { return d.where.line == 5; }), 0)
        << "a retract from where the cut ended removes nothing";
}

TEST(Findings, RapidAlongAStockFaceOrACutWallIsNone) {
    const auto setup = setupWithTool(1, "flat:d=4,l=20");
    EXPECT_TRUE(findingsOf("T1 M6\nG0 X5 Y5 Z0\nX30\nG1 Z-4 F100\nX10\nG0 X30\nZ0\nX0 Y0\n", setup).empty());
}

TEST(Findings, RapidFromAnUnknownPositionIntoTheStockIsUnverified) {
    const auto findings = findingsOf("T1 M6\nG0 Z-8\nG0 X10 Y5\n");
    ASSERT_EQ(findings.size(), 2U);
    for (std::size_t index = 0; index < 2; ++index) {
        EXPECT_STREQ(findings[index].id, "rapid-unchecked");
        EXPECT_TRUE(findings[index].unverified);
        EXPECT_EQ(findings[index].where.line, static_cast<int>(index) + 2);
        EXPECT_THAT(message(findings[index]), HasSubstr("8.000 mm below"));
    }
}

TEST(Findings, RapidOverTheStockAtAnUnknownHeightIsUnverified) {
    const auto findings = findingsOf("T1 M6\nG0 X0 Y0\nG0 X30\nG0 Z5\n");
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_STREQ(findings[0].id, "rapid-unchecked");
    EXPECT_TRUE(findings[0].unverified);
    EXPECT_EQ(findings[0].where.line, 3);
    for (const char* beside : {"G0 X0 Y-3\nG0 X30\nG0 Z5", "G0 X0 Y0\nG0 Z5\nX30", "G0 X0\nG0 Y0\nG0 Z5"})
        EXPECT_TRUE(findingsOf(fmt::format("T1 M6\n{}\n", beside)).empty()) << beside;
}

TEST(Findings, RapidToAnUnknownPlaceAtAnUnknownHeightIsUnverified) {
    const auto findings = findingsOf("T1 M6\nG0 X-20 Y10\nG53 G0 X0 Y0\nG0 X5 Y5 Z5\n");
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_STREQ(findings[0].id, "rapid-unchecked");
    EXPECT_EQ(findings[0].where.line, 3);
    EXPECT_TRUE(findingsOf("T1 M6\nG0 X-20 Y10\nG53 G0 Z0\nG53 G0 X0 Y0\nG0 X5 Y5\nZ5\n").empty())
        << "at the machine's zero";
    EXPECT_TRUE(findingsOf("T1 M6\nG0 X5 Y-30\nG53 G0 X0\nG0 Z5\nX5 Y5\n").empty()) << "beside the stock";
}

TEST(Findings, RapidFromAnUnknownPositionThatEndsClearOfTheStockIsNone) {
    for (const char* start : {"G0 Z0", "G0 X10 Y5", "G0 X10 Y5 Z1", "G0 X-2.1 Y5 Z-8", "G0 X42.1\nG0 Z-8"})
        EXPECT_TRUE(findingsOf(fmt::format("T1 M6\n{}\n", start)).empty()) << start;
}

TEST(Findings, RapidFromAnUnknownPositionIsMeasuredAgainstTheStockThatIsLeft) {
    const std::string pocket = "T1 M6\nG0 X20 Y15 Z5\nG1 Z-8 F100\nG91 G28 Z0\nG90\n";
    EXPECT_EQ(find(findingsOf(pocket + "G0 X20 Y15 Z-7\n"), "rapid-unchecked"), nullptr);
    EXPECT_NE(find(findingsOf(pocket + "G0 X10 Y15 Z-7\n"), "rapid-unchecked"), nullptr);
}

TEST(Findings, TheReferencePositionIsClearOfThePart) {
    const std::string pocket = "T1 M6\nG0 X20 Y15 Z5\nG1 Z-8 F100\n";
    for (const char* rest : {"G91 G28 Z0\nG28 X0 Y0\nG90 G0 X5 Y5\nG0 Z5\n", "G0 Z5\nG28\nG0 X5 Y5\n",
                             "G53 G0 Z0\nG53 X0 Y0\nG0 X5 Y5\nZ2\n"})
        EXPECT_TRUE(findingsOf(pocket + rest).empty()) << rest;
    // All axes at once out of a pocket, and a machine height that is unknown.
    for (const char* rest : {"G28\n", "G53 G0 Z-100\nG0 X5 Y5\n", "G91 G28 Z0\nG90 G0 X10 Y15 Z-7\n"})
        EXPECT_NE(find(findingsOf(pocket + rest), "rapid-unchecked"), nullptr) << rest;
}

TEST(Findings, ReportLargeToolNumbersExactly) {
    const auto findings = findingsOf("T16777217 M6\nG0 X5 Y5 Z5\n");
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_THAT(message(findings[0]), HasSubstr("T16777217 "));
}

/// Findings for the small stock, and a tool that cuts in a rapid, deeper than its flutes.
Diagnostics faultsWith(const ToolOrigin& origin) {
    proveout::Setup setup = *smallSetup();
    setup.tools.set(7, parseCutter("flat:d=4,l=1").value(), origin);
    return findingsOf("T7 M6\nG0 X5 Y5 Z5\nZ-3\nX30\nG0 Z5\n",
                      std::make_shared<const proveout::Setup>(setup));
}

TEST(Findings, OfAToolThatIsNotConfirmedAreNoFaults) {
    for (const ToolOrigin& origin :
         {ToolOrigin{ToolSource::assumed}, ToolOrigin{ToolSource::comment, 3, "T7 D4", {}}}) {
        const auto findings = faultsWith(origin);
        for (const Diagnostic& finding : findings) {
            EXPECT_EQ(finding.severity, Severity::warning) << message(finding);
            EXPECT_TRUE(finding.unverified) << message(finding);
            EXPECT_THAT(message(finding), HasSubstr("T7"));
        }
        EXPECT_NE(find(findings, "rapid-cuts"), nullptr);
        EXPECT_NE(find(findings, "depth-beyond-flutes"), nullptr);
        const auto* reported = find(findings, "tool-unconfirmed");
        ASSERT_NE(reported, nullptr);
        EXPECT_EQ(reported->where.line, origin.source == ToolSource::comment ? 3 : 2);
    }
    const auto given = faultsWith({});
    EXPECT_EQ(find(given, "rapid-cuts")->severity, Severity::fault);
    EXPECT_EQ(find(given, "tool-unconfirmed"), nullptr);
}

TEST(Findings, AToolThatIsNotConfirmedIsDescribedInWords) {
    const auto reported = [](const ToolOrigin& origin) {
        const auto findings = faultsWith(origin);
        const auto* finding = find(findings, "tool-unconfirmed");
        return finding == nullptr ? "" : message(*finding);
    };
    EXPECT_EQ(reported({ToolSource::comment, 3, "T7 D4", {}}),
              "T7 is read from a comment (⌀ 4 mm Flat end mill); it is not confirmed.");
    EXPECT_EQ(reported({ToolSource::comment, 3, "T7 D4", {"shape", "l"}}),
              "T7 is read from a comment (⌀ 4 mm Flat end mill; assumed: Shape, Flute length); it is not "
              "confirmed.");
    EXPECT_EQ(reported({ToolSource::assumed}),
              "The sizes of T7 are assumed (⌀ 4 mm Flat end mill); they are not confirmed.");
}

TEST(Findings, AFaultIsNotHiddenByOneOfAnUnconfirmedTool) {
    FindingLog log;
    const auto program = programOf("T1 M6\nG0 X5 Y5 Z5\nM98 P1\n");
    log.add(0, FindingKind::rapidCuts, 5, true);
    log.add(0, FindingKind::rapidCuts, 2, false); // in the same block
    const auto findings = log.diagnostics(*program, {});
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].severity, Severity::fault);
    EXPECT_THAT(message(findings[0]), HasSubstr("5.000"));
}

TEST(Findings, UndefinedToolCutsNothingAndIsUnverified) {
    const auto simulation =
        startedSimulation(programOf("T7 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX30\n"), smallSetup(), {});
    simulation->seek(3);
    const Frame frame = simulation->frame();
    EXPECT_EQ(frame.removedMm3, 0);
    EXPECT_EQ(frame.tool, 7);
    ASSERT_EQ(frame.findings.size(), 1U) << "told once, where the tool is missed first";
    const auto* found = find(frame.findings, "tool-undefined");
    ASSERT_NE(found, nullptr);
    EXPECT_TRUE(found->unverified);
    EXPECT_EQ(found->severity, Severity::error);
    EXPECT_EQ(found->where.line, 2);
    EXPECT_THAT(message(*found), HasSubstr("T7"));
}

TEST(Findings, CuttingWithoutAToolIsUnverified) {
    const auto setup = setupWithTool(2, "flat:d=4,l=20"); // two tools, so none can be assumed
    const auto findings = findingsOf("G0 X5 Y5 Z5\nG1 Z-2 F100\nX30\n", setup);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_STREQ(findings[0].id, "no-tool");
    EXPECT_TRUE(findings[0].unverified);
    EXPECT_EQ(findings[0].where.line, 2);
}

TEST(Findings, TheOnlyToolIsAssumedAndNothingIsVerified) {
    const auto simulation = startedSimulation(programOf("G0 X5 Y5 Z5\nG1 Z-2 F100\nX30\n"), smallSetup(), {});
    simulation->seek(3);
    const Frame frame = simulation->frame();
    EXPECT_GT(frame.removedMm3, 0);
    EXPECT_EQ(frame.tool, 1);
    EXPECT_TRUE(frame.toolAssumed);
    ASSERT_EQ(frame.findings.size(), 1U);
    EXPECT_STREQ(frame.findings[0].id, "tool-assumed");
    EXPECT_EQ(frame.findings[0].severity, Severity::warning);
    EXPECT_TRUE(frame.findings[0].unverified);
}

TEST(Findings, DepthBeyondTheFlutesIsAFault) {
    const auto setup = setupWithTool(1, "flat:d=4,l=3");
    const auto findings = findingsOf("T1 M6\nG0 X5 Y5 Z5\nG1 Z-3 F100\nX10\nZ-6.5\nG0 Z5\n", setup);
    ASSERT_EQ(findings.size(), 1U) << "3 mm at once is as long as the flutes";
    EXPECT_STREQ(findings[0].id, "depth-beyond-flutes");
    EXPECT_EQ(findings[0].severity, Severity::fault);
    EXPECT_EQ(findings[0].where.line, 5);
}

/// A slot along the stock for tool 1, then a wider one below it for tool 2.
std::string tSlot(const char* depth) {
    return fmt::format("T1 M6\nG0 X-15 Y15 Z5\nZ{0}\nG1 X55 F100\nG0 Z5\n"
                       "T2 M6\nG0 X-15 Y15 Z5\nZ{0}\nG1 X55\nG0 X60\nZ5\n",
                       depth);
}

std::shared_ptr<const Setup> tSlotSetup(const char* slot, const char* head) {
    auto setup = std::make_shared<Setup>(*setupWithTool(1, slot));
    setup->tools.set(2, parseCutter(head).value());
    return setup;
}

TEST(Findings, WhatStaysAboveAHeadIsUnverifiedWithVolumeAndPlace) {
    const auto setup = tSlotSetup("flat:d=6,l=20", "tslot:d=14,w=3,neck=6");
    const auto findings = findingsOf(tSlot("-8"), setup);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_STREQ(findings[0].id, "overhang-lost");
    EXPECT_TRUE(findings[0].unverified);
    EXPECT_EQ(findings[0].severity, Severity::error);
    EXPECT_EQ(findings[0].where.line, 9);
    ASSERT_EQ(findings[0].arguments.size(), 4U);
    EXPECT_NEAR(std::stod(findings[0].arguments[0]), 40 * 8 * 5, 1) << "length, width and height";
    EXPECT_NEAR(std::abs(std::stod(findings[0].arguments[2]) - 15), 5.5, 1.6);
    EXPECT_EQ(findings[0].arguments[3], "-5.000") << "the back of the head";
    EXPECT_EQ(find(findingsOf(tSlot("-3"), setup), "overhang-lost"), nullptr) << "the head comes out above";
}

TEST(Findings, ANeckThatGoesThroughStockIsAFault) {
    const auto findings = findingsOf(tSlot("-8"), tSlotSetup("flat:d=4,l=20", "tslot:d=14,w=3,neck=8"));
    const auto* found = find(findings, "neck-in-stock");
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->severity, Severity::fault);
    EXPECT_EQ(found->where.line, 9);
    EXPECT_EQ(found->arguments.front(), "5.000");
}

TEST(Findings, WhatStaysAboveAHeadIsReportedTheSameAfterAnySeek) {
    const auto program = programOf(tSlot("-8"));
    const auto setup = tSlotSetup("flat:d=6,l=20", "tslot:d=14,w=3,neck=6");
    const auto simulation = startedSimulation(program, setup, {});
    simulation->seek(simulation->blockCount());
    const Diagnostics whole = simulation->frame().findings;
    for (const std::size_t block : {3U, 9U, 0U, 6U}) {
        simulation->seek(block);
        EXPECT_EQ(simulation->frame().findings, whole) << "block " << block;
    }
}

/// `count` rapids that each remove material.
std::string manyRapids(int count) {
    std::string text = "T1 M6\nG0 X0 Y0 Z5\n";
    for (int block = 0; block < count; ++block)
        text += fmt::format("G0 X{} Y{} Z{}\n", block % 38, block % 27, -0.1 * block / 8);
    return text;
}

TEST(Findings, AreBoundedAndTheLastReportsTheRest) {
    const auto program = programOf(manyRapids(400));
    const auto straight = straightRun(program, smallSetup(), {});
    std::size_t cutting = 0;
    for (std::size_t row = 0; row < straight.back().statistics.size(); ++row)
        cutting += straight.back().statistics[row].maxDepth > 2e-3F ? 1 : 0;
    const auto& findings = straight.back().findings;
    ASSERT_GT(cutting, 150U);
    ASSERT_EQ(findings.size(), 101U);
    EXPECT_STREQ(findings.back().id, "more-findings");
    EXPECT_EQ(findings.back().arguments.front(), std::to_string(cutting - 100));
    EXPECT_EQ(findings.back().severity, Severity::fault) << "as severe as the worst of the rest";
    EXPECT_FALSE(findings.back().unverified);
}

TEST(Findings, TakeNoLongerWhereThereAreMany) {
    const auto program = programOf(manyRapids(400));
    const ToolChoice tools(*program, *smallSetup());
    const auto millisecondsOfAFrame = [&](int count) {
        FindingLog log;
        for (int block = 0; block < count; ++block)
            log.add(static_cast<std::size_t>(block), FindingKind::rapidCuts, 1);
        const std::clock_t begin = std::clock(); // CPU time, so that other load does not matter
        for (int frame = 0; frame < 100; ++frame)
            (void)log.diagnostics(*program, tools);
        return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC * 10;
    };
    EXPECT_LT(millisecondsOfAFrame(3'000'000), 5);
}

/// "LINE id argument" for each finding.
std::vector<std::string> briefly(const Diagnostics& findings) {
    std::vector<std::string> out;
    for (const Diagnostic& finding : findings)
        out.push_back(
            fmt::format("{} {} {}", finding.where.line, finding.id, finding.arguments.front().text()));
    return out;
}

TEST(Findings, OfMissingToolsAreKnownBeforeTheFirstBlockAndAtEveryBlock) {
    const auto program = programOf("T7 M6\nG0 X5 Y5 Z5\nG1 Z2 F100\nT1 M6\nG0 Z5\nX9\nT9 M6\nG0 Z6\nT7 M6\n"
                                   "G1 Z5\nT0 M6\nG0 Z7\nG1 Z8\nT8 M6\nT1 M6\nG0 Z9\n");
    const std::vector<std::string> expected{"2 tool-undefined 7", "8 tool-undefined 9", "13 no-tool 0"};
    for (const Frame& frame : straightRun(program, smallSetup(), {}))
        EXPECT_EQ(briefly(frame.findings), expected) << "block " << frame.block;
    const auto simulation = startedSimulation(program, smallSetup(), {});
    for (const std::size_t block : {6U, 2U, 8U, 0U}) {
        simulation->seek(block);
        EXPECT_EQ(briefly(simulation->frame().findings), expected) << "block " << block;
    }
}

TEST(Findings, OfMissingToolsFollowAnEdit) {
    const auto simulation =
        startedSimulation(programOf("T7 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\n"), smallSetup(), {});
    apply(*simulation, programOf("(head)\nT7 M6\nG0 X6 Y5 Z5\nG1 Z-2 F100\nT2 M6\nX3\n"));
    EXPECT_THAT(briefly(simulation->frame().findings),
                testing::ElementsAre("3 tool-undefined 7", "6 tool-undefined 2"));
    apply(*simulation, programOf("T1 M6\nG0 X6 Y5 Z5\n"));
    EXPECT_TRUE(simulation->frame().findings.empty());
}

TEST(Findings, OfMissingToolsAreBoundedToo) {
    std::string text;
    for (int tool = 2; tool < 152; ++tool)
        text += fmt::format("T{} M6\nG0 X{} Y0 Z5\n", tool, tool);
    const auto simulation = startedSimulation(programOf(text), smallSetup(), {});
    const auto findings = simulation->frame().findings;
    ASSERT_EQ(findings.size(), 101U);
    EXPECT_EQ(briefly(findings).back(), "0 more-findings 50");
    EXPECT_TRUE(findings.back().unverified);
}

TEST(Findings, FollowTheirLineThroughAnEdit) {
    const auto simulation = startedSimulation(programOf("T1 M6\nG0 X5 Y5 Z5\nZ-3\n"), smallSetup(), {});
    simulation->seek(2);
    ASSERT_EQ(simulation->frame().findings.at(0).where.line, 3);
    apply(*simulation, programOf("(head)\n(of two lines)\nT1 M6\nG0 X5 Y5 Z5\nZ-3\n"));
    EXPECT_EQ(simulation->position(), 2U);
    EXPECT_EQ(simulation->frame().findings.at(0).where.line, 5);
}

} // namespace
} // namespace proveout
