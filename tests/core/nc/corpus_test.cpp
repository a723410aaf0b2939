// SPDX-License-Identifier: GPL-3.0-or-later
// Against LinuxCNC: programs written by others, and what its own interpreter makes of them.
#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iostream>
#include <map>
#include <set>

#include "core/nc/interpreter.h"
#include "tests/core/nc/oracle_records.h"

namespace proveout::test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kCorpus = fs::path(PROVEOUT_SHARED_DIR) / "corpus";

constexpr std::uint64_t kSteps = 1'000'000; ///< the longest program has 0.4 million lines; some are endless
constexpr double kPointTolerance = 1e-6;
constexpr double kCentreTolerance = 1e-4;

/// What this interpreter does not claim to understand: programs that need it are not compared.
const std::set<std::string> kBeyondSubset{"code-unsupported", "code-unknown", "axis-unsupported", "nc-binary",
                                          "nc-encoding"};

/// Errors of ours on programs that LinuxCNC runs: we are stricter on purpose.
const std::set<std::string> kStricter{"number-double-sign", "arc-turns"};

/// Programs on which we differ on purpose, each with the reason.
const std::map<std::string, const char*> kReasons{
    {"linuxcnc-nc_files/nc_files/x-trim.ngc",
     "a missing subprogram is told at its call, not at the end of the file"},
    {"linuxcnc-tests/tests/interp/pymove/test.ngc",
     "a missing subprogram is told at its call, not at the end of the file"},
    {"linuxcnc-tests/tests/interp/abort-hot-comment/test.ngc",
     "a comment cannot stop a program: nothing is run"},
    {"linuxcnc-tests/tests/interp/m98m99/06-error-mixed-sub-styles/O...-called-with-O..._call.ngc",
     "O call of a program for M98 is told at the call, not where it leads to"},
    {"linuxcnc-tests/tests/interp/m98m99/06-error-mixed-sub-styles/O...-sub-called-with-M98.ngc",
     "M98 of an O sub is told at the call, not where it leads to"},
    {"linuxcnc-tests/tests/interp/m98m99/11-main-program-oword/test-illegal-no-m30-before-osub.ngc",
     "a main program with a number may run into a sub, which is passed over"},
    {"linuxcnc-tp/nc_files/arc-feed/full_xz.ngc",
     "an arc of G18 under a rotation lies in no plane of the machine"},
    {"linuxcnc-tp/nc_files/arc-feed/full_yz.ngc",
     "an arc of G18 under a rotation lies in no plane of the machine"},
};

/// The motions and events of a program, one after the other, as one line of text or a motion.
struct Step {
    std::string kind;
    std::uint32_t line = 0;
    Motion motion;
    double number = 0; ///< tool, seconds
};

std::vector<Step> stepsOf(const Program& program) {
    std::vector<Step> steps;
    std::size_t event = 0;
    const auto addEvents = [&](std::size_t motion) {
        for (; event < program.events().size() && program.events()[event].beforeMotion <= motion; ++event) {
            const Event& e = program.events()[event];
            if (const auto* tool = std::get_if<ToolChange>(&e.data))
                steps.push_back({"tool", e.line, {}, static_cast<double>(tool->tool)});
            if (const auto* dwell = std::get_if<Dwell>(&e.data))
                steps.push_back({"dwell", e.line, {}, dwell->seconds});
            if (std::holds_alternative<ProgramEnd>(e.data))
                steps.push_back({"end", e.line, {}, 0});
        }
    };
    for (std::size_t i = 0; i < program.motionCount(); ++i) {
        addEvents(i);
        const Motion motion = program.motion(i);
        const char* const kind = motion.kind == MotionKind::rapid  ? "rapid"
                                 : motion.kind == MotionKind::feed ? "feed"
                                                                   : "arc";
        steps.push_back({kind, motion.line, motion, 0});
    }
    addEvents(program.motionCount());
    return steps;
}

/// A number; the oracle writes what JSON cannot hold as text.
double number(const json& value) {
    return value.is_string() ? std::nan("") : value.get<double>();
}

double distance(const json& point, const Vec3& ours) {
    return glm::length(Vec3(number(point[0]), number(point[1]), number(point[2])) - ours);
}

std::string cuttingDifference(const json& record, const Motion& motion) {
    const bool perRevolution = record["fm"] == "rev";
    const double feed = number(record["f"]) * (perRevolution ? std::abs(motion.spindleRpm) : 1.0);
    if (perRevolution != motion.perRevolution)
        return "feed mode";
    if (std::abs(feed - motion.feedMmPerMin) > 1e-6 + 1e-6 * feed)
        return fmt::format("feed {} / {}", feed, motion.feedMmPerMin);
    if (record["t"].get<int>() != motion.tool)
        return fmt::format("tool {} / {}", record["t"].dump(), motion.tool);
    const double speed = number(record["s"]) * record["d"].get<int>();
    if (std::abs(speed - motion.spindleRpm) > 1e-6)
        return fmt::format("spindle {} / {}", speed, motion.spindleRpm);
    if (std::abs(number(record["s"]) - motion.orderedRpm) > 1e-6)
        return fmt::format("speed {} / {}", record["s"].dump(), motion.orderedRpm);
    return {};
}

std::string arcDifference(const json& record, const Motion& motion) {
    const double radius = number(record["r"]);
    // An arc that is straight to a nanometre is handed on as a straight line.
    if (motion.kind == MotionKind::feed && radius > 1e7)
        return {};
    if (distance(record["c"], motion.centre) > kCentreTolerance)
        return fmt::format("centre off by {}", distance(record["c"], motion.centre));
    Vec3 normal(0);
    normal[axes(motion.plane).normal] = 1;
    if (distance(record["n"], normal) > 1e-9)
        return "plane";
    if (std::abs(number(record["w"]) - motion.sweep) * radius > kCentreTolerance)
        return fmt::format("sweep {} / {}", number(record["w"]), motion.sweep);
    return {};
}

std::string difference(const json& record, const Step& step) {
    const std::string kind = record["k"];
    const bool flatArc = kind == "arc" && step.kind == "feed" && number(record["r"]) > 1e7;
    if (kind != step.kind && !flatArc)
        return fmt::format("{} (line {}) / {} (line {})", kind, record["l"].dump(), step.kind, step.line);
    if (record["l"].is_number() && record["l"].get<std::uint32_t>() != step.line)
        return fmt::format("line {} / {}", record["l"].dump(), step.line);
    if (kind == "tool")
        return number(record["t"]) == step.number ? "" : "tool";
    if (kind == "dwell")
        return std::abs(number(record["sec"]) - step.number) < 1e-6 ? "" : "dwell";
    if (kind == "end")
        return {};
    if (distance(record["e"], step.motion.end) > kPointTolerance)
        return fmt::format("end point off by {}", distance(record["e"], step.motion.end));
    std::string why = kind == "rapid" ? "" : cuttingDifference(record, step.motion);
    return why.empty() && kind == "arc" ? arcDifference(record, step.motion) : why;
}

/// The first message with an id of `ids`; null where there is none.
const Diagnostic* firstOf(const Program& program, const std::set<std::string>& ids) {
    for (const Diagnostic& diagnostic : program.diagnostics()) {
        if (ids.contains(diagnostic.id))
            return &diagnostic;
    }
    return nullptr;
}

const Diagnostic* firstError(const Program& program) {
    for (const Diagnostic& diagnostic : program.diagnostics()) {
        if (diagnostic.severity == Severity::error)
            return &diagnostic;
    }
    return nullptr;
}

bool toldOnLine(const Program& program, int line) {
    for (const Diagnostic& diagnostic : program.diagnostics()) {
        if (diagnostic.where.line == line && diagnostic.severity >= Severity::warning)
            return true;
    }
    return false;
}

struct Tally {
    int compared = 0;
    int agreed = 0;
    std::size_t motions = 0;
    std::map<std::string, int> skipped;
    std::map<std::string, int> refused;
};

/// Whether the records before line `until` agree (0: all).
bool sameSteps(const OracleAnswer& answer, const Program& program, int until, std::string& why) {
    const std::vector<Step> steps = stepsOf(program);
    for (std::size_t i = 0; i < answer.records.size(); ++i) {
        if (i >= steps.size()) {
            why = fmt::format("only LinuxCNC: {}", answer.records[i].dump());
            return false;
        }
        why = difference(answer.records[i], steps[i]);
        if (!why.empty()) {
            why = fmt::format("record {} (line {}): {}", i, steps[i].line, why);
            return false;
        }
    }
    if (until == 0 && steps.size() > answer.records.size()) {
        why = fmt::format("only ours: {} of line {}", steps[answer.records.size()].kind,
                          steps[answer.records.size()].line);
        return false;
    }
    return true;
}

void compareProgram(const fs::path& path, const Program& program, Tally& tally) {
    const OracleAnswer answer = readAnswer(path);
    const bool refused = answer.errorLine != 0 && answer.errorClass != "no-program-end";
    const Diagnostic* beyond = firstOf(program, kBeyondSubset);
    if (beyond != nullptr && (!refused || answer.errorLine < 0 || beyond->where.line <= answer.errorLine)) {
        ++tally.skipped[beyond->id];
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
    if (path.filename() != "eol-mixed.ngc" && firstOf(program, {"cr-line-end"}) != nullptr) {
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
    bool agreed = sameSteps(answer, program, refused ? answer.errorLine : 0, why);
    const Diagnostic* error = firstError(program);
    if (agreed && !refused && error != nullptr) {
        why = "we refuse: " + oneLine(*error);
        agreed = false;
    }
    if (agreed && refused && answer.errorLine > 0 && !toldOnLine(program, answer.errorLine)) {
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
        options.subprogramFolders = {path.parent_path()};
        options.maxSteps = kSteps;
        compareProgram(path, *interpret(*text, options), tally);
    }
    std::cout << fmt::format("compared {} programs, {} motions: {} agree; not text: {}\n", tally.compared,
                             tally.motions, tally.agreed, unreadable);
    for (const auto& [reason, count] : tally.skipped)
        std::cout << fmt::format("  skipped {:4} for {}\n", count, reason);
    for (const auto& [reason, count] : tally.refused)
        std::cout << fmt::format("  refused by LinuxCNC {:4}: {}\n", count, reason);
    EXPECT_GT(tally.compared, 100);
}

TEST(Corpus, EveryFileIsInterpretedInTime) {
    if (!fs::exists(kCorpus))
        GTEST_SKIP() << "the corpus is not here";
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kCorpus)) {
        const std::string name = entry.path().string();
        if (!entry.is_regular_file() || name.ends_with(".jsonl") || name.ends_with(".gz"))
            continue;
        const std::clock_t begin = std::clock();
        const auto text = NcText::load(entry.path());
        if (!text)
            continue;
        InterpretOptions options;
        options.maxSteps = kSteps;
        options.maxMotions = kSteps;
        const auto program = interpret(*text, options);
        // Of the processor: what else the machine does is no matter.
        const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        ++files;
        const bool endless = firstOf(*program, {"too-many-steps", "too-many-motions"}) != nullptr;
        const double allowed = 0.1 + 2e-6 * static_cast<double>(entry.file_size()) +
                               (endless ? 1e-6 * static_cast<double>(kSteps) : 0.0);
        EXPECT_LT(seconds, allowed) << name;
        EXPECT_LE(program->diagnostics().size(), 101U) << name;
        for (std::size_t i = 0; i < program->motionCount(); ++i) {
            const Motion motion = program->motion(i);
            ASSERT_TRUE(std::isfinite(glm::dot(motion.end, motion.end)) && std::isfinite(motion.sweep) &&
                        std::isfinite(glm::dot(motion.centre, motion.centre)))
                << name;
        }
    }
    std::cout << fmt::format("{} files\n", files);
}

} // namespace proveout::test
