// SPDX-License-Identifier: GPL-3.0-or-later
// A check keeps the records that its rules need and no others. Random programs are judged by these and by all
// records: the findings must be the same, to the last bit.
#include <cstdio>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "core/cutter/cutter.h"
#include "core/simulation/run/block_cutter.h"
#include "core/simulation/run/simulation.h"
#include "core/verification/rules/first_contacts.h"
#include "core/verification/rules/rules.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

/// A random program with tool changes, stops of the spindle, and feeds through air.
std::string programText(std::mt19937& random) {
    std::istringstream in(randomProgram(random(), 500));
    std::string text = random() % 8 > 0 ? "S3000 M3\n" : "";
    for (std::string line; std::getline(in, line);) {
        text += line + "\n";
        switch (line == "M30" ? 99 : random() % 100) {
        case 0:
            text += fmt::format("G0 Z20\nT{} M6\nM3\n", 1 + random() % 7);
            break;
        case 1:
            text += random() % 2 == 0 ? "M4\n" : "M5\n";
            text += "X20\nY10\nM3\n";
            break;
        case 2:
            text += fmt::format("S{} M3\n", 1000 + random() % 9000);
            break;
        case 3:
            text += fmt::format("G1 Z{} F{}\n", 2 + random() % 9, 300 + random() % 900);
            for (std::size_t n = random() % 50; n > 0; --n)
                text += fmt::format("X{} Y{}\n", random() % 40, random() % 30);
            break;
        default:
            break;
        }
    }
    return text;
}

Setup setupOf(std::mt19937& random) {
    constexpr const char* kFree[]{"ball:d=4", "flat:d=3", "bull:d=6,r=1", "flat:d=5"};
    constexpr const char* kLimited[]{"flat:d=3,z=2,maxap=1", "flat:d=5,z=3,maxae=2,maxchip=0.03,maxvc=60",
                                     "flat:d=6,ramp=3,maxchip=0.02,z=4",
                                     "drill:d=5,angle=118,maxrpm=4000,maxfeed=500", "ball:d=6,maxmrr=1"};
    Setup setup = *smallSetup(0.5);
    int number = 1;
    for (const char* spec : kFree)
        setup.tools.set(number++, parseCutter(spec).value());
    if (random() % 2 == 0)
        setup.tools.set(static_cast<int>(1 + random() % 7), parseCutter(kLimited[random() % 5]).value());
    setup.start = Vec3(0, 0, 20);
    return setup;
}

CheckRules rulesOf(std::mt19937& random) {
    constexpr double kSeconds[]{2, 5, 10, 20};
    CheckRules rules;
    rules.limits.airSeconds = kSeconds[random() % 4];
    if (random() % 3 == 0)
        rules.limitsOfTools["air-cutting:T3.airSeconds"] = kSeconds[random() % 4];
    if (random() % 3 == 0)
        rules.off["spindle-stopped"] = "";
    return rules;
}

struct Judged {
    std::string findings;
    std::size_t records = 0;
};

std::string textOf(const RuleFinding& finding) {
    return fmt::format("{} block {} to {}, worst {}, {} of T{}: {:a} {:a} {}\n", finding.row->id,
                       finding.block.value_or(0), finding.lastBlock, finding.worstBlock, finding.count,
                       finding.tool, finding.value, finding.limit, finding.what);
}

Judged judged(const std::shared_ptr<const Program>& program, const std::shared_ptr<const Setup>& setup,
              const CheckRules& rules, bool onlyNeeded) {
    DecimationParameters parameters;
    parameters.method = DecimationMethod::none;
    parameters.period = 0;
    const auto simulation = Simulation::create(program, setup, parameters).value();
    const auto times = machineTimes(program, {});
    const auto runOf = [&](const Frame& frame) {
        return CheckedRun{.program = *program,
                          .setup = *setup,
                          .tools = simulation->tools(),
                          .machine = nullptr,
                          .times = *times,
                          .rows = simulation->rows(),
                          .begin = nullptr,
                          .end = frame.zmap,
                          .removedMm3 = frame.removedMm3};
    };
    const Frame begin = simulation->frame();
    if (onlyNeeded)
        simulation->keepRecordsOf(neededRecords(runOf(begin), rules));
    simulation->seek(program->blockCount());
    const Frame end = simulation->frame();
    const CheckedRun run = runOf(end);
    for (BlockSet missing = neededRecords(run, rules); !missing.empty();
         missing = neededRecords(run, rules)) {
        EXPECT_TRUE(onlyNeeded);
        if (!simulation->record(missing))
            break;
    }
    Judged result;
    for (const RuleFinding& finding : judge(run, rules))
        result.findings += textOf(finding);
    for (const FirstContact& contact : firstContacts(run))
        result.findings += fmt::format("T{} touches in block {}\n", contact.tool, contact.block);
    for (std::size_t block = 0; block < run.rows.size(); ++block)
        result.records += run.isRecorded(block) ? 1 : 0;
    return result;
}

TEST(NeededRecords, GiveTheFindingsOfAllRecords) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::size_t needed = 0;
    std::size_t all = 0;
    for (int round = 0; round < roundsOf(60); ++round) {
        const std::string text = programText(random);
        const auto setup = std::make_shared<const proveout::Setup>(setupOf(random));
        const auto program = programOf(text);
        const CheckRules rules = rulesOf(random);
        const Judged byAll = judged(program, setup, rules, false);
        const Judged byNeeded = judged(program, setup, rules, true);
        ASSERT_EQ(byNeeded.findings, byAll.findings) << "round " << round << '\n' << text;
        needed += byNeeded.records;
        all += byAll.records;
    }
    constexpr int kEnough = 20; // of a few programs, each may need all
    if (roundsOf(60) >= kEnough) {
        EXPECT_LT(needed, 4 * all / 5);
    }
}

TEST(NeededRecords, AreThoseOfSingleBlocks) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (int round = 0; round < roundsOf(40); ++round) {
        const auto program = programOf(programText(random));
        const auto setup = std::make_shared<const proveout::Setup>(setupOf(random));
        DecimationParameters parameters;
        parameters.method = DecimationMethod::none;
        const auto byAll = Simulation::create(program, setup, parameters).value();
        byAll->seek(program->blockCount());
        const auto later = Simulation::create(program, setup, parameters).value();
        later->keepRecordsOf({});
        later->seek(program->blockCount());
        BlockSet wanted;
        for (std::size_t n = 1 + random() % 20; n > 0; --n)
            wanted.add(random() % program->blockCount());
        ASSERT_TRUE(later->record(wanted));
        for (std::size_t block = 0; block < program->blockCount(); ++block) {
            const BlockStatistics& row = later->rows()[block];
            ASSERT_EQ(row.isRecorded(), wanted.contains(block));
            if (!row.isRecorded())
                continue;
            ASSERT_EQ(row.removedMm3, byAll->rows()[block].removedMm3) << "round " << round << ' ' << block;
            ASSERT_EQ(row.maxDepth, byAll->rows()[block].maxDepth);
            ASSERT_EQ(row.radialEngagement, byAll->rows()[block].radialEngagement);
        }
    }
}

} // namespace
} // namespace proveout
