// SPDX-License-Identifier: GPL-3.0-or-later
// Subprograms in files, limits, and what is reported if the flow of a program leads nowhere.
#include <chrono>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <stop_token>
#include <string>
#include <thread>

#include "core/nc/run/interpreter.h"
#include "tests/core/temporary_folder.h"

namespace proveout {

namespace {

std::string reportedBy(const std::string& text, const InterpretOptions& options = {}) {
    std::string reported;
    const auto program = interpret(NcText(text), options);
    for (const Diagnostic& diagnostic : program->diagnostics()) {
        if (diagnostic.severity == Severity::error)
            reported += std::to_string(diagnostic.where.line) + ":" +
                        std::to_string(diagnostic.where.column) + " " + diagnostic.id + "\n";
    }
    return reported;
}

InterpretOptions withFolder(const std::filesystem::path& folder) {
    InterpretOptions options;
    options.file = "main.ngc";
    options.assumeStartAtZero = true;
    options.subprogramFolders = {folder};
    return options;
}

} // namespace

TEST(ControlFlow, RunsSubprogramsOfTheirOwnFiles) {
    const TemporaryFolder folder;
    folder.put("step.ngc", "o<step> sub\nG91 G1 X#1\nG90\no<step> endsub\n");
    const auto program =
        interpret(NcText("F100\nG1 X1\no<Step> call [5]\no<step> call [7]\nM2\n"), withFolder(folder.path()));
    EXPECT_TRUE(program->diagnostics().empty());
    ASSERT_EQ(program->motionCount(), 3U);
    EXPECT_EQ(program->motion(2).end.x, 13);
    // A motion of such a file is attributed to the line that called it.
    EXPECT_EQ(program->motion(1).line, 3U);
    EXPECT_EQ(program->motion(2).line, 4U);
}

/// As in LinuxCNC: after other words or a comment, M98 is an unknown code.
TEST(ControlFlow, CallsByNumberAtTheBeginningOfABlockOnly) {
    const std::string sub = "\nM2\nO102\nG1 X3\nM99\n";
    EXPECT_EQ(reportedBy("F100\nN5 M98 P102 L2" + sub), "");
    EXPECT_EQ(reportedBy("F100\n/ M98 L2 P102 (twice)" + sub), "");
    EXPECT_EQ(reportedBy("F100\nL2 M98 P102" + sub), "2:4 call-not-first\n");
    EXPECT_EQ(reportedBy("F100\n(once) M98 P102" + sub), "2:8 call-not-first\n");
}

TEST(ControlFlow, ReturnsByABlockOfItsOwnOnly) {
    const std::string main = "F100\nM98 P102\nM2\nO102\n";
    EXPECT_EQ(reportedBy(main + "G1 X3\nN9 M99 (back)\n"), "");
    EXPECT_EQ(reportedBy(main + "G1 X3 M99\n"), "5:7 return-not-alone\n");
    EXPECT_EQ(reportedBy(main + "G1 X3\nM99 M8\n"), "6:1 return-not-alone\n");
    EXPECT_EQ(reportedBy(main + "G1 X3\n(back) M99\n"), "6:8 return-not-alone\n");
    EXPECT_EQ(reportedBy("G91 F100\nG1 X3\nG90 M99\n"), "");
}

/// LinuxCNC finds the break when it searches for the end of the loop, whether or not it was executed.
TEST(ControlFlow, RefusesABreakOfARepeatWhereTheLoopEnds) {
    const std::string loop = "o1 if [0]\no9 break\no1 endif\nG1 X3\no9 endrepeat\nM2\n";
    EXPECT_EQ(reportedBy("F100\no9 repeat [2]\n" + loop), "4:1 flow-partner\n");
    EXPECT_EQ(reportedBy("F100\no9 repeat [0]\n" + loop), "4:1 flow-partner\n");
    const auto program = interpret(NcText("F100\no9 repeat [2]\n" + loop));
    EXPECT_EQ(program->motionCount(), 2U);
}

TEST(ControlFlow, NamesTheFileOfAMessage) {
    const TemporaryFolder folder;
    folder.put("bad.ngc", "o<bad> sub\nG1 X[1/0]\no<bad> endsub\n");
    const auto program =
        interpret(NcText("F100\no<bad> call\nG1 X2 Z[1/0]\nM2\n"), withFolder(folder.path()));
    ASSERT_GE(program->diagnostics().size(), 2U);
    EXPECT_EQ(program->diagnostics()[0].file, (folder / "bad.ngc").string());
    EXPECT_EQ(program->diagnostics()[0].where.line, 2);
    EXPECT_EQ(program->diagnostics()[1].file, "main.ngc");
    EXPECT_EQ(program->diagnostics()[1].where.line, 3);
}

TEST(ControlFlow, OpensNothingOutsideOfItsFolders) {
    const TemporaryFolder outside;
    outside.put("out.ngc", "o<out> sub\nG0 X1\no<out> endsub\no<link> sub\no<link> endsub\n");
    const TemporaryFolder folder;
    std::filesystem::create_symlink(outside / "out.ngc", folder / "link.ngc");
    std::filesystem::create_directory(folder / "folder.ngc");
    const std::string up = "../" + outside.path().filename().string() + "/out";
    const InterpretOptions options = withFolder(folder.path());
    EXPECT_EQ(reportedBy("o<" + up + "> call\nM2\n", options), "1:1 sub-folder\n");
    EXPECT_EQ(reportedBy("o<" + (outside / "out").string() + "> call\nM2\n", options), "1:1 sub-folder\n");
    EXPECT_EQ(reportedBy("o<link> call\nM2\n", options), "1:1 sub-folder\n");
    EXPECT_EQ(reportedBy("o<folder> call\nM2\n", options), "1:1 sub-unknown\n");
    EXPECT_EQ(reportedBy("o<none> call\nM2\n"), "1:1 sub-unknown\n");
}

TEST(ControlFlow, NamesTheMissingPartner) {
    EXPECT_EQ(reportedBy("o1 if [1]\nM2\n"), "1:1 flow-partner\n");
    EXPECT_EQ(reportedBy("o1 while [1]\no1 endif\nM2\n"), "1:1 flow-partner\n2:1 flow-partner\n");
    EXPECT_EQ(reportedBy("o1 sub\nM2\n"), "1:1 flow-partner\n");
    EXPECT_EQ(reportedBy("o1 break\nM2\n"), "1:1 flow-partner\n");
    EXPECT_EQ(reportedBy("o1 endsub\nM2\n"), "1:1 return-outside\n");
    EXPECT_EQ(reportedBy("o1 if [0]\no1 endif\no1 if [0]\no1 endif\nM2\n"), "3:1 label-twice\n");
    EXPECT_EQ(reportedBy("o1 sub\no2 sub\no2 endsub\no1 endsub\nM2\n"),
              "1:1 flow-partner\n2:1 sub-nested\n3:1 return-outside\n4:1 return-outside\n");
    EXPECT_EQ(reportedBy("o1 if 1\no1 endif\nM2\n"), "1:1 flow-condition\n");
    EXPECT_EQ(reportedBy("o1 if [1] G0\no1 endif\nM2\n"), "1:11 flow-rest\n");
    EXPECT_EQ(reportedBy("M98 P7\nM2\n"), "1:5 sub-unknown\n");
}

TEST(ControlFlow, LimitsTheDepthOfCallsAndShowsTheirChain) {
    const auto program = interpret(NcText("o1 sub\no1 call\no1 endsub\no1 call\nM2\n"));
    ASSERT_FALSE(program->diagnostics().empty());
    const Diagnostic& reported = program->diagnostics().front();
    EXPECT_STREQ(reported.id, "call-too-deep");
    EXPECT_EQ(reported.arguments, (std::vector<Argument>{"9", "1 > 1 > 1 > 1 > 1 > 1 > 1 > 1 > 1 > 1"}));
}

TEST(ControlFlow, FindsALoopThatNothingEnds) {
    EXPECT_EQ(reportedBy("o1 while [1]\no1 endwhile\nM2\n"), "1:1 endless-loop\n");
    EXPECT_EQ(reportedBy("o9 sub\n#2=7\no9 endsub\no1 while [1]\no9 call\no1 endwhile\nM2\n"),
              "4:1 endless-loop\n");
}

TEST(ControlFlow, AnEndlessLoopIsShownForItsFirstRounds) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    const auto program = interpret(NcText("G0 X0\no1 while [1]\nG91 G0 X1\no1 endwhile\nM2\n"), options);
    EXPECT_GE(program->motionCount(), 2U);
    EXPECT_LE(program->motionCount(), 4U);
    EXPECT_EQ(program->bounds().hi.x, program->endOf(program->motionCount() - 1).x);
    EXPECT_TRUE(program->unverified());
}

/// Each of these ends because of something other than a variable of its own level.
TEST(ControlFlow, TakesNoLoopForEndlessThatEnds) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    for (const std::string text :
         {"o1 while [#<_x> LT 3]\nG91 G0 X1\no1 endwhile\nM2\n",
          "o1 repeat [3]\nG91 G0 X1\no1 endrepeat\nM2\n", "M98 P2 L3\nM2\nO2\nG91 G0 X1\nM99\n",
          "o1 sub\nG91 G0 X1\no1 endsub\no1 call\no1 call\no1 call\nM2\n",
          "o1 sub\no2 if [#1 GT 0]\no1 call [#1-1]\no2 endif\nG91 G0 X1\no1 endsub\no1 call [3]\nM2\n",
          "#1=0\no1 while [#1 LT 3]\n#1=[#1+1]\nG91 G0 X1\no1 endwhile\nM2\n"})
        EXPECT_EQ(reportedBy(text, options), "") << text;
}

TEST(ControlFlow, EndsALoopAtTheLimitOfWhatItRepeats) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    options.maxRepeated = 1000;
    const auto counting =
        interpret(NcText("G0 X0\no1 while [1]\n#1=[#1+1]\nG91 G0 X1\no1 endwhile\nM2\n"), options);
    EXPECT_STREQ(counting->diagnostics().front().id, "too-many-steps");
    EXPECT_EQ(counting->motionCount(), 2U); // the motions of the first pass through the loop
    EXPECT_EQ(counting->bounds().hi.x, 1);
    options.maxIdle = 500;
    EXPECT_EQ(reportedBy("#1=0\no1 while [1]\n#1=[#1+1]\no1 endwhile\nM2\n", options),
              "2:1 loop-without-motion\n");
    const std::string lines(1000, '\n');
    EXPECT_EQ(reportedBy("#1=0\no1 while [#1 LT 3000]\n#1=[#1+1]\no1 endwhile\nM2\n" + lines, options), "");
}

TEST(ControlFlow, RefusesMoreRoundsThanAnybodyWaitsFor) {
    InterpretOptions options;
    EXPECT_EQ(reportedBy("o1 repeat [1e12]\nG91\no1 endrepeat\nM2\n", options), "1:13 operator-missing\n");
    EXPECT_EQ(reportedBy("o1 repeat [1000000000]\nG91\no1 endrepeat\nM2\n", options),
              "1:1 too-many-rounds\n");
    EXPECT_EQ(reportedBy("M98 P5 L999999999\nM2\nO5\nG91\nM99\n", options), "1:5 too-many-rounds\n");
}

TEST(ControlFlow, ReportsTheCallsThatLedIntoAnEndlessLoop) {
    InterpretOptions options;
    options.maxRepeated = 1000;
    const auto program = interpret(
        NcText("o<a> sub\no1 while [1]\n#1=[#1+1]\no1 endwhile\no<a> endsub\no<a> call\nM2\n"), options);
    EXPECT_EQ(program->diagnostics().front().arguments, (std::vector<Argument>{"1000", "6 (Oa) > 4"}));
}

TEST(ControlFlow, AnEndlessLoopAnswersAStop) {
    std::stop_source stop;
    WorkContext context;
    context.stop = stop.get_token();
    std::jthread user([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        stop.request_stop();
    });
    InterpretOptions options;
    options.maxRepeated = options.maxIdle = std::numeric_limits<std::uint64_t>::max();
    const auto program =
        interpret(NcText("o<a> sub\no1 while [1]\n#1=[#1+1]\no1 endwhile\no<a> endsub\no<a> call\nM2\n"),
                  options, context);
    const Diagnostic& stopped = program->diagnostics().back();
    EXPECT_STREQ(stopped.id, "interpretation-stopped");
    ASSERT_EQ(stopped.arguments.size(), 1U);
    EXPECT_TRUE(stopped.arguments.front().text().starts_with("6 (Oa) > "))
        << stopped.arguments.front().text();
}

TEST(ControlFlow, LocalParametersComeBackAfterACall) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    const auto program = interpret(NcText("#1=1 #2=2 #<a>=3 #<_g>=4\no1 sub\n#2=9 #<_g>=[#<_g>+1]\n#<a>=#1\n"
                                          "o1 endsub\no1 call [7]\nG0 X#1 Y#2 Z[#<a>*10+#<_g>]\nM2\n"),
                                   options);
    ASSERT_EQ(program->motionCount(), 1U);
    EXPECT_EQ(program->motion(0).end, Vec3(1, 2, 35));
}

TEST(ControlFlow, EndsALoopThatOnlyRepeatsItsErrors) {
    InterpretOptions options;
    options.dialect = DialectId::fanuc;
    const std::string text = "#1=1\nWHILE [#1 LT 5] DO 1\nX[\nEND 1\nM30\n";
    const auto program = interpret(NcText(text), options);
    EXPECT_THAT(reportedBy(text, options), testing::HasSubstr("too-many-again"));
    EXPECT_TRUE(program->unverified());
    EXPECT_LE(program->diagnostics().size(), options.maxDiagnostics + 3);
    options.dialect = DialectId::linuxcnc;
    EXPECT_THAT(reportedBy("o1 while [1]\nX[\no1 endwhile\nM2\n", options),
                testing::HasSubstr("too-many-again"));
}

TEST(ControlFlow, EndsWhereACallOnTheLastLineLeadsToTheEndOfTheText) {
    const std::string reported = reportedBy("o100 sub\nG0 X1 endsub\n\no100 call [10] [15]");
    EXPECT_NE(reported.find("4:1 sub-end-missing\n"), std::string::npos) << reported;
}

} // namespace proveout
