// SPDX-License-Identifier: GPL-3.0-or-later
// What all motion codes do alike: find the target, tell what is missing, append, arrive.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/nc/execution.h"

namespace proveout {

/// "X, Y": the axes of some AxisBits.
[[nodiscard]] std::string namesOfAxes(std::uint8_t axes);

/// Where the tip stands when the machine is to stand at `programmed`: elsewhere under cutter compensation.
[[nodiscard]] Vec3 tipAt(const Execution& execution, const Vec3& programmed);
/// The control asks its machine where the tip stands, and goes on from there.
void goOnFromTip(Execution& execution);

/// A motion that begins and ends where the machine stands.
[[nodiscard]] Motion motionFromHere(const Execution& execution, MotionKind kind);

/// Puts a tool length offset in force: the machine stands still, its tip is elsewhere afterwards.
void setToolOffset(Execution& execution, const Vec3& offset);

/// Puts a work offset into force by its number: 1 for G54.
void selectSystem(Execution& execution, int system);

/// Sends an axis to machine coordinate `value`; where nobody knows the machine's zero, to nobody knows where,
/// but Z 0 is the machine's reference position.
void setMachineTarget(Execution& execution, Motion& motion, int axis, double value);

/// The end point in X and Y that the polar words of the block give, from where `program` stands; `known`:
/// AxisBits of it. Nothing where there are none, or where they count from an unknown place, which is told.
[[nodiscard]] std::optional<Vec2> polarTarget(Execution& execution, const Vec3& program, std::uint8_t known);

/// A motion from where the machine stands to where the axis words of the block send it. An increment from an
/// unknown place is told.
[[nodiscard]] Motion motionToTarget(Execution& execution, MotionKind kind);

/// Whether both ends are known in the plane of the motion.
[[nodiscard]] bool planeKnown(const Motion& motion);

/// A motion code without axis words only selects the mode; where the place is known it also stands as a
/// motion of no length, as LinuxCNC lists it.
[[nodiscard]] bool onlySelectsMode(const Execution& execution);

/// Tells once that there is no feed rate.
void tellMissingFeed(Execution& execution, const Word& word);

/// Tells that the motion cuts nothing, once an axis until its place becomes known and is lost again.
void tellUnknownStart(Execution& execution, const Motion& motion, const Word& word);

/// The machine stands at the end of the motion, whether or not it was appended.
void arrive(MachineState& state, const Motion& motion);

/// A motion that is ordered and not made: its end is known all the same, and what follows starts there, into
/// cutter compensation where that is on.
void leaveOut(Execution& execution, const Motion& motion);

/// The feed of a motion by G93, which depends on its length.
void setInverseTimeFeed(const Execution& execution, Motion& motion);

/// Appends a motion as it is, from where the tip stands.
void appendMotion(Execution& execution, Motion motion);

/// The same for a motion that has its feed already, whatever the mode of the feed.
void appendWithFeed(Execution& execution, Motion motion);

/// Appends straight feeds to `ends`, the pieces of one curve of which `whole` has everything else; with
/// inverse time feed they take the time of F together. Ends with the block where there are too many motions.
void appendPieces(Execution& execution, const Motion& whole, const std::vector<Vec3>& ends);

/// Appends a motion that a block orders: the path beside it while cutter compensation is on. What is wrong
/// with that is told at `word`.
void appendOrdered(Execution& execution, const Word& word, const Motion& motion);

} // namespace proveout
