// SPDX-License-Identifier: GPL-3.0-or-later
// A resumed run gives the same result as a run from the beginning.
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

#include "core/nc/run/resumable_interpreter.h"
#include "tests/core/nc/program_equality.h"

namespace proveout {

namespace {

const std::vector<std::string> kLinuxCnc{"G1 X1 Y2 F100",
                                         "X3",
                                         "Z-1.5",
                                         "G2 X4 Y4 R10",
                                         "G3 X1 I-1 J0.5",
                                         "G0 X0 Y0 Z5",
                                         "G91 X1",
                                         "G90",
                                         "G41 D1 X5",
                                         "G40 X9 Y9",
                                         "G81 X1 Y1 Z-2 R1",
                                         "G80",
                                         "T2 M6",
                                         "G43 H2",
                                         "G92 X0",
                                         "G54",
                                         "G55",
                                         "G20",
                                         "G21",
                                         "#1=[#1+1]",
                                         "#<_a>=#1",
                                         "X#1",
                                         "G5.2 X1 Y1 P1",
                                         "X2 Y3 P1",
                                         "G5.3",
                                         "o100 sub",
                                         "o100 endsub",
                                         "o100 call",
                                         "o1 repeat [2]",
                                         "o1 endrepeat",
                                         "o2 if [#1 GT 2]",
                                         "o2 else",
                                         "o2 endif",
                                         "o3 while [#1 LT 3]",
                                         "o3 endwhile",
                                         "M98 P100",
                                         "M99",
                                         "O100",
                                         "M70",
                                         "M72",
                                         "%",
                                         "M2",
                                         "(note)",
                                         "",
                                         "G1 X?",
                                         "G17.9",
                                         "/X7",
                                         "G33 Z-1 K1",
                                         "M66 P1",
                                         "X#5399",
                                         "G38.2 Z-3",
                                         "M3 S500"};

const std::vector<std::string> kFanuc{"G1 X1. Y2. F100",
                                      "N10 X3.",
                                      "N20 Z-1.5",
                                      "N10",
                                      "G2 X4. Y4. R10.",
                                      "G0 X0 Y0 Z5.",
                                      "G91 X1.",
                                      "G90",
                                      "G41 D1 X5.",
                                      "G40 X9. Y9.",
                                      "G81 X1. Y1. Z-2. R1.",
                                      "G80",
                                      "T2 M6",
                                      "G43 H2 Z9.",
                                      "G68 X0 Y0 R30.",
                                      "G69",
                                      "#1=#1+1",
                                      "#100=#1",
                                      "X#1",
                                      "IF[#1 LT 3] GOTO 10",
                                      "GOTO 20",
                                      "WHILE[#1 LT 3] DO1",
                                      "END1",
                                      "M98 P1000",
                                      "M99",
                                      "O1000",
                                      "G65 P1000 A1.",
                                      "G66 P1000",
                                      "G67",
                                      "%",
                                      "M30",
                                      "G10 L2 P1 X1.",
                                      "G54",
                                      "#3000=1(BAD)",
                                      "#3006=1",
                                      "G51 X0 Y0 P2.",
                                      "G50",
                                      "(note)",
                                      "",
                                      "X",
                                      "#11001=5.",
                                      "G31 Z-3."};

std::string randomText(std::mt19937& random, const std::vector<std::string>& lines, std::size_t count) {
    std::string text;
    for (std::size_t n = random() % (count + 1); n > 0; --n)
        text += lines[random() % lines.size()] + (random() % 30 == 0 ? "\r" : "\n");
    return text;
}

NcText randomEdit(std::mt19937& random, const NcText& text, const std::vector<std::string>& lines) {
    const std::size_t offset = random() % (text.size() + 1);
    const std::size_t removed =
        random() % 3 == 0 ? random() % std::min<std::size_t>(40, text.size() - offset + 1) : 0;
    const std::string inserted =
        random() % 2 == 0 ? std::string(1, "019.XYG\n\rN"[random() % 10]) : randomText(random, lines, 3);
    return text.replaced(offset, removed, inserted);
}

void checkEdits(DialectId dialect, const std::vector<std::string>& lines, unsigned seed,
                std::size_t& resumed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    InterpretOptions options;
    options.dialect = dialect;
    options.maxRepeated = 2000;
    options.maxDiagnostics = random() % 2 == 0 ? 100 : 8;
    ResumableInterpreter interpreter(1 + random() % 3);
    const std::size_t whole = options.stopAfterBlocks;
    NcText text("G0 X0 Y0 Z0\n" + randomText(random, lines, 60));
    for (int edit = 0; edit < 6; ++edit) {
        const auto program = interpreter.interpret(text, options);
        resumed += interpreter.resumedAt() > 0 ? 1 : 0;
        ASSERT_EQ(test::difference(*program, *interpret(text, options)), "")
            << "edit " << edit << ", gone on at " << interpreter.resumedAt() << ":\n"
            << text.toString();
        if (random() % 2 == 0)
            text = randomEdit(random, text, lines);
        options.stopAfterBlocks = random() % 3 == 0 ? random() % 10 : whole;
    }
}

std::string straightLines(std::size_t count) {
    std::string text = "G21 G90 F100\nG0 X0 Y0 Z0\n";
    for (std::size_t i = 0; i < count; ++i)
        text += "G1 X" + std::to_string(i % 1000) + " Y" + std::to_string(i % 7) + "\n";
    return text + "M2\n";
}

} // namespace

TEST(ResumableInterpreter, SaysWhatAFreshRunSays) {
    std::size_t resumed = 0;
    for (unsigned seed = 1; seed <= 250; ++seed) {
        checkEdits(DialectId::linuxcnc, kLinuxCnc, seed, resumed);
        checkEdits(DialectId::fanuc, kFanuc, seed, resumed);
        // The other dialects know some of these words.
        checkEdits(DialectId::haas, kFanuc, seed, resumed);
        checkEdits(DialectId::grbl, kLinuxCnc, seed, resumed);
        checkEdits(DialectId::mach, kLinuxCnc, seed, resumed);
        if (HasFatalFailure())
            return;
    }
    EXPECT_GT(resumed, 400U); // otherwise nothing was tested
}

TEST(ResumableInterpreter, ContinuesShortBeforeTheChange) {
    ResumableInterpreter interpreter(100);
    const NcText text(straightLines(50'000));
    static_cast<void>(interpreter.interpret(text, {}));
    EXPECT_EQ(interpreter.resumedAt(), 0U);
    const std::size_t offset = text.size() - 1000;
    const NcText edited = text.replaced(offset, 0, "\nG1 X5\n");
    static_cast<void>(interpreter.interpret(edited, {}));
    EXPECT_GT(interpreter.resumedAt(), 47'000U);
    EXPECT_LT(interpreter.resumedAt(), 50'000U);
    // An edit at the beginning leaves nothing to resume from.
    static_cast<void>(interpreter.interpret(edited.replaced(0, 0, "G1 X1\n"), {}));
    EXPECT_EQ(interpreter.resumedAt(), 0U);
}

TEST(ResumableInterpreter, LooksBackAndForth) {
    const NcText text(straightLines(20'000));
    ResumableInterpreter interpreter(100);
    static_cast<void>(interpreter.interpret(text, {}));
    for (const std::size_t block : {15'000U, 14'000U, 3U, 19'000U}) {
        InterpretOptions options;
        options.stopAfterBlocks = block;
        const auto program = interpreter.interpret(text, options);
        EXPECT_EQ(test::difference(*program, *interpret(text, options)), "") << block;
        EXPECT_LE(interpreter.resumedAt(), block + 1);
        EXPECT_GE(interpreter.resumedAt() + 500, block);
    }
}

TEST(ResumableInterpreter, OtherOptionsRestart) {
    ResumableInterpreter interpreter(100);
    const NcText text(straightLines(5000));
    InterpretOptions options;
    static_cast<void>(interpreter.interpret(text, options));
    static_cast<void>(interpreter.interpret(text, options));
    EXPECT_GT(interpreter.resumedAt(), 4000U);
    options.blockDelete = true;
    static_cast<void>(interpreter.interpret(text, options));
    EXPECT_EQ(interpreter.resumedAt(), 0U);
}

TEST(ResumableInterpreter, AStoppedRunIsGoneOnWith) {
    const NcText text(straightLines(50'000));
    ResumableInterpreter interpreter(100);
    std::stop_source source;
    WorkContext context{source.get_token(), {}};
    std::size_t reported = 0;
    context.progress = [&](double) { reported++ > 0 ? source.request_stop() : false; };
    static_cast<void>(interpreter.interpret(text, {}, context));
    const auto program = interpreter.interpret(text, {});
    EXPECT_GT(interpreter.resumedAt(), 0U);
    EXPECT_EQ(test::difference(*program, *interpret(text, {})), "");
}

TEST(ResumableInterpreter, TheBeginningIsThereBeforeTheRest) {
    const NcText text(straightLines(500'000));
    ResumableInterpreter interpreter;
    std::vector<std::shared_ptr<const Program>> published;
    const auto whole = interpreter.interpret(
        text, {}, {}, [&](const std::shared_ptr<const Program>& program) { published.push_back(program); });
    ASSERT_EQ(published.size(), 2U);
    EXPECT_LT(published.front()->motionCount(), 120'000U);
    for (const auto& program : published) {
        EXPECT_TRUE(program->unverified());
        EXPECT_STREQ(program->diagnostics().back().id, "still-reading");
        EXPECT_EQ(program->firstDifference(*whole), program->blockCount());
    }
    EXPECT_FALSE(whole->unverified());
}

} // namespace proveout
