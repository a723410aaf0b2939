// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the control at a block, compared with the text.
#include "core/nc/program/control_state.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

#include "core/nc/run/interpreter.h"

namespace proveout {

namespace {

ControlState stateBehind(const std::string& text, std::size_t blocks,
                         DialectId dialect = DialectId::linuxcnc) {
    InterpretOptions options;
    options.dialect = dialect;
    options.stopAfterBlocks = blocks;
    return interpret(NcText(text), options)->controlState();
}

bool inForce(const ControlState& state, std::string_view code) {
    return std::ranges::any_of(state.modes, [&](const auto& mode) { return mode.code == code; });
}

double variable(const ControlState& state, std::string_view name) {
    const auto found = std::ranges::find(state.variables, name, &ControlState::Variable::name);
    return found == state.variables.end() ? -1 : found->value;
}

} // namespace

TEST(ControlState, HoldsTheModalCodesOfABlock) {
    const std::string text =
        "G21 G90 G0 X1 Y2 Z3\nG20 G91 G18 S500 M3 M8\nG1 X1 F10\nG21 G90 G17\nG0 X5\nM2\n";
    const ControlState first = stateBehind(text, 1);
    EXPECT_EQ(first.line, 1U);
    for (const char* code : {"G0", "G17", "G90", "G21", "G40", "G54", "M5", "M9"})
        EXPECT_TRUE(inForce(first, code)) << code;
    const ControlState second = stateBehind(text, 2);
    EXPECT_EQ(second.line, 3U);
    for (const char* code : {"G1", "G18", "G91", "G20", "M3", "M8"})
        EXPECT_TRUE(inForce(second, code)) << code;
    EXPECT_EQ(second.places.front().value, Vec3(26.4, 2, 3));
    EXPECT_EQ(second.places.front().known, kAllAxes);
    EXPECT_EQ(second.quantities.front().value, 254);
}

TEST(ControlState, HoldsThePlaceOfEveryCall) {
    const std::string text = "o1 sub\nG0 X#1\no1 endsub\no2 sub\n#<a>=4\no1 call [#1+1]\no2 endsub\nG0 X0 Y0 "
                             "Z0\no2 call [7]\nM2\n";
    const ControlState inside = stateBehind(text, 2);
    ASSERT_EQ(inside.calls.size(), 2U);
    EXPECT_EQ(inside.calls[0].program, "2");
    EXPECT_EQ(inside.calls[0].line, 9U);
    EXPECT_EQ(inside.calls[1].program, "1");
    EXPECT_EQ(inside.calls[1].line, 6U);
    EXPECT_EQ(variable(inside, "#1"), 8);
    EXPECT_EQ(variable(inside, "#<a>"), -1) << "belongs to the caller";
    EXPECT_TRUE(stateBehind(text, 1).calls.empty());
}

TEST(ControlState, HoldsVariablesThatWereSetEvenToZero) {
    const ControlState state = stateBehind("#100=0 #101=2.5\nG0 X1.\nM30\n", 1, DialectId::fanuc);
    EXPECT_EQ(variable(state, "#100"), 0);
    EXPECT_EQ(variable(state, "#101"), 2.5);
    EXPECT_EQ(variable(state, "#102"), -1);
}

TEST(ControlState, IsThatOfPowerOnBeforeTheFirstBlock) {
    const ControlState state = stateBehind("G20 G0 X1\nM2\n", 0);
    EXPECT_EQ(state.line, 0U);
    EXPECT_TRUE(inForce(state, "G21"));
    EXPECT_TRUE(inForce(state, "G80"));
    EXPECT_EQ(state.places.front().known, 0);
}

TEST(ControlState, NamesAdditionalOffsetsAndTransformationsAsTheDialectDoes) {
    const std::string text = "G54.1 P3 G0 X0. Y0. Z5.\nG68 X0. Y0. R30.\nG43 H1 Z3.\nM30\n";
    const ControlState state = stateBehind(text, 2, DialectId::fanuc);
    for (const char* code : {"G54.1", "G68", "G43", "G50", "G15"})
        EXPECT_TRUE(inForce(state, code)) << code;
    EXPECT_FALSE(inForce(state, "G59.1"));
    EXPECT_FALSE(inForce(stateBehind("G0 X1\nM2\n", 1), "G50")) << "LinuxCNC knows no scaling";
}

TEST(ControlState, HoldsALengthOffsetThoughItIsZero) {
    EXPECT_TRUE(inForce(stateBehind("T1 M6\nG43 H1\nG0 Z1\nM2\n", 1), "G43"));
    EXPECT_TRUE(inForce(stateBehind("T1 M6\nG43 H1\nG49\nG0 Z1\nM2\n", 1), "G49"));
}

TEST(ControlState, IsThatOfTheEndWhereNothingStopsBefore) {
    InterpretOptions options;
    const auto program = interpret(NcText("G0 X1\nG91\nM2\n"), options);
    EXPECT_TRUE(inForce(program->controlState(), "G91"));
}

} // namespace proveout
