// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/tool_choice.h"

#include <algorithm>
#include <set>

namespace proveout {

namespace {

/// The first motion of the run that misses a cutter; none where all its motions do without.
std::optional<std::uint32_t> firstMiss(const Program& program, const Program::ToolRun& run) {
    for (std::size_t index = run.first; index < run.last; ++index) {
        const Motion motion = program.motion(index);
        if (run.tool != 0 || motion.kind != MotionKind::rapid)
            return motion.line;
    }
    return {};
}

} // namespace

std::optional<int> assumedTool(const Program& program, const ToolTable& tools) {
    const bool changesTools = std::ranges::any_of(
        program.events(), [](const Event& event) { return std::holds_alternative<ToolChange>(event.data); });
    if (changesTools || tools.tools().size() != 1)
        return {};
    return tools.tools().begin()->first;
}

ToolChoice::ToolChoice(const Program& program, const ToolTable& tools)
    : m_assumed(assumedTool(program, tools)) {
    std::set<int> told;
    for (const Program::ToolRun& run : program.toolRuns()) {
        const int number = tool(run.tool);
        if (tools.find(number) != nullptr || told.contains(number))
            continue;
        if (const auto line = firstMiss(program, run)) {
            m_missing.push_back({number, *line});
            told.insert(number);
        }
    }
}

} // namespace proveout
