// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace proveout {

/// Estimates the width of UTF-8 text in a font of 13 units, for any font.
[[nodiscard]] double textWidth(std::string_view text);

} // namespace proveout
