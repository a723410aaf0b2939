// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace proveout {

/// How a tool may be used, as its maker states it. Lengths in mm, angles in degrees; a limit of 0 is not
/// stated. Value type.
struct CuttingData {
    int teeth = 0;               ///< 0: unknown
    bool centreCutting = true;   ///< whether it may plunge into solid material
    double steepestRamp = 90;    ///< below level, on the way into solid material
    double pitch = 0;            ///< of the thread that a tap cuts; 0: unknown
    double mostDepth = 0;        ///< axial depth of cut
    double mostEngagement = 0;   ///< radial
    double mostChip = 0;         ///< thickness of a chip; needs the number of teeth
    double mostSpindle = 0;      ///< rpm
    double mostFeed = 0;         ///< mm/min, while cutting
    double mostSurfaceSpeed = 0; ///< m/min
    double mostRemoval = 0;      ///< cm³/min

    /// Whether a limit of the depth, the width or the chips of a cut is stated.
    [[nodiscard]] bool limitsCut() const {
        return mostDepth > 0 || mostEngagement > 0 || mostChip > 0 || mostRemoval > 0;
    }
    /// Whether the stated limits bound the load of the tool: that of the chips, of the volume, or both of
    /// depth and width.
    [[nodiscard]] bool limitsLoad() const {
        return mostChip > 0 || mostRemoval > 0 || (mostDepth > 0 && mostEngagement > 0);
    }
};

} // namespace proveout
