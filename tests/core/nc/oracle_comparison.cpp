// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/oracle_comparison.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace proveout::test {

namespace {

using nlohmann::json;

/// The motions and events of a program in sequence, one line of text per motion.
struct Step {
    std::string kind;
    std::uint32_t line = 0;
    Motion motion;
    double number = 0; ///< tool number or seconds
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

/// A number; the oracle writes values that JSON cannot represent as text.
double number(const json& value) {
    return value.is_string() ? std::nan("") : value.get<double>();
}

double distance(const json& point, const Vec3& ours) {
    return glm::length(Vec3(number(point[0]), number(point[1]), number(point[2])) - ours);
}

/// With G93, LinuxCNC computes an arc's feed from the radius at its start; if the radius at its end differs
/// because its words are rounded, so does the feed.
double feedSlack(const Motion& motion) {
    if (motion.kind != MotionKind::arc)
        return 0;
    const PlaneAxes plane = axes(motion.plane);
    const auto radius = [&](const Vec3& point) {
        return std::hypot(point[plane.first] - motion.centre[plane.first],
                          point[plane.second] - motion.centre[plane.second]);
    };
    return std::abs(radius(motion.start) - radius(motion.end)) / std::max(radius(motion.start), 1e-9);
}

std::string cuttingDifference(const json& record, const Motion& motion, bool withSpindle) {
    const bool perRevolution = record["fm"] == "rev";
    const double feed = number(record["f"]) * (perRevolution ? std::abs(motion.spindleRpm) : 1.0);
    if (perRevolution != motion.perRevolution)
        return "feed mode";
    if (std::abs(feed - motion.feedMmPerMin) > 1e-6 + (1e-6 + feedSlack(motion)) * feed)
        return fmt::format("feed {} / {}", feed, motion.feedMmPerMin);
    if (record["t"].get<int>() != motion.tool)
        return fmt::format("tool {} / {}", record["t"].dump(), motion.tool);
    if (!withSpindle)
        return {};
    const double speed = number(record["s"]) * record["d"].get<int>();
    if (std::abs(speed - motion.spindleRpm) > 1e-6)
        return fmt::format("spindle {} / {}", speed, motion.spindleRpm);
    if (std::abs(number(record["s"]) - motion.orderedRpm) > 1e-6)
        return fmt::format("speed {} / {}", record["s"].dump(), motion.orderedRpm);
    return {};
}

std::string arcDifference(const json& record, const Motion& motion, const OracleTolerances& tolerances) {
    const double radius = number(record["r"]);
    // An arc that is straight within a nanometre is output as a straight line.
    if (motion.kind == MotionKind::feed && radius > 1e7)
        return {};
    if (distance(record["c"], motion.centre) > tolerances.centre)
        return fmt::format("centre off by {}", distance(record["c"], motion.centre));
    Vec3 normal(0);
    normal[axes(motion.plane).normal] = 1;
    if (distance(record["n"], normal) > 1e-9)
        return "plane";
    if (std::abs(number(record["w"]) - motion.sweep) * radius > tolerances.centre)
        return fmt::format("sweep {} / {}", number(record["w"]), motion.sweep);
    return {};
}

std::string difference(const OracleAnswer& answer, const json& record, const Step& step,
                       const OracleTolerances& tolerances) {
    const std::string kind = record["k"];
    const bool flatArc = kind == "arc" && step.kind == "feed" && number(record["r"]) > 1e7;
    const bool asFeed = (kind == "probe" || kind == "tap") && step.kind == "feed";
    if (kind != step.kind && !flatArc && !asFeed)
        return fmt::format("{} (line {}) / {} (line {})", kind, record["l"].dump(), step.kind, step.line);
    // With cutter compensation, the oracle reports the line at which it outputs a motion.
    if (!answer.compensated && record["l"].is_number() && record["l"].get<std::uint32_t>() != step.line)
        return fmt::format("line {} / {}", record["l"].dump(), step.line);
    if (kind == "tool")
        return number(record["t"]) == step.number ? "" : "tool";
    if (kind == "dwell")
        return std::abs(number(record["sec"]) - step.number) < 1e-6 ? "" : "dwell";
    if (kind == "end")
        return {};
    if (distance(record["e"], step.motion.end) > tolerances.point)
        return fmt::format("end point off by {}", distance(record["e"], step.motion.end));
    std::string why = kind == "rapid" ? "" : cuttingDifference(record, step.motion, tolerances.spindle);
    return why.empty() && kind == "arc" ? arcDifference(record, step.motion, tolerances) : why;
}

/// The oracle reports a spline as one record without its path, so the motions after it are compared.
std::size_t behindSpline(const json& record, const std::vector<Step>& steps, std::size_t at) {
    while (at < steps.size() && steps[at].kind == "feed" && record["l"] == steps[at].line)
        ++at;
    return at;
}

/// Whether the oracle's arc is in none of the machine's planes.
bool turned(const json& record) {
    return record["k"] == "arc" &&
           std::ranges::none_of(record["n"], [](const json& n) { return std::abs(number(n)) == 1; });
}

Vec3 pointOf(const json& values) {
    return {number(values[0]), number(values[1]), number(values[2])};
}

/// We split a rotated arc into straight motions, whose ends must be on it. Returns the step after them; empty
/// if they are not on it.
std::optional<std::size_t> behindTurnedArc(const json& record, const std::vector<Step>& steps, std::size_t at,
                                           double tolerance) {
    const Vec3 normal = pointOf(record["n"]);
    for (; at < steps.size() && steps[at].kind == "feed"; ++at) {
        const Vec3 spoke = steps[at].motion.end - pointOf(record["c"]);
        const double radius = glm::length(spoke - normal * glm::dot(spoke, normal));
        if (std::abs(radius - number(record["r"])) > tolerance)
            return {};
        if (distance(record["e"], steps[at].motion.end) < tolerance)
            return at + 1;
    }
    return {};
}

/// The oracle reports only the way down of a rigid tap.
bool returns(const std::vector<Step>& steps, std::size_t at) {
    return at < steps.size() && steps[at].kind == "feed" &&
           steps[at].motion.end == steps[at - 1].motion.start;
}

/// Whether a record is a rapid to the position where the tool is already. The tool table of the stand-alone
/// machine is in inches, so the target level may be above the tool by a rounding error.
bool isStill(const json& record, const Step& next) {
    return record["k"] == "rapid" && (next.kind == "rapid" || next.kind == "feed" || next.kind == "arc") &&
           distance(record["e"], next.motion.start) < 1e-9;
}

} // namespace

const Diagnostic* firstError(const Program& program) {
    for (const Diagnostic& diagnostic : program.diagnostics()) {
        if (diagnostic.severity == Severity::error)
            return &diagnostic;
    }
    return nullptr;
}

bool isUnlikeControl(const Diagnostic& diagnostic) {
    return diagnostic.id == std::string("continue-in-do") || diagnostic.id == std::string("called-never");
}

const Diagnostic* firstParting(const Program& program) {
    for (const Diagnostic& diagnostic : program.diagnostics()) {
        if (diagnostic.severity == Severity::error || isUnlikeControl(diagnostic))
            return &diagnostic;
    }
    return nullptr;
}

bool reportedOnLine(const Program& program, int line) {
    for (const Diagnostic& diagnostic : program.diagnostics()) {
        if (diagnostic.where.line == line && diagnostic.severity >= Severity::warning)
            return true;
    }
    return false;
}

bool sameSteps(const OracleAnswer& answer, const Program& program, Extent extent,
               const OracleTolerances& tolerances, std::string& why) {
    const std::vector<Step> steps = stepsOf(program);
    std::size_t at = 0;
    for (std::size_t i = 0; i < answer.records.size(); ++i) {
        const json& record = answer.records[i];
        if (at >= steps.size()) {
            if (extent == Extent::oursBegins)
                return true;
            why = fmt::format("only LinuxCNC: {}", record.dump());
            return false;
        }
        if (record["k"] == "nurbs") {
            at = behindSpline(record, steps, at);
            continue;
        }
        if (turned(record)) {
            const auto behind = behindTurnedArc(record, steps, at, tolerances.point);
            if (!behind) {
                why = fmt::format("record {} (line {}): turned arc", i, steps[at].line);
                return false;
            }
            at = *behind;
            continue;
        }
        why = difference(answer, record, steps[at], tolerances);
        if (!why.empty() && isStill(record, steps[at]))
            continue;
        if (why.empty() && record["k"] == "tap" && !returns(steps, ++at))
            why = "the tap stays in its hole";
        if (!why.empty()) {
            why = fmt::format("record {} (line {}): {}", i, steps[std::min(at, steps.size() - 1)].line, why);
            return false;
        }
        ++at;
    }
    if (extent != Extent::oracleBegins && steps.size() > at) {
        why = fmt::format("only ours: {} of line {}", steps[at].kind, steps[at].line);
        return false;
    }
    return true;
}

} // namespace proveout::test
