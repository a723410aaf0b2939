// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace proveout {

/// Whether a pattern matches the whole of a text in upper case: "~" is any text or none, "#" one or more
/// digits, "?" one digit, "@" a name of letters, digits and "_"; "\" before a character makes it literal.
/// Time: at most the product of both lengths.
[[nodiscard]] bool matchesGlob(std::string_view pattern, std::string_view text);

} // namespace proveout
