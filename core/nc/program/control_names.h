// SPDX-License-Identifier: GPL-3.0-or-later
// Names in ControlState, by which entries are found.
#pragma once

#include "core/base/text.h"

namespace proveout::control_name {

/// The value of this entry is the number of a tool.
inline constexpr const char* kSpindleTool = PROVEOUT_TEXT("Core", "Tool in the spindle");

} // namespace proveout::control_name
