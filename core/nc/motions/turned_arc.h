// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs of G18 and G19 under a rotation of the work offset, which are not in a plane of the machine.
#pragma once

#include <vector>

#include "core/nc/state/execution.h"

namespace proveout {

/// The ends of straight pieces within `chordError` of an arc or helix, at equal angles; the last is the end
/// of the arc. A tenth of the chord error is reserved for ends at different distances from the centre.
[[nodiscard]] std::vector<Vec3> piecesOfArc(const Motion& arc, double chordError);
/// The number of these pieces.
[[nodiscard]] double pieceCountOfArc(const Motion& arc, double chordError);

/// Whether the rotation turns the plane of a motion out of the planes of the machine.
[[nodiscard]] bool turnsPlane(const WorkFrame& frame, Plane plane);

/// Appends the arc that the words of the block describe as straight motions within kChordError; `motion` has
/// its ends and its plane. False, with a report, if the words do not make an arc.
[[nodiscard]] bool appendTurnedArc(Execution& execution, const Word& word, const Motion& motion,
                                   bool clockwise);

} // namespace proveout
