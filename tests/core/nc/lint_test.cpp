// SPDX-License-Identifier: GPL-3.0-or-later
// Every rule with a program that violates it, and the same program corrected.
#include "core/nc/run/lint.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <string>

#include "core/nc/run/interpreter.h"

namespace proveout {

namespace {

struct Twins {
    std::string_view id;
    int line; ///< line of the message
    DialectId dialect;
    std::string bad;
    std::string clean;
};

const Twins kTwins[] = {
    {"feed-missing", 2, DialectId::linuxcnc, "G21\nG1 X1\nM2\n", "G21 F100\nG1 X1\nM2\n"},
    {"inverse-time-feed", 2, DialectId::linuxcnc, "G93 G1 X1 F2\nX2\nM2\n", "G93 G1 X1 F2\nX2 F2\nM2\n"},
    {"compensation-at-end", 4, DialectId::linuxcnc, "G0 X0 Y0 F100\nG41.1 D2 G1 X5\nG1 Y20\nM2\n",
     "G0 X0 Y0 F100\nG41.1 D2 G1 X5\nG1 Y20\nG40 G1 X9\nM2\n"},
    {"main-return", 2, DialectId::linuxcnc, "G0 X1\nM99\n", "G0 X1\nM30\n"},
    {"after-program-end", 3, DialectId::linuxcnc, "G0 X1\nM30\nG0 X2\n", "G0 X1\nG0 X2\nM30\n"},
    {"unreachable", 4, DialectId::fanuc, "O1\nG0 X1.\nGOTO 9\nX2.\nN9 M30\n", "O1\nG0 X1.\nGOTO 9\nN9 M30\n"},
    {"unreachable", 4, DialectId::fanuc, "O1\nG0 X1.\nGOTO 9\nN5 X2.\nN9 M30\n",
     "O1\nG0 X1.\nIF [1 EQ 2] GOTO 5\nGOTO 9\nN5 X2.\nN9 M30\n"},
    {"unreachable", 4, DialectId::fanuc, "O1\nN5 G0 X1.\nGOTO 9\nN7 X2.\nN9 M30\n",
     "O1\n#1=7\nIF [1 EQ 2] GOTO #1\nGOTO 9\nN7 X2.\nN9 M30\n"},
    {"unreachable", 6, DialectId::fanuc, "O1\nM98 P2\nM30\nO2\nM99\nG0 X1.\n",
     "O1\nM98 P2\nM30\nO2\nM99\nO3\nM99\n"},
    {"unreachable", 4, DialectId::linuxcnc, "o1 sub\nG0 X1\no1 return\nG0 X2\no1 endsub\no1 call\nM2\n",
     "o1 sub\nG0 X1\no2 if [#1 EQ 0]\no1 return\no2 endif\nG0 X2\no1 endsub\no1 call\nM2\n"},
    {"block-twice", 4, DialectId::fanuc,
     "O1\nN1 G0 X1.\nIF [1 EQ 2] GOTO 9\nGOTO 7\nN7 X2.\nN7 X3.\nN9 M30\n",
     "O1\nN1 G0 X1.\nN1 X5.\nGOTO 7\nN7 X2.\nN8 X3.\nN9 M30\n"},
    {"tool-not-in-table", 2, DialectId::linuxcnc, "T1 M6\nG0 X1 T7\nM2\n", "T1 M6\nG0 X1 T2\nM2\n"},
    {"feed-zero", 1, DialectId::linuxcnc, "G1 X1 F0\nM2\n", "G1 X1 F1\nM2\n"},
    {"length-missing", 3, DialectId::fanuc, "G54 T2 M6\nG0 Z5.\nG1 Z-1. F100\nM30\n",
     "G54 T2 M6\nG43 H2 G0 Z5.\nG1 Z-1. F100\nM30\n"},
    {"length-missing", 5, DialectId::linuxcnc, "T1 M6\nG1 Z1 F100\nG0 Z9\nT2 M6\nG1 Z-1\nM2\n",
     "T1 M6\nG1 Z1 F100\nG0 Z9\nT2 M6 G43\nG1 Z-1\nM2\n"},
    {"offset-never-chosen", 2, DialectId::fanuc, "G90 G0 X0.\nG1 X1. F100\nM30\n",
     "G90 G54 G0 X0.\nG1 X1. F100\nM30\n"},
    {"length-of-other-tool", 2, DialectId::linuxcnc, "T2 M6\nG0 G43 H3 Z5\nM2\n",
     "T2 M6\nG0 G43 H2 Z5\nM2\n"},
    {"diameter-missing", 2, DialectId::fanuc, "T1 M6\nG41 G1 X5. F100\nG40\nM30\n",
     "T1 M6\nG41 D1 G1 X5. F100\nG40\nM30\n"},
    {"compensation-on-arc", 3, DialectId::linuxcnc,
     "F100 G0 X0 Y0\nG41.1 D1\nG2 X10 Y10 I10\nG1 X20\nG40\nM2\n",
     "F100 G0 X0 Y0\nG41.1 D1\nG1 X5\nG2 X15 Y10 I10\nG1 X20\nG40\nM2\n"},
    {"units-mixed", 2, DialectId::linuxcnc, "G21 G1 X1 F100\nG20\nG1 X1 F10\nM2\n",
     "G20\nG1 X1 F10\nG1 X2\nM2\n"},
    {"left-on", 3, DialectId::linuxcnc, "G91 G0 X1\nT2\nM6\nG90\nM2\n", "G91 G0 X1\nT2 G90\nM6\nM2\n"},
    {"left-on", 2, DialectId::linuxcnc, "G18 G0 X1\nM2\n", "G18 G0 X1\nG17\nM2\n"},
    {"left-on", 3, DialectId::linuxcnc, "F100 G0 Z5\nG81 X1 Z-1 R2\nM2\n",
     "F100 G0 Z5\nG81 X1 Z-1 R2\nG80\nM2\n"},
    {"left-on", 3, DialectId::fanuc, "G54 G0 X0. Y0.\nG68 X0. Y0. R30.\nM30\n",
     "G54 G0 X0. Y0.\nG68 X0. Y0. R30.\nG69\nM30\n"},
    {"change-low", 3, DialectId::linuxcnc, "F100 G1 Z2\nZ-1\nT2 M6\nM2\n",
     "F100 G1 Z2\nZ-1\nG0 Z50\nT2 M6\nM2\n"},
    {"change-turning", 2, DialectId::linuxcnc, "S100 M3\nT2 M6\nM2\n", "S100 M3\nM5\nT2 M6\nM2\n"},
    {"no-decimal-point", 2, DialectId::fanuc, "G90 G0\nX10\nM30\n", "G90 G0\nX10.\nM30\n"},
    {"nearly-half-circle", 2, DialectId::linuxcnc, "F100 G0 X0 Y0\nG2 X10 Y0 R5.00001\nM2\n",
     "F100 G0 X0 Y0\nG2 X10 Y0 I5\nM2\n"},
};

std::vector<int> linesOf(const Twins& twins, const std::string& text) {
    InterpretOptions options;
    options.dialect = twins.dialect;
    options.assumeStartAtZero = true;
    options.tools = ToolOffsets({{1, {}}, {2, {}}, {3, {}}});
    std::vector<int> lines;
    const auto program = interpret(NcText(text), options);
    for (const Diagnostic& reported : program->diagnostics()) {
        if (reported.id == twins.id)
            lines.push_back(reported.where.line);
    }
    return lines;
}

} // namespace

TEST(Lint, ReportsTheBadTwinAndNotTheCleanOne) {
    for (const Twins& twins : kTwins) {
        EXPECT_EQ(linesOf(twins, twins.bad), std::vector<int>{twins.line}) << twins.id << "\n" << twins.bad;
        EXPECT_EQ(linesOf(twins, twins.clean), std::vector<int>{}) << twins.id << "\n" << twins.clean;
    }
}

TEST(Lint, HasTwinsForEveryRule) {
    std::set<std::string_view> ids;
    for (const Twins& twins : kTwins)
        ids.insert(twins.id);
    for (const LintRule& rule : lintRules())
        EXPECT_TRUE(ids.contains(rule.message->id)) << rule.message->id;
}

TEST(Lint, KeepsQuietWhereItIsSwitchedOff) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    options.lint = false;
    EXPECT_TRUE(interpret(NcText("S100 M3\nT2 M6\nM2\n"), options)->diagnostics().size() <= 1);
}

} // namespace proveout
