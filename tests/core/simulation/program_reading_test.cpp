// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/program_reading.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/stop_watch.h"
#include "core/simulation/run/interpretation.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

NcText textOf(int blocks) {
    std::string text = "G0 X0 Y0 Z5\nF500\n";
    for (int block = 0; block < blocks; ++block)
        text += fmt::format("G1 X{} Z{:.5f}\n", block % 40, -1e-5 * block);
    return NcText(std::move(text));
}

TEST(ProgramReading, ReturnsGrowingBeginningsOfTheProgram) {
    const auto setup = smallSetup();
    const NcText text = textOf(600'000);
    ProgramReading reading(*setup, text, interpretOptions(*setup, {}));
    EXPECT_EQ(reading.textBytes(), text.size());
    std::vector<std::shared_ptr<const Program>> programs;
    std::vector<double> parts;
    while (!reading.isWhole()) {
        programs.push_back(reading.next());
        parts.push_back(reading.partOf(*programs.back()));
    }
    ASSERT_GE(programs.size(), 1U);
    const auto whole = interpretOn(*setup, text, interpretOptions(*setup, {}));
    EXPECT_EQ(programs.back()->blockCount(), whole->blockCount());
    EXPECT_EQ(programs.back()->diagnostics().size(), whole->diagnostics().size());
    EXPECT_GT(reading.seconds(), 0);
    for (std::size_t k = 0; k < programs.size(); ++k) {
        const auto blocks = static_cast<double>(programs[k]->blockCount());
        EXPECT_NEAR(parts[k], blocks / static_cast<double>(whole->blockCount()), 1e-3);
        EXPECT_EQ(programs[k]->firstDifference(*whole), programs[k]->blockCount());
        if (k > 0) {
            EXPECT_GT(programs[k]->blockCount(), programs[k - 1]->blockCount());
        }
        if (k + 1 < programs.size()) {
            EXPECT_TRUE(programs[k]->unverified());
        }
    }
}

TEST(ProgramReading, ReturnsAShortProgramOnlyAsAWhole) {
    const auto setup = smallSetup();
    ProgramReading reading(*setup, textOf(1000), interpretOptions(*setup, {}));
    const auto program = reading.next();
    EXPECT_TRUE(reading.isWhole());
    EXPECT_EQ(program->blockCount(), 1001U);
}

TEST(ProgramReading, InterpretsAgainWithTheToolThatIsAssumed) {
    const auto setup = smallSetup();
    const NcText text("G0 X0 Y0 Z5\nF500\nG41 G1 X5 Y5\nX10\nY10\nG40 X0\n"); // D: that of T1
    const auto whole = interpretOn(*setup, text, interpretOptions(*setup, {}));
    ASSERT_EQ(toolToInterpretWith(*whole, setup->tools), 1);
    ProgramReading reading(*setup, text, interpretOptions(*setup, {}));
    const auto program = reading.next();
    EXPECT_EQ(program->blockCount(), whole->blockCount());
    EXPECT_EQ(program->firstDifference(*whole), whole->blockCount());
}

TEST(ProgramReading, StopsWhenItIsNoLongerWanted) {
    const auto setup = smallSetup();
    NcText text("O1 WHILE [1 LT 2]\nG1 X1 F100\nX2\nO1 ENDWHILE\nM2\n"); // has no end
    InterpretOptions options = interpretOptions(*setup, {});
    options.maxRepeated = UINT64_MAX / 16;
    options.maxMotions = SIZE_MAX / 16;
    options.maxBytes = UINT64_MAX / 16;
    const StopWatch watch;
    { const ProgramReading reading(*setup, std::move(text), options); }
    EXPECT_LT(watch.seconds(), 60);
}

} // namespace
} // namespace proveout
