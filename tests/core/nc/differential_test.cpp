// SPDX-License-Identifier: GPL-3.0-or-later
// Random programs against LinuxCNC's stand-alone interpreter. PROVEOUT_SHARE=40 tries 20,000 of them,
// PROVEOUT_SEED repeats a run; every program that differs is printed as short as it still differs.
#include <cctype>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iostream>
#include <map>
#include <random>

#include "core/nc/interpreter.h"
#include "tests/core/nc/explained_differences.h"
#include "tests/core/nc/oracle_comparison.h"
#include "tests/core/nc/random_program.h"
#include "tests/core/nc/rs274_run.h"
#include "tests/random_seed.h"

namespace proveout::test {

namespace {

constexpr int kPrograms = 500;
constexpr int kMostPrinted = 6;
/// In a thousand programs, so many differ for reasons that are not found yet; the number may only fall.
constexpr int kMostDiffering = 20;
constexpr std::uint64_t kSteps = 20'000;

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += line + "\n";
    return text;
}

class Comparison {
public:
    Comparison() : m_tools(toolsOfRandomPrograms()), m_oracle(m_tools) {}

    /// Where both differ without a reason that is written down; empty where they agree.
    Outcome compare(const std::vector<std::string>& lines) const {
        const std::string text = joined(lines);
        const OracleAnswer answer = m_oracle.run(text);
        InterpretOptions options;
        options.assumeStartAtZero = true;
        options.lint = false;
        options.maxRepeated = kSteps;
        options.tools = ToolOffsets(m_tools);
        const auto program = interpret(NcText(text), options);
        return outcomeOf(lines, answer, *program);
    }

private:
    std::map<int, ToolOffset> m_tools;
    Rs274 m_oracle;
};

/// What stays the same of a difference when a program becomes shorter.
std::string shapeOf(const Outcome& outcome) {
    constexpr std::size_t kBeginning = 40;
    std::string shape;
    for (const char c : outcome.why) {
        if (std::isalpha(static_cast<unsigned char>(c)) != 0)
            shape += c;
    }
    return shape.substr(0, kBeginning);
}

/// The lines without those that the difference does not need.
std::vector<std::string> shrunk(const Comparison& comparison, std::vector<std::string> lines,
                                const Outcome& outcome) {
    const std::string shape = shapeOf(outcome);
    for (std::size_t length = std::max<std::size_t>(1, lines.size() / 2); length > 0; length /= 2) {
        for (std::size_t at = 0; at + length <= lines.size();) {
            std::vector<std::string> fewer = lines;
            const auto begin = fewer.begin() + static_cast<std::ptrdiff_t>(at);
            fewer.erase(begin, begin + static_cast<std::ptrdiff_t>(length));
            if (shapeOf(comparison.compare(fewer)) == shape)
                lines = std::move(fewer);
            else
                ++at;
        }
    }
    return lines;
}

} // namespace

TEST(Differential, AgreesWithLinuxCncOnRandomPrograms) {
    if (!Rs274::isInstalled())
        GTEST_SKIP() << "rs274 of the package linuxcnc-uspace is not installed";
    const std::uint32_t seed = randomSeed();
    std::cout << fmt::format("seed {}\n", seed);
    const Comparison comparison;
    std::map<std::string, int> tally;
    const int programs = roundsOf(kPrograms);
    int differing = 0;
    for (int i = 0; i < programs; ++i) {
        std::mt19937 random(seed + static_cast<std::uint32_t>(i));
        const std::vector<std::string> lines = randomProgram(random);
        const Outcome outcome = comparison.compare(lines);
        ++tally[outcome.kind];
        if (!outcome.differs() || ++differing > kMostPrinted)
            continue;
        const std::vector<std::string> least = shrunk(comparison, lines, outcome);
        std::cout << "program of seed " << seed + static_cast<std::uint32_t>(i) << ": "
                  << comparison.compare(least).why << "\n"
                  << joined(least);
    }
    for (const auto& [kind, count] : tally)
        std::cout << fmt::format("{:6} {}\n", count, kind);
    EXPECT_LE(differing * 1000, kMostDiffering * programs);
}

} // namespace proveout::test
