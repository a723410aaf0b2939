// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/base/geometry.h"
#include "core/nc/geometry/compensation.h"

namespace proveout {

/// Further state of compensation by vectors.
struct VectorState {
    PlanePath programmed;  ///< of the motion whose end may still move
    double offset = 0;     ///< with which that motion began
    bool cornered = false; ///< more than one point leads to it
    bool seen = false;     ///< the motion belongs to the current block
    int blocksWithout = 0; ///< number of blocks since then without a motion in the plane
    Vec2 exit{0};          ///< the direction that I, J, K of G40 give
};

/// The state of cutter compensation. A motion is added to the program as soon as it is programmed, with its
/// end at a right angle beside its programmed end; that end moves when an inside corner follows. A value.
struct CutterCompensation {
    bool on = false;
    double side = 0;      ///< given by the code: 1 left, -1 right
    double offset = 0;    ///< the tool's radius in mm, positive if the tool is to the left of the path
    bool assumed = false; ///< whether that radius is assumed
    bool entered = false; ///< the lead-in motion has been made

    bool held = false;         ///< whether the end of the last motion in the plane may still move
    bool entry = false;        ///< whether that is the lead-in motion
    std::size_t firstHeld = 0; ///< its number; motions after it do not move in the plane
    PlanePath path;            ///< its path, ignoring other motions
    Vec2 from{0};              ///< start of that path
    Vec2 heading{0};           ///< of the programmed path at its end
    Vec3 displacement{0};      ///< from the programmed position to the position of the tip
    bool unknownReported = false;
    VectorState vectors; ///< of Fanuc's dialect

    [[nodiscard]] bool moves() const { return on && offset != 0; }
    /// Whether it is returning from the compensated to the programmed path.
    [[nodiscard]] bool leaving() const { return !entered && displacement != Vec3(0); }
};

} // namespace proveout
