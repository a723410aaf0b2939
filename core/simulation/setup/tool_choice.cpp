// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/tool_choice.h"

#include <algorithm>
#include <set>

namespace proveout {

namespace {

bool isToolChange(const Event& event) {
    return std::holds_alternative<ToolChange>(event.data);
}

bool cutsBefore(const Program& program, std::size_t end) {
    for (std::size_t index = 0; index < end; ++index) {
        if (program.motion(index).kind != MotionKind::rapid)
            return true;
    }
    return false;
}

/// The first motion of the run that lacks a cutter; nothing if none of its motions needs one.
std::optional<std::size_t> firstMiss(const Program& program, const Program::ToolRun& run) {
    for (std::size_t index = run.first; index < run.last; ++index) {
        if (run.tool != 0 || program.motion(index).kind != MotionKind::rapid)
            return index;
    }
    return {};
}

/// `toolOf(number)`: the tool of a motion that names tool `number`.
template<class ToolOf>
std::vector<UnconfirmedTool> unconfirmedTools(const Program& program, const ToolTable& tools,
                                              ToolOf&& toolOf) {
    std::vector<UnconfirmedTool> unconfirmed;
    std::set<int> listed;
    for (const Program::ToolRun& run : program.toolRuns()) {
        const int number = toolOf(run.tool);
        const ToolOrigin* origin = tools.unconfirmedOrigin(number);
        if (origin != nullptr && listed.insert(number).second)
            unconfirmed.push_back(
                {number, program.motion(run.first).line, tools.find(number)->spec(), *origin});
    }
    return unconfirmed;
}

} // namespace

std::size_t firstMotionWithCalledTool(const Program& program) {
    const auto change = std::ranges::find_if(program.events(), isToolChange);
    return change == program.events().end() ? program.motionCount() : change->beforeMotion;
}

bool callsTool(const Program& program) {
    return std::ranges::any_of(program.events(), isToolChange);
}

std::optional<int> assumedTool(const Program& program, const ToolTable& table) {
    const auto& tools = table.tools();
    if (tools.size() == 1 && !callsTool(program))
        return tools.begin()->first;
    if (tools.contains(0) && cutsBefore(program, firstMotionWithCalledTool(program)))
        return 0;
    return {};
}

std::optional<int> assumedTool(const Program& program, const Setup& setup) {
    return setup.startTool ? std::nullopt : assumedTool(program, setup.tools);
}

ToolChoice::ToolChoice(const Program& program, const Setup& setup)
    : m_assumed(assumedTool(program, setup)), m_callsTool(proveout::callsTool(program)) {
    const std::size_t firstCalled = firstMotionWithCalledTool(program);
    std::set<int> reported;
    for (const Program::ToolRun& run : program.toolRuns()) {
        const int number = tool(run.tool);
        if (setup.tools.find(number) != nullptr || reported.contains(number))
            continue;
        if (const auto index = firstMiss(program, run)) {
            m_missing.push_back({number, program.motion(*index).line, *index >= firstCalled});
            reported.insert(number);
        }
    }
    m_unconfirmed = unconfirmedTools(program, setup.tools, [this](int number) { return tool(number); });
}

} // namespace proveout
