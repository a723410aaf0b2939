// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cutter/tool_table.h"

namespace proveout {

/// A cutter and where its sizes come from.
struct SourcedCutter {
    Cutter cutter;
    ToolOrigin origin;
};

/// What a comment states now, overridden by what the user has entered for the tool before
/// (ToolOrigin::entered of `present`). If both together fit no shape, what the comment states.
[[nodiscard]] SourcedCutter withEntered(const SourcedCutter& stated, const SourcedCutter& present);

} // namespace proveout
