// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bounded_diagnostics.h"

#include <gtest/gtest.h>

namespace proveout {
namespace {

Diagnostic atLine(int line, Severity severity = Severity::warning) {
    Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.where.line = line;
    return diagnostic;
}

BoundedDiagnostics many(int count) {
    BoundedDiagnostics list;
    for (int line = count; line > 0; --line)
        list.add(atLine(line));
    return list;
}

TEST(BoundedDiagnostics, AreAllThereUpToTheLimit) {
    BoundedDiagnostics list = many(100);
    EXPECT_TRUE(list.full());
    list.sortByPlace();
    const Diagnostics all = list.take();
    ASSERT_EQ(all.size(), 100U);
    EXPECT_EQ(all.front().where.line, 1);
    EXPECT_EQ(all.back().where.line, 100);
    EXPECT_TRUE(list.empty());
}

TEST(BoundedDiagnostics, BeyondTheLimitACountIsAsSevereAsTheWorst) {
    BoundedDiagnostics list = many(150);
    Diagnostic worst = atLine(7, Severity::error);
    worst.unverified = true;
    list.add(worst);
    list.omit(Severity::note, false, 9);
    const Diagnostics all = list.take();
    ASSERT_EQ(all.size(), 101U);
    EXPECT_EQ(message(all.back()), "60 more messages are not shown.");
    EXPECT_EQ(all.back().severity, Severity::error);
    EXPECT_TRUE(all.back().unverified);
    EXPECT_FALSE(all.front().unverified);
}

TEST(BoundedDiagnostics, OfTwoListsCountTogether) {
    BoundedDiagnostics list = many(30);
    list.append(many(200));
    const Diagnostics all = list.take(FindingRow{Severity::note, false, "more", "", "{} more.", ""});
    ASSERT_EQ(all.size(), 101U);
    EXPECT_EQ(message(all.back()), "130 more.");
    EXPECT_STREQ(all.back().id, "more");
}

} // namespace
} // namespace proveout
