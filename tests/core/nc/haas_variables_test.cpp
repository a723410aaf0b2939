// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/haas_variables.h"

#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>

#include "core/nc/run/interpreter.h"

namespace proveout {

namespace {

/// The message ids of a program that executes `line` and then moves.
std::vector<std::string> reported(const std::string& line, DialectId dialect = DialectId::haas) {
    InterpretOptions options;
    options.dialect = dialect;
    options.lint = false;
    options.start = Vec3(0);
    const auto program = interpret(NcText("%\nO1\nG21 G90 G54\n" + line + "\nG0 X#1\nM30\n%\n"), options);
    std::vector<std::string> ids;
    for (const Diagnostic& diagnostic : program->diagnostics())
        ids.emplace_back(diagnostic.id);
    return ids;
}

const std::vector<std::string> kAssumed{"variable-assumed"};
const std::vector<std::string> kNothing;

} // namespace

TEST(HaasVariables, TimersAndMonitorsAreAssumedToBeZeroWithANote) {
    for (const int number : {1064, 1601, 1801, 3020, 3025, 3201, 3401, 5401, 5405, 5500, 5501, 5600,
                             5601, 5699, 5701, 5801, 5901, 6000, 7501, 7806, 8501, 8550, 8559, 9000})
        EXPECT_EQ(reported("#1=#" + std::to_string(number)), kAssumed) << number;
    EXPECT_EQ(reported("IF [#5405 GT 3600] GOTO 99\n#1=#5405\nN99"), kAssumed);
    EXPECT_EQ(reported("#1=#5405\n#1=#5406").size(), 2U);
}

TEST(HaasVariables, ResettingATimerIsNoUseOfIt) {
    EXPECT_EQ(reported("#5405=0\n#1=5"), kNothing);
    EXPECT_EQ(reported("#7501=1\n#1=5"), kNothing);
}

TEST(HaasVariables, SettingsAreOfTheMachine) {
    for (const int number : {1090, 6001, 6277, 6501, 11000, 13000})
        EXPECT_EQ(reported("#1=#" + std::to_string(number)).front(), "variable-of-machine") << number;
}

TEST(HaasVariables, ShowTheToolAndTheSpindle) {
    InterpretOptions options;
    options.dialect = DialectId::haas;
    options.lint = false;
    const auto program = interpret(NcText("G21 G90 T7 M6\nM3 S900\nG0 X#3026 Y#3027 Z1.\nM30\n"), options);
    ASSERT_EQ(program->motionCount(), 1U);
    EXPECT_EQ(program->motion(0).end.x, 7);
    EXPECT_EQ(program->motion(0).end.y, 900);
}

TEST(HaasVariables, OfGeneralPurposeHaveTwoNumbers) {
    InterpretOptions options;
    options.dialect = DialectId::haas;
    options.lint = false;
    const auto program =
        interpret(NcText("G21 G90\n#10101=3.\n#600=4.\n#10801=5.\nG0 X#101 Y#10600 Z#801\nM30\n"), options);
    ASSERT_EQ(program->motionCount(), 1U);
    EXPECT_EQ(program->motion(0).end, Vec3(3, 4, 5));
}

TEST(HaasVariables, AreNotThoseOfFanuc) {
    EXPECT_EQ(reported("#1=#5405", DialectId::fanuc).front(), "parameter-number");
}

} // namespace proveout
