// SPDX-License-Identifier: GPL-3.0-or-later
// Haas's hole patterns, drilled by the canned cycle in force: G70, G71, G72.
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>
#include <string>

#include "core/nc/codes/handlers.h"
#include "core/nc/cycles/cycle_order.h"
#include "core/nc/cycles/cycle_run.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

constexpr int kMostHoles = 9999;
constexpr double kDegree = std::numbers::pi / 180;

/// The words that all patterns have.
struct Pattern {
    double length; ///< I: radius, or distance of the holes
    double angle;  ///< J: of the first hole, or of the line; radians
    int holes;     ///< L
};

/// Radians; without a decimal point in thousandths of a degree.
double angleOf(const Execution& execution, char letter) {
    const Word& word = execution.block.word(letter);
    return (word.point ? word.value : word.value * execution.dialect.leastMm) * kDegree;
}

std::optional<Pattern> readPattern(Execution& execution, const Word& word) {
    const Block& block = execution.block;
    for (const char letter : {'I', 'L'}) {
        if (block.has(letter))
            continue;
        execution.reporter.report(nc_message::kWordMissing, word,
                                  {fmt::format("G{:g}", word.value), std::string(1, letter)});
        return {};
    }
    const double holes = block.value('L');
    if (holes < 1 || holes > kMostHoles || holes != std::round(holes)) {
        execution.reporter.report(nc_message::kNotInteger, block.word('L'),
                                  {"L", "1", std::to_string(kMostHoles)});
        return {};
    }
    return Pattern{execution.length('I'), block.has('J') ? angleOf(execution, 'J') : 0,
                   static_cast<int>(holes)};
}

/// The origin of the pattern: the position of the tool. Nothing if there is no cycle to execute, or the
/// position is unknown.
std::optional<Vec2> beginOf(Execution& execution, const Word& word) {
    const MachineState& state = execution.state;
    const std::string name = fmt::format("G{:g}", word.value);
    if (!isCycle(state.motion) || !state.cycle.bottomGiven || !state.cycle.retractGiven) {
        execution.reporter.report(nc_message::kPatternWithoutCycle, word, {name});
        return {};
    }
    const PlaneAxes plane = axes(state.plane);
    for (const int axis : {plane.first, plane.second}) {
        if ((state.known >> static_cast<unsigned>(axis) & 1U) != 0)
            continue;
        execution.reporter.report(nc_message::kIncrementalUnknown, word, {name});
        return {};
    }
    const Vec3 at = state.frame.toProgram(state.position);
    return Vec2(at[plane.first], at[plane.second]);
}

Vec2 polar(double radius, double angle) {
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Drills holes at `placeOf(index)` relative to the origin of the pattern.
template<typename PlaceOf>
void drill(Execution& execution, const Word& word, const PlaceOf& placeOf) {
    const auto begin = beginOf(execution, word);
    const auto pattern = begin ? readPattern(execution, word) : std::nullopt;
    if (!pattern)
        return;
    const CannedCycle& cycle = cycleOf(execution.dialect.id, *execution.state.motion);
    const CycleOrder order = fanucOrderInForce(execution, cycle);
    CycleRun run(execution, word, cycle, order);
    if (!run.mayDrill(pattern->holes))
        return;
    for (int hole = 0; hole < pattern->holes && !execution.mustEnd(); ++hole)
        run.drillAt(*begin + placeOf(*pattern, hole));
}

} // namespace

void drillBoltCircle(Execution& execution, const Word& word) {
    drill(execution, word, [](const Pattern& pattern, int hole) {
        return polar(pattern.length, pattern.angle + 2 * std::numbers::pi * hole / pattern.holes);
    });
}

void drillBoltArc(Execution& execution, const Word& word) {
    if (!execution.block.has('K')) {
        execution.reporter.report(nc_message::kWordMissing, word, {"G71", "K"});
        return;
    }
    drill(execution, word, [step = angleOf(execution, 'K')](const Pattern& pattern, int hole) {
        return polar(pattern.length, pattern.angle + step * hole);
    });
}

void drillBoltLine(Execution& execution, const Word& word) {
    execution.reporter.report(nc_message::kBoltLineFirst, word);
    drill(execution, word,
          [](const Pattern& pattern, int hole) { return polar(pattern.length * hole, pattern.angle); });
}

} // namespace proveout
