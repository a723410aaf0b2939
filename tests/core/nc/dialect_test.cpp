// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <utility>

#include "core/nc/codes/dialect_guess.h"
#include "core/nc/codes/dialects.h"
#include "core/nc/run/dialect_comparison.h"
#include "core/nc/run/interpreter.h"

namespace proveout {

namespace {

DialectId guessed(const std::string& text) {
    return guessDialect(NcText(text)).dialect;
}

std::shared_ptr<const Program> readAs(DialectId dialect, const std::string& text) {
    InterpretOptions options;
    options.dialect = dialect;
    options.assumeStartAtZero = true;
    return interpret(NcText(text), options);
}

bool reported(const Program& program, std::string_view id) {
    return std::ranges::any_of(program.diagnostics(), [&](const Diagnostic& d) { return d.id == id; });
}

} // namespace

TEST(Dialects, AreFoundByTheirKeys) {
    for (const Dialect& row : dialects()) {
        EXPECT_EQ(findDialect(row.key), &row);
        EXPECT_EQ(&dialect(row.id), &row);
    }
    EXPECT_EQ(findDialect("basic"), nullptr);
}

TEST(Dialects, HaveTheirReferencePositionAtZeroWhereTheyKeepNone) {
    const auto program = readAs(DialectId::fanuc, "G0 X1. Y1. Z1.\nG91 G28 Z0\nM30\n");
    EXPECT_EQ(program->motion(program->motionCount() - 1).end, Vec3(1, 1, 0));
}

TEST(Dialects, AreGuessedByWhatOnlyTheyRead) {
    EXPECT_EQ(guessed("G21\no<hole> sub\no<hole> endsub\nM2\n"), DialectId::linuxcnc);
    EXPECT_EQ(guessed("G21 G64 P0.02\nG1 X#<depth>\nM2\n"), DialectId::linuxcnc);
    EXPECT_EQ(guessed("%\nO1000\nG65 P9010 A1.\nM30\n%\n"), DialectId::fanuc);
    EXPECT_EQ(guessed("O1000\nN10 IF [#1 EQ 1] GOTO 20\nN20 M30\n"), DialectId::fanuc);
    EXPECT_EQ(guessed("%\nO1000\nG154 P3\nG0 X0\nM30\n%\n"), DialectId::haas);
    EXPECT_EQ(guessed("$H\nG21\nG0 X1\nM2\n"), DialectId::grbl);
    EXPECT_EQ(guessed("G21 G91.1\nG68 A0 B0 R30\nM30\n"), DialectId::mach);
    EXPECT_EQ(guessed("G21 G91.1\nM98 P100 Q2\nM30\nO100\nM99\n"), DialectId::mach);
    EXPECT_EQ(guessed("G21 G90.1\nG59 P12\nM47\n"), DialectId::mach);
    EXPECT_EQ(guessed("G21\nG59 P12\no<hole> sub\no<hole> endsub\nM2\n"), DialectId::linuxcnc);
    EXPECT_EQ(guessed("G0 X1\nM2\n"), DialectId::linuxcnc);
}

TEST(Dialects, AreNotGuessedByComments) {
    EXPECT_EQ(guessed("(G65 P9010)\nG64 P0.1 ; IF[#1 EQ 1]GOTO 5\nM2\n"), DialectId::linuxcnc);
}

TEST(Dialects, AreGuessedByThePostThatACommentNames) {
    const std::pair<const char*, DialectId> named[] = {
        {"(Created with grbl post processor 2025/12/09)", DialectId::grbl},
        {"(Post Processor: grbl_post)", DialectId::grbl},
        {"(Postprocessor Geometry: GRBL_11_no_M6)", DialectId::grbl},
        {"; grbl", DialectId::grbl},
        {"(Mach2Mill)", DialectId::mach},
        {"(POST: Mach3 mm)", DialectId::mach},
        {"(Post processor: Mach 3)", DialectId::mach},
        {"(post: Mach 4)", DialectId::mach},
        {"(post: grblHAL)", DialectId::grbl},
        {"( Gcode for linuxcnc )", DialectId::linuxcnc},
        {"(Post processor: LinuxCNC plasma.scpost)", DialectId::linuxcnc},
        {"( FANUC 0M)", DialectId::fanuc},
        {"(machine: Haas VF-2)", DialectId::haas},
        {"(Using G0 which travels along dogleg path.)", DialectId::haas},
    };
    for (const auto& [comment, dialect] : named) {
        const DialectGuess guess = guessDialect(NcText(std::string("%\n") + comment + "\nG0 X1.\nM30\n%\n"));
        EXPECT_EQ(guess.dialect, dialect) << comment;
        ASSERT_EQ(guess.reasons.size(), 1U) << comment;
        EXPECT_EQ(guess.reasons.front().line, 2) << comment;
        EXPECT_TRUE(std::string_view(comment).starts_with(guess.reasons.front().shown)) << comment;
    }
}

TEST(Dialects, AreNotGuessedByCommentsThatMentionOne) {
    for (const char* comment :
         {"( Fanuc M98 requires P-word )", "; Fanuc-style: all params are changed", "(PRINT,X FANUC)",
          "( Note: modified for compatibility with Mach3)", "(tap.ngc of grbl)", "(postamble of Machine 3)"})
        EXPECT_TRUE(guessDialect(NcText(std::string(comment) + "\nG0 X1\nM2\n")).reasons.empty()) << comment;
    // Syntax that only one control supports takes precedence over a name.
    EXPECT_EQ(guessed("(Post Processor: grbl_post)\no<a> sub\no<a> endsub\nM2\n"), DialectId::linuxcnc);
}

TEST(Dialects, GiveTheReasonsOfAGuessWithTheirLines) {
    const DialectGuess guess = guessDialect(NcText("G21\n\nN5 g65 p 9010 (drill)\nM30\n"));
    ASSERT_EQ(guess.reasons.size(), 1U);
    EXPECT_EQ(guess.reasons.front().line, 3);
    EXPECT_EQ(guess.reasons.front().shown, "G65P9010");
}

TEST(Dialects, GiveTheSignsThatMachSharesAmongItsReasons) {
    const DialectGuess guess = guessDialect(NcText("G91.1\nG68 A0 B0 R30\nM30\n"));
    ASSERT_EQ(guess.reasons.size(), 2U);
    EXPECT_EQ(guess.reasons.front().shown, "G91.1");
    EXPECT_EQ(guess.reasons.back().shown, "G68A0B0R30");
}

TEST(Dialects, NameTheErrorWithWhichGrblAnswers) {
    const std::pair<const char*, const char*> answers[] = {
        {"G0 X\n", "error:2 "},          {"G1 X1\n", "error:22 "},        {"G0 G1 X1 F1\n", "error:21 "},
        {"G81 X1 Z1 R2\n", "error:20 "}, {"G0 X1 X2\n", "error:25 "},     {"G92\n", "error:26 "},
        {"G4\n", "error:28 "},           {"G10 L2 P7 X1\n", "error:29 "}, {"G80\nX1\n", "error:31 "},
        {"G0 X1 P3\n", "error:36 "},     {"G43.1 X1\n", "error:37 "},     {"T999\n", "error:38 "}};
    for (const auto& [text, answer] : answers) {
        const auto program = readAs(DialectId::grbl, text);
        const auto names = [&](const Diagnostic& d) {
            return std::string_view(d.hint).find(answer) != std::string_view::npos && d.unverified;
        };
        EXPECT_TRUE(std::ranges::any_of(program->diagnostics(), names)) << text;
    }
}

TEST(Dialects, ReportThatTheyWereGuessedAndKeepQuietWhereTheyWereChosen) {
    InterpretOptions options;
    options.dialect.reset();
    const auto program = interpret(NcText("O1\nG65 P2\nM30\nO2\nG0 X1.\nM99\n"), options);
    EXPECT_EQ(program->dialect(), DialectId::fanuc);
    EXPECT_TRUE(reported(*program, "dialect-guessed"));
    EXPECT_EQ(interpret(NcText("G0 X1\nM2\n"), options)->dialect(), DialectId::linuxcnc);
    EXPECT_FALSE(reported(*readAs(DialectId::fanuc, "G0 X1.\nM30\n"), "dialect-guessed"));
}

TEST(DialectComparison, FindsTheLinesThatMoveOtherwise) {
    const std::string text = "G21 G90 F100\nG1 X10. Y0.\nG1 X2000\nG1 X#100 Y5.\nM30\n";
    const auto lines =
        differentLines(*readAs(DialectId::linuxcnc, text), *readAs(DialectId::fanuc, text), 100);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].line, 3U);
    EXPECT_DOUBLE_EQ(lines[0].one.front().end.x, 2000);
    EXPECT_DOUBLE_EQ(lines[0].other.front().end.x, 2);
    EXPECT_EQ(lines[1].line, 4U);
    EXPECT_DOUBLE_EQ(lines[1].one.front().end.x, 0);
    EXPECT_DOUBLE_EQ(lines[1].other.front().end.x, 2);
}

TEST(DialectComparison, IsEmptyWhereBothReadTheSame) {
    const std::string text = "G21 G90 G17\nG0 X0. Y0. Z5.\nG1 Z-1. F200.\nG2 X10. Y0. I5. J0.\nG0 Z5.\nM30\n";
    EXPECT_TRUE(
        differentLines(*readAs(DialectId::linuxcnc, text), *readAs(DialectId::fanuc, text), 100).empty());
}

TEST(DialectComparison, KeepsToItsLimit) {
    std::string text = "G21 G90 F100\n";
    for (int i = 1; i <= 50; ++i)
        text += "G1 X" + std::to_string(i) + "\n";
    EXPECT_EQ(differentLines(*readAs(DialectId::linuxcnc, text), *readAs(DialectId::fanuc, text), 7).size(),
              7U);
}

} // namespace proveout
