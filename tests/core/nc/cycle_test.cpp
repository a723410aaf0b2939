// SPDX-License-Identifier: GPL-3.0-or-later
// The spindle in the canned cycles of Fanuc's dialect, which the case files do not show. Source: operator's
// manual B-64304EN-2, canned cycles for drilling, rigid tapping.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/nc/interpreter.h"

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

/// The motions of line `line`.
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

TEST(Cycles, RigidTappingTurnsInAndOutAndStandsOtherwise) {
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

} // namespace proveout
