// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <set>
#include <string>

#include "core/verification/findings/rule_findings.h"
#include "core/verification/rules/rules.h"
#include "core/verification/verdict/verdict.h"

namespace proveout {
namespace {

NotChecked entry(bool accepted) {
    return {&notCheckedRows().front(), accepted};
}

TEST(Verdict, IsSafeOnlyIfNothingWasFoundOrLeftOut) {
    const Diagnostics note{diagnosticOf(rule_finding::kAirCutting)};
    const Diagnostics fault{diagnosticOf(rule_finding::kSpindleStopped)};
    const Diagnostics unverified{diagnosticOf(rule_finding::kNothingCut)};
    const NotChecked accepted[] = {entry(true)};
    const NotChecked open[] = {entry(true), entry(false)};
    EXPECT_EQ(verdictOf({}, {}), Verdict::safe);
    EXPECT_EQ(verdictOf(note, accepted), Verdict::safe);
    EXPECT_EQ(verdictOf({}, open), Verdict::unverified);
    EXPECT_EQ(verdictOf(unverified, accepted), Verdict::unverified);
    EXPECT_EQ(verdictOf(fault, accepted), Verdict::faults);
    EXPECT_EQ(verdictOf(fault, open), Verdict::faults);
}

TEST(Verdict, NamesEachEntryAndRuleOnce) {
    std::set<std::string> ids;
    for (const NotCheckedRow& row : notCheckedRows())
        EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    for (const Rule& rule : rules())
        EXPECT_TRUE(ids.insert(rule.id()).second) << rule.id();
}

} // namespace
} // namespace proveout
