// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/utf8.h"

#include <array>

namespace proveout {

namespace {

/// The smallest code that needs so many bytes.
constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
constexpr char32_t kLast = 0x10ffff;

std::size_t lengthFrom(unsigned char lead) {
    if (lead < 0x80)
        return 1;
    if (lead < 0xc0 || lead >= 0xf8)
        return 0;
    return lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
}

/// Whether a byte continues a character, that is, is not its first.
bool continues(char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
}

} // namespace

Utf8Character firstCharacter(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text.front());
    const Utf8Character alone{lead, 1, lead < 0x80};
    const std::size_t length = lengthFrom(lead);
    if (length < 2 || length > text.size())
        return alone;
    char32_t code = lead & (0x7fU >> length);
    for (const char c : text.substr(1, length - 1)) {
        const auto byte = static_cast<unsigned char>(c);
        if (!continues(c))
            return alone;
        code = (code << 6) | (byte & 0x3fU);
    }
    const bool surrogate = code >= 0xd800 && code <= 0xdfff;
    return code < kLeast[length] || code > kLast || surrogate ? alone : Utf8Character{code, length, true};
}

bool isUtf8(std::string_view text) {
    while (!text.empty()) {
        const Utf8Character character = firstCharacter(text);
        if (!character.valid)
            return false;
        text.remove_prefix(character.length);
    }
    return true;
}

std::string_view shortened(std::string_view text, std::size_t bytes) {
    if (text.size() <= bytes)
        return text;
    while (bytes > 0 && continues(text[bytes]))
        --bytes;
    return text.substr(0, bytes);
}

} // namespace proveout
