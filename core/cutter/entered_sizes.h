// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cutter/tool_table.h"

namespace proveout {

/// A cutter with where its sizes come from.
struct SourcedCutter {
    Cutter cutter;
    ToolOrigin origin;
};

/// What a comment states now, with what the user has entered for the tool before (ToolOrigin::entered of
/// `present`) in the place of it. Where both fit no shape together, what the comment states.
[[nodiscard]] SourcedCutter withEntered(const SourcedCutter& stated, const SourcedCutter& present);

} // namespace proveout
