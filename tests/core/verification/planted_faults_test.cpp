// SPDX-License-Identifier: GPL-3.0-or-later
// What a check finds in random programs with one planted fault each, and in their clean twins.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <memory>

#include "core/nc/run/interpreter.h"
#include "core/simulation/run/interpretation.h"
#include "core/verification/check/check.h"
#include "core/verification/verdict/not_checked.h"
#include "tests/core/verification/planted_faults.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

constexpr int kPairsOfAKind = 20;

CheckRules acceptingAll(const PlantedPair& pair) {
    CheckRules rules;
    rules.limits.rapidClearance = 1;
    rules.limits.holderClearance = pair.holderClearance;
    for (const NotCheckedRow& row : notCheckedRows())
        rules.accepted.insert({row.id, {}});
    return rules;
}

std::shared_ptr<const CheckReport> checked(const std::string& text, const PlantedPair& pair) {
    const auto setup = std::make_shared<const Setup>(pair.setup);
    const NcText lines(text);
    CheckSubject subject;
    subject.program = interpretOn(*setup, lines, interpretOptions(*setup, "part.nc"));
    subject.setup = setup;
    subject.machine = pair.machine;
    return check(subject, acceptingAll(pair), std::uint64_t{1} << 32).value();
}

std::string described(const CheckReport& report) {
    std::string out = name(report.verdict());
    for (const CheckFinding& finding : report.findings)
        out += fmt::format("\n{} line {} value {}: {}", finding.diagnostic.id, finding.diagnostic.where.line,
                           finding.value, message(finding.diagnostic));
    return out;
}

/// A note does not change the verdict.
bool counts(const CheckFinding& finding) {
    return finding.diagnostic.severity != Severity::note;
}

/// What was found of one kind of fault.
struct Tally {
    int planted = 0;
    int found = 0;         ///< at the right line, of the right size
    int wronglyBlamed = 0; ///< findings of other faults, and of clean twins
    double worst = 0;      ///< the largest difference of a size, relative
};

void judge(const PlantedKind& kind, std::uint_fast32_t seed, Tally& tally) {
    const PlantedPair pair = plantedPair(kind, seed);
    SCOPED_TRACE(fmt::format("{} seed {}", kind.name, seed));
    const auto faulty = checked(pair.faulty, pair);
    const auto clean = checked(pair.clean, pair);
    ++tally.planted;
    const auto isIt = [&](const CheckFinding& one) { return one.diagnostic.id == std::string(kind.id); };
    const auto found = std::ranges::find_if(faulty->findings, isIt);
    if (found == faulty->findings.end()) {
        ADD_FAILURE() << pair.faulty << described(*faulty);
        return;
    }
    EXPECT_EQ(found->diagnostic.where.line, pair.line) << pair.faulty << described(*faulty);
    if (pair.value) {
        const double off = std::abs(found->value - *pair.value);
        tally.worst = std::max(tally.worst, off / *pair.value);
        EXPECT_LE(off, std::max(0.01, 0.02 * *pair.value)) << pair.faulty << described(*faulty);
    }
    ++tally.found;
    for (const CheckFinding& other : faulty->findings)
        tally.wronglyBlamed += !isIt(other) && counts(other) && !pair.alsoFound.contains(other.diagnostic.id);
    tally.wronglyBlamed += static_cast<int>(std::ranges::count_if(
        clean->findings, [&](const CheckFinding& one) { return counts(one) || isIt(one); }));
    EXPECT_EQ(tally.wronglyBlamed, 0) << pair.faulty << described(*faulty) << "\ntwin:\n"
                                      << described(*clean);
    EXPECT_EQ(clean->verdict(), Verdict::safe) << pair.clean << described(*clean);
}

TEST(PlantedFaults, AreAllFoundAndTheirTwinsAreSafe) {
    const std::uint32_t seed = randomSeed();
    std::printf("seed %u\n%-26s %-20s %8s %6s %7s %10s\n", seed, "planted", "finding", "programs", "found",
                "blamed", "size off");
    for (const PlantedKind& kind : plantedKinds()) {
        Tally tally;
        for (int round = 0; round < roundsOf(kPairsOfAKind); ++round)
            judge(kind, seed + static_cast<std::uint32_t>(round), tally);
        std::printf("%-26s %-20s %8d %6d %7d %8.2f %%\n", kind.name, kind.id, tally.planted, tally.found,
                    tally.wronglyBlamed, 100 * tally.worst);
    }
}

} // namespace
} // namespace proveout
