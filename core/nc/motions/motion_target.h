// SPDX-License-Identifier: GPL-3.0-or-later
// From the words of a block to a motion: where the machine stands, where it is sent, and what is missing.
#pragma once

#include <cstdint>
#include <optional>

#include "core/nc/state/execution.h"

namespace proveout {

/// A motion that begins and ends where the machine stands.
[[nodiscard]] Motion motionFromHere(const Execution& execution, MotionKind kind);

/// Sends an axis to machine coordinate `value`; where nobody knows the machine's zero, to nobody knows where,
/// but Z 0 is the machine's reference position.
void setMachineTarget(Execution& execution, Motion& motion, int axis, double value);

/// The end point in X and Y that the polar words of the block give, from where `program` stands; `known`:
/// AxisBits of it. Nothing where there are none, or where they count from an unknown place, which is told.
[[nodiscard]] std::optional<Vec2> polarTarget(Execution& execution, const Vec3& program, std::uint8_t known);

/// A motion from where the machine stands to where the axis words of the block send it. An increment from an
/// unknown place is told.
[[nodiscard]] Motion motionToTarget(Execution& execution, MotionKind kind);

/// A motion code without axis words only selects the mode; where the place is known it also stands as a
/// motion of no length, as LinuxCNC lists it.
[[nodiscard]] bool onlySelectsMode(const Execution& execution);

/// Tells once that there is no feed rate.
void reportMissingFeed(Execution& execution, const Word& word);

/// Tells that the motion cuts nothing, once an axis until its place becomes known and is lost again.
void reportUnknownStart(Execution& execution, const Motion& motion, const Word& word);

} // namespace proveout
