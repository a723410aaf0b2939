// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/utf8.h"

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

} // namespace
} // namespace proveout
