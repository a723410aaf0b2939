// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/svg_text.h"

#include <cstddef>

#include "core/base/utf8.h"

namespace proveout {

double textWidth(std::string_view text) {
    constexpr double kLetter = 7.6;
    constexpr double kWideLetter = 13; // Korean; three bytes in UTF-8
    double width = 0;
    while (!text.empty()) {
        const std::size_t length = firstCharacter(text).length;
        width += length >= 3 ? kWideLetter : kLetter;
        text.remove_prefix(length);
    }
    return width;
}

} // namespace proveout
