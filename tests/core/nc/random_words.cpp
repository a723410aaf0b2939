// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/random_words.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace proveout::test {

int RandomWords::between(int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(m_random);
}

std::string RandomWords::number(double least, double most) {
    const double value = std::uniform_real_distribution<double>(least, most)(m_random);
    switch (between(0, 9)) {
    case 0:
        return fmt::format("{:.3f}", value);
    case 1:
        return fmt::format("{:.1f}", value);
    case 2:
        return fmt::format("{:+.2f}", value);
    case 3:
        return fmt::format("{:.0f}.", value);
    case 4:
        return fmt::format("{:.4f}", value);
    default:
        return fmt::format("{:.0f}", value);
    }
}

std::string RandomWords::length() {
    constexpr double kFar = 20;
    switch (between(0, 24)) {
    case 0:
        return fmt::format("[{} MOD 20]", expression(1));
    case 1:
        return fmt::format("[{} + {}]", number(-9, 9), number(-9, 9));
    case 2:
        return fmt::format("#{}", between(1, 4));
    case 3:
        return fmt::format("-[{} * {}]", number(0, 3), number(-3, 3));
    case 4:
        return fmt::format("[SIN[{}] * 10]", number(-180, 180));
    default:
        return number(-kFar, kFar);
    }
}

std::string RandomWords::parameter() {
    switch (between(0, 11)) {
    case 0:
        return fmt::format("#{}", between(31, 40));
    case 1:
        return "#<_shared>";
    case 2:
        return once(6) ? "#<own>" : "#<_shared>";
    case 3:
        return oneOf({"#5220", "#5230", "#5400"});
    case 4:
        return fmt::format("#<{}>", oneOf({"_absolute",
                                           "_ccomp",
                                           "_coord_system",
                                           "_current_tool",
                                           "_feed",
                                           "_flood",
                                           "_ijk_absolute_mode",
                                           "_imperial",
                                           "_incremental",
                                           "_metric",
                                           "_mist",
                                           "_motion_mode",
                                           "_plane",
                                           "_rpm",
                                           "_selected_tool",
                                           "_spindle_cw",
                                           "_spindle_on",
                                           "_x",
                                           "_y",
                                           "_z"}));
    case 5:
        return oneOf({"#5420", "#5421", "#5422"});
    default:
        return fmt::format("#{}", between(1, 6));
    }
}

std::string RandomWords::target() {
    switch (between(0, 7)) {
    case 0:
        return fmt::format("#{}", between(31, 40));
    case 1:
        return "#<_shared>";
    case 2:
        return "#<own>";
    default:
        return fmt::format("#{}", between(1, 6));
    }
}

std::string RandomWords::operand(int depth) {
    if (depth == 0 || once(3))
        return once(3) ? parameter() : number(-10, 10);
    switch (between(0, 5)) {
    case 0:
        return oneOf({"ABS", "COS", "EXP", "FIX", "FUP", "ROUND", "SIN", "TAN", "ABS", "FIX", "LN", "SQRT",
                      "ACOS", "ASIN"}) +
               expression(depth - 1);
    case 1:
        return fmt::format("ATAN{}/{}", expression(depth - 1), expression(depth - 1));
    case 2:
        return fmt::format("EXISTS[#<{}>]", oneOf({"own", "_shared", "_x", "missing"}));
    case 3:
        return oneOf({"-", "+", ""}) + expression(depth - 1);
    case 4:
        return oneOf({"-", "+", "- -"}) + parameter();
    default:
        return expression(depth - 1);
    }
}

std::string RandomWords::expression(int depth) {
    std::string text = fmt::format("[{}", operand(depth));
    for (int more = between(0, 2); more > 0; --more) {
        const std::string sign = oneOf({"+",   "-",  "*",  "/",  "+",  "-",  "*",  "+",   "-",  "**",
                                        "MOD", "EQ", "NE", "GT", "GE", "LT", "LE", "AND", "OR", "XOR"});
        text += fmt::format(" {} {}", sign, operand(depth));
    }
    return text + "]";
}

std::string RandomWords::block(std::vector<std::string> words) {
    std::shuffle(words.begin(), words.end(), m_random);
    const bool joined = once(4);
    std::string text;
    for (const std::string& word : words) {
        if (!text.empty() && !joined)
            text += ' ';
        text += word;
        if (once(60))
            text += " (in between)";
    }
    if (once(12)) {
        std::ranges::transform(text, text.begin(),
                               [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    }
    return text;
}

} // namespace proveout::test
