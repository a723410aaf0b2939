// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/decimation/regions/parameters.h"
#include "core/decimation/regions/region_grid.h"

namespace proveout {

/// The polyline with the fewest vertices whose vertices are samples and from which no sample is farther than
/// `allowance` (mm) vertically; of several, the one with the smallest sum of squared distances. Pure function
/// of its arguments: both regions at a border get the same result. The border is on a line of the canonical
/// mesh, so this bounds the distance between the samples too. `kept` (ascending) are kept as well; the
/// polyline has the fewest vertices among those that contain them.
///
/// The fewest vertices are a shortest path over the chords that stay within the allowance (H. Imai and M.
/// Iri, "Polygonal approximations of a curve"); the chords from one sample are found in one pass, by the cone
/// through the tolerance intervals of the samples passed.
[[nodiscard]] BorderLine certifiedBorder(std::span<const float> heights, double allowance,
                                         std::span<const std::uint32_t> kept = {});

/// The share of the allowance that a border may use. If it uses all of it, triangles beside it cannot keep
/// the surface within the allowance and request points of the border one by one, each of which causes a
/// second decimation of both regions: at the surface level, 0.7 costs 0–4 % more faces than the whole
/// allowance, and saves up to a third of the time.
[[nodiscard]] constexpr double borderAllowance(const DecimationParameters& parameters) {
    return parameters.level == ErrorLevel::surface ? 0.7 * parameters.allowance : parameters.allowance;
}

} // namespace proveout
