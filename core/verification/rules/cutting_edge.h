// SPDX-License-Identifier: GPL-3.0-or-later
// The edge of a cutter at the top of a cut, and the chips that it makes there.
//
// With the feed per tooth fz = feed / (teeth * rpm), the diameter D of the cutter at the top of the cut and
// its radial engagement ae, the chip of a motion sideways is thickest where a tooth leaves or enters the
// material:
//     h = fz * sin(phi) * sin(kappa),  sin(phi) = 2 * sqrt(ae / D * (1 - ae / D)), or 1 from ae = D / 2 on,
// where kappa is the angle between the edge and the plane across the axis, 90 degrees for a cylinder. Thinner
// chips of small engagements (phi) and of round or slanted edges (kappa) are so taken into account. Straight
// down it is h = fz * cos(kappa), of the flattest part of the edge in the material.
#pragma once

#include "core/cutter/cutter.h"

namespace proveout {

/// The edge at one height. Value type.
struct CuttingEdge {
    double radius = 0;
    double sine = 1; ///< sin(kappa)
};

/// The edge of a cutter at a height above its tip, mm; above its profile it is a cylinder.
[[nodiscard]] CuttingEdge edgeAt(const Cutter& cutter, double height);

/// The thickness of the chips of a motion sideways, mm. `depth` and `engagement`: axial and radial, mm.
[[nodiscard]] double chipThickness(const Cutter& cutter, double feedPerTooth, double depth,
                                   double engagement);
/// The same of a motion straight down that cuts up to `depth` above the tip.
[[nodiscard]] double chipThicknessDown(const Cutter& cutter, double feedPerTooth, double depth);

/// m/min, at the top of a cut.
[[nodiscard]] double surfaceSpeed(const Cutter& cutter, double depth, double rpm);

} // namespace proveout
