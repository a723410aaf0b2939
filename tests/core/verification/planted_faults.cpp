// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/verification/planted_faults.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <numbers>
#include <vector>

#include "core/cutting/fixtures/fixture_surface.h"

namespace proveout {

namespace {

constexpr double kSpacing = 0.5;
constexpr int kThickness = 20;
constexpr int kHeadWidth = 5; // of T3
constexpr int kHolderHeight = 40;
constexpr int kLanes = 4; // of the cuts without a fault, at Y12, Y28, …
constexpr const char* kToFault = "G0 X[20] Y[92] Z[5]";

// ---- cuts without a fault, each in a lane of its own ----

void writeSlot(TwinProgram& out, int y) {
    out.line(fmt::format("G0 X[10] Y[{}] Z[5]", y));
    out.line(fmt::format("G1 Z[-{}] F[400]", out.among(2, 4)));
    out.line(fmt::format("X[{}] F[800]", out.among(100, 130)));
    out.line("G0 Z[5]");
}

void writeArc(TwinProgram& out, int y) {
    out.line(fmt::format("G0 X[30] Y[{}] Z[5]", y));
    out.line("G1 Z[-2] F[400]");
    out.line(fmt::format("G{} X[38] Y[{}] I[4] J[0] F[600]", out.among(2, 3), y));
    out.line("G1 X[60]");
    out.line("G0 Z[5]");
}

void writeHelix(TwinProgram& out, int y) {
    out.line(fmt::format("G0 X[33] Y[{}] Z[5]", y));
    out.line("G1 Z[0] F[400]");
    out.line(fmt::format("G3 X[33] Y[{}] I[-3] J[0] Z[-2]", y));
    out.line(fmt::format("G3 X[33] Y[{}] I[-3] J[0]", y));
    out.line("G0 Z[5]");
}

void takeTool(TwinProgram& out, int tool) {
    out.line(fmt::format("T{} M6", tool));
    out.line(fmt::format("S{} M3", out.among(8, 60) * 100));
    out.line(fmt::format("G0 G43 H{} Z[50]", tool));
}

void changeTo(TwinProgram& out, int tool) {
    out.line("G0 Z[50]");
    out.line("M5");
    takeTool(out, tool);
}

void writeHoles(TwinProgram& out, int y) {
    changeTo(out, 2);
    out.line(fmt::format("G0 X[20] Y[{}] Z[5]", y));
    out.line(out.either() ? "G98 G81 Z[-6] R[2] F[300]" : "G99 G83 Z[-9] R[1] Q[2] F[300]");
    out.line("X[40]");
    out.line("X[60]");
    out.line("G80");
    changeTo(out, 1);
}

constexpr std::array kCuts{writeSlot, writeArc, writeHelix, writeHoles};

// ---- faults, in the lane at Y92 ----

void plantRapidLine(Planting& p) {
    const int depth = p.program.among(1, 8);
    p.program.line(kToFault);
    p.program.line(fmt::format("G1 Z[-{}] F[200]", depth));
    p.program.line("X[40]");
    p.program.mark();
    p.program.faulty("G0 X[60]");
    p.program.clean("G1 X[60]");
    p.program.line("G1 X[70]");
    p.value = depth;
}

void plantRapidPlunge(Planting& p) {
    const int depth = p.program.among(1, 8);
    p.program.line(kToFault);
    p.program.mark();
    p.program.faulty(fmt::format("G0 Z[-{}]", depth));
    p.program.clean(fmt::format("G1 Z[-{}] F[200]", depth));
    p.program.line("G1 X[40] F[200]");
    p.value = depth;
}

void plantRapidOfCycle(Planting& p) {
    const int depth = p.program.among(1, 6);
    changeTo(p.program, 2);
    p.program.line(kToFault);
    const char* cycle = p.program.either() ? "G98 G81" : "G98 G83 Q[3]";
    p.program.mark();
    p.program.faulty(fmt::format("{} Z[-10] R[-{}] F[300]", cycle, depth));
    p.program.clean(fmt::format("{} Z[-10] R[2] F[300]", cycle));
    p.program.line("G80");
    changeTo(p.program, 1);
    p.value = depth;
}

/// The spindle is turned off or back before a cut, and forward again after it.
void plantSpindle(Planting& p, const char* code) {
    const int depth = p.program.among(1, 8);
    p.program.line(kToFault);
    p.program.faulty(code);
    p.program.mark();
    p.program.line(fmt::format("G1 Z[-{}] F[200]", depth));
    p.program.line("X[50]");
    p.program.line("G0 Z[5]");
    p.program.faulty("M3");
    p.value = depth;
}

void plantStoppedSpindle(Planting& p) {
    plantSpindle(p, "M5");
}

/// Routers of hobbyists are often switched on by hand, and their programs give no speed.
void plantUnusedSpindle(Planting& p) {
    p.program.dropSpindle();
    p.program.line(kToFault);
    p.program.mark();
    p.program.line("G1 Z[-3] F[200]");
    p.program.line("X[120]");
    p.value = 3;
}

void plantReversedSpindle(Planting& p) {
    plantSpindle(p, "M4");
}

void plantFeed(Planting& p) {
    const int feed = p.program.among(31, 60) * 100;
    p.machine = Machine{.largestFeed = 3000};
    p.program.line(kToFault);
    p.program.line("G1 Z[-2] F[200]");
    p.program.mark();
    p.program.faulty(fmt::format("X[60] F[{}]", feed));
    p.program.clean("X[60] F[3000]");
    p.value = feed;
}

void plantSidewaysDrill(Planting& p) {
    const int depth = p.program.among(2, 8);
    const bool arc = p.program.either();
    changeTo(p.program, 2);
    p.program.line(kToFault);
    p.program.line(fmt::format("G1 Z[-{}] F[200]", depth));
    p.program.mark();
    p.program.faulty(arc ? "G3 X[20] Y[92] I[-3] J[0]" : "X[30]");
    p.program.line("G0 Z[5]");
    changeTo(p.program, 1);
    p.value = depth;
}

void plantBelowStock(Planting& p) {
    const int below = p.program.among(4, 9);
    const bool cycle = p.program.either();
    p.flutes = 40;
    p.stickOut = 60;
    if (cycle)
        changeTo(p.program, 2);
    p.program.line(kToFault);
    p.program.mark();
    const char* words = cycle ? "G98 G83 R[2] Q[5] Z[-{}] F[300]" : "G1 Z[-{}] F[200]";
    p.program.faulty(fmt::format(fmt::runtime(words), kThickness + below));
    p.program.clean(fmt::format(fmt::runtime(words), kThickness + 2));
    if (cycle) {
        p.program.line("G80");
        changeTo(p.program, 1);
    }
    p.value = below;
}

void plantBeyondFlutes(Planting& p) {
    p.flutes = p.program.among(5, 9);
    const int depth = p.flutes + p.program.among(1, 4);
    p.program.line(kToFault);
    p.program.mark();
    p.program.faulty(fmt::format("G1 Z[-{}] F[200]", depth));
    p.program.clean(fmt::format("G1 Z[-{}] F[200]", p.flutes));
    p.program.line("X[50]");
    p.value = depth;
}

void plantHolder(Planting& p) {
    p.stickOut = p.program.among(10, 16);
    p.flutes = p.stickOut;
    const int overlap = p.program.among(1, 3);
    p.program.line(kToFault);
    p.program.mark();
    p.program.faulty(fmt::format("G1 Z[-{}] F[200]", p.stickOut + overlap));
    p.program.clean(fmt::format("G1 Z[-{}] F[200]", p.stickOut - 1));
    p.value = overlap;
    p.alsoFound = {"depth-beyond-flutes"};
}

/// A pocket in steps of 2 mm, whose edge the holder reaches in the last step.
void plantHolderAtEdge(Planting& p) {
    p.stickOut = p.program.among(5, 11);
    p.flutes = p.stickOut;
    p.holder = p.diameter + 12;
    p.program.line(kToFault);
    int depth = 0;
    const auto step = [&](bool both) {
        depth += 2;
        for (const std::string& words : {fmt::format("G1 Z[-{}] F[200]", depth), std::string("Y[96]"),
                                         std::string("X[24]"), std::string("Y[92]"), std::string("X[20]")})
            both ? p.program.line(words) : p.program.faulty(words);
    };
    while (depth + 2 <= p.stickOut)
        step(true);
    p.program.mark();
    step(false);
    p.value = depth - p.stickOut;
}

void plantShank(Planting& p) {
    p.flutes = p.program.among(6, 12);
    p.shank = p.diameter + 4;
    const int overlap = p.program.among(1, 3);
    p.program.line(kToFault);
    p.program.mark();
    p.program.faulty(fmt::format("G1 Z[-{}] F[200]", p.flutes + overlap));
    p.program.clean(fmt::format("G1 Z[-{}] F[200]", p.flutes));
    p.value = overlap;
    p.alsoFound = {"depth-beyond-flutes"};
}

/// A part of the tool, so far above its tip, comes near to the top of the stock.
void plantNear(Planting& p, int above, int clearance) {
    p.holderClearance = clearance;
    const int gap = p.program.among(1, clearance - 1);
    p.program.line(kToFault);
    p.program.mark();
    p.program.faulty(fmt::format("G1 Z[-{}] F[200]", above - gap));
    p.program.clean(fmt::format("G1 Z[-{}] F[200]", above - clearance));
    p.value = clearance - gap;
}

void plantHolderNear(Planting& p) {
    const int above = p.program.among(14, 18);
    p.stickOut = above;
    p.flutes = above;
    plantNear(p, above, 4);
}

void plantShankNear(Planting& p) {
    const int above = p.program.among(14, 18);
    p.flutes = above;
    p.shank = p.diameter + 4;
    plantNear(p, above, 3);
}

/// A square is cut around; in the twin, a bridge is left.
void plantLoosePiece(Planting& p) {
    p.shape = "flat";
    p.flutes = 40;
    p.stickOut = 60;
    // No point of the grid is on the edge of the cut.
    p.program.line("G0 X[20.25] Y[80.25] Z[5]");
    p.program.line("G1 Z[-20.5] F[200]");
    p.program.line("X[44.25]");
    p.program.line("Y[104.25]");
    p.program.line("X[20.25]");
    p.program.faulty("Y[80.25]");
    p.program.clean(fmt::format("Y[{}.25]", 80 + p.diameter + 6));
    p.value = std::pow(24 - p.diameter, 2) * kThickness;
}

void plantNothingCut(Planting& p) {
    p.program.faulty("G0 X[320] Y[92] Z[5]");
    p.program.clean(kToFault);
    p.program.line("G1 Z[-3] F[200]");
    p.program.faulty("X[400]");
    p.program.clean("X[120]");
    p.alsoFound = {"never-cuts"};
}

void plantHardlyCuts(Planting& p) {
    p.program.line(kToFault);
    p.program.faulty("G1 Z[-0.05] F[200]");
    p.program.clean("G1 Z[-3] F[200]");
    p.program.clean("X[120]");
}

void plantAirCutting(Planting& p) {
    const int speed = p.program.among(2, 5) * 100;
    p.program.line(kToFault);
    p.program.mark();
    p.program.faulty(fmt::format("G1 X[120] F[{}]", speed));
    p.program.clean("G0 X[120]");
    p.program.line("G1 Z[-2] F[300]");
    p.value = 100 * 60.0 / speed;
}

void plantMissingFeed(Planting& p) {
    p.program.line(kToFault);
    p.program.mark();
    p.program.faulty("G1 Z[-3]");
    p.program.clean("G1 Z[-3] F[300]");
    p.program.line("X[120] F[300]");
}

void plantUnknownCode(Planting& p) {
    p.program.line(kToFault);
    p.program.mark();
    p.program.faulty(p.program.either() ? "G12.9" : "G38.9");
}

void plantRotaryWord(Planting& p) {
    p.program.line(kToFault);
    p.program.mark();
    p.program.faulty(p.program.either() ? "G0 A90." : "G0 B-45.");
}

void plantArcEnd(Planting& p) {
    p.program.line(kToFault);
    p.program.line("G1 Z[-2] F[200]");
    p.program.mark();
    p.program.faulty("G2 X[33] Y[92] I[4] J[0]");
    p.program.clean("G2 X[28] Y[92] I[4] J[0]");
    p.program.line("G0 Z[5]");
    p.alsoFound = {"rapid-cuts"}; // from where the arc began
}

/// The head of the keyseat cutter leaves room for its neck only near the top.
void plantNeck(Planting& p) {
    const int depth = p.program.among(7, 12);
    changeTo(p.program, 3);
    p.program.line("G0 X[-20] Y[92.25] Z[5]");
    p.program.faulty(fmt::format("G0 Z[-{}]", depth));
    p.program.clean("G0 Z[-4]");
    p.program.mark();
    p.program.line("G1 X[30] F[900]");
    p.program.line("X[-20]");
    changeTo(p.program, 1);
    p.value = depth - kHeadWidth;
    p.alsoFound = {"overhang-lost"};
}

void plantMissingTool(Planting& p) {
    p.program.line("G0 Z[50]");
    p.program.faulty("M5");
    p.program.faulty("T7 M6");
    p.program.faulty("S2000 M3");
    p.program.faulty("G43 H7");
    p.program.mark(); // the first motion of the tool
    p.program.line(kToFault);
    p.program.line("G1 Z[-2] F[300]");
    p.program.line("X[40]");
    p.program.line("G0 Z[50]");
    p.program.faulty("M5");
    p.program.faulty("T1 M6");
    p.program.faulty("S2000 M3");
    p.program.faulty("G43 H1");
    p.alsoFound = {"offset-unknown"};
}

/// The frame is as large as the stock, in a unit that the program does not state.
void plantWrongUnit(Planting& p, bool tooSmall) {
    p.program.writeIn(tooSmall);
    p.program.faulty(tooSmall ? "G21" : "G20");
    p.program.clean(tooSmall ? "G20" : "G21");
    p.program.line("G0 X[10] Y[8] Z[5]");
    p.program.line("G1 Z[-2] F[300]");
    p.program.line("X[130]");
    p.program.line("Y[102]");
    p.program.line("X[10]");
    p.program.line("Y[8]");
}

void plantInchesAsMillimetres(Planting& p) {
    plantWrongUnit(p, true);
    p.alsoFound = {"nothing-cut", "rapid-too-close"};
}

void plantMillimetresAsInches(Planting& p) {
    plantWrongUnit(p, false);
    p.alsoFound = {"nothing-cut", "never-cuts"};
}

/// Its ridge is parallel to X, in the middle, and as high as `h` says; turned by a quarter of a turn.
Fixture meshOfWedge(double x, double y, double z, double w, double d, double h) {
    const auto at = [](double left, double up, double back) { // as in the file
        return glm::vec3(static_cast<float>(back), static_cast<float>(-left), static_cast<float>(up));
    };
    const std::array near{at(0, 0, 0), at(0, 0, d), at(0, h, d / 2)};
    const std::array far{at(w, 0, 0), at(w, 0, d), at(w, h, d / 2)};
    std::vector<FixtureFacet> facets{{near[0], near[1], near[2]}, {far[0], far[2], far[1]}};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        facets.push_back({near[k], far[k], near[next]});
        facets.push_back({near[next], far[k], far[next]});
    }
    return FixtureMesh{
        .x = x, .y = y, .z = z, .turn = 90, .surface = std::make_shared<const FixtureSurface>(facets)};
}

/// A clamp beside the stock, at X165 in the lane.
void plantFixture(Planting& p, const char* moveToIt) {
    const int top = p.program.among(8, 30);
    const int overlap = p.program.among(1, 4);
    const double height = top + kThickness;
    const std::array<Fixture, 3> clamps{FixtureBox{150, 80, -kThickness, 30, 24, height},
                                        FixtureCylinder{165, 92, -kThickness, 20, height},
                                        meshOfWedge(150, 80, -kThickness, 30, 24, height)};
    p.fixtures["clamp"] = clamps[static_cast<std::size_t>(p.program.among(0, 2))];
    p.program.line("G0 X[120] Y[92] Z[50]");
    p.program.faulty(fmt::format("Z[{}]", top - overlap));
    p.program.clean(fmt::format("Z[{}]", top + 2));
    p.program.mark();
    p.program.line(moveToIt);
    p.program.line("G0 Z[50]");
    p.program.line("X[120]");
    p.value = overlap;
}

void plantFixtureInRapid(Planting& p) {
    plantFixture(p, "X[165]");
}

void plantFixtureInArc(Planting& p) {
    plantFixture(p, "G3 X[165] Y[92] I[22.5] J[0] F[3000]");
}

void plantFixtureInCycle(Planting& p) {
    const int overlap = p.program.among(1, 6);
    p.fixtures["screw"] = FixtureCylinder{165, 92, -10, 8, 20};
    changeTo(p.program, 2);
    p.program.line(kToFault);
    p.program.line("G98 G81 Z[-6] R[2] F[300]");
    p.program.line("G0 Z[15]");
    p.program.line(fmt::format("G98 G81 X[120] Z[-6] R[{}] F[300]", 10 - overlap));
    p.program.mark();
    p.program.faulty("X[165]");
    p.program.line("G80");
    changeTo(p.program, 1);
    p.value = 16; // to the bottom of the hole
}

// ---- what a tool may do ----

void setSpindle(TwinProgram& out, int faulty, int clean) {
    out.faulty(fmt::format("S{}", faulty));
    out.clean(fmt::format("S{}", clean));
}

/// A slot of the full width of a flat mill, after a plunge; the fault is in its second block.
void writeFullSlot(Planting& p, int depth, int faultyFeed, int cleanFeed) {
    p.shape = "flat";
    p.program.line("G0 X[20] Y[92.25] Z[5]"); // no point of the grid is on its edges
    p.program.line(fmt::format("G1 Z[-{}] F[100]", depth));
    p.program.mark();
    p.program.faulty(fmt::format("X[60] F[{}]", faultyFeed));
    p.program.clean(fmt::format("X[60] F[{}]", cleanFeed));
}

void plantDepth(Planting& p) {
    p.limits = ",maxap=4";
    const int depth = p.program.among(5, 10);
    p.program.line(kToFault);
    p.program.faulty(fmt::format("G1 Z[-{}] F[200]", depth));
    p.program.clean("G1 Z[-4] F[200]");
    p.program.mark(); // a plunge does not load the side
    p.program.line("X[50]");
    p.value = depth;
}

/// Along the edge of the stock at Y110, between points of the grid.
void plantEngagement(Planting& p) {
    p.shape = "flat";
    p.limits = ",maxae=2";
    const double edge = 110 + p.diameter / 2.0;
    p.program.line("G0 X[-20] Y[130] Z[-5]");
    const int width = p.program.among(3, 4);
    p.program.faulty(fmt::format("Y[{}]", edge - width));
    p.program.clean(fmt::format("Y[{}]", edge - 1));
    p.program.mark();
    p.program.line("G1 X[160] F[800]");
    p.program.line("G0 Z[50]");
}

void plantChips(Planting& p) {
    p.limits = ",z=2,maxchip=0.6";
    const int feed = p.program.among(14, 24) * 100;
    p.program.line("S1000");
    writeFullSlot(p, 2, feed, 1000);
    p.value = feed / 2000.0;
}

void plantSurfaceSpeed(Planting& p) {
    p.limits = ",maxvc=200";
    const int speed = p.program.among(20, 30) * 1000;
    setSpindle(p.program, speed, 6000);
    writeFullSlot(p, 2, 300, 300);
    p.program.markBefore(1); // the plunge turns as fast
    p.program.line("G0 Z[5]");
    setSpindle(p.program, 5000, 5000);
    p.value = std::numbers::pi * p.diameter * speed / 1000;
}

void plantToolFeed(Planting& p) {
    p.limits = ",maxfeed=2000";
    const int feed = p.program.among(25, 50) * 100;
    writeFullSlot(p, 2, feed, 2000);
    p.value = feed;
}

void plantSpindle(Planting& p, int most) {
    const int speed = most + p.program.among(1, 12) * 1000;
    setSpindle(p.program, speed, most);
    writeFullSlot(p, 2, 300, 300);
    p.program.markBefore(1); // the plunge turns as fast
    p.program.line("G0 Z[5]");
    setSpindle(p.program, 5000, 5000);
    p.value = speed;
}

void plantToolSpindle(Planting& p) {
    p.limits = ",maxrpm=8000";
    plantSpindle(p, 8000);
}

void plantMachineSpindle(Planting& p) {
    p.machine = Machine();
    p.machine->largestSpindle = 9000;
    plantSpindle(p, 9000);
    p.program.markBefore(1); // the approach turns as fast
}

void plantRemovalRate(Planting& p) {
    p.limits = ",maxmrr=30";
    const int rate = p.program.among(35, 60);
    const int feed = rate * 1000 / (5 * p.diameter);
    writeFullSlot(p, 5, feed, 400);
    p.value = p.diameter * 5 * feed / 1000.0;
}

void plantRamp(Planting& p) {
    p.limits = ",ramp=10";
    const int depth = p.program.among(5, 9);
    p.program.line("G0 X[20] Y[92] Z[5]");
    p.program.line("G1 Z[0] F[300]");
    p.program.mark();
    p.program.faulty(fmt::format("X[40] Z[-{}]", depth));
    p.program.clean("X[40] Z[-3]");
    p.program.line("X[120] F[800]");
    p.value = std::atan2(depth, 20.0) * 180 / std::numbers::pi;
}

void plantPlunge(Planting& p) {
    p.limits = ",centre=0";
    const int depth = p.program.among(2, 6);
    p.program.line("G0 X[20] Y[92] Z[5]");
    p.program.line("G1 Z[0] F[300]");
    p.program.mark();
    p.program.faulty(fmt::format("Z[-{}]", depth));
    p.program.clean(fmt::format("X[40] Z[-{}]", depth));
    p.program.line("X[120] F[800]");
    p.value = depth;
}

void plantTapFeed(Planting& p) {
    changeTo(p.program, 2);
    p.program.line(kToFault);
    p.program.line("G98 G81 Z[-10] R[2] F[300]");
    p.program.line("G80");
    changeTo(p.program, 4);
    p.program.line("S500");
    p.program.line(kToFault);
    const int feed = 500 + p.program.among(1, 5) * 20;
    p.program.mark();
    p.program.faulty(fmt::format("G98 G84 Z[-8] R[5] F[{}]", feed));
    p.program.clean("G98 G84 Z[-8] R[5] F[500]");
    p.program.line("G80");
    changeTo(p.program, 1);
    p.value = feed;
}

void plantTapWithoutHole(Planting& p) {
    changeTo(p.program, 2);
    p.program.line(kToFault);
    p.program.clean("G98 G81 Z[-10] R[2] F[300]");
    p.program.clean("G80");
    changeTo(p.program, 4);
    p.program.line("S500");
    p.program.line(kToFault);
    p.program.mark();
    p.program.line("G98 G84 Z[-8] R[5] F[500]");
    p.program.line("G80");
    changeTo(p.program, 1);
    p.value = 8;
}

void plantCloseRapid(Planting& p) {
    p.program.line(kToFault);
    p.program.mark();
    p.program.faulty("G0 Z[0.4]");
    p.program.clean("G0 Z[2]");
    p.program.line("X[60]");
    p.value = 0.6;
}

constexpr int kTravel = 200; ///< the last position of X in program coordinates

Machine machineWithTravel() {
    Machine machine;
    machine.offsetX = -300;
    machine.offsetY = -250;
    machine.offsetZ = -400;
    machine.minX = -500;
    machine.maxX = kTravel - 300;
    machine.minY = -400;
    machine.minZ = -500;
    return machine;
}

void plantTravel(Planting& p) {
    const int beyond = p.program.among(1, 30);
    p.machine = machineWithTravel();
    p.program.line(kToFault);
    p.program.mark();
    p.program.faulty(fmt::format("X[{}]", kTravel + beyond));
    p.program.clean(fmt::format("X[{}]", kTravel));
    p.value = beyond;
}

/// Only the arc's extreme is beyond the travel.
void plantTravelOfArc(Planting& p) {
    const int beyond = p.program.among(1, 9);
    const int radius = 10 + beyond;
    p.machine = machineWithTravel();
    p.program.line(kToFault);
    p.program.line(fmt::format("X[{}] Y[60]", kTravel - 10));
    p.program.mark();
    const std::string arc =
        fmt::format("X[{}] Y[{}] I[0] J[{}] F[3000]", kTravel - 10, 60 + 2 * radius, radius);
    p.program.faulty("G3 " + arc);
    p.program.clean("G2 " + arc);
    p.value = beyond;
}

/// The face of the spindle is above the tip by stick-out and holder.
void plantTravelUpwards(Planting& p) {
    const int beyond = p.program.among(1, 30);
    p.machine = machineWithTravel();
    p.machine->maxZ = p.machine->offsetZ + p.stickOut + kHolderHeight + 60;
    p.program.line(kToFault);
    p.program.mark();
    p.program.faulty(fmt::format("Z[{}]", 60 + beyond));
    p.program.clean("Z[60]");
    p.value = beyond;
}

/// T1 is changed at Z50 everywhere else; T2 has no known length.
void plantToolChange(Planting& p) {
    const int low = p.program.among(10, 40);
    p.machine = machineWithTravel();
    p.machine->changeZ = p.machine->offsetZ + p.stickOut + kHolderHeight + 50;
    p.program.line(kToFault);
    p.program.faulty(fmt::format("Z[{}]", low));
    p.program.clean("Z[50]");
    p.program.line("M5");
    p.program.mark();
    takeTool(p.program, 2);
    changeTo(p.program, 1);
    p.value = 50 - low;
}

// ---- the rows ----

constexpr std::array kKinds{
    PlantedKind{"rapid along a line", "rapid-cuts", plantRapidLine},
    PlantedKind{"rapid plunge", "rapid-cuts", plantRapidPlunge},
    PlantedKind{"rapid of a cycle", "rapid-cuts", plantRapidOfCycle},
    PlantedKind{"spindle stopped", "spindle-stopped", plantStoppedSpindle},
    PlantedKind{"spindle never turned on", "spindle-never-turns", plantUnusedSpindle, true},
    PlantedKind{"spindle reversed", "spindle-reversed", plantReversedSpindle},
    PlantedKind{"feed of the machine", "feed-limit", plantFeed},
    PlantedKind{"drill moves sideways", "plunge-not-allowed", plantSidewaysDrill},
    PlantedKind{"below the stock", "table-collision", plantBelowStock},
    PlantedKind{"beyond the flutes", "depth-beyond-flutes", plantBeyondFlutes},
    PlantedKind{"holder, plunge", "holder-collision", plantHolder},
    PlantedKind{"holder, edge of a pocket", "holder-collision", plantHolderAtEdge},
    PlantedKind{"shank", "shank-collision", plantShank},
    PlantedKind{"neck", "neck-in-stock", plantNeck},
    PlantedKind{"tool not in the table", "tool-undefined", plantMissingTool},
    PlantedKind{"inches read as mm", "units-suspect", plantInchesAsMillimetres, true},
    PlantedKind{"mm read as inches", "units-suspect", plantMillimetresAsInches, true},
    PlantedKind{"fixture, rapid", "fixture-collision", plantFixtureInRapid},
    PlantedKind{"fixture, arc", "fixture-collision", plantFixtureInArc},
    PlantedKind{"fixture, cycle", "fixture-collision", plantFixtureInCycle},
    PlantedKind{"axial depth", "depth-limit", plantDepth},
    PlantedKind{"radial engagement", "engagement-limit", plantEngagement, true},
    PlantedKind{"chip thickness", "chip-limit", plantChips},
    PlantedKind{"surface speed", "surface-speed", plantSurfaceSpeed},
    PlantedKind{"feed of the tool", "tool-feed-limit", plantToolFeed},
    PlantedKind{"spindle of the tool", "tool-spindle-limit", plantToolSpindle},
    PlantedKind{"spindle of the machine", "spindle-limit", plantMachineSpindle},
    PlantedKind{"removal rate", "removal-rate-limit", plantRemovalRate},
    PlantedKind{"ramp", "ramp-too-steep", plantRamp, true},
    PlantedKind{"plunge without centre", "plunge-not-allowed", plantPlunge, true},
    PlantedKind{"feed of a tap", "tap-feed", plantTapFeed},
    PlantedKind{"tap without a hole", "plunge-not-allowed", plantTapWithoutHole},
    PlantedKind{"rapid near the stock", "rapid-too-close", plantCloseRapid},
    PlantedKind{"loose piece", "loose-piece", plantLoosePiece},
    PlantedKind{"beside the stock", "nothing-cut", plantNothingCut, true},
    PlantedKind{"hardly a cut", "nothing-cut", plantHardlyCuts, true},
    PlantedKind{"feeding in air", "air-cutting", plantAirCutting},
    PlantedKind{"feed missing", "feed-missing", plantMissingFeed, true},
    PlantedKind{"unknown code", "code-unknown", plantUnknownCode},
    PlantedKind{"rotary word", "axis-unsupported", plantRotaryWord},
    PlantedKind{"travel", "travel-limit", plantTravel},
    PlantedKind{"travel, arc extreme", "travel-limit", plantTravelOfArc},
    PlantedKind{"travel upwards", "travel-limit", plantTravelUpwards},
    PlantedKind{"tool change elsewhere", "tool-change-position", plantToolChange},
    PlantedKind{"holder near the stock", "holder-near", plantHolderNear},
    PlantedKind{"shank near the stock", "shank-near", plantShankNear},
    PlantedKind{"arc that misses its end", "arc-ends-differ", plantArcEnd},
};

std::string millOf(const Planting& p) {
    std::string spec = fmt::format("{}:d={},l={},so={},holder={}x{}", p.shape, p.diameter, p.flutes,
                                   p.stickOut, p.holder, kHolderHeight);
    if (p.shape == "bull")
        spec += ",r=1";
    if (p.shank > 0)
        spec += fmt::format(",sd={}", p.shank);
    return spec + p.limits;
}

void writeHead(TwinProgram& out) {
    if (out.writing().dialect == DialectId::fanuc) {
        out.line("%");
        out.line("O0012 (TEST)");
    }
    out.line(out.writing().inch ? "G20 G90 G17 G40 G80 G94 G54" : "G21 G90 G17 G40 G80 G94 G54");
    takeTool(out, 1);
    out.line("G0 X[5] Y[5]");
}

void writeEnd(TwinProgram& out) {
    out.line("G0 Z[50]");
    out.line("M5");
    out.line("M30");
    if (out.writing().dialect == DialectId::fanuc)
        out.line("%");
}

} // namespace

std::span<const PlantedKind> plantedKinds() {
    return kKinds;
}

PlantedPair plantedPair(const PlantedKind& kind, std::uint_fast32_t seed) {
    const Writing writing{seed % 2 == 0 ? DialectId::linuxcnc : DialectId::fanuc, seed / 2 % 2 == 1};
    Planting planting{.program = TwinProgram(writing, seed)};
    TwinProgram& out = planting.program;
    constexpr std::array kShapes{"flat", "ball", "bull"};
    planting.shape = kShapes[static_cast<std::size_t>(out.among(0, 2))];
    planting.diameter = 2 * out.among(2, 4);
    writeHead(out);
    const int before = out.among(0, kLanes - 1);
    for (int lane = 0; lane < kLanes; ++lane) {
        if (lane == before) {
            kind.plant(planting);
            out.line("G0 Z[5]");
        }
        const auto cut = lane == 0 ? 0 : static_cast<std::size_t>(out.among(0, kCuts.size() - 1));
        if (!kind.alone)
            kCuts[cut](out, 12 + 16 * lane);
    }
    writeEnd(out);

    PlantedPair pair{out.faultyText(), out.cleanText(),    out.markedLine(),         planting.value,
                     planting.machine, planting.alsoFound, planting.holderClearance, {}};
    pair.setup.stock = {Vec3(0), 140, 110, kThickness};
    pair.setup.spacing = kSpacing;
    pair.setup.dialect = writing.dialect;
    pair.setup.fixtures = planting.fixtures;
    pair.setup.tools.set(1, parseCutter(millOf(planting)).value());
    pair.setup.tools.set(2, parseCutter("drill:d=4,angle=118,l=60").value());
    pair.setup.tools.set(4, parseCutter("tap:d=6,tip=4,lead=1,pitch=1,l=30").value());
    pair.setup.tools.set(3, parseCutter(fmt::format("tslot:d=12,w={},neck=6", kHeadWidth)).value());
    return pair;
}

} // namespace proveout
