// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs of G18 and G19 under a rotation of the work offset: they lie in no plane of the machine.
#pragma once

#include <vector>

#include "core/nc/state/execution.h"

namespace proveout {

/// The ends of straight pieces within `chordError` of an arc or helix, at equal angles; the last is the end
/// of the arc. Of the chord error a tenth is kept for ends at different distances from the centre.
[[nodiscard]] std::vector<Vec3> piecesOfArc(const Motion& arc, double chordError);
/// How many those are.
[[nodiscard]] double pieceCountOfArc(const Motion& arc, double chordError);

/// Whether the rotation turns the plane of a motion out of the planes of the machine.
[[nodiscard]] bool turnsPlane(const WorkFrame& frame, Plane plane);

/// Appends the arc that the words of the block describe as straight motions within kChordError; `motion` has
/// its ends and its plane. False where the words make no arc, which is then told.
[[nodiscard]] bool appendTurnedArc(Execution& execution, const Word& word, const Motion& motion,
                                   bool clockwise);

} // namespace proveout
