// SPDX-License-Identifier: GPL-3.0-or-later
// The meaning of a line when it is first executed: values, parameters, codes before and after it.
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "core/nc/run/interpreter.h"
#include "core/nc/run/resumable_interpreter.h"

namespace proveout {
namespace {

InterpretOptions watching(std::uint32_t line, bool toEnd = false, DialectId dialect = DialectId::linuxcnc) {
    InterpretOptions options;
    options.dialect = dialect;
    options.start = Vec3(0);
    options.watchedLine = line;
    options.watchToEnd = toEnd;
    return options;
}

LineValues valuesOf(const std::string& text, std::uint32_t line, bool toEnd = false,
                    DialectId dialect = DialectId::linuxcnc) {
    return *interpret(NcText(text), watching(line, toEnd, dialect))->lineValues();
}

/// The value, e.g. "12.5 mm", of the word that starts at `begin`.
std::string valueAt(const LineValues& values, std::size_t begin) {
    const auto found = std::ranges::find(values.words, begin, &LineValues::Value::begin);
    if (found == values.words.end())
        return "none";
    std::string number = std::to_string(found->value);
    number.erase(number.find_last_not_of('0') + 1);
    return number + " " + found->unit;
}

std::string codeOf(const std::vector<ControlState::Mode>& modes, std::string_view group) {
    const auto found = std::ranges::find(modes, group, &ControlState::Mode::group);
    return found == modes.end() ? "none" : found->code;
}

TEST(LineWatch, KnowsTheValuesOfWords) {
    const LineValues values = valuesOf("G21 F300 S1000\n#1=10.5\nG1 X[#1+2] Y-3 F[2*#1] S5 A7\nM2\n", 3);
    EXPECT_EQ(values.executions, 1U);
    EXPECT_EQ(valueAt(values, 3), "12.5 mm");
    EXPECT_EQ(valueAt(values, 11), "-3. mm");
    EXPECT_EQ(valueAt(values, 15), "21. mm/min");
    EXPECT_EQ(valueAt(values, 23), "5. rpm");
    EXPECT_EQ(valueAt(values, 26), "7. °");
}

TEST(LineWatch, ReportsInTheUnitOfTheProgram) {
    EXPECT_EQ(valueAt(valuesOf("G20\nF5\nG1 X0.5 F7\nM2\n", 3), 3), "0.5 in");
    EXPECT_EQ(valueAt(valuesOf("G20\nF5\nG1 X0.5 F7\nM2\n", 3), 8), "7. in/min");
    EXPECT_EQ(valueAt(valuesOf("G20 G1 X0.5 F7\nM2\n", 1), 7), "0.5 in");
    EXPECT_EQ(valueAt(valuesOf("S100 M3\nG95 G1 X5 F0.1\nM2\n", 2), 10), "0.1 mm/rev");
}

TEST(LineWatch, CountsOutWhatHasNoDecimalPoint) {
    const LineValues values = valuesOf("G90 G0 X1500 Y2.\nM30\n", 1, false, DialectId::fanuc);
    EXPECT_EQ(valueAt(values, 7), "1.5 mm");
    EXPECT_EQ(valueAt(values, 13), "2. mm");
}

TEST(LineWatch, KnowsParametersBeforeAndBehindTheLine) {
    const LineValues values = valuesOf("#1=4\n#<depth>=2\n#1=[#1+#<depth>] #7=##1 (#2)\nM2\n", 3);
    ASSERT_EQ(values.parameters.size(), 6U);
    EXPECT_EQ(values.parameters[0].begin, 0U);
    EXPECT_EQ(values.parameters[0].before, 4);
    EXPECT_EQ(values.parameters[0].after, 6);
    EXPECT_EQ(values.parameters[2].before, 2);
    EXPECT_EQ(values.parameters[3].before, 0); // #7
    const LineValues unset = valuesOf("#<a>=3\nM2\n", 1);
    EXPECT_FALSE(unset.parameters[0].before.has_value());
    EXPECT_EQ(unset.parameters[0].after, 3);
    const LineValues null = valuesOf("#101=#102\nM30\n", 1, false, DialectId::fanuc);
    EXPECT_FALSE(null.parameters[1].before.has_value());
}

TEST(LineWatch, KnowsTheCodesBeforeAndBehindTheLine) {
    const LineValues values = valuesOf("G0 X1\nG1 X2 F100 M3 S5\nG55\nM2\n", 2);
    EXPECT_EQ(codeOf(values.before, "motion"), "G0");
    EXPECT_EQ(codeOf(values.after, "motion"), "G1");
    EXPECT_EQ(codeOf(values.before, "spindle"), "M5");
    EXPECT_EQ(codeOf(values.after, "spindle"), "M3");
    EXPECT_EQ(codeOf(values.after, "work offset"), "G54");
}

TEST(LineWatch, IsOfTheFirstExecutionAndCountsThemWhereAsked) {
    const std::string loop = "#1=0\no1 while [#1 LT 5]\n#1=[#1+1]\nG1 X#1 F100\no1 endwhile\nM2\n";
    const LineValues first = valuesOf(loop, 4);
    EXPECT_EQ(first.executions, 1U);
    EXPECT_EQ(valueAt(first, 3), "1. mm");
    const LineValues all = valuesOf(loop, 4, true);
    EXPECT_EQ(all.executions, 5U);
    EXPECT_EQ(valueAt(all, 3), "1. mm");
    EXPECT_EQ(valuesOf(loop, 2, true).executions, 6U);
    EXPECT_TRUE(interpret(NcText(loop))->runsAgain());
    EXPECT_FALSE(interpret(NcText("G1 X1 F100\nM2\n"))->runsAgain());
}

TEST(LineWatch, SaysWhatIsNotExecuted) {
    EXPECT_EQ(valuesOf("G0 X1\nM2\nG0 X2\n", 3).executions, 0U);
    EXPECT_EQ(valuesOf("o1 if [0]\nG0 X1\no1 endif\nM2\n", 2).executions, 0U);
    EXPECT_EQ(valuesOf("G0 X1\nM2\n", 77).executions, 0U);
}

TEST(LineWatch, LooksWithoutUsing) {
    const auto program = interpret(NcText("F100\nM66 P1 L0\nG0 X1 (#5399) \nG0 X2\nM2\n"), watching(3, true));
    EXPECT_FALSE(program->unverified());
    const auto read = interpret(NcText("F100\nM66 P1 L0\nG0 X#5399\nG0 X2\nM2\n"), watching(3, true));
    EXPECT_TRUE(read->unverified());
}

TEST(LineWatch, TakesARunUpAgainBeforeTheLine) {
    std::string text = "F100\n#1=0\n";
    for (int i = 0; i < 5000; ++i)
        text += "#1=[#1+1]\nG1 X#1\n";
    const NcText program(text + "M2\n");
    ResumableInterpreter interpreter(100);
    for (const std::uint32_t line : {9000U, 9002U, 4000U, 9500U, 3U, 9002U}) {
        const auto values = interpreter.interpret(program, watching(line))->lineValues();
        EXPECT_EQ(values->executions, 1U) << line;
        const auto fresh = interpret(program, watching(line))->lineValues();
        ASSERT_EQ(values->parameters.size(), 1U + (line % 2));
        EXPECT_EQ(values->parameters[0].after, fresh->parameters[0].after) << line;
    }
    EXPECT_GT(interpreter.resumedAt(), 8000U);
}

} // namespace
} // namespace proveout
