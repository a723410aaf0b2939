// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that the core has computed as an argument of a diagnostic.
#pragma once

#include <fmt/format.h>
#include <utility>

#include "core/base/argument.h"

namespace proveout {

/// Formatted by fmt, e.g. figures("{:.3f}", depth). Whole numbers without a unit read the same everywhere and
/// need not be marked; a number that the user wrote, e.g. the value of a word, stays text.
template<class... Values>
[[nodiscard]] Argument figures(fmt::format_string<Values...> format, Values&&... values) {
    return Argument::ofFigures(fmt::format(format, std::forward<Values>(values)...));
}

} // namespace proveout
