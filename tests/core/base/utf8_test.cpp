// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/utf8.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <utility>

namespace proveout {
namespace {

TEST(Utf8, ReadsCharactersOfEveryLength) {
    for (const auto& [text, code] : {std::pair<std::string_view, char32_t>{"A", U'A'},
                                     {"ä", U'ä'},
                                     {"공", U'공'},
                                     {"𝄞", U'𝄞'},
                                     {"\xf4\x8f\xbf\xbf", 0x10ffff}}) {
        const Utf8Character character = firstCharacter(std::string(text) + "rest");
        EXPECT_TRUE(character.valid) << text;
        EXPECT_EQ(character.code, code) << text;
        EXPECT_EQ(character.length, text.size()) << text;
    }
}

TEST(Utf8, GivesBytesThatAreNoneOneByOne) {
    for (const char* text : {"\xff", "\x80x", "\xc3", "\xc3(", "\xe2\x80", "\xc0\xaf", "\xe0\x80\xaf",
                             "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80"}) {
        const Utf8Character character = firstCharacter(text);
        EXPECT_FALSE(character.valid) << text;
        EXPECT_EQ(character.code, static_cast<unsigned char>(*text)) << text;
        EXPECT_EQ(character.length, 1U) << text;
    }
}

TEST(Utf8, IsDistinguishedFromOtherBytes) {
    EXPECT_TRUE(isUtf8(""));
    EXPECT_TRUE(isUtf8("G1 X1 (Fr\xc3\xa4ser \xe2\x8c\x80 \xf0\x9f\x94\xa7)"));
    EXPECT_FALSE(isUtf8("Fr\xe4ser"));        // Latin-1
    EXPECT_FALSE(isUtf8("\xc3"));             // half of a character
    EXPECT_FALSE(isUtf8("\xc0\xaf"));         // overlong
    EXPECT_FALSE(isUtf8("\xed\xa0\x80"));     // a surrogate
    EXPECT_FALSE(isUtf8("\xf4\x90\x80\x80")); // beyond the last code
}

/// For every length of every text: the result is a prefix, no longer than requested, and splits no character.
TEST(Utf8, IsShortenedBetweenCharacters) {
    for (const std::string text : {"", "abc", "\xc3\xa4\xc3\xb6", "a\xe2\x8c\x80z", "\xf0\x9f\x94\xa7"}) {
        for (std::size_t bytes = 0; bytes <= text.size() + 2; ++bytes) {
            const std::string_view left = shortened(text, bytes);
            EXPECT_TRUE(text.starts_with(left) && left.size() <= bytes && isUtf8(left))
                << text << ' ' << bytes;
            EXPECT_LT(std::min(bytes, text.size()) - left.size(), 4U);
        }
        EXPECT_EQ(shortened(text, text.size()), text);
    }
}

} // namespace
} // namespace proveout
