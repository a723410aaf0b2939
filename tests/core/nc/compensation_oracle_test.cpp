// SPDX-License-Identifier: GPL-3.0-or-later
// Compares cutter compensation with LinuxCNC's stand-alone interpreter, on random programs.
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <map>

#include "core/nc/run/interpreter.h"
#include "tests/core/nc/oracle_comparison.h"
#include "tests/core/nc/random_path.h"
#include "tests/random_seed.h"

namespace proveout::test {

namespace {

namespace fs = std::filesystem;

const fs::path kOracle = fs::path(PROVEOUT_SHARED_DIR) / "oracle" / "oracle.py";
constexpr int kPrograms = 400;
constexpr double kDiameter = 6;
/// The listing has four decimals, and a corner magnifies the rounding error.
constexpr OracleTolerances kListing{2e-4, 2e-3};

bool oracleIsHere() {
    return fs::exists(kOracle) && std::system("command -v rs274 python3 > /dev/null") == 0;
}

/// A line that may be between two motions without ending compensation.
std::string between(std::mt19937& random) {
    const std::vector<std::string> lines{
        "", "", "", "", "", "", "", "G1 Z-1\n", "G4 P1\n", "M8\n", "F200\n", "G1 Z-2\nG1 Z3\n", "G91\nG90\n"};
    return lines[random() % lines.size()];
}

std::string programOf(std::mt19937& random) {
    RandomPathShape shape;
    shape.shortest = random() % 2 == 0 ? 1 : 8;
    shape.longest = random() % 2 == 0 ? 20 : 60;
    const bool left = random() % 2 == 0;
    std::string text = "G21 G17 G90 F300 T1 M6\nG0 X0 Y0 Z0\n";
    text += left ? "G41\n" : "G42 D2\n";
    for (const PlanePath& path : randomPath(random, shape)) {
        std::string words = wordsOf(path);
        if (!path.arc() && random() % 12 == 0)
            words.replace(0, 2, "G0");
        text += words + "\n" + between(random);
    }
    return text + (random() % 2 == 0 ? "G40 G1 X-100\nM2\n" : "M2\n");
}

/// Runs the oracle for all programs of a folder.
void ask(const fs::path& folder) {
    const std::string command =
        fmt::format("python3 '{}' batch '{}' -j 1 --gz-above 0 --tool-dia {} > /dev/null", kOracle.string(),
                    folder.string(), kDiameter);
    ASSERT_EQ(std::system(command.c_str()), 0);
}

/// The first difference between both; empty if they agree.
std::string disagreement(const fs::path& file, int& refused) {
    const OracleAnswer answer = readAnswer(file);
    const auto text = NcText::load(file);
    InterpretOptions options;
    options.assumeStartAtZero = true;
    options.lint = false;
    options.tools = toolsOfAnswer(file);
    const auto program = interpret(*text, options);
    std::string why;
    if (!sameSteps(answer, *program, answer.errorLine != 0 ? Extent::oracleBegins : Extent::whole, kListing,
                   why))
        return why;
    const Diagnostic* error = firstError(*program);
    const int ours = error == nullptr ? 0 : error->where.line;
    refused += ours != 0 ? 1 : 0;
    if (ours != answer.errorLine)
        return fmt::format("refused at line {} ({}) / {} ({})", answer.errorLine, answer.errorText, ours,
                           error == nullptr ? "" : error->id);
    return {};
}

} // namespace

TEST(CompensationOracle, AgreesOnRandomPrograms) {
    if (!oracleIsHere())
        GTEST_SKIP() << "LinuxCNC's interpreter is not here";
    const auto seed = randomSeed();
    std::cout << fmt::format("seed {}\n", seed);
    std::mt19937 random(seed);
    const fs::path folder = fs::path(testing::TempDir()) / fmt::format("proveout-compensation-{}", seed);
    fs::create_directories(folder);
    for (int i = 0; i < kPrograms; ++i)
        std::ofstream(folder / fmt::format("{:03}.ngc", i)) << programOf(random);
    ask(folder);
    int refused = 0;
    for (int i = 0; i < kPrograms; ++i) {
        const fs::path file = folder / fmt::format("{:03}.ngc", i);
        EXPECT_EQ(disagreement(file, refused), "") << file;
    }
    std::cout << fmt::format("{} programs, {} of them refused by both\n", kPrograms, refused);
    if (!HasFailure())
        fs::remove_all(folder);
}

} // namespace proveout::test
