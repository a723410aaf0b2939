// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace proveout {

/// RFC 4648, section 4.
[[nodiscard]] std::string base64Of(std::string_view bytes);

} // namespace proveout
