// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nc/state/execution.h"

namespace proveout {

/// Gives `program`, an arc in program coordinates that has its ends and its plane, the centre and the sweep
/// that the words I J K R P of the block describe. False where they make no arc, which is then told.
[[nodiscard]] bool readArc(Execution& execution, const Word& word, Motion& program, bool clockwise);

/// The same for a motion in machine coordinates, in a plane that the work offset does not turn; a flat arc
/// about a far centre becomes a straight feed.
[[nodiscard]] bool shapeArc(Execution& execution, const Word& word, Motion& motion, bool clockwise);

/// Makes the arc a line where it is one; false where it is too large to be computed, which is then told.
[[nodiscard]] bool fitForSize(Execution& execution, const Word& word, Motion& motion);

} // namespace proveout
