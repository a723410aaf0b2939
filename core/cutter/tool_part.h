// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace proveout {

/// The parts of a tool, from the tip upwards. A neck counts as shank.
enum class ToolPart : std::uint8_t { flutes, shank, holder };

} // namespace proveout
