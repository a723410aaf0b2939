// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/base/geometry.h"
#include "core/nc/geometry/compensation.h"

namespace proveout {

/// What compensation by vectors knows besides.
struct VectorState {
    PlanePath programmed;  ///< of the motion whose end may still move
    double offset = 0;     ///< with which that motion was begun
    bool cornered = false; ///< more than one point leads to it
    bool seen = false;     ///< the motion is of the block that is executed now
    int blocksWithout = 0; ///< since then, without a motion in the plane
    Vec2 exit{0};          ///< the way that I, J, K of G40 tell
};

/// The state of cutter compensation. A motion stands in the program as soon as it is ordered, with the end
/// square beside its programmed end; that end moves when an inside corner follows. A value.
struct CutterCompensation {
    bool on = false;
    double side = 0;      ///< as the code says: 1 left, -1 right
    double offset = 0;    ///< the tool's radius in mm, positive where it goes on the left of the path
    bool assumed = false; ///< that radius
    bool entered = false; ///< the motion into compensation is done

    bool held = false;         ///< whether the end of the last motion in the plane may still move
    bool entry = false;        ///< whether that is the motion into compensation
    std::size_t firstHeld = 0; ///< its number; motions after it lead nowhere in the plane
    PlanePath path;            ///< of it, as if no other motion were there
    Vec2 from{0};              ///< where it begins
    Vec2 heading{0};           ///< of the programmed path at its end
    Vec3 displacement{0};      ///< from the programmed position to where the tip stands
    bool unknownReported = false;
    VectorState vectors; ///< of Fanuc's dialect

    [[nodiscard]] bool moves() const { return on && offset != 0; }
    /// On the way from the compensated to the programmed path.
    [[nodiscard]] bool leaving() const { return !entered && displacement != Vec3(0); }
};

} // namespace proveout
