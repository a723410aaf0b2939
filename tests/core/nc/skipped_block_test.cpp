// SPDX-License-Identifier: GPL-3.0-or-later
// What stays active after a block that cannot be executed: one mistake must not change the motions after it.
#include "core/nc/run/skipped_block.h"

#include <gtest/gtest.h>
#include <memory>
#include <string>

#include "core/nc/run/interpreter.h"

namespace proveout {

namespace {

std::shared_ptr<const Program> read(const std::string& text, DialectId dialect = DialectId::linuxcnc) {
    InterpretOptions options;
    options.dialect = dialect;
    options.lint = false;
    return interpret(NcText(text), options);
}

/// The kind of every motion (R, F or A) with its feed rate.
std::string kindsOf(const Program& program) {
    std::string kinds;
    for (std::size_t i = 0; i < program.motionCount(); ++i) {
        const Motion motion = program.motion(i);
        kinds += motion.kind == MotionKind::rapid ? "R" : motion.kind == MotionKind::feed ? "F" : "A";
        if (motion.kind != MotionKind::rapid)
            kinds += std::to_string(static_cast<int>(motion.feedMmPerMin)) + " ";
    }
    return kinds;
}

constexpr const char* kBegin = "G21 G90 G17\nG0 X0 Y0 Z5\n";
constexpr const char* kRest = "\nX10\nZ-1\nX30\nM2\n";

} // namespace

TEST(SkippedBlock, LeavesItsMotionCodeAndFeedInForce) {
    for (const char* skipped :
         {"G1 Z-1..5 F100", "Z-1..5 F100 G1", "N30 g1 z-1..5 f100", "G1 F100 Z[1/0]", "G1 F100 Z-1 Z-2",
          "G1 F100 Z-1 (open", "G1 F100 Z-1 Q4", "G1 F100 Z-1 G20 G21", "G01 F100 Z#[1"}) {
        const auto program = read(std::string(kBegin) + skipped + kRest);
        EXPECT_EQ(program->diagnostics().size(), 1U) << skipped;
        EXPECT_EQ(kindsOf(*program), "RF100 F100 F100 ") << skipped;
    }
}

TEST(SkippedBlock, LeavesItsOtherModesInForce) {
    const auto program = read(std::string(kBegin) + "G91 G1 Z-1..5 F100\nX10\nX10\nG20 X1..0 F10\nX1\nM2\n");
    ASSERT_EQ(program->motionCount(), 4U);
    EXPECT_FALSE(program->motion(2).endKnown == 0);
    EXPECT_NEAR(program->motion(2).end.x, 20, 1e-9);
    EXPECT_NEAR(program->motion(3).feedMmPerMin, 254, 1e-9);
}

TEST(SkippedBlock, LeavesNoMotionInForceWhereItsCodeCannotBeRead) {
    for (const char* skipped :
         {"G1..0 Z-1 F100", "G G1 Z-1", "G#[ Z-1 F100", "G0 G1 Z-1 F100", "G81 Z-1..0 R2 F100"}) {
        const auto program = read(std::string(kBegin) + skipped + kRest);
        EXPECT_EQ(program->diagnostics().size(), 1U) << skipped;
        EXPECT_EQ(kindsOf(*program), "R") << skipped;
        const auto again = read(std::string(kBegin) + skipped + "\nX10\nG1 F50 X20 Y0 Z3\nX30\nM2\n");
        EXPECT_EQ(kindsOf(*again), "RF50 F50 ") << skipped;
    }
}

/// The depth of the next hole would be missing from the program.
TEST(SkippedBlock, EndsACycleWhoseWordsItHas) {
    const auto program =
        read(std::string(kBegin) + "F100 G81 X0 Z-1 R2\nX10 Z-2..0\nX20\nG80\nG0 X0 Y0 Z5\nM2\n");
    const auto shorter = read(std::string(kBegin) + "F100 G81 X0 Z-1 R2\nG80\nG0 X0 Y0 Z5\nM2\n");
    EXPECT_EQ(kindsOf(*program), kindsOf(*shorter));
}

TEST(SkippedBlock, HasNoEffectOnAControlThatForgetsWhatItRefuses) {
    const auto program = read(std::string(kBegin) + "G1 Z-1..5 F100" + kRest, DialectId::grbl);
    EXPECT_EQ(kindsOf(*program), "RRRR");
}

TEST(SkippedBlock, IsNoJumpWordsAreNoCodes) {
    const ReadableWords words = readableWords("IF [#1 EQ 1..0] GOTO 100 (G1 X5) ; G2");
    EXPECT_TRUE(words.codesKnown);
    EXPECT_TRUE(words.block.codes().empty());
    EXPECT_FALSE(readableWords("G1..5 X1").codesKnown);
    EXPECT_FALSE(readableWords("G[1] X1").codesKnown);
}

} // namespace proveout
