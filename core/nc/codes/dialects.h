// SPDX-License-Identifier: GPL-3.0-or-later
// The table of dialects.
#pragma once

#include <span>
#include <string_view>

#include "core/nc/text/dialect.h"

namespace proveout {

/// All dialects, in the order of DialectId.
[[nodiscard]] std::span<const Dialect> dialects();
[[nodiscard]] const Dialect& dialect(DialectId id);
/// The dialect with this key; null if there is none.
[[nodiscard]] const Dialect* findDialect(std::string_view key);

} // namespace proveout
