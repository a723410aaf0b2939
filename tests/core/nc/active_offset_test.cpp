// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/program/active_offset.h"

#include <gtest/gtest.h>
#include <string>

#include "core/nc/run/interpreter.h"

namespace proveout {
namespace {

ActiveOffset offsetAfter(const std::string& text, std::size_t blocks,
                         DialectId dialect = DialectId::linuxcnc) {
    InterpretOptions options;
    options.dialect = dialect;
    return activeOffset(*interpret(NcText(text), options), blocks);
}

} // namespace

TEST(ActiveOffset, IsThatOfTheLastMotion) {
    const std::string text =
        "G21 G90 G10 L2 P2 X10 Y20 Z-3\nG0 X0 Y0 Z5\nG55 G0 X1\nG0 X2\nG92 X0\nG0 X1\nG54\nM2\n";
    EXPECT_EQ(offsetAfter(text, 1), (ActiveOffset{"G54", Vec3(0)}));
    EXPECT_EQ(offsetAfter(text, 2), (ActiveOffset{"G55", Vec3(10, 20, -3)}));
    EXPECT_EQ(offsetAfter(text, 3), (ActiveOffset{"G55", Vec3(10, 20, -3)}));
    EXPECT_EQ(offsetAfter(text, 4), (ActiveOffset{"G55", Vec3(12, 20, -3)})); // G92 has moved its zero
    EXPECT_EQ(offsetAfter(text, 99), (ActiveOffset{"G55", Vec3(12, 20, -3)}));
}

TEST(ActiveOffset, IsThatOfTheFirstMotionBeforeAny) {
    EXPECT_EQ(offsetAfter("G21 G90 G56\nG0 X1 Y1 Z1\nG54 G0 X2\nM2\n", 0).code, "G56");
    EXPECT_EQ(offsetAfter("M2\n", 0), ActiveOffset());
}

TEST(ActiveOffset, IsNamedThoughItsZeroIsThatOfAnother) {
    EXPECT_EQ(offsetAfter("G21 G90 G57\nG0 X1 Y1 Z1\nM2\n", 1).code, "G57");
    EXPECT_EQ(offsetAfter("G21 G90 G59.2\nG0 X1 Y1 Z1\nM2\n", 1).code, "G59.2");
    EXPECT_EQ(offsetAfter("G21 G90 G54.1 P3\nG0 X1 Y1 Z1\nM30\n", 1, DialectId::fanuc).code, "G54.1 P3");
    EXPECT_EQ(offsetAfter("G21 G90 G154 P12\nG0 X1 Y1 Z1\nM30\n", 1, DialectId::haas).code, "G154 P12");
}

} // namespace proveout
