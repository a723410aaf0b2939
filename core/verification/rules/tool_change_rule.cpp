// SPDX-License-Identifier: GPL-3.0-or-later
// Where tools are changed, in machine coordinates.
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "core/cutter/gauge_length.h"
#include "core/verification/findings/rule_findings.h"
#include "core/verification/rules/rules.h"

namespace proveout {

namespace {

constexpr double kSamePosition = 0.01; ///< mm; less than what a position switch resolves

/// From program to machine coordinates; nothing for Z of a tool without a known length.
std::optional<double> machineShift(const CheckedRun& run, int tool, int axis) {
    const double zero = (*run.machine->programZero())[axis];
    if (axis != 2)
        return zero;
    const auto length = gaugeLength(run.setup.tools.find(run.tools.tool(tool)));
    return length ? std::optional(zero + *length) : std::nullopt;
}

/// A change in a position that is not known is not judged: that is where G28, G30 and G53 lead.
void judgeChange(const CheckedRun& run, const Event& change, std::size_t block, RuleFindings& out) {
    const Motion before = run.program.motion(change.beforeMotion - 1);
    for (int axis = 0; axis < 3; ++axis) {
        const std::optional<double> wanted = run.machine->toolChange(axis);
        const std::optional<double> shift = machineShift(run, before.tool, axis);
        if (!wanted || !shift || (before.endKnown & axisBit(axis)) == 0)
            continue;
        const double off = std::abs(before.end[axis] + *shift - *wanted);
        if (off > kSamePosition)
            out.addAtLine(change.line, rule_finding::kToolChangePosition, block, run.tools.tool(before.tool),
                          off, *wanted, std::string(1, letterOfAxis(axis)), before.end);
    }
}

} // namespace

void judgeToolChanges(const CheckedRun& run, const RuleLimits& /*limits*/, RuleFindings& out) {
    if (run.machine == nullptr || !run.machine->programZero())
        return;
    std::size_t block = 0; // of the last motion before the event
    for (const Event& event : run.program.events()) {
        const auto* change = std::get_if<ToolChange>(&event.data);
        if (change == nullptr || change->numberOnly || event.beforeMotion == 0)
            continue;
        while (run.program.blockMotions(block).last < event.beforeMotion)
            ++block;
        judgeChange(run, event, block, out);
    }
}

} // namespace proveout
