// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever the path to a block, the state there must equal that of a fresh run; and the cost of an edit must
// depend only on what follows it.
#include <gtest/gtest.h>
#include <random>
#include <sstream>
#include <vector>

#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

/// Replaces one line after the head of the program by another feed motion.
std::string withAnotherLine(const std::string& text, std::mt19937& random) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    const std::size_t at = 4 + random() % (lines.size() - 5);
    lines[at] = "G1 X" + std::to_string(random() % 40) + " Y" + std::to_string(random() % 30) + " Z-" +
                std::to_string(random() % 8) + " F500";
    std::string out;
    for (const std::string& line : lines)
        out += line + "\n";
    return out;
}

DecimationParameters anyParameters(std::mt19937& random) {
    DecimationParameters parameters;
    parameters.method = random() % 2 == 0 ? DecimationMethod::lee : DecimationMethod::none;
    parameters.regionCells = 8 << (random() % 2);
    parameters.period = static_cast<int>(random() % 30);
    return parameters;
}

struct PathCase {
    const char* name;
    std::size_t budget;
};

class RandomPath : public testing::TestWithParam<PathCase> {};

/// Each kind of step as frequently as in practice; 1 000 in total.
TEST_P(RandomPath, EndsAsAFreshRunDoes) {
    const int steps = roundsOf(1000);
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const auto setup = smallSetup(0.25); // gives some tens of tiles
    std::string text = randomProgram(random(), 120);
    auto program = programOf(text);
    DecimationParameters parameters;
    parameters.method = DecimationMethod::lee;
    parameters.regionCells = 8;
    auto straight = straightRun(program, setup, parameters);
    const auto simulation = startedSimulation(program, setup, parameters);
    simulation->setCheckpointBudget(GetParam().budget);
    for (int step = 0; step < steps; ++step) {
        const auto kind = random() % 100;
        if (kind < 50) {
            simulation->seek(random() % (program->blockCount() + 1));
        } else if (kind < 75) {
            simulation->seek(std::max<std::size_t>(simulation->position(), 1) - 1);
        } else if (kind < 96) {
            simulation->step();
        } else if (kind < 98) {
            parameters = anyParameters(random);
            apply(*simulation, parameters);
            straight = straightRun(program, setup, parameters);
        } else {
            text = withAnotherLine(text, random);
            program = programOf(text);
            apply(*simulation, program);
            straight = straightRun(program, setup, parameters);
        }
        ASSERT_EQ(difference(simulation->frame(), straight[simulation->position()]), "")
            << "step " << step << " of kind " << kind << " at block " << simulation->position();
    }
}

INSTANTIATE_TEST_SUITE_P(Budgets, RandomPath,
                         testing::Values(PathCase{"Plenty", 1'000'000'000}, PathCase{"Packed", 1'500'000},
                                         PathCase{"None", 0}),
                         [](const auto& row) { return std::string(row.param.name); });

/// Counted in blocks, which other load on the machine hardly changes. With a fine grid and a wide cutter:
/// checkpoints are hundredths of a second of cutting apart, however small a share of the total that is.
TEST(EditCost, IsWhatLiesBehindTheEdit) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const int blocks = roundsOf(10'000);
    const std::string text = randomProgram(seed, blocks);
    const auto setup = std::make_shared<proveout::Setup>(*smallSetup(0.01));
    setup->tools.set(1, parseCutter("ball:d=20,l=30").value());
    DecimationParameters parameters;
    parameters.period = 0;
    const auto simulation = startedSimulation(programOf(text), setup, parameters);
    simulation->seek(simulation->blockCount());
    const std::size_t whole = simulation->effort().blocksCut;
    ASSERT_EQ(whole, simulation->blockCount());
    std::mt19937 random(seed);
    for (int edit = 0; edit < 3; ++edit) {
        // A line in the last tenth; the head of the text has three lines without motion.
        std::size_t at = 0;
        const auto tenth = static_cast<std::size_t>(blocks / 10);
        for (std::size_t line = 3 + 9 * tenth + random() % (tenth - 5); line > 0; --line)
            at = text.find('\n', at) + 1;
        std::string edited = text;
        edited.insert(at, "G1 X20 Y15 Z-6 F500\n");
        const std::size_t before = simulation->effort().blocksCut;
        apply(*simulation, programOf(edited));
        simulation->seek(simulation->blockCount());
        const std::size_t cut = simulation->effort().blocksCut - before;
        EXPECT_LE(static_cast<double>(cut), 0.15 * static_cast<double>(whole)) << "edit " << edit;
    }
}

} // namespace
} // namespace proveout
