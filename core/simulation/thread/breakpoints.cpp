// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/thread/breakpoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>
#include <variant>

#include "core/base/figures_argument.h"
#include "core/base/text.h"

namespace proveout {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

bool reachesLine(const ArmedBreakpoint& armed, const Program& program, std::size_t block) {
    return armed.insteadOfLine == block || program.blockLine(block) == armed.breakpoint.line;
}

/// Whether an event of some kind happens right before a block, or within it.
template<class Matches>
bool comesBehind(const Program& program, std::size_t block, Matches matches) {
    const auto motions = program.blockMotions(block);
    const auto& events = program.events();
    auto event = std::ranges::lower_bound(events, motions.first, {}, &Event::beforeMotion);
    for (; event != events.end() && event->beforeMotion < motions.last; ++event) {
        if (matches(event->data))
            return true;
    }
    return false;
}

bool followsToolChange(const ArmedBreakpoint& /*armed*/, const Program& program, std::size_t block) {
    return comesBehind(program, block,
                       [](const EventData& data) { return std::holds_alternative<ToolChange>(data); });
}

bool followsStop(const ArmedBreakpoint& /*armed*/, const Program& program, std::size_t block) {
    return comesBehind(program, block,
                       [](const EventData& data) { return std::holds_alternative<ProgramStop>(data); });
}

bool goesBelow(const ArmedBreakpoint& armed, const Program& program, std::size_t block) {
    const auto motions = program.blockMotions(block);
    for (std::size_t index = motions.first; index < motions.last; ++index) {
        const Motion motion = program.motion(index);
        if ((motion.endKnown & kAxisZ) == 0)
            continue;
        const double z = armed.breakpoint.z;
        const bool arc = motion.kind == MotionKind::arc && motion.known();
        const bool below = arc ? bounds(motion).lo.z < z : motion.end.z < z;
        if (below && !((motion.startKnown & kAxisZ) != 0 && motion.start.z < z))
            return true;
    }
    return false;
}

ConditionValues valuesOf(const Motion& motion, int tool, std::size_t block, std::uint32_t line) {
    const auto axis = [&](int index, AxisBits bit) {
        return (motion.endKnown & bit) != 0 ? motion.end[index] : kUnknown;
    };
    return {axis(0, kAxisX),
            axis(1, kAxisY),
            axis(2, kAxisZ),
            motion.feedMmPerMin,
            std::abs(motion.spindleRpm),
            static_cast<double>(tool),
            static_cast<double>(block + 1),
            static_cast<double>(line)};
}

bool beginsToHold(const ArmedBreakpoint& armed, const Program& program, std::size_t block) {
    const auto holdsAt = [&](std::size_t motion, std::size_t ofBlock) {
        const Motion at = program.motion(motion);
        const int tool = at.tool == 0 ? armed.toolOfNone : at.tool;
        return armed.condition.holds(valuesOf(at, tool, ofBlock, program.blockLine(ofBlock)));
    };
    const auto motions = program.blockMotions(block);
    bool held = block > 0 && holdsAt(motions.first - 1, block - 1);
    for (std::size_t index = motions.first; index < motions.last; ++index) {
        const bool holds = holdsAt(index, block);
        if (holds && !held)
            return true;
        held = holds;
    }
    return false;
}

int toolOf(const Program& program, std::size_t block) {
    return program.motion(program.blockMotions(block).first).tool;
}

/// Searches back to the previous block that cut: rows between two cuts are read only once.
bool touchesFirst(const Program& program, std::size_t block, const ExecutedBlocks& executed) {
    const auto removes = [&](std::size_t index) { return executed.rows[index].cuts(); };
    if (block >= executed.rows.size() || !removes(block))
        return false;
    const int tool = toolOf(program, block);
    for (std::size_t before = block; before-- > 0 && toolOf(program, before) == tool;) {
        if (removes(before))
            return false;
    }
    return true;
}

bool wasFound(const Program& /*program*/, std::size_t /*block*/, const ExecutedBlocks& executed) {
    return executed.somethingFound;
}

const std::array<BreakpointRow, 7> kRows{{
    {BreakpointKind::line, "line", PROVEOUT_TEXT("Core", "Line"),
     PROVEOUT_TEXT("Core", "Stop before a line of the program."),
     PROVEOUT_TEXT("Core", "Stopped before line {}."), BreakpointValue::line, reachesLine},
    {BreakpointKind::toolChange, "toolChange", PROVEOUT_TEXT("Core", "Tool change"),
     PROVEOUT_TEXT("Core", "Stop at each tool change."), PROVEOUT_TEXT("Core", "Stopped at a tool change."),
     BreakpointValue::none, followsToolChange},
    {BreakpointKind::programStop, "programStop", PROVEOUT_TEXT("Core", "M0 or M1"),
     PROVEOUT_TEXT("Core", "Stop at M0, M1 or M60."), PROVEOUT_TEXT("Core", "Program stop (M0, M1 or M60)."),
     BreakpointValue::none, followsStop},
    {BreakpointKind::zBelow, "zBelow", PROVEOUT_TEXT("Core", "Z below"),
     PROVEOUT_TEXT("Core", "Stop before a block that goes below a height."),
     PROVEOUT_TEXT("Core", "Stopped before going below Z {}."), BreakpointValue::height, goesBelow},
    {BreakpointKind::firstContact, "firstContact", PROVEOUT_TEXT("Core", "First contact"),
     PROVEOUT_TEXT("Core", "Stop after the first block of each tool that removes material."),
     PROVEOUT_TEXT("Core", "Stopped after the first contact of the tool."), BreakpointValue::none, nullptr,
     touchesFirst},
    {BreakpointKind::fault, "fault", PROVEOUT_TEXT("Core", "On finding"),
     PROVEOUT_TEXT("Core", "Stop after a block with a finding."),
     PROVEOUT_TEXT("Core", "Stopped after a block with a finding."), BreakpointValue::none, nullptr,
     wasFound},
    {BreakpointKind::condition, "condition", PROVEOUT_TEXT("Core", "Condition"),
     PROVEOUT_TEXT("Core", "Stop before a block where a condition becomes true."),
     PROVEOUT_TEXT("Core", "Breakpoint: {}."), BreakpointValue::condition, beginsToHold},
}};

} // namespace

std::span<const BreakpointRow> breakpointRows() {
    return kRows;
}

const BreakpointRow& rowOf(BreakpointKind kind) {
    return kRows[static_cast<std::size_t>(kind)];
}

Argument valueText(const Breakpoint& breakpoint) {
    switch (rowOf(breakpoint.kind).value) {
    case BreakpointValue::line:
        return std::to_string(breakpoint.line);
    case BreakpointValue::height:
        return figures("{}", breakpoint.z);
    case BreakpointValue::condition:
        return breakpoint.condition;
    case BreakpointValue::none:
        break;
    }
    return "";
}

void Breakpoints::set(const std::vector<Breakpoint>& breakpoints, const Program& program,
                      const ToolChoice& tools) {
    m_armed.clear();
    for (const Breakpoint& breakpoint : breakpoints) {
        if (!breakpoint.enabled || m_armed.size() == kMost)
            continue;
        ArmedBreakpoint armed{breakpoint, {}, std::nullopt, 0};
        if (breakpoint.kind == BreakpointKind::condition) {
            auto condition = Condition::parse(breakpoint.condition);
            if (!condition)
                continue;
            armed.condition = std::move(*condition);
        }
        m_armed.push_back(std::move(armed));
    }
    follow(program, tools);
}

void Breakpoints::follow(const Program& program, const ToolChoice& tools) {
    for (ArmedBreakpoint& armed : m_armed) {
        armed.toolOfNone = tools.tool(0);
        armed.insteadOfLine.reset();
        if (armed.breakpoint.kind != BreakpointKind::line)
            continue;
        const std::size_t block = program.blocksBeforeLine(armed.breakpoint.line);
        if (block == program.blockCount() || program.blockLine(block) != armed.breakpoint.line)
            armed.insteadOfLine = block;
    }
}

const Breakpoint* Breakpoints::before(const Program& program, std::size_t block) const {
    for (const ArmedBreakpoint& armed : m_armed) {
        const BreakpointRow& row = rowOf(armed.breakpoint.kind);
        if (row.before != nullptr && row.before(armed, program, block))
            return &armed.breakpoint;
    }
    return nullptr;
}

const Breakpoint* Breakpoints::after(const Program& program, std::size_t block,
                                     const ExecutedBlocks& executed) const {
    for (const ArmedBreakpoint& armed : m_armed) {
        const BreakpointRow& row = rowOf(armed.breakpoint.kind);
        if (row.after != nullptr && row.after(program, block, executed))
            return &armed.breakpoint;
    }
    return nullptr;
}

} // namespace proveout
