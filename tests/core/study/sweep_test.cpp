// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the counts of a run with a simulation stepped by hand; and checks what a sweep must preserve.
#include <gtest/gtest.h>
#include <set>

#include "core/simulation/run/simulation.h"
#include "core/study/sweep.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

constexpr int kBlocks = 90;

StudyJob randomJob(std::uint_fast32_t seed = 5) {
    return {programOf(randomProgram(seed, kBlocks)), smallSetup()};
}

DecimationParameters parametersOf(int region, int period, double allowance = 0.05) {
    DecimationParameters parameters;
    parameters.method = DecimationMethod::lee;
    parameters.regionCells = region;
    parameters.period = period;
    parameters.allowance = allowance;
    return parameters;
}

/// The definition: every mesh that did not exist one block before was created.
WorkCount countedByHand(const StudyJob& job, const DecimationParameters& parameters) {
    const auto simulation = Simulation::create(job.program, job.setup, parameters).value();
    WorkCount count;
    std::set<const RegionMesh*> seen;
    std::vector<RegionMeshPtr> alive; // so that no address is reused
    const auto look = [&](const SurfaceSnapshot& surface) {
        std::uint64_t made = 0;
        for (std::size_t region = 0; region < surface.meshes.size(); ++region)
            if (const auto& mesh = surface.meshes[region]; mesh && seen.insert(mesh.get()).second) {
                alive.push_back(mesh);
                ++made;
                count.facesMade += mesh->triangles.size();
            }
        count.regionsDecimated += made;
        count.moments += made > 0 ? 1 : 0;
        return made;
    };
    count.startRegions = look(simulation->frame().surface);
    while (!simulation->atEnd()) {
        simulation->step();
        const SurfaceSnapshot surface = simulation->frame().surface;
        look(surface);
        ++count.frames;
        count.faces += surface.triangles().size();
        count.regionsShown += surface.meshes.size();
    }
    return count;
}

TEST(RunStudy, CountsWhatIsThere) {
    const StudyJob job = randomJob();
    for (const int period : {-1, 0, 1, 7, 20})
        for (const int region : {5, 16}) {
            const auto parameters = parametersOf(region, period);
            const auto run = runStudy(job, {parameters}, nullptr);
            ASSERT_TRUE(run);
            EXPECT_EQ(run->count, countedByHand(job, parameters))
                << "region " << region << " period " << period;
        }
}

TEST(RunStudy, AnAllowanceOfZeroShowsEveryTriangle) {
    const StudyJob job = randomJob();
    const auto run = runStudy(job, {parametersOf(8, 20, 0)}, nullptr);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->count.faces, std::uint64_t{kBlocks} * 2 * 80 * 60);
    EXPECT_EQ(run->count.moments, 0U);
}

TEST(RunStudy, StopsAtTheBlockAskedFor) {
    StudyPoint point{parametersOf(8, 20), 33};
    const auto run = runStudy(randomJob(), point, nullptr);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->rows.size(), 33U);
    EXPECT_EQ(run->count.frames, 33U);
}

/// Counts its calls, and returns the cost set by the test.
class CountingDrawing final : public DrawCost {
public:
    int begun = 0;
    int drawn = 0;
    void begin() override { ++begun; }
    Seconds draw(const FramePtr&) override {
        ++drawn;
        return {0.25, 2};
    }
};

TEST(RunStudy, ChargesDrawingForEveryBlock) {
    CountingDrawing drawing;
    const auto run = runStudy(randomJob(), {parametersOf(8, 20)}, &drawing);
    ASSERT_TRUE(run);
    EXPECT_EQ(drawing.begun, 1);
    EXPECT_EQ(drawing.drawn, 1 + kBlocks); // including the uncut stock
    EXPECT_DOUBLE_EQ(run->seconds.draw, 2 * (1 + kBlocks));
    EXPECT_DOUBLE_EQ(run->seconds.upload, 0.25 * (1 + kBlocks));
}

TEST(RunStudy, DrawingFewerBlocksChargesTheOthersAlike) {
    CountingDrawing drawing;
    const auto run = runStudy(randomJob(), {parametersOf(8, 20)}, &drawing, 9);
    ASSERT_TRUE(run);
    EXPECT_LE(drawing.drawn, 2 + kBlocks / 9 + 1);
    EXPECT_GE(drawing.drawn, 1 + kBlocks / 9);
    EXPECT_DOUBLE_EQ(run->seconds.draw, 2 * (1 + kBlocks));
}

TEST(RunSweep, AgreesWithSingleRunsAndRunsInTurns) {
    const StudyJob job = randomJob();
    const std::vector<StudyPoint> points{{parametersOf(5, 10)}, {parametersOf(8, 20)}, {parametersOf(8, -1)}};
    SweepOptions options;
    options.repeats = 3;
    int finished = 0;
    options.finished = [&](const StudyRun&) { ++finished; };
    double reported = 0;
    const WorkContext context{{}, [&](double done) {
                                  EXPECT_GE(done, reported);
                                  EXPECT_LE(done, 1);
                                  reported = done;
                              }};
    const auto swept = runSweep(job, points, options, context);
    ASSERT_TRUE(swept);
    ASSERT_EQ(swept->size(), 3U);
    EXPECT_EQ(finished, 3);
    EXPECT_DOUBLE_EQ(reported, 1);
    for (std::size_t k = 0; k < points.size(); ++k) {
        EXPECT_EQ((*swept)[k].run.point, points[k]);
        EXPECT_EQ((*swept)[k].run.count, runStudy(job, points[k], nullptr)->count);
        EXPECT_NEAR((*swept)[k].run.seconds.total(), (*swept)[k].seconds.median, 1e-12);
    }
}

TEST(RunSweep, StopsSoonAndSaysSo) {
    std::stop_source stop;
    int reported = 0;
    const WorkContext context{stop.get_token(), [&](double) {
                                  if (++reported == 10)
                                      stop.request_stop();
                              }};
    const std::vector<StudyPoint> points(50, {parametersOf(8, 1)});
    const auto swept = runSweep(randomJob(), points, {}, context);
    ASSERT_FALSE(swept);
    EXPECT_STREQ(swept.error().front().id, "study-stopped");
    EXPECT_EQ(reported, 10);
}

TEST(RunSweep, RefusesParametersOutOfRange) {
    const std::vector<StudyPoint> points{{parametersOf(1, 20)}};
    EXPECT_FALSE(runSweep(randomJob(), points, {}));
}

} // namespace
} // namespace proveout
