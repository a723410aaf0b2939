// SPDX-License-Identifier: GPL-3.0-or-later
// Two figures in one sentence. Internal to this library.
#pragma once

#include <fmt/format.h>
#include <limits>
#include <string>

namespace proveout {

/// With the fewest digits that distinguish the value from the other one: "0.05 mm, more than 0.05 mm" would
/// say nothing.
inline std::string distinguished(double value, double other) {
    constexpr int kFewest = 4;
    for (int digits = kFewest; digits < std::numeric_limits<double>::max_digits10; ++digits)
        if (std::string text = fmt::format("{:.{}g}", value, digits);
            text != fmt::format("{:.{}g}", other, digits))
            return text;
    return fmt::format("{}", value);
}

} // namespace proveout
