// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/breakpoint_list.h"

#include <algorithm>
#include <utility>

#include "ui/session/simulation_hub.h"

namespace proveout {

void BreakpointList::set(std::vector<Breakpoint> breakpoints) {
    if (breakpoints == m_breakpoints)
        return;
    m_breakpoints = std::move(breakpoints);
    m_simulation.post(BreakpointsCommand{m_breakpoints});
    emit changed();
}

void BreakpointList::add(const Breakpoint& added) {
    std::vector<Breakpoint> changed = m_breakpoints;
    const auto known = std::ranges::find_if(changed, [&added](Breakpoint each) {
        each.enabled = added.enabled;
        return each == added;
    });
    if (known == changed.end())
        changed.push_back(added);
    else
        known->enabled = true;
    set(std::move(changed));
}

void BreakpointList::toggle(std::uint32_t line) {
    std::vector<Breakpoint> changed = m_breakpoints;
    const auto removed = std::erase_if(changed, [line](const Breakpoint& breakpoint) {
        return breakpoint.kind == BreakpointKind::line && breakpoint.line == line;
    });
    if (removed == 0) {
        Breakpoint added;
        added.line = line;
        changed.push_back(added);
    }
    set(std::move(changed));
}

void BreakpointList::move(std::uint32_t line, bool fromItsStart, std::ptrdiff_t added) {
    const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(line) + (fromItsStart ? 0 : 1);
    const std::ptrdiff_t goneBefore = added < 0 ? from - added : from;
    std::vector<Breakpoint> moved;
    for (Breakpoint breakpoint : m_breakpoints) {
        const auto at = static_cast<std::ptrdiff_t>(breakpoint.line);
        if (breakpoint.kind == BreakpointKind::line && at >= from) {
            if (at < goneBefore)
                continue; // its line was deleted
            breakpoint.line = static_cast<std::uint32_t>(at + added);
        }
        moved.push_back(std::move(breakpoint));
    }
    set(std::move(moved));
}

void BreakpointList::post() {
    if (!m_breakpoints.empty())
        m_simulation.post(BreakpointsCommand{m_breakpoints});
}

} // namespace proveout
