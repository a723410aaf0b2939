// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/dialects.h"
#include "core/simulation/run/interpretation.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/core/temporary_folder.h"

namespace proveout {

namespace {

Setup withBall(double diameter) {
    Setup setup;
    setup.tools.set(3, parseToolOption("3=ball:d=" + std::to_string(diameter))->second);
    return setup;
}

// In a test, "Setup" would be GoogleTest's.
const Setup kNothing;

} // namespace

TEST(Interpretation, CompensatesForTheCuttersOfTheSetUp) {
    const auto program =
        interpret(NcText("T3 M6\nF100\nG0 X0 Y-20 Z0\nG41 G1 X0 Y0\nG1 Y20\nG1 Y40\nG40\nM2\n"),
                  interpretOptions(withBall(8), {}));
    EXPECT_FALSE(program->unverified());
    ASSERT_GE(program->motionCount(), 3U);
    // Offset to the left of a path along Y by the radius.
    EXPECT_NEAR(program->motion(2).end.x, -4, 1e-9);
}

TEST(Interpretation, WarnsOnlyWhereTheToolThatDoesNotFitIsAssumed) {
    // The left of a counter-clockwise arc is its inside: a cutter of 8 mm does not fit into a radius of 1 mm.
    const std::string tight = "G21 G0 X0. Y-20. Z0.\nG41 D3 G1 X0. Y0. F100.\nG3 X-2. Y0. I-1. J0.\n"
                              "G1 Y-20.\nG40 X-9.\nM2\n";
    for (const DialectId dialect : {DialectId::linuxcnc, DialectId::fanuc}) {
        proveout::Setup setup = withBall(8);
        setup.dialect = dialect;
        const Cutter cutter = *setup.tools.find(3);
        const auto worst = [&](const ToolOrigin& origin) {
            setup.tools.set(3, cutter, origin);
            const auto program = interpret(NcText("T3 M6\n" + tight), interpretOptions(setup, {}));
            EXPECT_TRUE(program->unverified());
            EXPECT_FALSE(program->diagnostics().empty());
            return std::ranges::max(program->diagnostics(), {}, &Diagnostic::severity).severity;
        };
        EXPECT_EQ(worst({}), Severity::error);
        EXPECT_EQ(worst({.source = ToolSource::assumed}), Severity::warning);
        EXPECT_EQ(worst({.source = ToolSource::assumed, .entered = {"d"}}), Severity::error);
        EXPECT_EQ(worst({.source = ToolSource::comment, .line = 1, .comment = "FLAT D8"}), Severity::error);
        EXPECT_EQ(worst({.source = ToolSource::comment, .line = 1, .comment = "FLAT", .defaults = {"d"}}),
                  Severity::warning);
    }
}

TEST(Interpretation, LooksForSubprogramsBesideTheProgram) {
    const TemporaryFolder folder;
    folder.put("step.ngc", "o<step> sub\nG0 X7 Y8 Z9\no<step> endsub\n");
    const auto program =
        interpret(NcText("o<step> call\nM2\n"), interpretOptions(kNothing, folder / "main.ngc"));
    ASSERT_EQ(program->motionCount(), 1U);
    EXPECT_EQ(program->motion(0).end, Vec3(7, 8, 9));
    EXPECT_TRUE(interpret(NcText("o<step> call\nM2\n"), interpretOptions(kNothing, {}))->unverified());
}

TEST(Interpretation, IsTheSameWhereOffsetsStartAndBlockDeleteAre) {
    const auto plain = interpret(NcText("T3 M6\nG0 X1\nM2\n"));
    const auto compensated = interpret(NcText("T3 M6\nF100\nG0 X0 Y-20 Z0\nG41 G1 X0 Y0\nG40\nM2\n"));
    proveout::Setup other = withBall(8);
    other.spacing = 0.25;
    EXPECT_TRUE(interpretedAlike(*compensated, withBall(8), other));
    EXPECT_FALSE(interpretedAlike(*compensated, withBall(8), withBall(6)));
    EXPECT_FALSE(interpretedAlike(*compensated, withBall(8), kNothing));
    EXPECT_TRUE(interpretedAlike(*plain, withBall(8), withBall(6)));
    other.tools.set(3, *other.tools.find(3), {.source = ToolSource::assumed});
    EXPECT_FALSE(interpretedAlike(*compensated, withBall(8), other)) << "confirmed";
    EXPECT_TRUE(interpretedAlike(*plain, withBall(8), other));
    other.blockDelete = true;
    EXPECT_FALSE(interpretedAlike(*plain, withBall(8), other));
}

TEST(Interpretation, TypeOfTheCompensationsStartIsASettingOfControlsThatKnowIt) {
    const NcText text("F100\nG0 X0 Y-20 Z0\nG41 D3 G1 X0 Y0\nG40 X-20\nM30\n");
    proveout::Setup typeB = withBall(8);
    typeB.compensationTypeB = true;
    EXPECT_TRUE(interpretOptions(typeB, {}).compensationTypeB);
    for (const Dialect& row : dialects()) {
        InterpretOptions options;
        options.dialect = row.id;
        EXPECT_EQ(interpretedAlike(*interpret(text, options), withBall(8), typeB), !row.vectors.used)
            << row.key;
    }
}

} // namespace proveout
