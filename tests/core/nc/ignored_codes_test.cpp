// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/dialects.h"
#include "core/nc/codes/ignored_codes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/codes/codes.h"
#include "core/nc/run/interpreter.h"

namespace proveout {

namespace {

std::shared_ptr<const Program> read(const std::string& text, DialectId dialect,
                                    const std::set<int>& ignored = {}) {
    InterpretOptions options;
    options.dialect = dialect;
    options.start = Vec3(0, 0, 50);
    options.lint = false;
    options.ignoredM = ignored;
    return interpret(NcText(text), options);
}

/// "line:column id sentence" of every message.
std::vector<std::string> reported(const Program& program) {
    std::vector<std::string> all;
    for (const Diagnostic& d : program.diagnostics())
        all.push_back(std::to_string(d.where.line) + ":" + std::to_string(d.where.column) + " " + d.id + " " +
                      message(d));
    return all;
}

const char* const kClamped = "G21 G90 F100\nM11\nG0 X0. Y0. Z5.\nM10\nG1 Z-1.\nX10. M11\nM10\nX20.\nM30\n";

} // namespace

TEST(IgnoredCodes, OfTheControlAreListedAndLeaveTheRestVerified) {
    const auto program = read(kClamped, DialectId::fanuc);
    EXPECT_FALSE(program->unverified());
    EXPECT_EQ(reported(*program),
              (std::vector<std::string>{
                  "4:1 code-ignored M10 (clamp of a rotary axis or pallet on) moves no axis and is ignored "
                  "(2×, lines 4, 7).",
                  "2:1 code-ignored M11 (clamp of a rotary axis or pallet off) moves no axis and is ignored "
                  "(2×, lines 2, 6)."}));
    for (const Diagnostic& d : program->diagnostics())
        EXPECT_EQ(d.severity, Severity::note);
    ASSERT_EQ(program->ignoredCodes().size(), 2U);
    EXPECT_EQ(program->ignoredCodes().at(11).lines, (std::vector<std::uint32_t>{2, 6}));
    // The axis words in the block with M11 belong to the active motion mode.
    EXPECT_EQ(program->motionCount(), 4U);
    EXPECT_EQ(program->endOf(2), Vec3(10, 0, -1));
}

TEST(IgnoredCodes, UnknownOnesStayUnverifiedAndTheHintNamesTheList) {
    const auto program = read("G0 X1.\nM16\nG1 X2. F100\nM30\n", DialectId::fanuc);
    EXPECT_TRUE(program->unverified());
    ASSERT_EQ(program->diagnostics().size(), 1U);
    const Diagnostic& problem = program->diagnostics().front();
    EXPECT_STREQ(problem.id, "code-unknown");
    EXPECT_NE(std::string(problem.hint).find("ignored M codes"), std::string::npos);
    EXPECT_EQ(unknownMCode(problem), 16);
}

TEST(IgnoredCodes, OfTheListAreIgnoredOnEveryControl) {
    for (const Dialect& row : dialects()) {
        const auto program = read("G21 G90\nG0 X1.\nM163 P2\nG1 X2. F100\nM2\n", row.id, {163});
        EXPECT_FALSE(program->unverified()) << row.key;
        EXPECT_EQ(program->motionCount(), 2U) << row.key;
        EXPECT_EQ(reported(*program),
                  (std::vector<std::string>{"3:1 code-ignored M163 is ignored because the setup lists it "
                                            "(1×, line 3)."}))
            << row.key;
    }
}

TEST(IgnoredCodes, AreNotThoseWithAKnownEffect) {
    const auto program = read("T1 M6\nM98 P2\nM30\nO2\nG0 X1.\nM99\n", DialectId::fanuc, {6, 98, 30});
    EXPECT_EQ(program->motionCount(), 1U);
    EXPECT_TRUE(program->ignoredCodes().empty());
    EXPECT_EQ(std::ranges::count_if(
                  program->diagnostics(),
                  [](const Diagnostic& d) { return std::string_view(d.id) == "ignored-code-executed"; }),
              3);
    // A call of a program in the control's memory is known to cause motion: no list makes it harmless.
    EXPECT_TRUE(read("M198 P2\nM30\n", DialectId::fanuc, {198})->unverified());
}

TEST(IgnoredCodes, OfTheTablesDoNothingToSpindleToolOrProgram) {
    const std::set<int> effect{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 19, 29, 30, 97, 98, 99, 198};
    for (const Dialect& dialect : dialects()) {
        for (const CodeRow* row : codesOf(dialect.id).rows()) {
            if (!row->ignored)
                continue;
            EXPECT_TRUE(row->letter == 'M' && row->handler == nullptr && row->tenths % 10 == 0 &&
                        !effect.contains(row->tenths / 10))
                << dialect.key << " M" << row->tenths;
        }
    }
    // On a Haas, M16 changes the tool.
    EXPECT_EQ(codesOf(DialectId::haas).find('M', 160)->group, ModalGroup::toolChange);
}

TEST(IgnoredCodes, CountWhatIsRepeatedOnce) {
    std::string text;
    for (int i = 0; i < 12; ++i)
        text += "M10\n";
    const auto program = read(text + "G0 X1.\nM30\n", DialectId::fanuc);
    ASSERT_EQ(program->diagnostics().size(), 1U);
    EXPECT_NE(message(program->diagnostics().front()).find("(12×, lines 1, 2, 3, 4, 5, 6, 7, 8 …)"),
              std::string::npos)
        << message(program->diagnostics().front());
}

TEST(MCodeList, IsReadAsPeopleWriteIt) {
    EXPECT_EQ(parseMCodes("10, 11,16"), (std::set<int>{10, 11, 16}));
    EXPECT_EQ(parseMCodes(" m24;M025\t7 "), (std::set<int>{7, 24, 25}));
    EXPECT_EQ(parseMCodes(""), std::set<int>());
    EXPECT_EQ(formatMCodes({16, 10, 11}), "10, 11, 16");
    for (const char* bad : {"G10", "10.5", "-1", "100000", "M", "10 x", "99999999999999"}) {
        const auto codes = parseMCodes(bad);
        ASSERT_FALSE(codes) << bad;
        EXPECT_STREQ(codes.error().front().id, "m-code-list");
    }
}

/// One message per mistake: the position that is lost because of it causes no second one.
TEST(LostPosition, IsNotReportedOnceMoreBehindAnError) {
    const char* const after = "\nG1 X10. F100\nX20. Y5.\nZ-1.\nM30\n";
    for (const char* wrong : {"X5. Y5. Z", "G1 X1.2.3 Y5. Z1. F100", "G1 G0 X5. Y5. Z1. F100",
                              "G777 X5. Y5. Z5.", "X5. Y5. Z5. (open", "G1 X5. Y#[1 Z5."}) {
        const auto program =
            read(std::string("G21 G90 G17\nG0 X0. Y0. Z5.\n") + wrong + after, DialectId::linuxcnc);
        EXPECT_EQ(program->diagnostics().size(), 1U) << wrong << "\n" << reported(*program).back();
        EXPECT_TRUE(program->unverified()) << wrong;
        // A motion from an unknown position still cuts nothing.
        EXPECT_NE(program->motion(1).startKnown, kAllAxes) << wrong;
    }
}

/// The simulation reports the missing tool, so its empty offsets cause no second message.
TEST(MissingTool, IsNotReportedOnceMoreByItsRegisters) {
    const auto ids = [](const std::string& block) {
        InterpretOptions options;
        options.dialect = DialectId::fanuc;
        options.start = Vec3(0, 0, 50);
        options.lint = false;
        options.tools = ToolOffsets(std::map<int, ToolOffset>{{1, {Vec3(0, 0, 100), 10}}});
        const auto program = interpret(NcText("G21 G90 F100\nT4 M6\n" + block + "\nG40\nM30\n"), options);
        std::string all;
        for (const Diagnostic& diagnostic : program->diagnostics())
            all += std::string(diagnostic.id) + " ";
        return all;
    };
    EXPECT_EQ(ids("G43 H4 Z5."), "");
    EXPECT_EQ(ids("G1 G41 D4 X10. Y0. Z5.\nY10."), "");
    EXPECT_EQ(ids("G43 H5 Z5."), "register-unknown ");
}

TEST(LostPosition, IsReportedWhereNothingElseSaysSo) {
    InterpretOptions options;
    options.lint = false;
    const auto program = interpret(NcText("G1 X5 F100\nX6\nM2\n"), options);
    ASSERT_FALSE(program->diagnostics().empty());
    EXPECT_STREQ(program->diagnostics().front().id, "start-unknown");
    EXPECT_TRUE(program->unverified());
}

} // namespace proveout
