// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/parameter_trace.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace proveout {

std::uint32_t ParameterTrace::numberOf(const DecimationParameters& parameters) {
    // Searched from the newest, which is nearly always the right one.
    const auto found = std::find(m_seen.rbegin(), m_seen.rend(), parameters);
    if (found != m_seen.rend())
        return static_cast<std::uint32_t>(m_seen.rend() - found - 1);
    m_seen.push_back(parameters);
    return static_cast<std::uint32_t>(m_seen.size() - 1);
}

void ParameterTrace::update(const DecimationParameters& parameters, std::size_t first, std::size_t executed,
                            std::size_t rows) {
    if (rows == 0)
        m_seen.clear();
    const std::uint32_t present = numberOf(parameters);
    resize(rows, present);
    assign(first, std::min(executed, rows), present);
}

void ParameterTrace::resize(std::size_t rows, std::uint32_t added) {
    m_runs.erase(m_runs.lower_bound(rows), m_runs.end());
    const std::size_t before = std::exchange(m_rows, rows);
    assign(before, rows, added);
}

void ParameterTrace::assign(std::size_t first, std::size_t end, std::uint32_t used) {
    if (first >= end)
        return;
    const auto after = m_runs.upper_bound(end);
    if (end < m_rows && after != m_runs.begin())
        m_runs.emplace(end, std::prev(after)->second); // unless a run begins there
    auto next = m_runs.erase(m_runs.lower_bound(first), m_runs.lower_bound(end));
    if (next != m_runs.end() && next->second == used)
        next = m_runs.erase(next);
    if (next == m_runs.begin() || std::prev(next)->second != used)
        m_runs.emplace(first, used);
}

std::vector<std::size_t> ParameterTrace::changes() const {
    std::vector<std::size_t> blocks;
    for (auto run = m_runs.begin(); run != m_runs.end(); ++run)
        if (run != m_runs.begin() && std::prev(run)->second != run->second)
            blocks.push_back(run->first);
    return blocks;
}

} // namespace proveout
