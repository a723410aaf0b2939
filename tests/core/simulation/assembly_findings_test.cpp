// SPDX-License-Identifier: GPL-3.0-or-later
// Collisions of shank and holder with the stock, as findings of a run.
#include <algorithm>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

#include "core/simulation/run/block_cutter.h"
#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Diagnostics collisionsOf(const std::string& text, const std::shared_ptr<const Setup>& setup) {
    const auto simulation = startedSimulation(programOf(text), setup, {});
    simulation->seek(simulation->blockCount());
    return simulation->frame().findings;
}

/// "LINE id depth" for each finding.
std::vector<std::string> described(const Diagnostics& findings) {
    std::vector<std::string> out;
    for (const Diagnostic& finding : findings)
        out.push_back(
            fmt::format("{} {} {}", finding.where.line, finding.id, finding.arguments.front().text()));
    return out;
}

/// A pocket of 8 × 8 mm around X20 Y15, `depth` mm deep, in steps of 2 mm.
std::string pocket(int depth) {
    std::string text = "T1 M6\nG0 X18 Y13 Z5\n";
    for (int z = 2; z <= depth; z += 2)
        text += fmt::format("G1 Z-{} F100\nY17\nX22\nY13\nX18\n", z);
    return text + "G0 Z5\n";
}

TEST(AssemblyFindings, TheHolderReachesTheEdgeOfAPocket) {
    const auto findings = collisionsOf(pocket(8), setupWithTool(1, "flat:d=4,so=5,holder=9x20"));
    // The pocket is as wide as the way of the cutter; the holder is wider than the cutter, 5 mm above its
    // tip.
    ASSERT_FALSE(findings.empty());
    EXPECT_EQ(described(findings)[0], "13 holder-collision 1.000") << "the third step, 6 mm deep";
    EXPECT_EQ(findings[0].severity, Severity::fault);
    EXPECT_FALSE(findings[0].unverified);
    EXPECT_THAT(message(findings[0]), HasSubstr("1.000 mm deep at X"));
    EXPECT_EQ(findings[0].arguments[3], "-1.000") << "the face of the holder";
    for (const Diagnostic& finding : findings)
        EXPECT_STREQ(finding.id, "holder-collision");
    EXPECT_TRUE(collisionsOf(pocket(4), setupWithTool(1, "flat:d=4,so=5,holder=9x20")).empty());
    EXPECT_TRUE(collisionsOf(pocket(8), setupWithTool(1, "flat:d=4,so=8,holder=9x20")).empty());
    EXPECT_TRUE(collisionsOf(pocket(8), setupWithTool(1, "flat:d=4,so=5")).empty()) << "without a holder";
}

TEST(AssemblyFindings, AShankIsCheckedWhereItIsGiven) {
    const std::string plunge = "T1 M6\nG0 X20 Y15 Z5\nG1 Z-7 F100\nG0 Z5\n";
    EXPECT_THAT(described(collisionsOf(plunge, setupWithTool(1, "flat:d=4,l=7,sd=6"))), ElementsAre());
    EXPECT_THAT(
        described(collisionsOf(plunge, setupWithTool(1, "flat:d=4,l=6.5,sd=6"))),
        ElementsAre("3 shank-collision 0.500", "3 depth-beyond-flutes 7.000", "4 shank-collision 0.500"));
    EXPECT_THAT(described(collisionsOf(plunge, setupWithTool(1, "flat:d=4,l=6.5"))),
                ElementsAre("3 depth-beyond-flutes 7.000"));
}

TEST(AssemblyFindings, AToolThatIsNotCentreCuttingMustNotPlungeIntoMaterial) {
    const auto setup = setupWithTool(1, "flat:d=4,centre=0");
    EXPECT_THAT(described(collisionsOf("T1 M6\nG0 X20 Y15 Z5\nG1 Z-3 F100\nG0 Z5\nG1 Z-3\nZ-4\n", setup)),
                ElementsAre("3 plunge-not-allowed 3.000", "6 plunge-not-allowed 1.000"))
        << "not where it has cut before";
    EXPECT_THAT(described(collisionsOf("T1 M6\nG0 X20 Y15 Z5\nG83 Z-5 R2 Q1 F100\nG80\n", setup)),
                ElementsAre("3 plunge-not-allowed 1.000"))
        << "each peck is as deep";
    EXPECT_THAT(described(collisionsOf("T1 M6\nG0 X20 Y15 Z0\nG1 X24 Z-1 F100\nX20\n", setup)),
                ElementsAre());
}

TEST(AssemblyFindings, OfRapidsArcsAndCyclesAreFoundToo) {
    const auto setup = setupWithTool(1, "flat:d=4,so=5,holder=9x20");
    EXPECT_THAT(described(collisionsOf("T1 M6\nG0 X20 Y15 Z5\nG81 Z-5.5 R2 F100\nX30\nG80\n", setup)),
                ElementsAre("3 holder-collision 0.500", "4 holder-collision 0.500"));
    const auto helix = collisionsOf("T1 M6\nG0 X22 Y15 Z0\nG3 X22 Y15 I-2 Z-5.25 F100\n", setup);
    EXPECT_THAT(described(helix), ElementsAre("3 holder-collision 0.250"));
    const auto rapid = collisionsOf("T1 M6\nG0 X-9 Y15 Z5\nZ-6\nX50\n", setup);
    EXPECT_THAT(described(rapid), ElementsAre("4 holder-collision 1.000", "4 rapid-cuts 6.000"));
}

TEST(AssemblyFindings, ARapidFromAnUnknownPositionThatBringsTheHolderIntoTheStockIsUnverified) {
    const auto reported = [](const char* tool, const char* rapids) {
        const auto findings = collisionsOf(std::string("T1 M6\n") + rapids, setupWithTool(1, tool));
        std::vector<std::string> ids;
        for (const Diagnostic& finding : findings)
            ids.emplace_back(finding.id);
        return ids;
    };
    const char* wide = "flat:d=4,so=5,holder=20x20";
    for (const char* rapids : {"G0 X-6 Y15 Z-8\n", "G0 X-6 Y0\nG0 Y30\n"}) {
        EXPECT_THAT(reported(wide, rapids), ElementsAre("rapid-unchecked")) << rapids;
        EXPECT_THAT(reported("flat:d=4", rapids), ElementsAre()) << rapids;
    }
    EXPECT_THAT(reported(wide, "G0 X-6 Y15 Z-5\n"), ElementsAre()) << "the face is level with the top";
    EXPECT_THAT(reported(wide, "G0 X-11 Y15 Z-8\n"), ElementsAre()) << "beside the stock";
}

TEST(AssemblyFindings, OfAnUnconfirmedToolAreWarnings) {
    proveout::Setup setup = *smallSetup();
    setup.tools.set(7, parseCutter("flat:d=4,l=3,sd=6,so=5,holder=9x20").value(),
                    ToolOrigin{ToolSource::assumed});
    const auto findings =
        collisionsOf("T7 M6\nG0 X20 Y15 Z5\nG1 Z-6 F100\n", std::make_shared<proveout::Setup>(setup));
    EXPECT_EQ(std::ranges::count_if(findings,
                                    [](const Diagnostic& finding) {
                                        return message(finding).find("with the unconfirmed tool T7.") !=
                                                   std::string::npos &&
                                               finding.severity == Severity::warning && finding.unverified;
                                    }),
              2);
}

TEST(AssemblyFindings, KeepTheDeepestOfABlockWithItsPlace) {
    const auto program = programOf("T1 M6\nG0 X5 Y5 Z5\nG0 X9\n");
    for (const bool deepestFirst : {true, false}) {
        FindingLog log;
        for (const bool deepest : {deepestFirst, !deepestFirst})
            log.add(1, FindingKind::holderCollision, deepest ? 3 : 2, false,
                    deepest ? Vec3(1, 2, 3) : Vec3(4, 5, 6));
        log.add(1, FindingKind::shankCollision, 1, false, Vec3(7, 8, 9));
        const auto findings = log.diagnostics(*program, {});
        ASSERT_EQ(findings.size(), 2U);
        EXPECT_THAT(message(findings[0]), HasSubstr("3.000 mm deep at X1.000 Y2.000 Z3.000."));
        EXPECT_THAT(message(findings[1]), HasSubstr("1.000 mm deep at X7.000 Y8.000 Z9.000."));
        log.truncate(1);
        EXPECT_TRUE(log.diagnostics(*program, {}).empty());
    }
}

/// A random program with several tools, most of which collide sometimes, and cycles.
std::string collidingProgram(std::uint_fast32_t seed, int blocks) {
    std::mt19937 random(seed);
    std::istringstream in(randomProgram(seed, blocks));
    std::string text;
    for (std::string line; std::getline(in, line);) {
        text += line + "\n";
        if (line != "M30" && random() % 20 == 0)
            text += fmt::format("T{} M6\n", 1 + random() % 6);
        if (line != "M30" && random() % 25 == 0)
            text += fmt::format("G83 X20 Y{} Z-8 R2 Q0.{} F300\nG80\n", random() % 30, 1 + random() % 8);
    }
    return text;
}

TEST(AssemblyFindings, OfManyBlocksAtOnceAreThoseOfSingleBlocks) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    auto setup = std::make_shared<proveout::Setup>(*smallSetup(0.4));
    int number = 1;
    for (const char* spec : {"ball:d=4,so=6,holder=12x20", "flat:d=3,l=4,sd=5",
                             "bull:d=6,r=1,so=7,holder=8-20x6,centre=0", "ball:d=6,so=5,holder=7x1+12x30",
                             "drill:d=5,angle=118,so=9,holder=20x9", "lollipop:d=4,neck=2,so=5,holder=9x9"})
        setup->tools.set(number++, parseCutter(spec).value());
    std::size_t found = 0;
    std::size_t plunges = 0;
    for (int round = 0; round < roundsOf(30); ++round) {
        const auto program = programOf(collidingProgram(random(), 200));
        const ToolChoice tools(*program, *setup);
        ZMap alone = uncutStock(setup->stock, setup->shape, *makeGrid(setup->stock, setup->spacing)).zmap;
        ZMap together(alone.snapshot());
        FindingLog aloneLog;
        FindingLog togetherLog;
        PortionCutting cutting;
        const BlockSet none;
        const bool isRecorded = round % 2 == 0;
        for (std::size_t first = 0; first < program->blockCount();) {
            const std::size_t last = std::min(first + 1 + random() % 80, program->blockCount());
            const auto records = cutBlocksInTurn(together, *program, first, last, *setup, tools, &togetherLog,
                                                 {}, cutting, isRecorded ? nullptr : &none);
            ASSERT_TRUE(records);
            for (; first < last; ++first) {
                const auto record = cutBlock(alone, *program, first, *setup, tools, &aloneLog, {});
                const CutRecord& other = (*records)[records->size() - (last - first)];
                if (isRecorded) {
                    ASSERT_EQ(record->removedMm3, other.removedMm3) << "round " << round;
                    ASSERT_EQ(record->maxDepth, other.maxDepth);
                    ASSERT_TRUE(record->changed == other.changed);
                }
            }
            ASSERT_TRUE(sameZMap(alone.snapshot(), together.snapshot())) << "round " << round;
        }
        const Diagnostics findings = aloneLog.diagnostics(*program, tools);
        ASSERT_EQ(findings, togetherLog.diagnostics(*program, tools)) << "round " << round;
        found += std::ranges::count_if(findings, [](const Diagnostic& finding) {
            return std::string_view(finding.id).ends_with("-collision");
        });
        plunges += std::ranges::count_if(findings, [](const Diagnostic& finding) {
            return std::string_view(finding.id) == "plunge-not-allowed";
        });
    }
    EXPECT_GT(found, 10U);
    EXPECT_GT(plunges, static_cast<std::size_t>(roundsOf(30)));
}

TEST(AssemblyFindings, AreTheSameAfterAnySeek) {
    const auto program = programOf(collidingProgram(randomSeed(), 120));
    const auto setup = setupWithTool(1, "ball:d=4,so=6,holder=12x20");
    const auto simulation = startedSimulation(program, setup, {});
    simulation->seek(simulation->blockCount());
    const Diagnostics whole = simulation->frame().findings;
    for (const std::size_t block : {30U, 90U, 0U, 60U}) {
        simulation->seek(block);
        EXPECT_EQ(simulation->frame().findings, whole) << "block " << block;
    }
}

} // namespace
} // namespace proveout
