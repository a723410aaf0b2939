// SPDX-License-Identifier: GPL-3.0-or-later
// Program faults caused by the control, the operator or the disk, by their numbers in the list of guarantees.
// The tests assert the work done: lines, motions, messages. They assert times only where a program used to
// hang.
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <stop_token>
#include <string>
#include <vector>

#include "core/nc/run/interpreter.h"
#include "tests/core/temporary_folder.h"

namespace proveout::test {

namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::size_t kMostLines = 1'000'000;
constexpr std::size_t kMostMotions = 200'000;
constexpr double kHangs = 60; ///< seconds; much longer than any of these takes on any machine

InterpretOptions optionsFor(DialectId dialect) {
    InterpretOptions options;
    options.dialect = dialect;
    options.assumeStartAtZero = true;
    options.lint = false;
    options.maxRepeated = options.maxIdle = kMostLines;
    options.maxMotions = kMostMotions;
    return options;
}

bool finite(const Vec3& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

/// Checks what must hold whatever the fault in the program.
std::shared_ptr<const Program> soundly(const std::string& text, const InterpretOptions& options,
                                       const WorkContext& context = {}) {
    const auto begin = std::chrono::steady_clock::now();
    auto program = interpret(NcText(text), options, context);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(taken.count(), kHangs);
    EXPECT_LE(program->diagnostics().size(), 105U);
    EXPECT_LE(program->motionCount(), kMostMotions + 1000);
    for (std::size_t i = 0; i < program->motionCount(); ++i) {
        const Motion motion = program->motion(i);
        EXPECT_TRUE(finite(motion.start) && finite(motion.end) && finite(motion.centre)) << i;
        EXPECT_TRUE(std::isfinite(motion.feedMmPerMin) && std::isfinite(motion.sweep)) << i;
    }
    return program;
}

std::shared_ptr<const Program> readAs(const std::string& text, DialectId dialect = DialectId::linuxcnc) {
    return soundly(text, optionsFor(dialect));
}

/// Messages as "line:column id", in sequence.
std::vector<std::string> reported(const Diagnostics& diagnostics) {
    std::vector<std::string> messages;
    for (const Diagnostic& d : diagnostics)
        messages.push_back(fmt::format("{}:{} {}", d.where.line, d.where.column, d.id));
    return messages;
}

std::vector<std::string> reported(const std::string& text, DialectId dialect = DialectId::linuxcnc) {
    return reported(readAs(text, dialect)->diagnostics());
}

/// The sentence of the first message with an id.
std::string sentence(const Program& program, std::string_view id) {
    for (const Diagnostic& d : program.diagnostics()) {
        if (d.id == id)
            return message(d);
    }
    return {};
}

std::string sentence(const std::string& text, std::string_view id, DialectId dialect = DialectId::linuxcnc) {
    return sentence(*readAs(text, dialect), id);
}

/// The messages from loading a file with these bytes; empty if it is read.
std::vector<std::string> reportedByLoading(const std::string& bytes) {
    const TemporaryFolder folder;
    folder.put("p.nc", bytes);
    const auto text = NcText::load(folder / "p.nc");
    return text ? std::vector<std::string>{} : reported(text.error());
}

std::string repeated(const std::string& part, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
        text += part;
    return text;
}

} // namespace

TEST(Reliability, Fault01EmptyAndPercentOnly) {
    for (const std::string text : {"", "%\n%\n"}) {
        const auto program = readAs(text);
        EXPECT_EQ(program->motionCount(), 0U);
        EXPECT_TRUE(program->unverified()); // exit code 2
        ASSERT_THAT(program->diagnostics(), SizeIs(1));
        EXPECT_STREQ(program->diagnostics().front().id, "no-motion");
        EXPECT_EQ(program->diagnostics().front().severity, Severity::warning);
    }
}

TEST(Reliability, Fault02BinaryFiles) {
    std::mt19937 random(2);
    std::string noise;
    for (int i = 0; i < 65536; ++i)
        noise.push_back(static_cast<char>(random() & 0xff));
    for (const std::string& bytes :
         {std::string(1024, '\0'), noise, std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)})
        EXPECT_THAT(reportedByLoading(bytes), ElementsAre("0:0 nc-binary"));
}

TEST(Reliability, Fault03ByteOrderMarksAndUtf16) {
    EXPECT_THAT(reported("\xef\xbb\xbfG0 X1\nM2\n"), ElementsAre("1:1 byte-order-mark"));
    EXPECT_EQ(readAs("\xef\xbb\xbfG0 X1\nM2\n")->motionCount(), 1U);
    EXPECT_THAT(reportedByLoading(std::string("\xff\xfeG\0000\0 \0X\0001\0", 12)),
                ElementsAre("0:0 nc-encoding"));
}

TEST(Reliability, Fault04LineEnds) {
    const auto old = readAs("G0 X1\rG0 X2\rM2\r");
    EXPECT_EQ(old->motionCount(), 2U);
    EXPECT_EQ(old->motion(1).line, 2U);
    EXPECT_THAT(reported(old->diagnostics()), ElementsAre("1:6 cr-line-end"));
    const auto mixed = readAs("G0 X1\r\nG0 X2\n\rG0 X3");
    EXPECT_EQ(mixed->motionCount(), 3U);
    EXPECT_EQ(mixed->motion(2).line, 4U);
    EXPECT_EQ(readAs("G0 X1\nG0 X7")->motion(1).end.x, 7); // without a final newline
}

TEST(Reliability, Fault05ControlZAndDcCodes) {
    EXPECT_THAT(reported("G0 X1\nM2\n\x1a"), IsEmpty());
    const auto program = readAs("\x11\x12G0 X1\n\x13G0 X2\n\x14M2\n");
    EXPECT_EQ(program->motionCount(), 2U);
    EXPECT_THAT(reported(program->diagnostics()), ElementsAre("1:2 control-code"));
    EXPECT_FALSE(program->unverified());
}

TEST(Reliability, Fault06CommentsInAnyEncoding) {
    for (const std::string comment : {"caf\xe9", "H\xc3\xb6he", "\xff\xfe\x80", "\xe2\x80\xae rtl"}) {
        const auto program = readAs("G0 X1 (" + comment + ")\nM2\n");
        EXPECT_EQ(program->motionCount(), 1U);
        EXPECT_THAT(program->diagnostics(), IsEmpty());
    }
}

TEST(Reliability, Fault07NumbersOutsideOfAscii) {
    for (const std::string word : {"X\xe2\x88\x92"
                                   "10",
                                   "X\xef\xbc\x91\xef\xbc\x90"}) { // minus sign, wide digits
        const auto program = readAs("G0 " + word + "\nM2\n");
        EXPECT_EQ(program->motionCount(), 0U);
        EXPECT_THAT(reported(program->diagnostics()), Contains("1:5 bad-character"));
    }
}

TEST(Reliability, Fault08LongLines) {
    const auto blanks = readAs("G0 X1" + std::string(100'000, ' ') + "Y2\nM2\n");
    EXPECT_EQ(blanks->motionCount(), 1U);
    EXPECT_THAT(reported(blanks->diagnostics()), ElementsAre("1:253 line-long"));
    const auto digits = readAs("G0 X" + std::string(1'000'000, '7') + "\nM2\n");
    EXPECT_EQ(digits->motionCount(), 0U);
    EXPECT_THAT(reported(digits->diagnostics()), Contains("1:4 number-out-of-range"));
}

TEST(Reliability, Fault09NumbersOutOfRange) {
    EXPECT_THAT(reported("G0 X1" + std::string(308, '0') + "\nM2\n"), Contains("1:4 number-out-of-range"));
    for (const std::string word : {"Xnan", "Xinf", "X-inf"})
        EXPECT_EQ(readAs("G0 " + word + "\nM2\n")->motionCount(), 0U) << word;
    // An exponent is read as the word E, which is not used.
    const auto program = readAs("G0 X1e5\nM2\n");
    EXPECT_EQ(program->motionCount(), 0U);
    EXPECT_TRUE(program->unverified());
    EXPECT_THAT(reported("G0 X[10**400]\nM2\n"), Contains(HasSubstr("1:")));
}

TEST(Reliability, Fault10NumbersThatAreNone) {
    EXPECT_THAT(reported("G0 X--1\nM2\n"), Contains(HasSubstr("number-double-sign")));
    EXPECT_THAT(reported("G0 X1.2.3\nM2\n"), Contains("1:8 number-two-points"));
    for (const std::string word : {"X", "X-", "X.", "X+", "X-."})
        EXPECT_THAT(reported("G0 " + word + "\nM2\n"), Contains(HasSubstr("number-missing"))) << word;
}

TEST(Reliability, Fault11NestedTooDeep) {
    const std::string brackets = repeated("[", 10'000) + "1" + repeated("]", 10'000);
    const std::string functions = repeated("SIN[", 10'000) + "1" + repeated("]", 10'000);
    for (const std::string& value :
         {brackets, functions, repeated("#", 10'000) + "1", repeated("[-", 10'000) + "1"})
        EXPECT_THAT(reported("G0 X" + value + "\nM2\n"), Contains(HasSubstr("nested-too-deep")))
            << value.substr(0, 5);
}

TEST(Reliability, Fault12ExpressionsWithoutAResult) {
    const auto messages = reported(
        "G0 X[1/0]\nX[SQRT[0-1]]\nX[LN[0]]\nX[ACOS[2]]\nX[ASIN[0-2]]\nX[[0-1]**0.5]\nX[5 MOD 0]\nM2\n");
    for (int line = 1; line <= 7; ++line)
        EXPECT_THAT(messages, Contains(testing::MatchesRegex(fmt::format("{}:[1-9][0-9]* no-result", line))));
}

TEST(Reliability, Fault13LimitsOfParameters) {
    for (const std::string name : {"#0", "#5602", "#99999999", "#-1"})
        EXPECT_THAT(reported(name + "=1\nM2\n"), Contains("1:2 parameter-number")) << name;
    EXPECT_THAT(reported("#1.5=1\nM2\n"), Contains("1:2 parameter-not-whole"));
    EXPECT_THAT(sentence("#<" + std::string(5000, 'a') + ">=1\nM2\n", "name-long"), HasSubstr("256"));
    std::string many;
    for (int i = 0; i < 100'200; ++i)
        many += fmt::format("#<n{}>=1\n", i);
    const auto program = readAs(many + "M2\n");
    EXPECT_THAT(sentence(*program, "names-too-many"), HasSubstr("100000"));
    EXPECT_THAT(program->diagnostics(), SizeIs(testing::Le(101U)));
}

TEST(Reliability, Fault14BlockNumbers) {
    EXPECT_THAT(reported("N" + std::string(40, '9') + " G0 X1\nN-5 G0 X2\nM2\n"),
                ElementsAre("1:1 n-long", "2:1 n-negative"));
    EXPECT_THAT(reported("O1\nG0 X1.\nGOTO 7\nN7 X2.\nN7 X3.\nM30\n", DialectId::fanuc),
                ElementsAre("3:1 block-twice"));
    EXPECT_THAT(reported("N7 G0 X1\nN7 X2\nM2\n"), IsEmpty()); // labels only
}

TEST(Reliability, Fault15Comments) {
    for (const DialectId dialect :
         {DialectId::linuxcnc, DialectId::fanuc, DialectId::grbl, DialectId::mach}) {
        const auto program = readAs("G0 X1.\nY1. (open X2.\nM2\n", dialect);
        EXPECT_THAT(reported(program->diagnostics()), Contains("2:5 comment-unclosed"));
        EXPECT_TRUE(program->unverified());
    }
    EXPECT_THAT(reported("G0 X1\n(a (b) c) X2\nM2\n"), ElementsAre("2:4 comment-nested"));
    EXPECT_THAT(reported("G0 X1.\n(a (b) c) X2.\nM30\n", DialectId::fanuc),
                ElementsAre("2:9 number-missing"));
}

TEST(Reliability, Fault16ContradictionsWithinABlock) {
    EXPECT_THAT(reported("G0 G1 X1 F1\nM2\n"), Contains("1:4 modal-conflict"));
    EXPECT_THAT(reported("G0 G1 X1. F1\nM30\n", DialectId::fanuc), Contains("1:4 last-counts"));
    EXPECT_THAT(reported("G0 X1 X2\nM2\n"), Contains("1:7 word-twice"));
    EXPECT_THAT(reported("G0 X1. X2.\nM30\n", DialectId::fanuc), Contains(HasSubstr("last-word-counts")));
    EXPECT_THAT(reported("S100 M3 M8 M48 M1 T1 M6\nM2\n"), Contains(HasSubstr("too-many-m")));
    EXPECT_THAT(reported("S100 M3 M8 M1 M6\nM30\n", DialectId::fanuc), Contains(HasSubstr("too-many-m")));
}

TEST(Reliability, Fault17WhatIsNotKnownIsNeverIgnored) {
    for (const std::string line :
         {"G777 X1", "G68 X0 Y0 R30", "G0 A90", "M777", "G0 X1 B5", "G1 X1 C5 F1", "G100"}) {
        const auto program = readAs("G0 X0 Y0\n" + line + "\nG0 X9\nM2\n");
        EXPECT_TRUE(program->unverified()) << line;
        EXPECT_THAT(reported(program->diagnostics()), Contains(testing::StartsWith("2:"))) << line;
    }
}

TEST(Reliability, Fault18ArcsThatDoNotFit) {
    const std::string head = "G21 F100 G0 X0 Y0\n";
    EXPECT_THAT(reported(head + "G2 X10 Y0\nM2\n"), ElementsAre("2:1 arc-no-centre"));
    EXPECT_THAT(sentence(head + "G2 X10 Y0 R4\nM2\n", "arc-radius-small"),
                testing::AllOf(HasSubstr("4 mm"), HasSubstr("10 mm"), HasSubstr("2 mm")));
    EXPECT_THAT(sentence(head + "G2 X10 Y0 I6\nM2\n", "arc-ends-differ"),
                testing::AllOf(HasSubstr("6 mm"), HasSubstr("4 mm"), HasSubstr("2 mm")));
    EXPECT_THAT(sentence(head + "G2 X0 Y0 I0 J0\nM2\n", "arc-zero-radius"), HasSubstr("0 mm"));
}

TEST(Reliability, Fault19ArcOfManyTurns) {
    const auto program = readAs("F100 G0 X0 Y0\nG2 X0 Y0 I5 P1000000000\nM2\n");
    EXPECT_EQ(program->motionCount(), 1U);
    EXPECT_THAT(sentence(*program, "arc-turns"), HasSubstr("1000"));
}

TEST(Reliability, Fault20ArcAboutAFarCentre) {
    const auto program = readAs("F100 G0 X0 Y0\nG2 X10 Y0 I5 J-1000000000000\nM2\n");
    ASSERT_EQ(program->motionCount(), 2U);
    EXPECT_EQ(program->motion(1).kind, MotionKind::feed); // straight within a nanometre
    EXPECT_THAT(reported("F100 G0 X0 Y0\nG2 X0 Y0 I1000000000000\nM2\n"), ElementsAre("2:1 arc-too-large"));
}

TEST(Reliability, Fault21PecksOfNoDepth) {
    EXPECT_THAT(reported("F100 G0 X0 Y0 Z5\nG83 X1 Y1 Z-10 R1 Q0\nG80\nM2\n"),
                Contains(HasSubstr("cycle-peck")));
    const auto program = readAs("F100 G0 X0 Y0 Z5\nG83 X1 Y1 Z-10 R1 Q0.0000001\nG80\nM2\n");
    EXPECT_THAT(sentence(*program, "block-too-long"),
                testing::AllOf(HasSubstr("3300000"), HasSubstr("100000")));
    EXPECT_EQ(program->motionCount(), 1U);
}

TEST(Reliability, Fault22ManyRepeats) {
    const auto cycle = readAs("F100 G0 X0 Y0 Z5\nG91 G81 X1 Z-2 R-1 L999999999\nG80\nM2\n");
    EXPECT_THAT(sentence(*cycle, "block-too-long"), HasSubstr("3999999996"));
    EXPECT_EQ(cycle->motionCount(), 1U);
    for (const DialectId dialect : {DialectId::linuxcnc, DialectId::mach}) {
        const auto calls = readAs("M98 P2 L999999999\nM2\nO2\n#1=1\nM99\n", dialect);
        EXPECT_THAT(sentence(*calls, "too-many-rounds"), HasSubstr("1000000"));
    }
    std::stop_source stop;
    stop.request_stop();
    WorkContext context;
    context.stop = stop.get_token();
    const auto stopped =
        soundly("M98 P2 L999999999\nM2\nO2\n#1=1\nM99\n", optionsFor(DialectId::linuxcnc), context);
    EXPECT_NE(sentence(*stopped, "interpretation-stopped"), "");
}

TEST(Reliability, Fault23LoopOfManyRounds) {
    EXPECT_THAT(sentence("o1 repeat [1000000000000]\n#1=1\no1 endrepeat\nM2\n", "too-many-rounds"),
                HasSubstr("1000000000000"));
    EXPECT_THAT(sentence("o1 repeat [1000]\no2 repeat [1000]\n#1=1\no2 endrepeat\no1 endrepeat\nM2\n",
                         "too-many-steps"),
                HasSubstr(std::to_string(kMostLines)));
}

TEST(Reliability, Fault24LoopsWithoutAnEnd) {
    EXPECT_THAT(
        sentence("#1=0\nWHILE [1 EQ 1] DO 1\n#1=#1+1\nEND 1\nM30\n", "loop-without-motion", DialectId::fanuc),
        testing::ContainsRegex("line [234]\\."));
    EXPECT_THAT(sentence("o1 while [1]\n#1=1\no1 endwhile\nM2\n", "endless-loop"),
                HasSubstr("line 3 jumps back to line 1"));
    EXPECT_THAT(sentence("O1\nN1 #1=1\nGOTO 1\nM30\n", "endless-loop", DialectId::fanuc),
                HasSubstr("line 3 jumps back to line 2"));
}

TEST(Reliability, Fault25CallsWithoutAnEnd) {
    EXPECT_THAT(sentence("O1\nM98 P1\nM30\n", "call-too-deep", DialectId::fanuc), HasSubstr("1 > 1 > 1"));
    EXPECT_THAT(
        sentence("O1\nM98 P2\nM30\nO2\nM98 P3\nM99\nO3\nM98 P2\nM99\n", "call-too-deep", DialectId::fanuc),
        HasSubstr("2 > 3 > 2 > 3"));
    EXPECT_THAT(sentence("o7 sub\no7 call\no7 endsub\no7 call\nM2\n", "call-too-deep"),
                HasSubstr("7 > 7 > 7"));
}

TEST(Reliability, Fault26CallsThatDouble) {
    const auto program = readAs("o1 sub\n#1=[#1-1]\no2 if [#1 GT 0]\no1 call [#1]\no1 call [#1]\no2 endif\n"
                                "o1 endsub\no1 call [60]\nM2\n");
    EXPECT_TRUE(program->unverified());
    EXPECT_EQ(program->motionCount(), 0U);
    EXPECT_THAT(program->diagnostics(), SizeIs(testing::Le(105U)));
}

TEST(Reliability, Fault27FilesOutsideOfTheFolder) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "programs");
    folder.put("secret.ngc", "o<secret> sub\nG0 X99\no<secret> endsub\n");
    fs::create_symlink(folder / "secret.ngc", folder / "programs" / "secret.ngc");
    InterpretOptions options = optionsFor(DialectId::linuxcnc);
    options.subprogramFolders = {folder / "programs"};
    for (const std::string name : {"../secret", "/etc/passwd", "/dev/zero", "/dev/stdin", "secret"}) {
        const auto program = soundly("o<" + name + "> call\nM2\n", options);
        EXPECT_EQ(program->motionCount(), 0U) << name;
        EXPECT_THAT(sentence(*program, "sub-folder"), HasSubstr(name)) << name;
    }
}

TEST(Reliability, Fault28LogFilesAreNotWritten) {
    const TemporaryFolder folder;
    const std::string file = (folder / "log.txt").string();
    readAs("(LOGOPEN," + file + ")\n(LOG,hello)\n(LOGAPPEND," + file + ")\n(LOGCLOSE)\n(PROBEOPEN " + file +
           ")\nG0 X1\nM2\n");
    EXPECT_EQ(folder.entries(), 0U);
}

TEST(Reliability, Fault29PartnersThatAreMissing) {
    EXPECT_THAT(sentence("M98 P4711\nM2\n", "sub-unknown"), HasSubstr("4711"));
    EXPECT_THAT(sentence("GOTO 4711\nM30\n", "block-unknown", DialectId::fanuc), HasSubstr("N4711"));
    EXPECT_THAT(sentence("#1=1\nEND 3\nM30\n", "loop-partner", DialectId::fanuc), HasSubstr("DO"));
    EXPECT_THAT(sentence("WHILE [1 EQ 1] DO 1\nWHILE [1 EQ 1] DO 2\nEND 1\nEND 2\nM30\n", "loop-partner",
                         DialectId::fanuc),
                HasSubstr("END"));
    EXPECT_THAT(sentence("o1 endwhile\nM2\n", "flow-partner"), HasSubstr("while"));
    EXPECT_THAT(sentence("o2 else\nM2\n", "flow-partner"), HasSubstr("endif"));
    EXPECT_THAT(sentence("o4 if [1]\nM2\n", "flow-partner"), HasSubstr("endif"));
}

TEST(Reliability, Fault30CompensationThatGouges) {
    const std::string head = "F100 G0 X0 Y-20\n";
    const auto corner = readAs(head + "G41.1 D10 G1 X20 Y0\nY20\nX15\nY-20\nG40 G0 X99\nM2\n");
    EXPECT_TRUE(corner->unverified());
    EXPECT_THAT(reported(corner->diagnostics()),
                Contains(testing::ContainsRegex("[45]:[0-9]+ compensation-")));
    const auto end = readAs(head + "G41.1 D4 G1 X20 Y0\nY20\nM2\n");
    EXPECT_THAT(reported(end->diagnostics()), Contains(HasSubstr("compensation-at-end")));
    EXPECT_EQ(end->motion(end->motionCount() - 1).end.y, 20); // the last motion is there
    EXPECT_THAT(reported("F100 G0 X0 Y0\nG41.1 D4\nG3 X3 Y0 I1.5\nM2\n"),
                Contains(testing::StartsWith("3:")));
}

TEST(Reliability, Fault31FeedsThatAreNone) {
    for (const std::string line : {"G1 X1", "G93 G1 X1", "G95 F0.1 G1 X1", "G1 X1 F0"}) {
        const auto program = readAs(line + "\nM2\n");
        EXPECT_TRUE(program->unverified()) << line;
        for (std::size_t i = 0; i < program->motionCount(); ++i)
            EXPECT_EQ(program->motion(i).feedMmPerMin, 0) << line; // no default feed rate
    }
    EXPECT_THAT(reported("G1 X1 F-5\nM2\n"), Contains("1:7 number-negative"));
    EXPECT_THAT(reported("G95 F0.1 G1 X1\nM2\n"), Contains(HasSubstr("feed-without-spindle")));
    EXPECT_THAT(reported("G93 G1 X1\nM2\n"), Contains(HasSubstr("inverse-time-feed")));
}

TEST(Reliability, Fault32ToolsThatAreNotThere) {
    InterpretOptions options = optionsFor(DialectId::linuxcnc);
    options.tools = ToolOffsets(std::map<int, ToolOffset>{{1, {}}});
    options.lint = true;
    const auto program = soundly("G21 T777\nG43 H888\nG0 X1\nM2\n", options);
    EXPECT_TRUE(program->unverified());
    EXPECT_THAT(
        reported(program->diagnostics()),
        testing::IsSupersetOf({std::string("2:5 offset-unknown"), std::string("1:5 tool-not-in-table")}));
    for (const std::string word : {"T1.5", "T-1", "T100000000000"})
        EXPECT_THAT(reported(word + " M6\nG0 X1\nM2\n"), Contains(HasSubstr("1:1 number-not-integer")))
            << word;
}

TEST(Reliability, Fault33MotionsOfAlmostNoLength) {
    std::string text = "F100 G0 X0 Y0\nG91\n";
    for (int i = 0; i < 20'000; ++i)
        text += "G1 X0.000000000001\n";
    const auto program = readAs(text + "M2\n");
    EXPECT_EQ(program->motionCount(), 20'001U);
    EXPECT_NEAR(program->motion(20'000).end.x, 2e-8, 1e-12);
    EXPECT_THAT(program->diagnostics(), IsEmpty());
    EXPECT_THAT(reported("F100 G0 X0 Y0\nG2 X0 Y0 I0.0000001\nM2\n"), Contains(HasSubstr("arc-zero-radius")));
}

TEST(Reliability, Fault34PartsOfAThousandKilometres) {
    const auto program = readAs("G21 F1000 G0 X0 Y0 Z5\nG1 X1000000000\nG1 Z-1\nG1 X0 Y1000000000\nM2\n");
    EXPECT_EQ(program->motionCount(), 4U);
    EXPECT_EQ(program->motion(3).end, Vec3(0, 1e9, -1));
    EXPECT_FALSE(program->unverified()); // the simulation refuses its size: fault 34 of the command line
}

TEST(Reliability, Fault35ManyLines) {
    constexpr std::size_t kLines = 150'000;
    std::string text = "G21 F1000 G0 X0 Y0 Z5\n";
    for (std::size_t i = 1; i < kLines; ++i)
        text += fmt::format("G1 X{} Y{}\n", i % 977, i % 13);
    EXPECT_EQ(readAs(text + "M2\n")->motionCount(), kLines);
    // A stop request during interpretation takes effect at the next check, some thousand lines later.
    std::stop_source stop;
    WorkContext context;
    context.stop = stop.get_token();
    context.progress = [&](double part) {
        if (part > 0)
            stop.request_stop();
    };
    const auto stopped = soundly(text, optionsFor(DialectId::linuxcnc), context);
    EXPECT_LT(stopped->motionCount(), kLines / 2 + 2000);
    EXPECT_NE(sentence(*stopped, "interpretation-stopped"), "");
    EXPECT_TRUE(stopped->unverified());
}

TEST(Reliability, Fault36FilesThatChangeWhileOpen) {
    const TemporaryFolder folder;
    folder.put("p.nc", "G0 X1\nG0 X2\nM2\n");
    const auto text = NcText::load(folder / "p.nc");
    ASSERT_TRUE(text);
    folder.put("p.nc", "G0");
    EXPECT_EQ(interpret(*text, optionsFor(DialectId::linuxcnc))->motionCount(), 2U);
    fs::remove(folder / "p.nc");
    EXPECT_EQ(interpret(*text, optionsFor(DialectId::linuxcnc))->motionCount(), 2U);
}

} // namespace proveout::test
