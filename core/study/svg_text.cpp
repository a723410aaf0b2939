// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/svg_text.h"

namespace proveout {

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            out += c;
        }
    }
    return out;
}

double textWidth(const std::string& text) {
    constexpr double kLetter = 7.6;
    constexpr double kWideLetter = 13; // Korean; three bytes in UTF-8
    double width = 0;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        width += byte >= 0xE0 ? kWideLetter : (byte & 0xC0U) == 0x80 ? 0 : kLetter;
    }
    return width;
}

} // namespace proveout
