// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/samples/mouse_case.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "resources/samples/block_budget.h"
#include "resources/samples/height_map.h"
#include "resources/samples/program_writer.h"
#include "resources/samples/z_level_roughing.h"

namespace proveout::samples {

namespace {

constexpr double kWidth = 140;
constexpr double kDepth = 100;
constexpr double kPartingZ = -30;
constexpr double kBallRadius = 5.5;
constexpr double kClearanceZ = 5;
constexpr std::size_t kRoughBlocks = 2000;
constexpr std::size_t kBlocks = 10273;

constexpr double kLattice = 0.25; ///< mm; rows and columns of the cutter paths lie on it
constexpr double kRowSpacing = 1.25;
/// What the drop-cutter surface may miss between lattice points of this design, with reserve.
constexpr double kLatticeError = 0.02;

double square(double value) {
    return value * value;
}

/// The greater (lesser) of two heights with the edge between them rounded over a width of `r`.
double roundedMax(double a, double b, double r) {
    const double overlap = std::max(r - std::abs(a - b), 0.0) / r;
    return std::max(a, b) + overlap * overlap * r / 4;
}
double roundedMin(double a, double b, double r) {
    return -roundedMax(-a, -b, r);
}

/// A dent of depth 1 at the middle line that fades out over `width` to both sides.
double dent(double distance, double width) {
    return std::exp(-square(distance / width));
}

/// 0 before `from`, 1 behind `to`, smooth between.
double ramp(double value, double from, double to) {
    const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// The shell of the mouse, palm to the left, buttons to the right.
double mouseShell(double x, double y) {
    const double u = (x - 68) / 50;
    // Narrow at the waist, where thumb and little finger hold it.
    const double halfWidth = 30 - 1.5 * u - 2.2 * dent(u - 0.15, 0.45);
    const double v = (y - 50) / halfWidth;
    const double plan = std::pow(std::pow(std::abs(u), 2.9) + std::pow(std::abs(v), 2.9), 1 / 2.9);

    // The crown: highest under the palm, falling towards the buttons, round across.
    const double palm = -3.2 - 9.5 * square(u + 0.28) - 2.0 * std::max(0.0, u) * u;
    double crown = palm - 7.5 * square(v);
    crown -= 1.4 * dent(y - 50, 4.2) * ramp(x, 74, 84);
    crown -= 1.3 * dent(x - 76 - 0.006 * square(y - 50), 4.2) * (1 - ramp(std::abs(y - 50), 20, 28));
    crown -= 3.2 * dent(y - 50, 7.0) * dent(x - 98, 11.0);

    const double side = kPartingZ + (1 - plan) * 88;
    return roundedMin(crown, side, 9);
}

/// Locating pads of the mould in the corners of the block.
double cornerPads(double x, double y) {
    const double dx = std::abs(x - kWidth / 2) - (kWidth / 2 - 11);
    const double dy = std::abs(y - kDepth / 2) - (kDepth / 2 - 11);
    const double distance = std::sqrt(dx * dx + dy * dy);
    return roundedMin(-23.0, kPartingZ + (7.5 - distance) * 4, 2);
}

/// The runner: a groove in the parting plane from the edge of the block to the nose of the mouse.
double partingPlane(double x, double y) {
    return kPartingZ - 3 * dent(y - 50, 6.8) * ramp(x, 108, 122);
}

/// Rows of the raster along x, there and back in turns.
std::vector<Polyline> rasterRows(const HeightMap& drop) {
    std::vector<Polyline> rows;
    for (double y = 0; y <= kDepth; y += kRowSpacing) {
        Polyline row;
        for (double x = -4; x <= kWidth + 4; x += kLattice)
            row.emplace_back(x, y, drop.at(drop.columnAt(x), drop.rowAt(y)));
        if (rows.size() % 2 == 1)
            std::reverse(row.begin(), row.end());
        rows.push_back(std::move(row));
    }
    return rows;
}

/// The rows with `segments` pieces in all, lifted so that no piece runs under the drop-cutter surface.
std::vector<Polyline> finishingRows(const HeightMap& drop, std::size_t segments) {
    const std::vector<Polyline> dense = rasterRows(drop);
    std::vector<Polyline> rows = spendSegments(dense, segments);
    double lift = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
        lift = std::max(lift, depthUnder(dense[i], rows[i]));
    for (Polyline& row : rows)
        for (Vec3& point : row)
            point.z += lift + kLatticeError;
    return rows;
}

void writeFinishing(ProgramWriter& nc, const HeightMap& drop, std::size_t segments) {
    const std::vector<Polyline> rows = finishingRows(drop, segments);
    const Vec3& start = rows.front().front();
    nc.rapid({nc.position().x, nc.position().y, kClearanceZ});
    nc.rapid({start.x, start.y, kClearanceZ});
    nc.setFeed(500);
    for (const Polyline& row : rows) {
        for (const Vec3& point : row) {
            nc.feed(point);
            nc.setFeed(2200);
        }
    }
    nc.rapid({nc.position().x, nc.position().y, 50});
}

/// One piece more or less is one block more or less, so one trial tells how many pieces fill the program.
std::size_t finishingSegments(const ProgramWriter& nc, const HeightMap& drop) {
    constexpr std::size_t kTrial = 4000;
    ProgramWriter trial = nc;
    writeFinishing(trial, drop, kTrial);
    return kTrial + kBlocks - trial.blocks();
}

void writeHead(ProgramWriter& nc) {
    nc.line("%");
    nc.comment("MOUSE CASE - CORE BLOCK");
    nc.comment("STOCK 140 X 100 X 50, X0 Y0 Z0 = LOWER LEFT CORNER OF THE TOP");
    nc.comment("T1 = BALL-END MILL D11 L50");
    nc.line("G21 G17 G90 G40 G49 G80 G94");
    nc.line("G54");
    nc.line("T1 M6");
    nc.line("S8000 M3");
    nc.line("M8");
    nc.comment("OPERATION 1 - ROUGHING, Z-LEVEL, STEP 2.95, ROWS 5., STOCK TO LEAVE 0.5");
    nc.rapid({-8, 0, 50});
}

void writeFinishHead(ProgramWriter& nc) {
    nc.comment("OPERATION 2 - FINISHING, PARALLEL TO X, STEP-OVER 1.25");
    nc.line("S11000");
}

void writeEnd(ProgramWriter& nc) {
    nc.line("M9");
    nc.line("M5");
    nc.line("M30");
    nc.line("%");
}

RoughingPlan roughing() {
    RoughingPlan plan;
    plan.lo = {-8, 0};
    plan.hi = {kWidth + 8, kDepth};
    plan.outsideLo = {-6.5, -6.5};
    plan.outsideHi = {kWidth + 6.5, kDepth + 6.5};
    plan.rowSpacing = 5;
    plan.firstLevel = -2.95;
    plan.levelStep = -2.95;
    plan.levels = 10;
    plan.allowance = 0.5;
    plan.clearanceZ = kClearanceZ;
    plan.cutFeed = 1800;
    plan.plungeFeed = 400;
    return plan;
}

} // namespace

double mouseCaseHeight(double x, double y) {
    const double block = roundedMax(partingPlane(x, y), mouseShell(x, y), 7);
    return roundedMax(block, cornerPads(x, y), 3);
}

std::string mouseCaseProgram() {
    const HeightMap surface = sample(mouseCaseHeight, {-14, -14}, {kWidth + 14, kDepth + 14}, kLattice);
    const HeightMap drop = dropBall(surface, kBallRadius);
    const RoughingPlan plan = roughing();

    ProgramWriter nc;
    writeHead(nc);
    writeRoughing(nc, drop, plan, contourSegmentsFor(kRoughBlocks - nc.blocks(), nc, drop, plan));
    assert(nc.blocks() == kRoughBlocks);
    writeFinishHead(nc);
    writeFinishing(nc, drop, finishingSegments(nc, drop));
    assert(nc.blocks() == kBlocks);
    writeEnd(nc);
    return nc.text();
}

} // namespace proveout::samples
