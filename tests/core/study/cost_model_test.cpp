// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/study/cost_model.h"

namespace proveout {
namespace {

/// Samples of work in which all three terms vary.
std::vector<CostSample> samplesOf(const Coefficients& truth) {
    std::vector<CostSample> samples;
    for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) {
            CostSample sample{{1, 10.0 + 7 * a * a, 1e4 * (b + 0.3 * a)}, 0};
            for (std::size_t term = 0; term < CostSample::kTerms; ++term)
                sample.seconds += truth.at(term) * sample.work.at(term);
            samples.push_back(sample);
        }
    return samples;
}

RC_GTEST_PROP(FitCost, FindsTheCoefficientsThatMadeTheSamples, ()) {
    const auto positive = [](double unit) { return unit * *rc::gen::inRange(0, 1000); };
    const Coefficients truth{positive(1e-6), positive(1e-7), positive(1e-10)};
    const Coefficients found = fitCost(samplesOf(truth));
    for (std::size_t term = 0; term < CostSample::kTerms; ++term)
        RC_ASSERT(std::abs(found.at(term) - truth.at(term)) <= 1e-9 * std::max(1e-3, truth.at(term)));
}

TEST(FitCost, LeavesOutASampleThatSomethingElseDisturbed) {
    const Coefficients truth{1e-3, 2e-5, 3e-8};
    std::vector<CostSample> samples = samplesOf(truth);
    for (std::size_t k = 0; k < samples.size(); ++k) // the error that every clock has
        samples[k].seconds *= k % 2 == 0 ? 1.001 : 0.999;
    samples[5].seconds += 10;
    const Coefficients found = fitCost(samples);
    for (std::size_t term = 0; term < CostSample::kTerms; ++term)
        EXPECT_NEAR(found.at(term), truth.at(term), 0.05 * truth.at(term));
}

TEST(Slowdown, GivesBackTheMeanThatAFitLeftOut) {
    // One of sixteen samples takes twice its time, which raises the mean by that share.
    const Coefficients truth{1e-3, 2e-5, 3e-8};
    std::vector<CostSample> samples = samplesOf(truth);
    double seconds = 0;
    for (const CostSample& sample : samples)
        seconds += sample.seconds;
    const double late = samples[7].seconds;
    samples[7].seconds += late;
    Slowdown slowdown;
    slowdown.add(samples, truth);
    EXPECT_NEAR(slowdown.factor(), 1 + late / seconds, 1e-12);
    EXPECT_DOUBLE_EQ(scaled(truth, 2)[1], 4e-5);
    EXPECT_EQ(Slowdown{}.factor(), 1);
}

TEST(FitCost, NeverGoesBelowZero) {
    // Plain least squares would give the constant a negative coefficient here.
    std::vector<CostSample> samples;
    for (int k = 1; k <= 8; ++k)
        samples.push_back({{1, double(k), 0}, double(k) - 0.5 + (k == 1 ? 0.1 : 0.0)});
    const Coefficients found = fitCost(samples);
    EXPECT_EQ(found[0], 0);
    EXPECT_GT(found[1], 0);
    EXPECT_EQ(found[2], 0);
}

TEST(FitCost, OfNothingIsNothing) {
    EXPECT_EQ(fitCost({}), (Coefficients{0, 0, 0}));
}

TEST(CostModel, IsCountedWorkTimesCoefficients) {
    CostModel model;
    model.cutSeconds = 2;
    model.drawPerFrameFaceRegion = {0.1, 0.01, 0.001};
    model.uploadPerFrameFaceRegion = {0.2, 0.02, 0.002};
    model.decimation[8] = {5, {0.3, 0.03, 0.003}};
    WorkCount count;
    count.frames = 10;
    count.faces = 1000;
    count.regionsShown = 100;
    EXPECT_DOUBLE_EQ(model.cost(count, 0), 2 + 1 + 10 + 0.1 + 2 + 0.2); // nothing was decimated
    count.moments = 4;
    count.startRegions = 3;
    count.regionsDecimated = 23;
    count.facesMade = 500;
    EXPECT_DOUBLE_EQ(model.cost(count, 8), 2 + 1 + 10 + 0.1 + 2 + 0.2 + 10 + 15 + 1.2 + 0.6 + 1.5);
}

} // namespace
} // namespace proveout
