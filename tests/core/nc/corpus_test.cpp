// SPDX-License-Identifier: GPL-3.0-or-later
// Compares with LinuxCNC: third-party programs, and the results of its own interpreter for them.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iostream>
#include <map>
#include <memory>
#include <set>

#include "core/nc/run/interpreter.h"
#include "tests/core/nc/oracle_comparison.h"

namespace proveout::test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kCorpus = fs::path(PROVEOUT_SHARED_DIR) / "corpus";

constexpr std::uint64_t kSteps = 1'000'000; ///< the longest program has 0.4 million lines; some programs
                                            ///< never end

/// Features that this interpreter does not support: programs that need them are not compared.
const std::map<std::string, const char*> kBeyondSubset{
    {"code-unsupported", "a code that is known but not supported"},
    {"code-unknown", "a code that the three-axis mill does not know"},
    {"axis-unsupported", "an axis A, B, C, U, V or W: a three-axis mill has none"},
    {"nc-binary", "not a text"},
    {"nc-encoding", "not a text"},
};

/// Our errors in programs that LinuxCNC runs, where we are stricter on purpose.
const std::set<std::string> kStricter{"number-double-sign", "arc-turns", "spline-handle", "spline-plane",
                                      "diameter-mode"};

/// Programs with deliberate differences, each with the reason.
const std::map<std::string, const char*> kReasons{
    {"linuxcnc-nc_files/nc_files/x-trim.ngc",
     "a missing subprogram is reported at its call, not at the end of the file"},
    {"linuxcnc-tests/tests/interp/pymove/test.ngc",
     "a missing subprogram is reported at its call, not at the end of the file"},
    {"linuxcnc-tests/tests/interp/abort-hot-comment/test.ngc",
     "a comment cannot stop a program: nothing is run"},
    {"linuxcnc-tests/tests/interp/m98m99/06-error-mixed-sub-styles/O...-called-with-O..._call.ngc",
     "O call of a program for M98 is reported at the call, not at its target"},
    {"linuxcnc-tests/tests/interp/m98m99/06-error-mixed-sub-styles/O...-sub-called-with-M98.ngc",
     "M98 of an O sub is reported at the call, not at its target"},
    {"linuxcnc-tests/tests/interp/m98m99/11-main-program-oword/test-illegal-no-m30-before-osub.ngc",
     "a main program with a number may run into a sub, which is skipped"},
    {"linuxcnc-tests/tests/interp/g33.1/g33.1.ngc",
     "a motion synchronized with the spindle has the feed of its pitch; the oracle has that of F"},
    {"pcb2gcode/multivibrator-extra-passes-two-isolators-tiles-al/back.ngc",
     "the stand-alone interpreter backs off 0.254 mm from where it has probed"},
};

/// The other programs that are not compared, and how many there are for each reason.
const std::map<std::string, int> kNotCompared{
    {"a code that is known but not supported", 3},
    {"a code that the three-axis mill does not know", 4},
    {"an axis A, B, C, U, V or W: a three-axis mill has none", 9},
    {"lone CR: LinuxCNC counts lines otherwise", 1},
    {"oracle incomplete", 3},
    {"stricter: diameter-mode", 1},
    {"stricter: number-double-sign", 1},
    {"stricter: spline-plane", 3},
};

/// Compared programs that LinuxCNC refuses, by the class of its error; both refuse the same line.
const std::map<std::string, int> kRefused{
    {"arc", 21},   {"axis-words", 2},    {"comment", 3}, {"conflict", 2},
    {"feed", 6},   {"line-too-long", 4}, {"modal", 9},   {"missing-subroutine", 6},
    {"other", 24}, {"parameter", 10},    {"syntax", 25},
};

constexpr int kCompared = 459;
constexpr std::size_t kMotions = 1'377'801;
constexpr int kNotText = 3;

/// The first message with one of the `ids`; null if there is none.
template<typename Ids>
const Diagnostic* firstOf(const Program& program, const Ids& ids) {
    for (const Diagnostic& diagnostic : program.diagnostics()) {
        if (ids.contains(diagnostic.id))
            return &diagnostic;
    }
    return nullptr;
}

struct Tally {
    int compared = 0;
    int agreed = 0;
    std::size_t motions = 0;
    std::map<std::string, int> skipped;
    std::map<std::string, int> refused;
};

void compareProgram(const fs::path& path, const Program& program, Tally& tally) {
    const OracleAnswer answer = readAnswer(path);
    const bool refused = answer.errorLine != 0 && answer.errorClass != "no-program-end";
    const Diagnostic* beyond = firstOf(program, kBeyondSubset);
    if (beyond != nullptr && (!refused || answer.errorLine < 0 || beyond->where.line <= answer.errorLine)) {
        ++tally.skipped[kBeyondSubset.at(beyond->id)];
        return;
    }
    if (answer.cut || answer.errorClass == "timeout" || answer.errorClass == "oracle-crash") {
        ++tally.skipped["oracle incomplete"];
        return;
    }
    if (answer.errorClass == "tool") {
        ++tally.skipped["tool table"];
        return;
    }
    if (path.filename() != "eol-mixed.ngc" &&
        firstOf(program, std::set<std::string>{"cr-line-end"}) != nullptr) {
        ++tally.skipped["lone CR: LinuxCNC counts lines otherwise"];
        return;
    }
    if (const Diagnostic* strict = firstOf(program, kStricter);
        strict != nullptr && (!refused || strict->where.line < answer.errorLine)) {
        ++tally.skipped[std::string("stricter: ") + strict->id];
        return;
    }
    ++tally.compared;
    tally.motions += program.motionCount();
    std::string why;
    OracleTolerances tolerances;
    tolerances.spindle =
        firstOf(program, std::set<std::string>{"surface-speed-limited", "surface-speed-unknown"}) == nullptr;
    bool agreed = sameSteps(answer, program, refused ? Extent::oracleBegins : Extent::whole, tolerances, why);
    const Diagnostic* error = firstError(program);
    if (agreed && !refused && error != nullptr) {
        why = "we refuse: " + oneLine(*error);
        agreed = false;
    }
    if (agreed && refused && answer.errorLine > 0 && !reportedOnLine(program, answer.errorLine)) {
        why = fmt::format("LinuxCNC refuses line {}: {}", answer.errorLine, answer.errorText);
        agreed = false;
    }
    if (refused)
        ++tally.refused[answer.errorClass];
    tally.agreed += agreed ? 1 : 0;
    const std::string name = fs::relative(path, kCorpus).string();
    if (const auto reason = kReasons.find(name); !agreed && reason != kReasons.end()) {
        ++tally.skipped[reason->second];
        return;
    }
    EXPECT_TRUE(agreed) << name << ": " << why;
}

double secondsToInterpret(const NcText& text, const InterpretOptions& options,
                          std::shared_ptr<const Program>& program) {
    const std::clock_t begin = std::clock(); // CPU time
    program = interpret(text, options);
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// CPU time of a line of a loop here, now: machines differ, and so do builds.
double secondsPerStep() {
    constexpr int kLines = 30'000;
    const NcText text = NcText(
        fmt::format("#1 = 0\no1 repeat [{}]\n  #1 = [#1 + 1]\n  G1 X#1 F1\no1 endrepeat\nM2\n", kLines / 3));
    std::shared_ptr<const Program> program;
    const double seconds = secondsToInterpret(text, {}, program);
    EXPECT_GE(program->motionCount(), kLines / 3 - 1U);
    return seconds / kLines;
}

} // namespace

TEST(Corpus, AgreesWithLinuxCncWhereTheSubsetSuffices) {
    if (!fs::exists(kCorpus))
        GTEST_SKIP() << "the corpus is not here";
    Tally tally;
    int unreadable = 0;
    for (const fs::path& path : programsWithAnswer(kCorpus)) {
        const auto text = NcText::load(path);
        if (!text) {
            ++unreadable;
            continue;
        }
        InterpretOptions options;
        options.file = path.filename().string();
        options.assumeStartAtZero = true;
        options.lint = false;
        options.subprogramFolders = {path.parent_path()};
        options.maxRepeated = kSteps;
        options.tools = toolsOfAnswer(path);
        compareProgram(path, *interpret(*text, options), tally);
    }
    std::cout << fmt::format("compared {} programs, {} motions: {} agree; not text: {}\n", tally.compared,
                             tally.motions, tally.agreed, unreadable);
    for (const auto& [reason, count] : tally.skipped)
        std::cout << fmt::format("  skipped {:4} for {}\n", count, reason);
    for (const auto& [reason, count] : tally.refused)
        std::cout << fmt::format("  refused by LinuxCNC {:4}: {}\n", count, reason);
    // Exact, so that no program drops out of the comparison unnoticed.
    std::map<std::string, int> skipped = kNotCompared;
    for (const auto& [name, reason] : kReasons)
        ++skipped[reason];
    EXPECT_EQ(tally.skipped, skipped);
    EXPECT_EQ(tally.refused, kRefused);
    EXPECT_EQ(tally.compared, kCompared);
    EXPECT_EQ(tally.motions, kMotions);
    EXPECT_EQ(unreadable, kNotText);
    EXPECT_EQ(tally.agreed, kCompared - static_cast<int>(kReasons.size()));
}

TEST(Corpus, TheTimeOfEveryFileGrowsWithItsSteps) {
    if (!fs::exists(kCorpus))
        GTEST_SKIP() << "the corpus is not here";
    constexpr double kSlack = 20; ///< a loop of plain lines, measured beside a busy core, differs by 4
    double perStep = secondsPerStep();
    double worst = 0;
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kCorpus)) {
        const std::string name = entry.path().string();
        if (!entry.is_regular_file() || name.ends_with(".jsonl") || name.ends_with(".gz"))
            continue;
        const auto text = NcText::load(entry.path());
        if (!text)
            continue;
        InterpretOptions options;
        options.maxRepeated = kSteps;
        options.maxMotions = kSteps;
        std::shared_ptr<const Program> program;
        double seconds = secondsToInterpret(*text, options, program);
        ++files;
        const bool endless = firstOf(*program, std::set<std::string>{"too-many-steps", "too-many-motions",
                                                                     "loop-without-motion"}) != nullptr;
        // A subprogram of the corpus takes up to 15 lines per motion.
        const double steps =
            1000 + static_cast<double>(text->lineCount()) + 0.05 * static_cast<double>(text->size()) +
            15 * static_cast<double>(program->motionCount()) + (endless ? static_cast<double>(kSteps) : 0.0);
        const auto tooLong = [&] { return seconds >= kSlack * perStep * steps; };
        // Load on the other core slows this down by a factor that changes: the shortest time counts.
        for (int again = 0; again < 8 && tooLong(); ++again) {
            perStep = std::max(perStep, secondsPerStep());
            seconds = std::min(seconds, secondsToInterpret(*text, options, program));
        }
        worst = std::max(worst, seconds / (perStep * steps));
        EXPECT_FALSE(tooLong()) << name << ": " << seconds << " s for " << steps << " steps of " << perStep
                                << " s";
        EXPECT_LE(program->diagnostics().size(), 2 * InterpretOptions().maxDiagnostics - 3) << name;
        for (std::size_t i = 0; i < program->motionCount(); ++i) {
            const Motion motion = program->motion(i);
            ASSERT_TRUE(std::isfinite(glm::dot(motion.end, motion.end)) && std::isfinite(motion.sweep) &&
                        std::isfinite(glm::dot(motion.centre, motion.centre)))
                << name;
        }
    }
    std::cout << fmt::format("{} files, at most {:.2f} times as long as a plain loop of as many steps\n",
                             files, worst);
}

} // namespace proveout::test
