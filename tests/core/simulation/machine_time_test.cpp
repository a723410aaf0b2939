// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/time/machine_time.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>

#include "core/nc/run/interpreter.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

/// 6 m/min and 500 mm/s² on every axis, which gives round numbers.
Machine plainMachine() {
    Machine machine;
    machine.rapidXY = machine.rapidZ = machine.largestFeed = 6000;
    machine.accelerationXY = machine.accelerationZ = 500;
    machine.cornerDeviation = 0;
    machine.toolChangeSeconds = 4;
    return machine;
}

std::shared_ptr<const MachineTimes> timesOf(const std::string& text,
                                            const Machine& machine = plainMachine()) {
    InterpretOptions options;
    options.start = Vec3(0);
    return machineTimes(interpret(NcText(text), options), machine);
}

/// Seconds of a move that starts and ends at rest.
double moveSeconds(double length, double mmPerMin, double acceleration = 500) {
    const double speed = mmPerMin / 60;
    return length >= speed * speed / acceleration ? length / speed + speed / acceleration
                                                  : 2 * std::sqrt(length / acceleration);
}

TEST(MachineTime, AddsUpRapidsFeedsDwellsAndToolChanges) {
    const auto times = timesOf("T1 M6\nG0 X100\nG1 Y50 F3000\nG4 P2.5\nT2 M6\nT2 M6\nG1 X0\nG4 P1\nM30\n");
    EXPECT_NEAR(times->parts.rapid, moveSeconds(100, 6000), 1e-9);
    EXPECT_NEAR(times->parts.feed, moveSeconds(50, 3000) + moveSeconds(100, 3000), 1e-9);
    EXPECT_DOUBLE_EQ(times->parts.dwell, 3.5);
    EXPECT_DOUBLE_EQ(times->parts.toolChange, 8); // the current tool is not changed again
    ASSERT_EQ(times->secondsAfter.size(), 4U);
    EXPECT_NEAR(times->secondsAfter[1], 4 + moveSeconds(100, 6000), 1e-9);
    EXPECT_NEAR(times->secondsAfter[2] - times->secondsAfter[1], moveSeconds(50, 3000), 1e-9);
    EXPECT_NEAR(times->secondsAfter[3] - times->secondsAfter[2], 2.5 + 4 + moveSeconds(100, 3000) + 1, 1e-9);
    EXPECT_NEAR(times->secondsAfter.back(), times->parts.total(), 1e-9);
    EXPECT_DOUBLE_EQ(times->lengthAfter.back(), 250);
    ASSERT_EQ(times->tools.size(), 2U);
    EXPECT_EQ(times->tools[1].tool, 2);
    EXPECT_DOUBLE_EQ(times->tools[1].feedLength, 100);
    EXPECT_NEAR(times->tools[0].parts.total() + times->tools[1].parts.total(), times->parts.total(), 1e-9);
}

TEST(MachineTime, KeepsEachAxisWithinItsLimits) {
    Machine machine = plainMachine();
    machine.rapidZ = 3000;
    machine.accelerationZ = 250;
    EXPECT_NEAR(timesOf("G0 Z-100\n", machine)->parts.rapid, moveSeconds(100, 3000, 250), 1e-9);
    // Both axes at their own limit: the path is √2 times as long and √2 times as fast.
    const double root = std::sqrt(2.0);
    EXPECT_NEAR(timesOf("G0 X100 Y100\n", machine)->parts.rapid,
                moveSeconds(100 * root, 6000 * root, 500 * root), 1e-9);
    machine.largestFeed = 1200;
    EXPECT_NEAR(timesOf("G1 X100 F9000\n", machine)->parts.feed, moveSeconds(100, 1200), 1e-9);
}

TEST(MachineTime, KnowsAllWaysToGiveAFeed) {
    // 50 mm in half a minute, and 0.1 mm per revolution at 6000 rpm.
    EXPECT_NEAR(timesOf("G93 G1 X50 F2\n")->parts.feed, moveSeconds(50, 100), 1e-6);
    EXPECT_NEAR(timesOf("S6000 M3\nG95 G1 X50 F0.1\n")->parts.feed, moveSeconds(50, 600), 1e-5);
    const auto without = timesOf("G1 X50\n");
    EXPECT_EQ(without->motionsWithoutFeed, 1U);
    EXPECT_NEAR(without->parts.feed, moveSeconds(50, 6000), 1e-9);
}

TEST(MachineTime, ArcsTakeTheirLengthAndKeepToTheCentripetalLimit) {
    constexpr double kPi = std::numbers::pi;
    // Half a circle of 20 mm at 3000 mm/min, i.e. 50 mm/s: the centripetal acceleration of 125 mm/s² is below
    // the limit of 500.
    EXPECT_NEAR(timesOf("G2 X40 I20 F3000\n")->parts.feed, moveSeconds(20 * kPi, 3000), 1e-9);
    // With a radius of 0.5 mm: √(500·0.5) mm/s.
    EXPECT_NEAR(timesOf("G2 I0.5 F6000\n")->parts.feed, moveSeconds(kPi, 60 * std::sqrt(250)), 1e-9);
    // A helix is as fast as its curvature allows, along its full path.
    const double length = std::hypot(20 * kPi, 20.0);
    const double speed = std::sqrt(500 * length * length / (10 * 4 * kPi * kPi));
    EXPECT_NEAR(timesOf("G2 I10 Z-20 F6000\n")->parts.feed, moveSeconds(length, 60 * speed), 1e-6);
}

TEST(MachineTime, TangentsAreNoCorners) {
    Machine machine = plainMachine();
    machine.accelerationXY = 5000; // so that the arc does not limit the speed
    machine.accelerationZ = 5000;
    constexpr double kPi = std::numbers::pi;
    const auto times = timesOf("G1 X30 F3000\nG3 X30 Y40 J20\nG1 X0\n", machine);
    EXPECT_NEAR(times->parts.feed, moveSeconds(60 + 20 * kPi, 3000, 5000), 1e-6);
}

TEST(MachineTime, SplittingAMotionChangesNothing) {
    std::string split;
    for (int i = 1; i <= 500; ++i)
        split += fmt::format("X{:.1f} Y{:.2f}\n", i * 0.4, i * 0.3);
    const Machine machine; // with a cornering tolerance, which must have no effect
    const double whole = timesOf("G1 F4000 X200 Y150\nX0\n", machine)->parts.total();
    EXPECT_NEAR(timesOf("G1 F4000\n" + split + "X0\n", machine)->parts.total(), whole, 1e-7 * whole);
}

TEST(MachineTime, CountsOnlyWhatIsKnownOfAStart) {
    const auto times = machineTimes(programOf("G0 X10\nG0 Y10 Z10\nG0 X20\n"), plainMachine());
    EXPECT_EQ(times->motionsFromUnknown, 2U);
    EXPECT_NEAR(times->parts.rapid, moveSeconds(10, 6000), 1e-9);
}

TEST(MachineTime, AnEmptyProgramTakesWhatItWaits) {
    const auto times = timesOf("G4 P3\nM30\n");
    EXPECT_EQ(times->secondsAfter, std::vector<double>{0});
    EXPECT_DOUBLE_EQ(times->parts.dwell, 3);
}

TEST(MachineTime, GivesUpWhenItIsStopped) {
    std::stop_source source;
    source.request_stop();
    EXPECT_EQ(machineTimes(programOf(randomProgram(3, 50)), {}, {source.get_token(), {}}), nullptr);
}

TEST(Machine, IsReadFromKeysAndValues) {
    const auto machine = parseMachine("rapidXY=30000,toolChange=2.5");
    ASSERT_TRUE(machine);
    EXPECT_EQ(machine->rapidXY, 30000);
    EXPECT_EQ(machine->toolChangeSeconds, 2.5);
    EXPECT_EQ(machine->rapidZ, Machine().rapidZ);
    for (const char* text : {"speed=3", "rapidXY", "rapidXY=", "rapidXY=fast", "rapidXY=1x", "rapidXY=0",
                             "rapidXY=nan", "=3", "rapidXY=1,,"})
        EXPECT_FALSE(parseMachine(text)) << text;
}

} // namespace
} // namespace proveout
