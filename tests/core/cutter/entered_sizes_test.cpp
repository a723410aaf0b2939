// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/entered_sizes.h"

#include <gtest/gtest.h>

namespace proveout {
namespace {

SourcedCutter sourced(const char* spec, std::vector<std::string> defaults,
                      std::vector<std::string> entered = {}) {
    return {parseCutter(spec).value(),
            {ToolSource::comment, 3, "T1", std::move(defaults), std::move(entered)}};
}

TEST(EnteredSizes, AToolThatNobodyTouchedFollowsItsComment) {
    const SourcedCutter stated = sourced("flat:d=5", {"shape", "l"});
    const SourcedCutter out = withEntered(stated, sourced("flat:d=6", {"shape", "l"}));
    EXPECT_EQ(out.cutter, stated.cutter);
    EXPECT_EQ(out.origin, stated.origin);
}

TEST(EnteredSizes, StayWhereTheCommentChanges) {
    const SourcedCutter out =
        withEntered(sourced("bull:d=8,r=1", {"l"}), sourced("bull:d=6,r=2,l=20", {}, {"l", "r"}));
    EXPECT_EQ(out.cutter.spec(), "bull:d=8,l=20,r=2");
    EXPECT_TRUE(out.origin.defaults.empty());
    EXPECT_EQ(out.origin.entered, (std::vector<std::string>{"l", "r"}));
    EXPECT_EQ(out.origin.line, 3U);
}

TEST(EnteredSizes, ADefaultValueThatWasEnteredStaysTheDefault) {
    const SourcedCutter out = withEntered(sourced("flat:d=8,l=30", {}), sourced("flat:d=8", {}, {"l"}));
    EXPECT_EQ(out.cutter.spec(), "flat:d=8");
}

TEST(EnteredSizes, AnotherShapeKeepsItsOwnSizes) {
    const SourcedCutter out = withEntered(sourced("flat:d=8,l=30", {"shape"}),
                                          sourced("cone:d=6,angle=60,tip=0.2", {"tip"}, {"shape", "angle"}));
    EXPECT_EQ(out.cutter.spec(), "cone:angle=60,d=8,l=30,tip=0.2");
    EXPECT_EQ(out.origin.defaults, std::vector<std::string>{"tip"});
    const SourcedCutter form =
        withEntered(sourced("flat:d=8", {"shape", "l"}), sourced("form:p=0/0:3/0:3/9", {"l"}, {"shape"}));
    EXPECT_EQ(form.cutter.spec(), "form:p=0/0:3/0:3/9") << "its profile is all that it has";
}

TEST(EnteredSizes, TheCommentCountsWhereBothFitNoCutter) {
    const SourcedCutter stated = sourced("bull:d=3,r=1", {"l"});
    const SourcedCutter out = withEntered(stated, sourced("bull:d=20,r=8", {"l"}, {"r"}));
    EXPECT_EQ(out.cutter, stated.cutter);
    EXPECT_TRUE(out.origin.entered.empty());
}

} // namespace
} // namespace proveout
