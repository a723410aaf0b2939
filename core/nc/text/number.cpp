// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/text/number.h"

#include "core/nc/text/characters.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

namespace proveout {

namespace {

/// Powers of ten that a double holds exactly.
constexpr std::array<double, 23> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                         1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                         1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t kExactInteger = std::uint64_t{1} << 53;

/// Characters that are allowed between the digits of a number.
bool isGap(char c) {
    return c == ' ' || c == '\t';
}

/// For numbers that do not fit into 53 bits: the characters of [begin, end) without blanks.
double readSlowly(std::string_view line, std::size_t begin, std::size_t end) {
    std::string digits;
    digits.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i) {
        if (!isGap(line[i]))
            digits.push_back(line[i]);
    }
    double value = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (read.ec == std::errc::result_out_of_range) {
        // Underflow or overflow: the digits before the point decide.
        const std::size_t nonZero = digits.find_first_not_of('0');
        return nonZero != std::string::npos && digits[nonZero] != '.' ? HUGE_VAL : 0.0;
    }
    return value;
}

} // namespace

NumberRead readNumber(std::string_view line, std::size_t at) {
    NumberRead read;
    const auto skipBlanks = [&] {
        while (at < line.size() && isGap(line[at]))
            ++at;
    };
    const auto failed = [&](NumberStatus status, std::size_t place) {
        read.status = status;
        read.place = place;
        read.end = at;
        return read;
    };

    skipBlanks();
    const std::size_t begin = at;
    bool negative = false;
    if (at < line.size() && (line[at] == '-' || line[at] == '+')) {
        negative = line[at++] == '-';
        skipBlanks();
        if (at < line.size() && (line[at] == '-' || line[at] == '+'))
            return failed(NumberStatus::doubleSign, begin);
    }
    if (at < line.size() && (line[at] == '#' || line[at] == '['))
        return failed(NumberStatus::expression, at);

    const std::size_t unsignedBegin = at;
    std::size_t end = at;
    std::uint64_t mantissa = 0;
    std::size_t digits = 0;
    std::size_t decimals = 0;
    bool exact = true;
    bool point = false;
    for (; at < line.size(); ++at) {
        const char c = line[at];
        if (isDigit(c)) {
            exact = exact && mantissa < kExactInteger / 10;
            mantissa = exact ? mantissa * 10 + static_cast<std::uint64_t>(c - '0') : mantissa;
            ++digits;
            decimals += point ? 1 : 0;
        } else if (c == '.') {
            if (point)
                return failed(NumberStatus::twoPoints, at);
            point = true;
        } else if (!isGap(c)) {
            break;
        }
        end = isGap(c) ? end : at + 1;
    }
    if (digits == 0)
        return failed(NumberStatus::missing, unsignedBegin);

    // Both are exact doubles, so that one division rounds correctly.
    double value = exact && decimals < kPowers.size() ? static_cast<double>(mantissa) / kPowers[decimals]
                                                      : readSlowly(line, unsignedBegin, end);
    read.end = end;
    read.place = begin;
    read.point = point;
    if (value > kLargestNumber)
        read.status = NumberStatus::outOfRange;
    // Otherwise "-0" would print and compare oddly later on.
    read.value = negative && value != 0 ? -value : value;
    return read;
}

} // namespace proveout
