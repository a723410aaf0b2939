// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace proveout {

/// A text as an XML or HTML document shows it, also within double quotation marks. Any thread.
[[nodiscard]] std::string escaped(std::string_view text);

} // namespace proveout
