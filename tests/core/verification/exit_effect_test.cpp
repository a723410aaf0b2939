// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/findings/exit_effect.h"

#include <gtest/gtest.h>

#include "core/verification/findings/findings.h"

namespace proveout {
namespace {

TEST(ExitEffects, FollowSeverityAndWhatIsUnverified) {
    EXPECT_EQ(exitEffect(Severity::fault, false), ExitEffect::faults);
    EXPECT_EQ(exitEffect(Severity::fault, true), ExitEffect::faults);
    EXPECT_EQ(exitEffect(Severity::error, false), ExitEffect::unverified);
    EXPECT_EQ(exitEffect(Severity::warning, true), ExitEffect::unverified);
    EXPECT_EQ(exitEffect(Severity::note, true), ExitEffect::unverified);
    EXPECT_EQ(exitEffect(Severity::warning, false), ExitEffect::none);
    EXPECT_EQ(exitEffect(Severity::note, false), ExitEffect::none);
}

TEST(ExitEffects, OutrankEachOtherAsTheContractSays) {
    using enum ExitEffect;
    EXPECT_EQ(worse(unusable, faults), unusable);
    EXPECT_EQ(worse(faults, unverified), faults);
    EXPECT_EQ(worse(unverified, faults), faults);
    EXPECT_EQ(worse(none, unverified), unverified);
    EXPECT_EQ(worse(none, none), none);
}

ExitEffect effectOf(std::string_view id) {
    for (const FindingTable& table : findingTables())
        for (const FindingRow* row : table.rows)
            if (row->id == id)
                return exitEffect(table, *row);
    ADD_FAILURE() << "no finding " << id;
    return ExitEffect::none;
}

TEST(ExitEffects, OfRowsDistinguishRefusedInputFromWhatIsUnverified) {
    EXPECT_EQ(effectOf("rapid-cuts"), ExitEffect::faults);
    EXPECT_EQ(effectOf("code-unknown"), ExitEffect::unverified);
    EXPECT_EQ(effectOf("tool-unconfirmed"), ExitEffect::unverified);
    EXPECT_EQ(effectOf("stock-mesh-open"), ExitEffect::unverified);
    EXPECT_EQ(effectOf("file-unreadable"), ExitEffect::unusable);
    EXPECT_EQ(effectOf("nc-binary"), ExitEffect::unusable);
    EXPECT_EQ(effectOf("dialect-foreign"), ExitEffect::unusable);
    EXPECT_EQ(effectOf("not-a-program"), ExitEffect::unusable);
    EXPECT_EQ(effectOf("job-field-unknown"), ExitEffect::none);
    EXPECT_EQ(effectOf("feed-zero"), ExitEffect::none);
}

} // namespace
} // namespace proveout
