// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/repetition.h"

#include <gtest/gtest.h>
#include <optional>
#include <random>
#include <vector>

#include "core/nc/text/expression_rules.h"
#include "core/nc/text/parameters.h"
#include "tests/random_seed.h"

namespace proveout {

namespace {

constexpr Repetition::Limits kFew{10, 5};

/// The number of jumps along `heads` until a repetition is detected, if they repeat from index `again` on.
std::optional<std::size_t> jumpsUntilClosed(const std::vector<Repetition::Head>& heads, std::size_t again) {
    Repetition repetition;
    const Program program;
    std::size_t at = 0;
    for (std::size_t jumps = 1; jumps < 100 * heads.size(); ++jumps) {
        if (repetition.closes(heads[at], program))
            return jumps;
        at = at + 1 < heads.size() ? at + 1 : again;
    }
    return {};
}

} // namespace

TEST(Repetition, FindsARoundOfAnyNumberOfJumps) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 200; ++round) {
        std::vector<Repetition::Head> heads(1 + random() % 60);
        std::uint64_t changes = random() % 3;
        const std::size_t again = random() % heads.size();
        for (std::size_t i = 0; i < heads.size(); ++i) {
            changes += i <= again ? random() % 2 : 0;
            heads[i] = {0, i, 0, changes};
        }
        const auto jumps = jumpsUntilClosed(heads, again);
        ASSERT_TRUE(jumps);
        EXPECT_GT(*jumps, heads.size()); // no head occurs twice before
        EXPECT_LE(*jumps, 4 * heads.size() + 4);
    }
}

TEST(Repetition, AnythingThatChangesOpensARound) {
    Repetition repetition;
    const Program program;
    const Repetition::Head head{0, 7, 1, 3};
    EXPECT_FALSE(repetition.closes(head, program));
    EXPECT_FALSE(repetition.closes({1, 7, 1, 3}, program)); // the text differs
    repetition.noteUse();
    EXPECT_FALSE(repetition.closes(head, program));
    repetition.leftTo(0); // leaves the call
    EXPECT_FALSE(repetition.closes(head, program));
    repetition.leftTo(1);
    EXPECT_TRUE(repetition.closes(head, program));
}

TEST(Repetition, CountsWhatRunsAgain) {
    Repetition repetition;
    Program program;
    const auto run = [&](bool again, bool moves, std::size_t length = 10) {
        repetition.begin(again, program);
        if (moves) {
            program.beginBlock(1);
            program.append(Motion{});
        }
        repetition.end(length, {}, program);
        return repetition.verdict(kFew);
    };
    for (int line = 0; line < 100; ++line)
        ASSERT_EQ(run(false, true), Repetition::Verdict::continues);
    for (int line = 0; line < 5; ++line)
        ASSERT_EQ(run(true, true), Repetition::Verdict::continues);
    EXPECT_EQ(run(true, true), Repetition::Verdict::tooMuch); // six lines and their motions
    EXPECT_EQ(repetition.before().motions, 100U);

    Repetition idle;
    for (int line = 0; line < 5; ++line) {
        idle.begin(true, program);
        idle.end(10, {}, program);
        EXPECT_EQ(idle.verdict(kFew), Repetition::Verdict::continues);
    }
    idle.begin(true, program);
    idle.end(10, {}, program);
    EXPECT_EQ(idle.verdict(kFew), Repetition::Verdict::idle);

    Repetition longLine;
    longLine.begin(true, program);
    longLine.end(100'000, {}, program);
    EXPECT_NE(longLine.verdict(kFew), Repetition::Verdict::continues);
}

TEST(Repetition, ParametersCountWhatIsAnotherValue) {
    Parameters parameters(MacroLanguage::macroB);
    const std::uint64_t before = parameters.changes();
    parameters.setNumbered(100, kNull); // the previous value
    parameters.setNumbered(1, kNull);
    EXPECT_EQ(parameters.changes(), before);
    parameters.setNumbered(100, 0);
    parameters.setNumbered(1, 0);
    EXPECT_EQ(parameters.changes(), before + 2);
    parameters.enter(parameters.noArguments());
    parameters.setNumbered(1, 5); // a parameter of the call
    parameters.leave();
    EXPECT_EQ(parameters.changes(), before + 2);
    EXPECT_TRUE(parameters.setNamed("_a", 1));
    EXPECT_TRUE(parameters.setNamed("_a", 1));
    EXPECT_EQ(parameters.changes(), before + 3);
}

} // namespace proveout
