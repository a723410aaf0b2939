// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/diagnostic.h"

#include <gtest/gtest.h>

#include "core/base/figures_argument.h"
#include "core/base/finding_row.h"
#include "core/base/list_argument.h"

namespace proveout {
namespace {

TEST(Diagnostic, FillsItsArgumentsInOrder) {
    EXPECT_EQ(fillIn("{} of {}", {"1", "2"}), "1 of 2");
    EXPECT_EQ(fillIn("{} of {}", {"1"}), "1 of {}") << "a missing argument stays visible";
    EXPECT_EQ(fillIn("{2} von {1}", {"1", "2"}), "2 von 1") << "a translation may change the order";
    EXPECT_EQ(fillIn("{3} {0} {12}", {"1", "2"}), "{3} {0} {12}");
    EXPECT_EQ(fillIn("none", {"1"}), "none");
    EXPECT_EQ(fillIn("{}", {"{}"}), "{}") << "an argument is text, not a place for the next";
    EXPECT_EQ(fillIn("{", {"1"}), "{");
    EXPECT_EQ(fillIn("", {}), "");
}

TEST(Diagnostic, ShowsAListWithCommas) {
    EXPECT_EQ(fillIn("assumed: {}", {listArgument({"Shape", "Flute length"})}),
              "assumed: Shape, Flute length");
    EXPECT_EQ(fillIn("assumed: {}", {listArgument({"Shape"})}), "assumed: Shape");
    EXPECT_EQ(fillIn("assumed: {1}", {listArgument({})}), "assumed: ");
}

TEST(Diagnostic, HasFiguresWithAPoint) {
    Diagnostic diagnostic;
    diagnostic.text = "{} mm deep at {} ({}).";
    diagnostic.hint = "Less than {1} mm.";
    diagnostic.arguments = {figures("{:.2f}", 0.25), "X1.5", 'G'};
    EXPECT_EQ(message(diagnostic), "0.25 mm deep at X1.5 (G).");
    EXPECT_EQ(hintText(diagnostic), "Less than 0.25 mm.");
    EXPECT_TRUE(diagnostic.arguments[0].isFigures());
    EXPECT_FALSE(diagnostic.arguments[1].isFigures()) << "as the user wrote it";
    EXPECT_EQ(diagnostic.arguments[0], "0.25");
}

Diagnostic unknownWord() {
    Diagnostic diagnostic;
    diagnostic.id = "unknown-word";
    diagnostic.text = "The word {} is not known.";
    diagnostic.arguments = {"G99.7"};
    diagnostic.file = "part.nc";
    return diagnostic;
}

TEST(Diagnostic, OneLineHasFileLineAndColumn) {
    auto diagnostic = unknownWord();
    EXPECT_EQ(oneLine(diagnostic), "part.nc: error: The word G99.7 is not known. [unknown-word]");
    diagnostic.where = {12, 5, 5};
    diagnostic.severity = Severity::fault;
    EXPECT_EQ(oneLine(diagnostic), "part.nc:12:5: fault: The word G99.7 is not known. [unknown-word]");
    diagnostic.file.clear();
    EXPECT_EQ(oneLine(diagnostic), "proveout:12:5: fault: The word G99.7 is not known. [unknown-word]");
}

TEST(Diagnostic, IsOneLineWhateverTheInputHolds) {
    auto diagnostic = unknownWord();
    diagnostic.file = "a\nb\x1b[31m";
    diagnostic.arguments = {std::string("x\0y\r\n", 5)};
    EXPECT_EQ(oneLine(diagnostic), "a\\x0ab\\x1b[31m: error: The word x\\x00y\\x0d\\x0a is not known. "
                                   "[unknown-word]");
}

TEST(Diagnostic, NothingInItTurnsTheTextAroundOrIsNoText) {
    auto diagnostic = unknownWord();
    diagnostic.file = "a\u202egnp.nc";
    diagnostic.arguments = {"Größe 공구 \u0085\u2066\xff\xc3"};
    EXPECT_EQ(oneLine(diagnostic), "a\\xe2\\x80\\xaegnp.nc: error: The word Größe 공구 "
                                   "\\xc2\\x85\\xe2\\x81\\xa6\\xff\\xc3 is not known. [unknown-word]");
}

TEST(Diagnostic, FailureIsOneError) {
    constexpr FindingRow kRow{Severity::error, false, "id", "Title", "Text {}.", "Hint."};
    const auto failed = failure(kRow, {"a"}, "file");
    ASSERT_EQ(failed.value().size(), 1U);
    EXPECT_EQ(failed.value().front().severity, Severity::error);
    EXPECT_EQ(oneLine(failed.value().front()), "file: error: Text a. [id]");
    EXPECT_STREQ(failed.value().front().hint, "Hint.");
}

TEST(Diagnostic, EverySeverityHasAName) {
    EXPECT_STREQ(name(Severity::note), "note");
    EXPECT_STREQ(name(Severity::warning), "warning");
    EXPECT_STREQ(name(Severity::error), "error");
    EXPECT_STREQ(name(Severity::fault), "fault");
}

} // namespace
} // namespace proveout
