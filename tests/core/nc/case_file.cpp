// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/case_file.h"

#include "core/nc/codes/dialects.h"
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <variant>

namespace proveout::test {

namespace {

constexpr double kTolerance = 1e-6; ///< mm, degrees, seconds; feed rates are stored as floats

std::string number(double value) {
    const double rounded = std::round(value * 1e7) / 1e7;
    return fmt::format("{:.10g}", rounded == 0 ? 0.0 : rounded);
}

std::string point(const Vec3& p) {
    return number(p.x) + " " + number(p.y) + " " + number(p.z);
}

void apply(CaseFile& into, const std::string& key, const std::string& value) {
    std::istringstream in(value);
    if (key == "rule") {
        into.rule = value;
    } else if (key == "dialect") {
        const Dialect* found = findDialect(value);
        if (found == nullptr)
            throw std::runtime_error("no dialect " + value);
        into.options.dialect = found->id;
    } else if (key == "start") {
        into.options.assumeStartAtZero = false;
        if (value != "unknown") {
            Vec3 start(0);
            in >> start.x >> start.y >> start.z;
            into.options.start = start;
        }
    } else if (key == "lint") {
        into.options.lint = value == "yes";
    } else if (key == "delete") {
        into.options.blockDelete = value == "yes";
    } else if (key == "start-up") {
        into.options.compensationTypeB = value == "B";
    } else if (key == "tools") {
        std::map<int, ToolOffset> tools;
        for (std::string tool; std::getline(in, tool, ',');) {
            std::istringstream words(tool);
            int index = 0;
            words >> index;
            for (std::string word; words >> word;)
                (word[0] == 'd' ? tools[index].diameter : tools[index].offset.z) = std::stod(word.substr(1));
        }
        into.options.tools = ToolOffsets(tools);
    } else {
        throw std::runtime_error("no key " + key);
    }
}

std::string stepOf(const Motion& motion) {
    const std::string feed =
        motion.feedMmPerMin > 0 && motion.kind != MotionKind::rapid ? " F" + number(motion.feedMmPerMin) : "";
    const char* const kind = motion.kind == MotionKind::rapid  ? "rapid"
                             : motion.kind == MotionKind::feed ? "feed"
                                                               : "arc";
    std::string step = fmt::format("{} {} {}", motion.line, kind, point(motion.end));
    if (motion.kind == MotionKind::arc) {
        const PlaneAxes plane = axes(motion.plane);
        step +=
            fmt::format(" c {} {} {}", number(motion.centre[plane.first]),
                        number(motion.centre[plane.second]), number(motion.sweep * 180 / std::numbers::pi));
    }
    return step + feed;
}

struct EventText {
    std::string operator()(const ToolChange& e) const { return fmt::format("tool {}", e.tool); }
    std::string operator()(const ToolLengthOffset& e) const { return "length " + point(e.offset); }
    std::string operator()(const Dwell& e) const { return "dwell " + number(e.seconds); }
    std::string operator()(const CoolantSwitch& e) const {
        return fmt::format("{} {}", e.coolant == Coolant::mist ? "mist" : "flood", e.on ? "on" : "off");
    }
    std::string operator()(const ProgramStop& e) const {
        return e.kind == StopKind::program    ? "stop"
               : e.kind == StopKind::optional ? "optional-stop"
                                              : "pallet";
    }
    std::string operator()(const ProgramEnd& /*e*/) const { return "end"; }
    std::string operator()(const UnitsChange& e) const { return e.inch ? "inch" : "mm"; }
    std::string operator()(const WorkOffset& e) const {
        return fmt::format("offset {} {}", e.system, point(e.offset));
    }
};

std::string trimmed(std::string text) {
    text.erase(text.find_last_not_of(" \t\r") + 1);
    text.erase(0, text.find_first_not_of(" \t"));
    return text;
}

} // namespace

CaseFile readCase(const std::filesystem::path& file) {
    CaseFile result;
    result.options.assumeStartAtZero = true;
    result.options.lint = false;
    std::ifstream in(file);
    enum class Part { heading, program, steps } part = Part::heading;
    for (std::string line; std::getline(in, line);) {
        if (part == Part::heading && !line.starts_with("# "))
            part = Part::program;
        if (part == Part::heading) {
            const std::size_t colon = line.find(':');
            if (colon == std::string::npos)
                throw std::runtime_error("a heading without a colon: " + line);
            apply(result, line.substr(2, colon - 2), trimmed(line.substr(colon + 1)));
        } else if (part == Part::program && line == "=>") {
            part = Part::steps;
        } else if (part == Part::program) {
            result.program += line + "\n";
        } else if (!trimmed(line).empty()) {
            result.steps.push_back(trimmed(line));
        }
    }
    if (result.rule.empty() || part != Part::steps)
        throw std::runtime_error("needs a rule, a program and steps behind =>");
    return result;
}

std::vector<std::string> stepsOf(const Program& program) {
    std::vector<std::string> steps;
    std::size_t event = 0;
    for (std::size_t i = 0; i <= program.motionCount(); ++i) {
        for (; event < program.events().size() && program.events()[event].beforeMotion <= i; ++event)
            steps.push_back(fmt::format("{} {}", program.events()[event].line,
                                        std::visit(EventText{}, program.events()[event].data)));
        if (i < program.motionCount())
            steps.push_back(stepOf(program.motion(i)));
    }
    for (const Diagnostic& reported : program.diagnostics()) {
        if (reported.severity != Severity::note)
            steps.push_back(
                fmt::format("! {}:{} {}", reported.where.line, reported.where.column, reported.id));
    }
    return steps;
}

bool sameStep(const std::string& expected, const std::string& actual) {
    std::istringstream one(expected);
    std::istringstream two(actual);
    for (std::string a, b;;) {
        const bool more = static_cast<bool>(one >> a);
        if (more != static_cast<bool>(two >> b))
            return false;
        if (!more)
            return true;
        const std::size_t skip = a.starts_with("F") && b.starts_with("F") ? 1 : 0;
        char* endA = nullptr;
        char* endB = nullptr;
        const double x = std::strtod(a.c_str() + skip, &endA);
        const double y = std::strtod(b.c_str() + skip, &endB);
        const bool numbers = *endA == '\0' && *endB == '\0';
        const double tolerance = skip != 0 ? 1e-4 * std::abs(x) : kTolerance;
        if (numbers ? std::abs(x - y) > tolerance : a != b)
            return false;
    }
}

} // namespace proveout::test
