// SPDX-License-Identifier: GPL-3.0-or-later
// What golden cases cannot express: limits, stopping, time, and what is stored besides the records.
#include "core/nc/run/interpreter.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <stop_token>
#include <string>
#include <thread>

namespace proveout {

namespace {

/// CPU time, the shortest of three runs, so that other load on the machine does not matter.
double secondsOf(const std::function<void()>& work) {
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < 3; ++run) {
        const std::clock_t begin = std::clock();
        work();
        least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    return least;
}

std::string repeated(const std::string& line, int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += line;
    return text;
}

bool has(const Program& program, std::string_view id) {
    return std::any_of(program.diagnostics().begin(), program.diagnostics().end(),
                       [&](const Diagnostic& d) { return d.id == id; });
}

} // namespace

TEST(Interpreter, NamesTheFileAndThePlaceOfEveryMessage) {
    InterpretOptions options;
    options.file = "part.ngc";
    const auto program = interpret(NcText("G0 X0 Y0 Z0\nG1 X1 F100 G68\nM2\n"), options);
    ASSERT_EQ(program->diagnostics().size(), 1U);
    const Diagnostic& diagnostic = program->diagnostics().front();
    EXPECT_EQ(oneLine(diagnostic),
              "part.ngc:2:12: error: G68 (coordinate rotation) is not supported yet. [code-unsupported]");
    EXPECT_EQ(diagnostic.where, (TextRange{2, 12, 3}));
    EXPECT_NE(std::string(diagnostic.hint), "");
    EXPECT_TRUE(program->unverified());
}

TEST(Interpreter, ReportsAnAxisWhosePositionIsNeverKnown) {
    const auto axesNeverKnown = [](const char* text, const InterpretOptions& options = {}) {
        const auto program = interpret(NcText(text), options);
        for (const Diagnostic& diagnostic : program->diagnostics())
            if (diagnostic.id == std::string("position-never-known")) {
                EXPECT_TRUE(diagnostic.unverified);
                return diagnostic.arguments.at(0).text();
            }
        return std::string();
    };
    EXPECT_EQ(axesNeverKnown("G0 X0 Y0\nG0 X100\nM2\n"), "Z");
    EXPECT_EQ(axesNeverKnown("G0 Z5\nM2\n"), "X, Y");
    EXPECT_EQ(axesNeverKnown("G0 X0 Y0\nZ5\nM2\n"), "");
    EXPECT_EQ(axesNeverKnown("M2\n"), "") << "without a motion that is what is told";
    EXPECT_EQ(axesNeverKnown("G1 X1 Y1 F100\nM2\n"), "") << "told where the motion cut nothing";
    InterpretOptions started;
    started.start = Vec3(0, 0, 50);
    EXPECT_EQ(axesNeverKnown("G0 X0 Y0\nG0 X100\nM2\n", started), "");
}

TEST(Interpreter, SaysNothingOfTheWholeWhereItWasStopped) {
    std::stop_source source;
    source.request_stop();
    const auto program = interpret(NcText("G0 X0\nM2\n"), {}, {source.get_token(), {}});
    ASSERT_EQ(program->diagnostics().size(), 1U);
    EXPECT_TRUE(program->unverified());
}

TEST(Interpreter, ReportsTheSmallerRadiusWhereAnArcHasNone) {
    // As text, "10" would sort before "5e-05".
    const auto program = interpret(NcText("G0 X0 Y0 Z0\nF100\nG2 X10 Y0 I-0.00005 J0\nM2\n"));
    ASSERT_EQ(program->diagnostics().size(), 1U);
    EXPECT_EQ(std::string(program->diagnostics()[0].id), "arc-zero-radius");
    EXPECT_EQ(program->diagnostics()[0].arguments, std::vector<Argument>{"5e-05"});
}

TEST(Interpreter, KnowsNothingOfTheStartUnlessGiven) {
    const NcText text("G1 X1 Y1 F100\n");
    const auto unknown = interpret(text);
    EXPECT_EQ(unknown->motion(0).startKnown, 0);
    EXPECT_EQ(unknown->motion(0).endKnown, kAxisX | kAxisY);
    EXPECT_FALSE(unknown->motion(0).known());
    EXPECT_TRUE(unknown->unverified());
    EXPECT_TRUE(unknown->bounds().empty());
    EXPECT_EQ(message(unknown->diagnostics().front()), "X, Y, Z position unknown; move not simulated.");

    InterpretOptions assumed;
    assumed.assumeStartAtZero = true;
    EXPECT_TRUE(interpret(text, assumed)->motion(0).known());
    EXPECT_FALSE(interpret(text, assumed)->unverified());

    InterpretOptions given;
    given.start = Vec3(5, 6, 7);
    const Motion motion = interpret(text, given)->motion(0);
    EXPECT_TRUE(motion.known());
    EXPECT_EQ(motion.start, Vec3(5, 6, 7));
    EXPECT_EQ(motion.end, Vec3(1, 1, 7));
}

TEST(Interpreter, AStoppedSpindleHasItsSpeedAllTheSame) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    const auto program = interpret(NcText("S500 G1 X1 F10\nM4\nX2\nM2\n"), options);
    EXPECT_EQ(program->motion(0).spindleRpm, 0);
    EXPECT_EQ(program->motion(0).orderedRpm, 500);
    EXPECT_EQ(program->motion(1).spindleRpm, -500);
}

TEST(Interpreter, CountsTheMessagesBeyondTheLimit) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    const auto program = interpret(NcText(repeated("G68\n", 250) + "G0 X1\nM2\n"), options);
    ASSERT_EQ(program->diagnostics().size(), 97U) << "four places are kept for the program as a whole";
    EXPECT_STREQ(program->diagnostics().back().id, "too-many-messages");
    EXPECT_EQ(message(program->diagnostics().back()), "154 more messages are not shown.");
    EXPECT_TRUE(program->motion(0).unverified);

    options.maxDiagnostics = 5;
    const auto hidden = interpret(NcText("G0 X1\n%\nG0 X2\n" + repeated("Q1\n", 9)), options);
    EXPECT_LE(hidden->diagnostics().size(), 7U);
    EXPECT_TRUE(has(*hidden, "no-program-end"));

    options.assumeStartAtZero = false;
    const auto many = interpret(NcText("G0 X1 Y1\nG41.1 D1\nG0 X9\n" + repeated("Q1\n", 9)), options);
    EXPECT_TRUE(has(*many, "compensation-at-end") && has(*many, "no-program-end") &&
                has(*many, "position-never-known"));
    EXPECT_LE(many->diagnostics().size(), 7U) << "messages about the program as a whole count too";
}

TEST(Interpreter, ShowsAnErrorBehindAnyNumberOfWarnings) {
    InterpretOptions options;
    options.dialect = DialectId::fanuc;
    const auto program =
        interpret(NcText("G0 X1.\n" + repeated("G1 X1. P5 F100.\n", 250) + "G1 X2. R\nM30\n"), options);
    const auto severe = [](const Diagnostic& reported) { return reported.severity == Severity::error; };
    ASSERT_EQ(std::ranges::count_if(program->diagnostics(), severe), 1);
    EXPECT_EQ(std::ranges::find_if(program->diagnostics(), severe)->where.line, 252);
    EXPECT_STREQ(program->diagnostics().back().id, "too-many-messages");
}

TEST(Interpreter, AWordThatNothingUsesIsNeverGreen) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    for (const DialectId dialect : {DialectId::fanuc, DialectId::haas}) {
        options.dialect = dialect;
        EXPECT_TRUE(interpret(NcText("G0 X1.\nG1 X2. E5. F100.\nM30\n"), options)->unverified());
        EXPECT_FALSE(interpret(NcText("G0 X1.\nG1 X2. F100.\nM30\n"), options)->unverified());
    }
}

TEST(Interpreter, StopsAtTheLimitOfMotions) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    options.lint = false;
    options.maxMotions = 10;
    const auto program = interpret(NcText(repeated("G91 G0 X1\n", 20)), options);
    EXPECT_EQ(program->motionCount(), 11U);
    ASSERT_TRUE(has(*program, "too-many-motions"));
    EXPECT_EQ(program->diagnostics().back().where.line, 11);
    EXPECT_TRUE(program->unverified());

    const auto justWithin = interpret(NcText(repeated("G91 G0 X1\n", 10) + "M2\n"), options);
    EXPECT_EQ(justWithin->motionCount(), 10U);
    EXPECT_TRUE(justWithin->diagnostics().empty());
}

TEST(Interpreter, StopsAtTheLimitOfEvents) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    options.lint = false;
    options.maxMotions = 10;
    const auto program = interpret(NcText("G0 X1\n" + repeated("M0\n", 20)), options);
    EXPECT_EQ(program->events().size(), 11U);
    ASSERT_TRUE(has(*program, "too-many-events"));
    EXPECT_EQ(program->diagnostics().back().where.line, 12);
    EXPECT_TRUE(program->unverified());

    const auto justWithin = interpret(NcText("G0 X1\n" + repeated("M0\n", 9) + "M2\n"), options);
    EXPECT_EQ(justWithin->events().size(), 10U);
    EXPECT_TRUE(justWithin->diagnostics().empty());
}

TEST(Interpreter, CutsTheTextInAMessageBetweenCharacters) {
    const auto program = interpret(NcText("#<" + repeated("ä", 30) + ">\n"));
    ASSERT_FALSE(program->diagnostics().empty());
    EXPECT_EQ(program->diagnostics().front().arguments.at(0), "#<" + repeated("ä", 19));
}

TEST(Interpreter, AnswersAStopAndSaysSo) {
    const NcText text(repeated("G91 G1 X0.001 F100\n", 3'000'000));
    std::stop_source stop;
    WorkContext context;
    context.stop = stop.get_token();
    std::chrono::steady_clock::time_point asked;
    context.progress = [&](double done) {
        if (done > 0.1 && !stop.stop_requested()) {
            asked = std::chrono::steady_clock::now();
            stop.request_stop();
        }
    };
    const auto program = interpret(text, {}, context);
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - asked).count(), 0.2);
    EXPECT_TRUE(has(*program, "interpretation-stopped"));
    EXPECT_TRUE(program->unverified());
    EXPECT_LT(program->motionCount(), 3'000'000U);
    EXPECT_GT(program->motionCount(), 0U);
}

TEST(Interpreter, ReportsItsProgressUpToOne) {
    double last = 0;
    bool rises = true;
    WorkContext context;
    context.progress = [&](double done) {
        rises = rises && done >= last;
        last = done;
    };
    (void)interpret(NcText(repeated("G0 X1\n", 200'000)), {}, context);
    EXPECT_TRUE(rises);
    EXPECT_EQ(last, 1);
}

TEST(Interpreter, LongLinesTakeNoTime) {
    struct Case {
        const char* name;
        std::string text;
    };
    for (const Case& c :
         {Case{"line of words", repeated("X1 Y2 ", 100'000)},
          Case{"digits", "G0 X" + std::string(1'000'000, '9')},
          Case{"comment", "(" + std::string(1'000'000, 'a')}, Case{"blanks", std::string(1'000'000, ' ')},
          Case{"brackets", "G0 X" + std::string(100'000, '[')}, Case{"comments", repeated("()", 500'000)},
          Case{"blanks in a number", "G0 X1" + std::string(1'000'000, ' ') + "5"},
          Case{"CR alone", repeated("G0 X1\r", 100'000)}, Case{"percent", repeated("%\n", 200'000)}}) {
        const double seconds = secondsOf([&] { (void)interpret(NcText(c.text)); });
#ifdef NDEBUG
        EXPECT_LT(seconds, 0.1) << c.name;
#else
        EXPECT_LT(seconds, 2) << c.name;
#endif
    }
}

TEST(Interpreter, KeepsTheBytesOfAMotionSmall) {
    // Ten million lines must fit into a laptop's memory; the figure is that of the packed motion.
    InterpretOptions options;
    options.assumeStartAtZero = true;
    const auto program = interpret(NcText(repeated("G91 G1 X1 Y1 F100\n", 1000)), options);
    EXPECT_EQ(program->motionCount(), 1000U);
    EXPECT_LE(Program::kBytesPerMotion, 64U);
}

TEST(Interpreter, KnowsNoPlaceThatRepetitionMakesTooFar) {
    InterpretOptions options;
    options.dialect = DialectId::linuxcnc;
    options.assumeStartAtZero = true;
    const auto program = interpret(NcText(repeated("G91 G0 X999999999999 Y1\n", 150)), options);
    ASSERT_TRUE(has(*program, "target-too-far"));
    EXPECT_TRUE(program->unverified());
    ASSERT_EQ(program->motionCount(), 150U);
    for (std::size_t k = 0; k < program->motionCount(); ++k) {
        const Motion motion = program->motion(k);
        EXPECT_LE(std::abs(motion.end.x), 1e14);
        EXPECT_EQ((motion.endKnown & kAxisX) != 0, k < 100);
        EXPECT_EQ(motion.end.y, static_cast<double>(k + 1));
    }
}

TEST(Interpreter, IsAFunctionOfItsInput) {
    const NcText text("T1 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\nG3 X10 Y0 R7\nG68\nX5\nM2\n");
    const auto first = interpret(text);
    std::shared_ptr<const Program> second;
    std::thread([&] { second = interpret(text); }).join();
    EXPECT_EQ(first->firstDifference(*second), first->blockCount());
    EXPECT_EQ(first->diagnostics().size(), second->diagnostics().size());
    EXPECT_EQ(first->events().size(), second->events().size());
}

} // namespace proveout
