// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/tool_choice.h"

#include <algorithm>

namespace proveout {

ToolChoice::ToolChoice(const Program& program, const ToolTable& tools) {
    const bool changesTools = std::ranges::any_of(
        program.events(), [](const Event& event) { return std::holds_alternative<ToolChange>(event.data); });
    if (!changesTools && tools.tools().size() == 1)
        m_assumed = tools.tools().begin()->first;
}

} // namespace proveout
