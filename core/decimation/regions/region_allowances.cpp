// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/regions/region_allowances.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace proveout {

RegionAllowances::RegionAllowances(const RegionGrid& grid, double smallest)
    : m_grid(grid), m_smallest(smallest) {}

double RegionAllowances::region(std::size_t region) const {
    return m_steps.empty() ? m_smallest : std::ldexp(m_smallest, m_steps[region]);
}

double RegionAllowances::border(std::size_t border) const {
    return m_steps.empty() ? m_smallest : std::ldexp(m_smallest, borderStep(border, m_steps));
}

std::uint8_t RegionAllowances::borderStep(std::size_t border, std::span<const std::uint8_t> steps) const {
    const auto [a, b] = m_grid.sharers(border);
    return b == RegionGrid::kNoRegion ? steps[a] : std::min(steps[a], steps[b]);
}

std::uint8_t RegionAllowances::stepFor(std::size_t region, double wanted) const {
    int step = m_steps.empty() ? 0 : m_steps[region];
    while (step > 0 && std::ldexp(m_smallest, step) > wanted)
        --step;
    while (step < kMostSteps && std::ldexp(m_smallest, step + 1) * kSlack <= wanted)
        ++step;
    return static_cast<std::uint8_t>(step);
}

std::vector<std::size_t> RegionAllowances::follow(std::span<const double> wanted) {
    assert(wanted.size() == m_grid.regionCount());
    std::vector<std::uint8_t> before = m_steps;
    before.resize(wanted.size());
    std::vector<std::uint8_t> steps(wanted.size());
    for (std::size_t region = 0; region < wanted.size(); ++region)
        steps[region] = stepFor(region, wanted[region]);

    std::vector<std::size_t> outdated;
    for (std::size_t region = 0; region < wanted.size(); ++region) {
        const auto borders = m_grid.borders(region);
        const bool changed = steps[region] != before[region] ||
                             std::any_of(borders.begin(), borders.end(), [&](std::size_t border) {
                                 return borderStep(border, steps) != borderStep(border, before);
                             });
        if (changed)
            outdated.push_back(region);
    }
    m_steps = std::move(steps);
    return outdated;
}

} // namespace proveout
