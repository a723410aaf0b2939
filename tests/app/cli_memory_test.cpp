// SPDX-License-Identifier: GPL-3.0-or-later
// The memory forecast is reliable: no peak exceeds 1.2 times the forecast.
#include <algorithm>
#include <fmt/format.h>
#include <random>
#include <regex>
#include <thread>

#include "core/decimation/regions/region_decimator.h"
#include "core/decimation/surface/map_memory.h"
#include "core/formats/npy.h"
#include "core/nc/program/program.h"
#include "tests/app/command_line.h"
#include "tests/app/memory_cases.h"

namespace proveout {
namespace {

class CliMemory : public CommandLine {
protected:
    void SetUp() override {
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
        GTEST_SKIP() << "sanitizers take memory of their own";
#endif
        write("tiny.nc", kSound);
        const auto tiny = run("simulate tiny.nc --stock 5x5x5 --grid 1 --allow-outside --json" + kTool);
        ASSERT_LT(tiny.exitCode, 3) << tiny.err;
        m_program = tiny.json()["peakBytes"];
    }

    static double predicted(int nx, int ny, DecimationMethod method, const MapOutputs& outputs) {
        DecimationParameters parameters;
        parameters.method = method;
        useDefaults(parameters, false, false, static_cast<double>(nx) * ny);
        Grid grid;
        grid.nx = nx;
        grid.ny = ny;
        return zmapBytes(grid) + static_cast<double>(nx) * ny * meshBytesPerPoint(parameters, outputs);
    }

    void expectWithin(const Finished& done, double prediction) {
        ASSERT_LT(done.exitCode, 3) << done.err;
        EXPECT_LE(done.json()["peakBytes"].get<double>(), 1.2 * prediction + m_program) << prediction;
    }

    double m_program = 0; ///< with its libraries, which depend on the machine: that of a tiny map

    /// A map from which no triangle can be removed.
    void writeNoise(int points) {
        std::mt19937 random(1);
        NpyArray noise{points, points, std::vector<double>(static_cast<std::size_t>(points) * points)};
        for (double& height : noise.values)
            height = std::uniform_real_distribution<double>(0, 5)(random);
        ASSERT_TRUE(writeNpy(folder / "noise.npy", noise));
    }
};

TEST_F(CliMemory, OfALongRunIsThatOfItsMap) {
    std::string program = "T1 M6\nG0 X0 Y0 Z5\nF1000\n";
    std::mt19937 random(2);
    for (int block = 0; block < 800; ++block)
        program += fmt::format("G1 X{} Y{} Z{:.3f}\n", random() % 400, random() % 400, -0.01 * block);
    write("long.nc", program);
    const auto done = run("simulate long.nc --stock 400x400x60 --grid 0.2 --method none --json" + kTool);
    expectWithin(done, predicted(2001, 2001, DecimationMethod::none, {.schedule = false}));
}

TEST_F(CliMemory, OfALongProgramIsForecast) {
    constexpr int kBlocks = 2'000'000;
    std::string program = "T1 M6\nG0 X0 Y0 Z5\nF1000\n";
    for (int block = 0; block < kBlocks; ++block)
        program += fmt::format("G1 X{} Y{:.4f} Z-1\n", block % 2, block * 1e-5);
    write("long.nc", program);
    for (const char* threads : {"1", "2"}) { // with two it is cut while it is read
        const auto done = run(
            fmt::format("simulate long.nc --stock 40x30x10 --grid 0.5 --json --threads {}", threads) + kTool);
        ASSERT_LT(done.exitCode, 3) << done.err;
        const double forecast = done.json()["forecastBytes"];
        expectWithin(done, forecast);
        EXPECT_GT(done.json()["expectedBytes"], static_cast<double>(kBlocks * Program::kBytesPerMotion));
        EXPECT_LT(forecast, 3 * done.json()["peakBytes"].get<double>())
            << "a forecast that refuses nothing else";
    }
}

TEST_F(CliMemory, OfAWrittenZMapIsThatOfTheMap) {
    write("p.nc", kSound);
    const auto done =
        run("simulate p.nc --stock 400x400x60 --grid 0.2 --method none --zmap z.npy --json" + kTool);
    expectWithin(done, predicted(2001, 2001, DecimationMethod::none, {.schedule = false}));
}

TEST_F(CliMemory, OfNoiseDecimatedAndExportedIsPredicted) {
    writeNoise(601);
    for (const DecimationMethod method : {DecimationMethod::certified, DecimationMethod::lee}) {
        const auto* key = kMethodChoices[static_cast<std::size_t>(method)].key;
        const auto done = run(
            fmt::format("decimate noise.npy --grid 1 --method {} --allowance 0.05 --stl n.stl --json", key));
        expectWithin(done, predicted(601, 601, method, {.schedule = false, .whole = true, .solid = true}));
    }
}

TEST_F(CliMemory, OfNoiseDecimatedAloneIsPredicted) {
    writeNoise(801);
    const auto done = run("decimate noise.npy --grid 1 --allowance 0.05 --json");
    expectWithin(done, predicted(801, 801, DecimationMethod::certified, {.schedule = false, .whole = true}));
}

TEST_F(CliMemory, OfTheGlobalMethodIsPredicted) {
    writeNoise(401);
    const auto done = run("decimate noise.npy --grid 1 --method global --allowance 0.05 --json");
    expectWithin(done, predicted(401, 401, DecimationMethod::global, {.schedule = false, .whole = true}));
}

TEST_F(CliMemory, IsWithinTheForecastOfTheRunItself) {
    writeMemoryInputs(folder.path());
    const double smallest = smallestPeakBytes(PROVEOUT_CLI, folder.path());
    for (const MemoryCase& one : memoryCases()) {
        if (!one.isQuick)
            continue;
        const MemoryRun run = runForMemory(PROVEOUT_CLI, folder.path(), one.arguments);
        EXPECT_EQ(brokenPromise(run, smallest), "")
            << one.arguments << ": " << run.peakBytes - smallest << " of " << run.forecastBytes;
    }
}

/// `ulimit -v` with the given megabytes in addition to what the threads reserve.
std::string addressLimit(unsigned megabytes) {
    constexpr unsigned kThread = 80;
    const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
    return fmt::format("ulimit -v {};", 1000 * (megabytes + kThread * threads));
}

TEST_F(CliMemory, UnderAnAddressLimitTheFigureIsReportedAndWhatWouldFit) {
    write("p.nc", "G21 G90\nT1 M6\nG0 X20 Y20 Z5\nG1 Z-9 F100\nX30 Y22\nG0 Z5\nX5\nG1 Z-12\nG0 Z5\nM30\n");
    const std::string limit = addressLimit(300);
    for (const std::string rest : {"--mesh full --stl s.stl", "--stl s.stl", "--provenance p.npy"}) {
        const std::string job = "simulate p.nc --json --stock 40x30x10 " + kTool + rest + " --grid ";
        const auto refused = run(job + "0.003", limit);
        EXPECT_EQ(refused.exitCode, 3);
        EXPECT_TRUE(refused.reports("", "grid-needs-too-much-memory")) << refused.err;
        EXPECT_FALSE(exists("s.stl"));
        std::smatch spacing;
        ASSERT_TRUE(
            std::regex_search(refused.err, spacing, std::regex("enough for a spacing of ([0-9.]+) mm")))
            << refused.err;
        const auto fits = run(job + spacing[1].str(), limit);
        EXPECT_LT(fits.exitCode, 3) << rest << ", " << spacing[1] << ": " << fits.err;
        std::filesystem::remove(folder / "s.stl");
    }
}

TEST_F(CliMemory, ASurfaceThatDoesNotFitEndsTheRunWithTheOtherFiles) {
    write("p.nc", "G21 G90\nT1 M6\nG0 X20 Y20 Z5\nG1 Z-9 F100\nX30 Y22\nG0 Z5\nX5\nG1 Z-12\nG0 Z5\nM30\n");
    const auto done = run("simulate p.nc --json --stock 40x30x10 --grid 0.005 --allowance 0.000002 "
                          "--export s.ply --zmap z.npy --save-stock s.pvstock" +
                              kTool,
                          addressLimit(450));
    EXPECT_EQ(done.exitCode, 3);
    EXPECT_TRUE(done.reports("", "surface-needs-too-much-memory")) << done.err;
    EXPECT_FALSE(exists("s.ply"));
    EXPECT_TRUE(exists("z.npy"));
    EXPECT_TRUE(exists("s.pvstock"));
}

TEST_F(CliMemory, UnderALimitOfPrivateMemoryItIsRefusedAsWell) {
    write("p.nc", kSound);
    const auto refused = run("simulate p.nc --stock 40x30x10 --grid 0.005 --mesh full --stl s.stl" + kTool,
                             "ulimit -d 600000;");
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_TRUE(refused.reports("", "grid-needs-too-much-memory")) << refused.err;
}

} // namespace
} // namespace proveout
