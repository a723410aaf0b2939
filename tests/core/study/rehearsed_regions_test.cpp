// SPDX-License-Identifier: GPL-3.0-or-later
// What a rehearsal measures on a machine with known costs.
#include <gtest/gtest.h>

#include "core/simulation/run/block_cutter.h"
#include "core/study/rehearsed_regions.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

constexpr int kBlocks = 240;
constexpr int kStretch = 15;
constexpr std::array kPeriods{-1, 1, 2, 5, 20, 50};

struct Rehearsed {
    std::unique_ptr<RehearsedRegions> reference;
    std::unique_ptr<RehearsedRegions> size;
};

/// Cuts and samples a program like a rehearsal.
Rehearsed rehearsed(DecimationMethod method, int cells, std::uint_fast32_t seed) {
    const auto program = programOf(randomProgram(seed, kBlocks));
    const auto setup = smallSetup();
    ZMap zmap(setup->stock, *makeGrid(setup->stock, setup->spacing));
    const ToolChoice tools(*program, *setup);
    ZMapSnapshot moment = zmap.snapshot();
    DecimationParameters parameters;
    parameters.method = method;
    parameters.regionCells = 5;
    Rehearsed out;
    out.reference =
        std::make_unique<RehearsedRegions>(moment, parameters, kPeriods, false, std::stop_token{});
    parameters.regionCells = cells;
    out.size = std::make_unique<RehearsedRegions>(moment, parameters, kPeriods, false, std::stop_token{});
    for (std::size_t block = 0; block < program->blockCount(); ++block) {
        const auto record = cutBlock(zmap, *program, block, *setup, tools, nullptr, {});
        ZMapSnapshot now = zmap.snapshot();
        out.reference->block(moment, now, record->changed);
        out.size->block(moment, now, record->changed);
        moment = std::move(now);
        if ((block + 1) % kStretch != 0)
            continue;
        out.reference->sample(moment, nullptr);
        out.size->sample(moment, out.reference.get());
    }
    return out;
}

struct Case {
    DecimationMethod method;
    int cells;
    std::uint_fast32_t seed;
};
class KnownMachine : public testing::TestWithParam<Case> {};

/// The samples must separate the cost of a decimation, of a region and of a triangle. Batches of one region
/// each, as for large regions before, cannot do that.
TEST_P(KnownMachine, IsRecoveredFromTheWorkSampled) {
    const auto [method, cells, seed] = GetParam();
    const Rehearsed run = rehearsed(method, cells, seed);
    const Coefficients truth{4e-5, 2e-5, 6e-7};
    std::vector<CostSample> samples(run.size->samples().begin(), run.size->samples().end());
    for (CostSample& sample : samples) {
        sample.seconds = 0;
        for (std::size_t term = 0; term < CostSample::kTerms; ++term)
            sample.seconds += truth.at(term) * sample.work.at(term);
    }
    const Coefficients found = fitCost(samples);
    for (std::size_t term = 0; term < CostSample::kTerms; ++term)
        EXPECT_NEAR(found.at(term), truth.at(term), 1e-6 * truth.at(term))
            << "term " << term << ", seed " << seed;
}

INSTANTIATE_TEST_SUITE_P(Sizes, KnownMachine,
                         testing::Values(Case{DecimationMethod::certified, 8, 1},
                                         Case{DecimationMethod::certified, 20, 2},
                                         Case{DecimationMethod::certified, 30, 3},
                                         Case{DecimationMethod::lee, 20, 4},
                                         Case{DecimationMethod::lee, 30, 5}));

TEST(RehearsedRegions, SampleAShareOfWhatAllSchedulesDecimate) {
    const Rehearsed run = rehearsed(DecimationMethod::certified, 8, 6);
    double sampled = 0;
    for (const CostSample& sample : run.size->samples())
        sampled += sample.work[1];
    std::uint64_t all = 0;
    for (std::size_t period = 0; period < kPeriods.size(); ++period) {
        const WorkCount count = run.size->count(period);
        all += count.regionsDecimated - count.startRegions;
    }
    EXPECT_GT(sampled, 0);
    EXPECT_LE(sampled, 0.05 * static_cast<double>(all));
}

} // namespace
} // namespace proveout
