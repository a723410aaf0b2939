// SPDX-License-Identifier: GPL-3.0-or-later
// Texts in which each line used to cost as much as all lines before it, so that a megabyte took minutes. The
// asserted time is many times the current one.
#include <chrono>
#include <fmt/format.h>
#include <functional>
#include <gtest/gtest.h>
#include <string>

#include "core/nc/run/interpreter.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

constexpr std::chrono::seconds kMostTime(20);

std::string lines(int count, const std::function<std::string(int)>& line) {
    std::string text;
    for (int k = 0; k < count; ++k)
        text += line(k) + "\n";
    return text;
}

struct LongText {
    const char* name;
    DialectId dialect;
    std::string (*text)();
};

const LongText kTexts[] = {
    {"PercentSigns", DialectId::linuxcnc,
     [] { return "G1 X1 F100\n" + lines(300'000, [](int) { return "%"; }) + "X2\n"; }},
    {"CallsOfMissingPrograms", DialectId::fanuc,
     [] { return lines(300'000, [](int k) { return fmt::format("M98 P{}", 1 + k % 3); }); }},
    {"CallsAmongManyPrograms", DialectId::fanuc,
     [] {
         return "O1\n" + lines(300'000, [](int) { return "M98 <N299999>"; }) + "M30\n" +
                lines(300'000, [](int k) { return fmt::format("<N{}>\nM99", k); });
     }},
    {"LoopsThatNeverEnd", DialectId::fanuc,
     [] { return lines(300'000, [](int) { return "DO1"; }) + lines(300'000, [](int) { return "END2"; }); }},
    {"ScopesAfterALargeOne", DialectId::linuxcnc,
     [] {
         return lines(300'000, [](int k) { return fmt::format("o{} if [1]", k); }) +
                lines(300'000, [](int) { return "o1 endsub"; });
     }},
};

class LongTexts : public testing::TestWithParam<LongText> {};

INSTANTIATE_TEST_SUITE_P(Kinds, LongTexts, testing::ValuesIn(kTexts),
                         [](const auto& text) { return std::string(text.param.name); });

TEST_P(LongTexts, AreReadInTime) {
    const TemporaryFolder folder;
    InterpretOptions options;
    options.dialect = GetParam().dialect;
    options.subprogramFolders = {folder.path()};
    const NcText text(GetParam().text());
    const auto start = std::chrono::steady_clock::now();
    const auto program = interpret(text, options);
    EXPECT_LT(std::chrono::steady_clock::now() - start, kMostTime);
    EXPECT_LE(program->diagnostics().size(), 2 * options.maxDiagnostics + 5);
}

TEST(LongText, MessagesStayShort) {
    const std::string label(100'000, 'a');
    const std::string text = lines(200, [&](int) { return "o<" + label + "\xc3\xa4> call [1]"; });
    const auto program = interpret(NcText(text));
    ASSERT_GT(program->diagnostics().size(), 50U);
    for (const Diagnostic& diagnostic : program->diagnostics())
        for (const Argument& argument : diagnostic.arguments)
            ASSERT_LE(argument.text().size(), 2003U);
}

/// What is cached about missing files must not affect other files.
TEST(LongText, AMissingProgramHidesNoOther) {
    const TemporaryFolder folder;
    folder.put("O0002.nc", "O2\nG0 X5.\nM99\n");
    InterpretOptions options;
    options.dialect = DialectId::fanuc;
    options.assumeStartAtZero = true;
    options.subprogramFolders = {folder.path()};
    const auto program = interpret(NcText("O9\nM98 P1\nM98 P2\nG0 X0\nM98 P1\nM98 P2\nM30\n"), options);
    std::size_t missing = 0;
    for (const Diagnostic& diagnostic : program->diagnostics())
        missing += std::string_view(diagnostic.id) == "sub-unknown" ? 1 : 0;
    EXPECT_EQ(missing, 2U);
    ASSERT_EQ(program->motionCount(), 3U);
    EXPECT_EQ(program->endOf(2).x, 5);
}

} // namespace
} // namespace proveout
