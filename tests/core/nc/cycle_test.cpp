// SPDX-License-Identifier: GPL-3.0-or-later
// The spindle in the canned cycles of the Fanuc dialect, which the case files do not cover. Source:
// operator's manual B-64304EN-2, canned cycles for drilling, rigid tapping.
#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

#include "core/nc/codes/canned_cycle.h"
#include "core/nc/run/interpreter.h"
#include "tests/random_seed.h"

namespace proveout {

namespace {

struct Turn {
    MotionKind kind;
    double z;
    double rpm;
    bool operator==(const Turn&) const = default;
};

void PrintTo(const Turn& turn, std::ostream* out) {
    *out << (turn.kind == MotionKind::rapid ? "rapid" : "feed") << " Z" << turn.z << " S" << turn.rpm;
}

/// The motions of source line `line`.
std::vector<Turn> turnsOf(const std::string& text, std::uint32_t line, DialectId dialect = DialectId::fanuc) {
    InterpretOptions options;
    options.dialect = dialect;
    options.start = Vec3(0, 0, 5);
    const auto program = interpret(NcText(text), options);
    std::vector<Turn> turns;
    for (std::size_t i = 0; i < program->motionCount(); ++i) {
        const Motion motion = program->motion(i);
        if (motion.line == line)
            turns.push_back({motion.kind, motion.end.z, motion.spindleRpm});
    }
    return turns;
}

constexpr auto kRapid = MotionKind::rapid;
constexpr auto kFeed = MotionKind::feed;

} // namespace

TEST(Cycles, RigidTappingTurnsInAndOutAndStopsOtherwise) {
    const std::string text = "G21 G90 S500 M3\nM29\nG98 G84 X1. R2. Z-4. F500.\nG80\nM30\n";
    const std::vector<Turn> expected{
        {kRapid, 5, 0}, {kRapid, 2, 0}, {kFeed, -4, 500}, {kFeed, 2, -500}, {kRapid, 5, 0}};
    EXPECT_EQ(turnsOf(text, 3), expected);
}

TEST(Cycles, TappingWithAFloatingChuckTurnsAsBeforeAfterwards) {
    const std::string text = "G21 G90 S500 M4\nG98 G74 X1. R2. Z-4. F500.\nG80\nM30\n";
    const std::vector<Turn> expected{
        {kRapid, 5, -500}, {kRapid, 2, -500}, {kFeed, -4, -500}, {kFeed, 2, 500}, {kRapid, 5, -500}};
    EXPECT_EQ(turnsOf(text, 2), expected);
}

TEST(Cycles, PecksOfATapTurnBackInBetween) {
    const std::string text = "G21 G90\nM29 S100\nG99 G84 X0. R2. Z-4. Q4. F100.\nG80\nM30\n";
    const std::vector<Turn> expected{
        {kRapid, 2, 0}, {kFeed, -2, 100}, {kFeed, -1, -100}, {kFeed, -4, 100}, {kFeed, 2, -100}};
    EXPECT_EQ(turnsOf(text, 3), expected);
}

TEST(Cycles, TheTapOfHaasTurnsFasterOnItsWayOut) {
    const std::string text = "G21 G90 S500\nG99 G84 X0. R2. Z-4. J2 F500.\nG80\nM30\n";
    const std::vector<Turn> expected{{kRapid, 2, 0}, {kFeed, -4, 500}, {kFeed, 2, -1000}};
    EXPECT_EQ(turnsOf(text, 2, DialectId::haas), expected);
}

TEST(Cycles, BoringStopsTheSpindleOnItsWayOut) {
    const std::string text = "G21 G90 S500 M3\nG98 G86 X0. R2. Z-4. F500.\nX1.\nG80\nM30\n";
    const std::vector<Turn> expected{{kRapid, 2, 500}, {kFeed, -4, 500}, {kRapid, 5, 0}};
    EXPECT_EQ(turnsOf(text, 2), expected);
    EXPECT_EQ(turnsOf(text, 3).front(), (Turn{kRapid, 5, 500}));
}

TEST(Cycles, BackBoringTurnsOnlyWhileItBores) {
    const std::string text = "G21 G90 S500 M3\nG98 G87 X1. R-20. Z-15. Q2. F500.\nG80\nM30\n";
    const std::vector<Turn> expected{{kRapid, 5, 500},  {kRapid, 5, 0},   {kRapid, -20, 0}, {kRapid, -20, 0},
                                     {kFeed, -15, 500}, {kRapid, -15, 0}, {kRapid, 5, 0},   {kRapid, 5, 0}};
    EXPECT_EQ(turnsOf(text, 2), expected);
}

TEST(Cycles, OrientationStopsTheSpindle) {
    const std::string text = "G21 G90 S500 M3\nG1 X1. F100.\nM19\nG1 X2.\nM30\n";
    EXPECT_EQ(turnsOf(text, 4), (std::vector<Turn>{{kFeed, 5, 0}}));
}

TEST(Cycles, M5StopsTheSpindleBehindTheMotionOfItsBlock) {
    const std::string text = "G21 G90 S500 M3\nG1 X1. F100. M5\nX2.\nM30\n";
    EXPECT_EQ(turnsOf(text, 2), (std::vector<Turn>{{kFeed, 5, 500}}));
    EXPECT_EQ(turnsOf(text, 3), (std::vector<Turn>{{kFeed, 5, 0}}));
}

/// Compares with the pecks generated one by one.
TEST(Cycles, PecksAreCountedBeforeTheyAreMade) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const auto length = [&](double most) { return std::uniform_real_distribution<double>(0, most)(random); };
    for (int round = 0; round < 2000; ++round) {
        Pecks pecks{.first = length(2)};
        pecks.least = random() % 3 == 0 ? 0.0 : pecks.first * (random() % 2 == 0 ? 1 : length(1.2));
        pecks.less = random() % 2 == 0 ? 0.0 : length(0.5 * pecks.first);
        const double depth = length(50);
        double made = 0;
        double step = pecks.first;
        for (double at = step; step > 0 && at < depth; at += step) {
            ++made;
            step = std::max(step - pecks.less, pecks.least);
        }
        const double counted = pecks.count(depth);
        // The last decreasing peck may count as several of the minimum.
        const double shallow = pecks.least > 0 ? pecks.less / pecks.least : 0;
        ASSERT_GE(counted, made) << pecks.first << ' ' << pecks.less << ' ' << pecks.least << ' ' << depth;
        ASSERT_LE(counted, made + 3 + shallow)
            << pecks.first << ' ' << pecks.less << ' ' << pecks.least << ' ' << depth;
    }
    EXPECT_EQ(Pecks{}.count(10), 0);
    EXPECT_GT((Pecks{.first = 1e-300, .least = 1e-300}.count(10)), 1e300);
}

/// The longest holes and rows of holes in practice are far below the limit of a block.
TEST(Cycles, LongJobsOfOneBlockAreDrilled) {
    const std::string head = "G21 G90 G0 X0 Y0 Z5. S500 M3 F500.\n";
    InterpretOptions options;
    options.dialect = DialectId::fanuc;
    for (const std::string block :
         {"G83 X1. R2. Z-3000. Q0.5", "G91 G81 X1. R-3. Z-4. K9999", "G91 G83 X1. R-3. Z-50. Q1. K99"}) {
        const auto program = interpret(NcText(head + block + "\nG80\nM30\n"), options);
        EXPECT_FALSE(program->unverified()) << block;
        EXPECT_GT(program->motionCount(), 9000U) << block;
    }
}

} // namespace proveout
