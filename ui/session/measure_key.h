// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace proveout {

/// The key of the command that measures every block; texts name it where values are missing.
inline constexpr const char* kMeasureKey = "Ctrl+Shift+M";

} // namespace proveout
