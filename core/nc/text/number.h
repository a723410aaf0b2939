// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace proveout {

enum class NumberStatus : std::uint8_t {
    good,
    missing,    ///< no digit where the number should stand
    doubleSign, ///< two signs; LinuxCNC multiplies them, which no reader of the program would expect
    twoPoints,
    outOfRange, ///< larger than kLargestNumber
    expression, ///< a parameter or a bracket: not a plain number
};

/// No length, feed or speed of a milling machine comes near it, and its products stay far from infinity.
constexpr double kLargestNumber = 1e12;

/// A number as it stands in an NC line.
struct NumberRead {
    NumberStatus status = NumberStatus::good;
    double value = 0;
    bool point = false;    ///< it has a decimal point
    std::size_t end = 0;   ///< index behind the number, or behind what was understood of it
    std::size_t place = 0; ///< what `status` is about
};

/// Reads the number that begins at `line[at]`. Blanks and tabs may stand anywhere in it. The one place where
/// the value of a word is read: expressions will begin here.
[[nodiscard]] NumberRead readNumber(std::string_view line, std::size_t at);

} // namespace proveout
