// SPDX-License-Identifier: GPL-3.0-or-later
// Compares random programs with LinuxCNC's stand-alone interpreter. PROVEOUT_SHARE=40 tries 20,000 of them,
// PROVEOUT_SEED repeats a run; the first programs that differ are printed, shortened as far as they still
// differ.
#include <cctype>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <regex>
#include <set>
#include <utility>

#include "core/nc/codes/code_rows.h"
#include "core/nc/program/probe_target.h"
#include "core/nc/run/interpreter.h"
#include "tests/core/nc/explained_differences.h"
#include "tests/core/nc/oracle_comparison.h"
#include "tests/core/nc/random_program.h"
#include "tests/core/nc/rs274_listing.h"
#include "tests/core/nc/rs274_run.h"
#include "tests/random_seed.h"

namespace proveout::test {

namespace {

constexpr int kPrograms = 500;
constexpr int kMostPrinted = 6;
constexpr int kProgramsForAllCodes = 4000;
constexpr std::uint64_t kSteps = 20'000;

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += line + "\n";
    return text;
}

/// The program up to the last block before its first error, or before a block after which LinuxCNC is known
/// to continue differently: the part on which both must agree.
std::shared_ptr<const Program> upToParting(const NcText& text, InterpretOptions options,
                                           const Program& whole) {
    std::size_t without = 0;
    std::size_t with = whole.blockCount() + 1;
    while (with - without > 1) {
        options.stopAfterBlocks = (without + with) / 2;
        (firstParting(*interpret(text, options)) == nullptr ? without : with) = options.stopAfterBlocks;
    }
    options.stopAfterBlocks = without;
    return interpret(text, options);
}

/// Where and why each of them stops.
std::string refusals(const OracleAnswer& answer, const Program& ours) {
    const Diagnostic* error = firstError(ours);
    return fmt::format("LinuxCNC stops at line {} ({}), we at line {} ({})", answer.errorLine,
                       answer.errorText, error == nullptr ? 0 : error->where.line,
                       error == nullptr ? "" : error->id);
}

/// Where the stand-alone interpreter assumes that a probe is triggered.
class Backup : public ProbeTarget {
public:
    Answer probe(const Program& /*program*/, const Motion& motion, Seek /*seek*/,
                 const WorkContext& /*context*/) override {
        const Vec3 back = motion.start - motion.end;
        return {Answer::Kind::found, motion.end + back * (kProbeBackup / glm::length(back))};
    }
};

class ProbedEverywhere : public ProbedPart {
public:
    [[nodiscard]] std::unique_ptr<ProbeTarget> target() const override { return std::make_unique<Backup>(); }
    [[nodiscard]] bool sameAs(const ProbedPart& other) const override { return this == &other; }
};

class Comparison {
public:
    Comparison() : m_tools(toolsOfRandomPrograms()), m_oracle(m_tools) {}

    /// The first difference without a documented reason; empty if they agree.
    Outcome compare(const std::vector<std::string>& lines) const {
        const std::string text = joined(lines);
        const OracleAnswer answer = m_oracle.run(text);
        InterpretOptions options;
        options.assumeStartAtZero = true;
        options.lint = false;
        options.maxRepeated = kSteps;
        options.tools = ToolOffsets(m_tools);
        options.part = m_part;
        const auto program = interpret(NcText(text), options);
        const auto beginning = upToParting(NcText(text), options, *program);
        Outcome outcome = outcomeOf(lines, answer, {*program, *beginning});
        if (!outcome.why.empty())
            outcome.why += fmt::format("; {}", refusals(answer, *program));
        return outcome;
    }

private:
    std::map<int, ToolOffset> m_tools;
    Rs274 m_oracle;
    PartToProbe m_part{std::make_shared<ProbedEverywhere>()};
};

/// The part of a difference that stays the same when a program is shortened.
std::string shapeOf(const Outcome& outcome) {
    constexpr std::size_t kBeginning = 40;
    std::string shape;
    for (const char c : outcome.why) {
        if (std::isalpha(static_cast<unsigned char>(c)) != 0)
            shape += c;
    }
    return shape.substr(0, kBeginning);
}

/// The lines without those that the difference does not depend on.
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

/// Adds letter and tenths of every G and M word of a line.
void addCodes(const std::string& line, std::set<std::pair<char, int>>& codes) {
    static const std::regex kCode("([GgMm])([0-9]+)(?:[.]([0-9]))?");
    for (std::sregex_iterator it(line.begin(), line.end(), kCode), end; it != end; ++it) {
        const int tenths = (*it)[3].matched ? std::stoi((*it)[3]) : 0;
        codes.emplace(std::toupper(static_cast<unsigned char>((*it)[1].str()[0])),
                      std::stoi((*it)[2]) * 10 + tenths);
    }
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
        if (!outcome.differs())
            continue;
        std::cout << fmt::format("program of seed {}: {}\n", seed + static_cast<std::uint32_t>(i),
                                 outcome.why);
        if (++differing > kMostPrinted)
            continue;
        const std::vector<std::string> least = shrunk(comparison, lines, outcome);
        std::cout << comparison.compare(least).why << "\n" << joined(least) << std::flush;
    }
    for (const auto& [kind, count] : tally)
        std::cout << fmt::format("{:6} {}\n", count, kind);
    EXPECT_EQ(differing, 0) << "of " << programs;
}

TEST(Differential, TheGeneratorWritesEveryCodeOfTheDialect) {
    std::mt19937 random(1);
    std::set<std::pair<char, int>> written;
    for (int i = 0; i < kProgramsForAllCodes; ++i) {
        for (const std::string& line : randomProgram(random))
            addCodes(line, written);
    }
    for (const auto rows : {basicCodes(), rs274Codes()}) {
        for (const CodeRow& row : rows)
            EXPECT_TRUE(written.contains({row.letter, row.tenths})) << row.letter << row.tenths / 10.0;
    }
}

} // namespace proveout::test
