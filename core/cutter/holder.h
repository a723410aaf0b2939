// SPDX-License-Identifier: GPL-3.0-or-later
// The holder of a tool, written as its segments from the face upwards: 40x30+60x40 (diameter x height), or
// 20-40x15 for a cone that is 20 mm wide at its lower and 40 mm at its upper end.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"

namespace proveout {

/// A cylinder or a cone, mm.
struct HolderSegment {
    double lowerRadius = 0;
    double upperRadius = 0;
    double height = 0;
};

inline constexpr std::size_t kMostHolderSegments = 16;
/// The limits of diameters and heights, mm.
inline constexpr double kLeastHolderSize = 0.001;
inline constexpr double kLargestHolderSize = 1000;

/// Reads the segments. Errors: one that is not written like this, a size beyond the limits, too many
/// segments.
[[nodiscard]] Result<std::vector<HolderSegment>> parseHolder(std::string_view text);

} // namespace proveout
