// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace proveout {

/// A character of a text in UTF-8.
struct Utf8Character {
    char32_t code = 0;      ///< the byte itself if it is not part of a character
    std::size_t length = 1; ///< bytes
    bool valid = false;
};

/// The character at the beginning of `text`, which must not be empty. Bytes that are not UTF-8 (also overlong
/// forms and surrogates) come one by one, as not valid.
[[nodiscard]] Utf8Character firstCharacter(std::string_view text);

/// Whether the whole text is UTF-8.
[[nodiscard]] bool isUtf8(std::string_view text);

/// The first `bytes` bytes of a text, or fewer, so that the last character is whole.
[[nodiscard]] std::string_view shortened(std::string_view text, std::size_t bytes);

} // namespace proveout
