// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nc/state/execution.h"

namespace proveout {

/// Sets in `program`, an arc in program coordinates that has its ends and its plane, the centre and the sweep
/// that the words I J K R P of the block describe. False, with a report, if they do not make an arc.
[[nodiscard]] bool readArc(Execution& execution, const Word& word, Motion& program, bool clockwise);

/// The same for a motion in machine coordinates, in a plane that the work offset does not rotate; a flat arc
/// about a far centre becomes a straight feed.
[[nodiscard]] bool shapeArc(Execution& execution, const Word& word, Motion& motion, bool clockwise);

/// Turns the arc into a line if it is that flat; false, with a report, if it is too large to be computed.
[[nodiscard]] bool fitForSize(Execution& execution, const Word& word, Motion& motion);

} // namespace proveout
