// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace proveout {

enum class NumberStatus : std::uint8_t {
    good,
    missing,    ///< no digit where a number is expected
    doubleSign, ///< two signs; LinuxCNC multiplies them, which no reader of the program would expect
    twoPoints,
    outOfRange, ///< larger than kLargestNumber
    expression, ///< a parameter or a bracket: not a plain number
};

/// No length, feed or speed of a milling machine comes near this, and products of such numbers stay far from
/// infinity.
constexpr double kLargestNumber = 1e12;

/// A number as written in an NC line.
struct NumberRead {
    NumberStatus status = NumberStatus::good;
    double value = 0;
    bool point = false;    ///< it has a decimal point
    std::size_t end = 0;   ///< index after the number, or after the part of it that was understood
    std::size_t place = 0; ///< the position that `status` refers to
};

/// Reads the number that begins at `line[at]`. Blanks and tabs are allowed anywhere in it. The only place
/// where the number of a word is read; expressions use it too.
[[nodiscard]] NumberRead readNumber(std::string_view line, std::size_t at);

} // namespace proveout
