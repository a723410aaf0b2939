// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/modal_groups.h"
#include "core/nc/codes/word_help.h"

#include <gtest/gtest.h>

namespace proveout {

namespace {

std::string shownAt(std::string_view line, std::size_t at, DialectId dialect = DialectId::linuxcnc) {
    const auto help = helpAt(line, at, dialect);
    return !help ? "" : help->word + ": " + (help->name == nullptr ? "?" : help->name);
}

} // namespace

TEST(WordHelp, NamesTheWordUnderAnyOfItsCharacters) {
    const std::string_view line = "N10 g 1x-2.5 (G2 X3) F100;M3";
    EXPECT_EQ(shownAt(line, 4), "G1: straight feed");
    EXPECT_EQ(shownAt(line, 6), "G1: straight feed");
    EXPECT_EQ(shownAt(line, 7), "X: X coordinate");
    EXPECT_EQ(shownAt(line, 11), "X: X coordinate");
    EXPECT_EQ(shownAt(line, 21), "F: feed rate");
    EXPECT_EQ(shownAt(line, 1), "N: block number");
}

TEST(WordHelp, SaysNothingAboutCommentsBlanksAndKeywords) {
    const std::string_view line = "G1 X1 (G2 X3) ;M3";
    EXPECT_EQ(shownAt(line, 2), "");
    EXPECT_EQ(shownAt(line, 7), "");
    EXPECT_EQ(shownAt(line, 15), "");
    EXPECT_EQ(shownAt("o100 while [#1 LT 3]", 7), "");
    EXPECT_EQ(shownAt("", 0), "");
    EXPECT_EQ(shownAt("G1", 99), "");
}

TEST(WordHelp, NamesParameters) {
    EXPECT_EQ(shownAt("G1 X#<depth>", 8), "#<depth>: parameter");
    EXPECT_EQ(shownAt("#12=##3", 2), "#12: parameter");
    EXPECT_EQ(shownAt("#12=##3", 4), "##3: parameter");
    EXPECT_EQ(shownAt("X#[#1+2]", 1), "#: parameter");
    EXPECT_EQ(shownAt("X#[#1+2]", 4), "#1: parameter");
    EXPECT_EQ(shownAt("X#", 1), "#: parameter");
    EXPECT_EQ(shownAt("(#1)", 1), "");
}

TEST(WordHelp, FollowsTheDialect) {
    EXPECT_EQ(shownAt("G76 X1", 0, DialectId::fanuc), "G76: fine boring cycle");
    EXPECT_EQ(shownAt("G65 P1", 0, DialectId::fanuc), "G65: macro call");
    EXPECT_FALSE(helpAt("G65 P1", 0, DialectId::linuxcnc)->supported);
    EXPECT_EQ(shownAt("G777", 0), "G777: ?");
}

TEST(WordHelp, NamesTheModalGroup) {
    EXPECT_STREQ(helpAt("G17", 0, DialectId::linuxcnc)->group, "plane");
    EXPECT_STREQ(helpAt("G54", 0, DialectId::linuxcnc)->group, "work offset");
    EXPECT_STREQ(helpAt("M8", 0, DialectId::linuxcnc)->group, "coolant");
    EXPECT_EQ(helpAt("X5", 0, DialectId::linuxcnc)->group, nullptr);
    EXPECT_STREQ(nameOf(ModalGroup::tapping), "tapping");
    EXPECT_STREQ(nameOf(ModalGroup::subprogram), "subprogram");
    EXPECT_STREQ(nameOf(ModalGroup::diameterMode), "diameter mode");
}

} // namespace proveout
