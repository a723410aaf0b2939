// SPDX-License-Identifier: GPL-3.0-or-later
// From the words of a block to a motion: its start, its target, and what is missing.
#pragma once

#include <cstdint>
#include <optional>

#include "core/nc/state/execution.h"

namespace proveout {

/// A motion that begins and ends at the position of the machine.
[[nodiscard]] Motion motionFromHere(const Execution& execution, MotionKind kind);

/// Sends an axis to machine coordinate `value`; if machine zero is unknown, its position becomes unknown, but
/// Z 0 is the machine's reference position.
void setMachineTarget(Execution& execution, Motion& motion, int axis, double value);

/// The end point in X and Y that the polar words of the block give, relative to `program`; `known`: its
/// AxisBits. Nothing if there are none, or, with a report, if they are relative to an unknown position.
[[nodiscard]] std::optional<Vec2> polarTarget(Execution& execution, const Vec3& program, std::uint8_t known);

/// A motion from the position of the machine to the target of the axis words of the block. An increment from
/// an unknown position is reported.
[[nodiscard]] Motion motionToTarget(Execution& execution, MotionKind kind);

/// A motion code without axis words only selects the mode; if the position is known, it is also listed as a
/// motion of no length, as LinuxCNC does.
[[nodiscard]] bool onlySelectsMode(const Execution& execution);

/// Reports once that there is no feed rate.
void reportMissingFeed(Execution& execution, const Word& word);

/// Reports that the motion cuts nothing, once per axis until its position becomes known and is lost again.
void reportUnknownStart(Execution& execution, const Motion& motion, const Word& word);

} // namespace proveout
