// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/decimation/regions/region_grid.h"

namespace proveout {

/// How far each region may be from the z-map when a view tolerates more in one region than in another.
/// Allowances are the smallest one times powers of two, and change with hysteresis: an allowance becomes
/// finer as soon as the view requires it, coarser only when the view tolerates kSlack times more than that
/// step needs. Value type.
class RegionAllowances {
public:
    static constexpr double kSlack = 1.25;
    static constexpr int kMostSteps = 10;

    RegionAllowances() = default;
    /// `smallest`, mm, for all regions.
    RegionAllowances(const RegionGrid& grid, double smallest);

    [[nodiscard]] double region(std::size_t region) const;
    /// For the polyline of a border: the smaller one of its regions', so that it serves both.
    [[nodiscard]] double border(std::size_t border) const;

    /// `wanted`: what the view tolerates, mm, per region; less than the smallest allowance counts as that.
    /// Returns the regions, ascending, whose mesh or borders had another allowance before.
    std::vector<std::size_t> follow(std::span<const double> wanted);

private:
    [[nodiscard]] std::uint8_t stepFor(std::size_t region, double wanted) const;
    [[nodiscard]] std::uint8_t borderStep(std::size_t border, std::span<const std::uint8_t> steps) const;

    RegionGrid m_grid;
    double m_smallest = 0;
    std::vector<std::uint8_t> m_steps; ///< per region; empty: 0 everywhere
};

} // namespace proveout
