// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/program_invariants.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>

namespace proveout::test {

namespace {

bool finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isLine(const NcText& text, std::uint32_t line) {
    return line >= 1 && line <= text.lineCount();
}

std::string brokenByDiagnostics(const NcText& text, const InterpretOptions& options, const Program& program) {
    // The limit applies to errors and to other messages separately, but the places that are reserved for
    // messages about the whole program exist only once.
    if (program.diagnostics().size() > 2 * options.maxDiagnostics - 3)
        return "more messages than asked for";
    bool unverified = false;
    for (std::size_t i = 0; i < program.diagnostics().size(); ++i) {
        const Diagnostic& reported = program.diagnostics()[i];
        if (reported.where.line < 1 || !isLine(text, static_cast<std::uint32_t>(reported.where.line)))
            return "a message is about no line of the text: " + oneLine(reported);
        const auto size = text.line(static_cast<std::size_t>(reported.where.line) - 1).size();
        if (reported.where.column < 1 || reported.where.length < 0 ||
            static_cast<std::size_t>(reported.where.column + reported.where.length) > size + 2)
            return "a message is about a place outside of its line: " + oneLine(reported);
        const std::string_view sentence = reported.text;
        if (static_cast<std::size_t>(std::ranges::count(sentence, '{')) > reported.arguments.size())
            return "a message lacks an argument: " + oneLine(reported);
        if (program.motionAfterDiagnostic(i) > program.motionCount())
            return "a message stands behind the last motion: " + oneLine(reported);
        unverified = unverified || reported.unverified;
    }
    return unverified && !program.unverified() ? "a message is unverified and the program is not" : "";
}

std::string brokenByArc(const Motion& motion) {
    const double radius = arcRadius(motion);
    if (!(radius > 0)) // R may also specify a thousandth of a millimetre
        return "an arc has no radius";
    if (motion.sweep == 0)
        return "an arc leads nowhere";
    // The sweep ends at the end point: the limit of pointAt() must be its value there.
    const double allowed = 1e-6 + radius * 1e-9 + pathLength(motion) * 2e-12;
    return glm::length(pointAt(motion, 1 - 1e-12) - motion.end) < allowed
               ? ""
               : "the sweep of an arc does not lead to its end";
}

std::string brokenByMotion(const Motion& motion) {
    if (!finite(motion.start) || !finite(motion.end) || !finite(motion.centre) ||
        !std::isfinite(motion.sweep))
        return "a motion leads to no finite place";
    if (!std::isfinite(motion.feedMmPerMin) || !std::isfinite(motion.spindleRpm) || motion.feedMmPerMin < 0)
        return "a motion has no finite feed or speed";
    if (!withinLimits(motion))
        return "a motion is beyond the limits";
    if (!std::isfinite(pathLength(motion)) || !finite(pointAt(motion, 0.3)))
        return "a motion has no finite path";
    const Box3 box = bounds(motion);
    if (!finite(box.lo) || !finite(box.hi))
        return "a motion has no finite box";
    if (pointAt(motion, 1) != motion.end)
        return "a motion does not lead to its end";
    return motion.kind == MotionKind::arc ? brokenByArc(motion) : "";
}

/// The known start of a motion must be the end of the previous one.
bool follows(const Motion& before, const Motion& motion) {
    for (int axis = 0; axis < 3; ++axis) {
        const bool known = ((before.endKnown & motion.startKnown) >> axis & 1) != 0;
        if (known && before.end[axis] != motion.start[axis])
            return false;
    }
    return true;
}

std::string brokenByMotions(const NcText& text, const Program& program) {
    auto event = program.events().begin();
    for (std::size_t i = 0; i < program.motionCount(); ++i) {
        // Another tool length moves the tip, and after an error a motion may be missing.
        bool moved = program.motion(i).unverified;
        for (; event != program.events().end() && event->beforeMotion <= i; ++event)
            moved = moved || !std::holds_alternative<Dwell>(event->data);
        const Motion motion = program.motion(i);
        std::string broken = brokenByMotion(motion);
        if (broken.empty() && !isLine(text, motion.line))
            broken = "a motion stands on no line of the text";
        if (broken.empty() && i > 0 && !moved && !follows(program.motion(i - 1), motion))
            broken = "a motion does not begin where the one before it ended";
        if (broken.empty() && !finite(program.programmedEnd(i)))
            broken = "a motion has no programmed end";
        if (broken.empty() && motion.kind != MotionKind::rapid && !program.unverified() &&
            (motion.startKnown & motion.endKnown) != kAllAxes)
            broken = "a cut comes from or goes to an unknown place, and the program is not unverified";
        if (!broken.empty())
            return broken + " (motion " + std::to_string(i) + ", line " + std::to_string(motion.line) + ")";
    }
    return "";
}

std::string brokenByBlocks(const NcText& text, const Program& program) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < program.blockCount(); ++i) {
        const auto [first, last] = program.blockMotions(i);
        if (first != next || last <= first)
            return "the motions of block " + std::to_string(i) + " do not follow those of the one before";
        if (!isLine(text, program.blockLine(i)))
            return "block " + std::to_string(i) + " stands on no line of the text";
        next = last;
    }
    if (next != program.motionCount())
        return "a motion belongs to no block";
    std::size_t passed = 0;
    for (std::uint32_t line = 0; line <= text.lineCount(); ++line) {
        const std::size_t before = program.blocksBeforeLine(line);
        const std::size_t after = program.blocksAfterLine(line);
        if (before > after || after > program.blockCount())
            return "the blocks of line " + std::to_string(line) + " are not those of the program";
        if (program.runsAgain())
            continue;
        const std::size_t passedBefore = passed;
        while (passed < program.blockCount() && program.blockLine(passed) <= line)
            ++passed;
        // A call that no line follows, as when the limit of motions stops a subprogram, lasts to the end.
        if (before != passedBefore || (after != passed && after != program.blockCount()))
            return "the blocks before or after line " + std::to_string(line) + " are others";
    }
    return program.firstDifference(program) == program.blockCount() ? "" : "a program differs from itself";
}

std::string brokenByTools(const Program& program) {
    std::size_t next = 0;
    int tool = -1;
    for (const Program::ToolRun& run : program.toolRuns()) {
        if (run.first != next || run.last <= run.first || run.tool == tool)
            return "the runs of tools do not follow each other";
        next = run.last;
        tool = run.tool;
    }
    return next == program.motionCount() ? "" : "a motion belongs to no run of a tool";
}

std::string brokenByEvents(const NcText& text, const Program& program) {
    std::uint32_t before = 0;
    for (const Event& event : program.events()) {
        if (event.beforeMotion < before || event.beforeMotion > program.motionCount())
            return "an event stands at no place among the motions";
        if (!isLine(text, event.line))
            return "an event stands on no line of the text";
        before = event.beforeMotion;
    }
    return "";
}

} // namespace

std::string brokenPromise(const NcText& text, const InterpretOptions& options, const Program& program) {
    for (const std::string& broken :
         {brokenByDiagnostics(text, options, program), brokenByMotions(text, program),
          brokenByBlocks(text, program), brokenByTools(program), brokenByEvents(text, program)}) {
        if (!broken.empty())
            return broken;
    }
    return "";
}

} // namespace proveout::test
