// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace proveout {

/// Escapes the text for an XML document.
[[nodiscard]] std::string escaped(const std::string& text);

/// Estimates the width of UTF-8 text in a font of 13 units, for any font.
[[nodiscard]] double textWidth(std::string_view text);

} // namespace proveout
