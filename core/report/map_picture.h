// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a stock from above, without a graphics driver.
#pragma once

#include "core/base/geometry.h"
#include "core/part/deviation.h"
#include "core/report/png.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The longest side of a picture, px; a map with fewer points has a pixel for each.
inline constexpr int kPictureSide = 1200;

/// The colour of a deviation without the allowance: vermilion where material is missing, blue where it is
/// left, of Okabe and Ito, which are distinguishable with every common colour blindness; grey in tolerance.
[[nodiscard]] Rgb deviationColour(double off, const PartTolerance& tolerance);

/// The stock, lit from the upper left; the picture covers the whole map.
[[nodiscard]] Picture stockPicture(const ZMapSnapshot& stock);

enum class Shading : std::uint8_t { none, lit };

/// The same in the colours of its deviations, lit or as a texture for something that is lit later. A pixel
/// for several points has the colour of the worst of them; steep faces count as well.
[[nodiscard]] Picture deviationPicture(const Deviation& deviation, const PartTolerance& tolerance,
                                       Shading shading);

} // namespace proveout
