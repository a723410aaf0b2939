// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/parameter_trace.h"

#include <algorithm>

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
    m_used.resize(rows, present);
    for (std::size_t row = first; row < std::min(executed, rows); ++row)
        m_used[row] = present;
}

std::vector<std::size_t> ParameterTrace::changes() const {
    std::vector<std::size_t> blocks;
    for (std::size_t row = 1; row < m_used.size(); ++row)
        if (m_used[row] != m_used[row - 1])
            blocks.push_back(row);
    return blocks;
}

} // namespace proveout
