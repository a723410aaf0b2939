// SPDX-License-Identifier: GPL-3.0-or-later
// The end of the pipeline for every motion: it is appended to the program, and the machine is at its end.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/nc/state/execution.h"

namespace proveout {

/// "X, Y": the names of the axes in AxisBits.
[[nodiscard]] std::string namesOfAxes(std::uint8_t axes);

/// The position of the tip when the machine is at `programmed`: it differs under cutter compensation.
[[nodiscard]] Vec3 tipAt(const Execution& execution, const Vec3& programmed);
/// The control reads the position of the tip from the machine, and continues from there.
void continueFromTip(Execution& execution);

/// Whether both ends are known in the plane of the motion.
[[nodiscard]] bool planeKnown(const Motion& motion);

/// A transformation about an unknown centre leads to unknown positions.
void forgetUnplaced(const Execution& execution, Motion& motion);

/// Sets the machine position to the end of the motion, whether or not it was appended.
void arrive(MachineState& state, const Motion& motion);

/// The next motion starts cutter compensation from the programmed path.
void restartCompensation(CutterCompensation& compensation);

/// A motion that is programmed but not executed: its end is known, and the following motion starts there,
/// with a lead-in if cutter compensation is on.
void skipMotion(Execution& execution, const Motion& motion);

/// The feed of a motion by G93, which depends on its length.
void setInverseTimeFeed(const Execution& execution, Motion& motion);

/// Appends a motion unchanged, from the position of the tip.
void appendMotion(Execution& execution, Motion motion);

/// The same for a motion that has its feed already, in any feed mode.
void appendWithFeed(Execution& execution, Motion motion);

/// Appends straight feeds to `ends`, the pieces of one curve; all other values come from `whole`. With
/// inverse time feed they take the time of F together. Ends with the block if there are too many motions.
void appendPieces(Execution& execution, const Motion& whole, const std::vector<Vec3>& ends);

} // namespace proveout
