// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace proveout {

/// As it may stand in an XML document.
[[nodiscard]] std::string escaped(const std::string& text);

/// About as wide as the letters of UTF-8 text will be in a font of 13 units, whichever font there is.
[[nodiscard]] double textWidth(std::string_view text);

} // namespace proveout
