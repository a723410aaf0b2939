// SPDX-License-Identifier: GPL-3.0-or-later
// Where every motion ends up: it is appended to the program, and the machine stands at its end.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/nc/state/execution.h"

namespace proveout {

/// "X, Y": the axes of some AxisBits.
[[nodiscard]] std::string namesOfAxes(std::uint8_t axes);

/// Where the tip stands when the machine is to stand at `programmed`: elsewhere under cutter compensation.
[[nodiscard]] Vec3 tipAt(const Execution& execution, const Vec3& programmed);
/// The control asks its machine where the tip stands, and goes on from there.
void continueFromTip(Execution& execution);

/// Whether both ends are known in the plane of the motion.
[[nodiscard]] bool planeKnown(const Motion& motion);

/// A transformation about an unknown centre leads to unknown places.
void forgetUnplaced(const Execution& execution, Motion& motion);

/// The machine stands at the end of the motion, whether or not it was appended.
void arrive(MachineState& state, const Motion& motion);

/// What follows begins cutter compensation from the programmed path.
void restartCompensation(CutterCompensation& compensation);

/// A motion that is ordered and not made: its end is known all the same, and what follows starts there, into
/// cutter compensation where that is on.
void skipMotion(Execution& execution, const Motion& motion);

/// The feed of a motion by G93, which depends on its length.
void setInverseTimeFeed(const Execution& execution, Motion& motion);

/// Appends a motion as it is, from where the tip stands.
void appendMotion(Execution& execution, Motion motion);

/// The same for a motion that has its feed already, whatever the mode of the feed.
void appendWithFeed(Execution& execution, Motion motion);

/// Appends straight feeds to `ends`, the pieces of one curve of which `whole` has everything else; with
/// inverse time feed they take the time of F together. Ends with the block where there are too many motions.
void appendPieces(Execution& execution, const Motion& whole, const std::vector<Vec3>& ends);

} // namespace proveout
