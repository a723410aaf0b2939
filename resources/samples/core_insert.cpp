// SPDX-License-Identifier: GPL-3.0-or-later
// The insert is made of plain mould features: a stepped core with draft and round corners, a dome and an
// oblong pocket on its shoulder, and a locating lug in each corner of the block. Roughing follows them with
// lines and arcs; island walls are passed clockwise and the pocket counter-clockwise, which is climb milling
// for M3.
#include "resources/samples/core_insert.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "resources/samples/height_map.h"
#include "resources/samples/program_writer.h"

namespace proveout::samples {

namespace {

constexpr double kSize = 140;
constexpr double kCentre = kSize / 2;
constexpr double kPartingZ = -30;
constexpr double kBallRadius = 5.5;
constexpr double kAllowance = 0.6; ///< stock to leave on walls
constexpr double kOffset = kBallRadius + kAllowance;
constexpr double kClearanceZ = 5;
constexpr double kOutside = -8; ///< here the cutter is clear of the stock

/// A block with round corners and drafted walls. All steps of the core share the centres of their corners.
struct Step {
    double topZ;
    double cornerRadius; ///< at the top
    double draft;        ///< outward growth of a wall per mm of depth

    [[nodiscard]] double radiusAt(double z) const { return cornerRadius + std::max(0.0, topZ - z) * draft; }
};
constexpr Vec2 kCornerCentre{30, 24}; ///< from the centre of the insert
constexpr Step kCore{-12, 14, 0.176};
constexpr Step kBase{-19, 22, 0.176};

constexpr double kFacedZ = -3;
constexpr double kLugRadius = 17;
constexpr double kLugDraft = 0.0875;

constexpr Vec2 kDomeCentre{58, 70};
constexpr double kDomeTopZ = -3.5;
constexpr double kDomeSphere = 32.72;

constexpr Vec2 kPocketCentre{97, 70};
constexpr double kPocketHalfLength = 9; ///< between the centres of its round ends and its middle
constexpr double kPocketRadius = 9.5;   ///< at the shoulder
constexpr double kPocketFloorZ = -18.5;
constexpr double kPocketDraft = 0.0875;

/// Distance from the box of corner centres; contours of a step are where it equals the corner radius.
double distanceFromCornerBox(double x, double y) {
    const double dx = std::max(0.0, std::abs(x - kCentre) - kCornerCentre.x);
    const double dy = std::max(0.0, std::abs(y - kCentre) - kCornerCentre.y);
    return std::sqrt(dx * dx + dy * dy);
}

double draftedHeight(double topZ, double outside, double draft) {
    return topZ - std::max(0.0, outside) / draft;
}

double domeHeight(double x, double y) {
    const Vec2 off = Vec2(x, y) - kDomeCentre;
    const double squared = kDomeSphere * kDomeSphere - glm::dot(off, off);
    return squared > 0 ? kDomeTopZ - kDomeSphere + std::sqrt(squared) : kPartingZ;
}

double lugHeight(double x, double y) {
    const Vec2 corner(x < kCentre ? 0 : kSize, y < kCentre ? 0 : kSize);
    return draftedHeight(kFacedZ - 0.5, glm::distance(Vec2(x, y), corner) - kLugRadius, kLugDraft);
}

double pocketHeight(double x, double y) {
    const double dy = std::max(0.0, std::abs(y - kPocketCentre.y) - kPocketHalfLength);
    const double dx = x - kPocketCentre.x;
    const double inside = kPocketRadius - std::sqrt(dx * dx + dy * dy);
    return std::max(kPocketFloorZ, kCore.topZ - std::max(0.0, inside) / kPocketDraft);
}

Vec3 at(const Vec2& place, double z) {
    return {place.x, place.y, z};
}

/// Lifts the cutter and brings it down again outside of the stock or over an open place.
void goOver(ProgramWriter& nc, const Vec2& place) {
    nc.rapid({nc.position().x, nc.position().y, kClearanceZ});
    nc.rapid(at(place, kClearanceZ));
}

void comeInFromTheLeft(ProgramWriter& nc, const Vec3& start) {
    goOver(nc, {kOutside, start.y});
    nc.rapid({kOutside, start.y, start.z});
    nc.setFeed(1500);
    nc.feed(start);
}

/// Zigzag over the whole block.
void face(ProgramWriter& nc, double z, int rows) {
    constexpr double kFirstY = 2;
    const double spacing = (kSize - 2 * kFirstY) / (rows - 1);
    nc.rapid({kOutside, kFirstY, kClearanceZ});
    nc.rapid({kOutside, kFirstY, z});
    nc.setFeed(1800);
    for (int row = 0; row < rows; ++row) {
        if (row > 0)
            nc.feed({nc.position().x, kFirstY + row * spacing, z});
        nc.feed({row % 2 == 0 ? kSize - 2 : 2.0, nc.position().y, z});
    }
}

/// Full circles about the dome, from the outside in.
void roughDome(ProgramWriter& nc, double z) {
    constexpr double kOutermost = 60;
    constexpr double kStepOver = 8;
    const double centreZ = kDomeTopZ - kDomeSphere;
    const double reach = kDomeSphere + kBallRadius + kAllowance;
    const double innermost = std::sqrt(reach * reach - std::pow(z + kBallRadius - centreZ, 2));
    const int steps = static_cast<int>(std::ceil((kOutermost - innermost) / kStepOver));
    comeInFromTheLeft(nc, at(kDomeCentre - Vec2(kOutermost, 0), z));
    for (int step = 0; step <= steps; ++step) {
        const double radius = kOutermost + (innermost - kOutermost) * step / steps;
        const Vec3 start = at(kDomeCentre - Vec2(radius, 0), z);
        nc.feed(start);
        nc.arc(Turn::clockwise, start, kDomeCentre);
    }
}

/// Clockwise round the core at `radius` about its corner centres.
void goRoundTheCore(ProgramWriter& nc, double radius, double z) {
    const Vec2 middle(kCentre);
    const auto place = [&](double sx, double sy, const Vec2& off) {
        return at(middle + Vec2(sx, sy) * kCornerCentre + off, z);
    };
    const auto centre = [&](double sx, double sy) { return middle + Vec2(sx, sy) * kCornerCentre; };
    nc.feed(place(-1, -1, {-radius, 0}));
    nc.feed(place(-1, 1, {-radius, 0}));
    nc.arc(Turn::clockwise, place(-1, 1, {0, radius}), centre(-1, 1));
    nc.feed(place(1, 1, {0, radius}));
    nc.arc(Turn::clockwise, place(1, 1, {radius, 0}), centre(1, 1));
    nc.feed(place(1, -1, {radius, 0}));
    nc.arc(Turn::clockwise, place(1, -1, {0, -radius}), centre(1, -1));
    nc.feed(place(-1, -1, {0, -radius}));
    nc.arc(Turn::clockwise, place(-1, -1, {-radius, 0}), centre(-1, -1));
}

/// Along the edges of the block and round the lugs in its corners.
void followTheRim(ProgramWriter& nc, double z) {
    constexpr double kFromEdge = 3;
    const double radius = kLugRadius + (kFacedZ - 0.5 - z) * kLugDraft + kOffset;
    const double near = std::sqrt(radius * radius - kFromEdge * kFromEdge);
    const double far = kSize - near;
    const double low = kFromEdge;
    const double high = kSize - kFromEdge;
    comeInFromTheLeft(nc, {low, near, z});
    nc.feed({low, far, z});
    nc.arc(Turn::counterClockwise, {near, high, z}, {0, kSize});
    nc.feed({far, high, z});
    nc.arc(Turn::counterClockwise, {high, far, z}, {kSize, kSize});
    nc.feed({high, near, z});
    nc.arc(Turn::counterClockwise, {far, low, z}, {kSize, 0});
    nc.feed({near, low, z});
    nc.arc(Turn::counterClockwise, {low, near, z}, {0, 0});
}

/// One level outside of the core, from the rim inwards to the wall of `step`.
void roughOutside(ProgramWriter& nc, const Step& step, double z, int loops) {
    constexpr double kOutermost = 33.5;
    const double wall = step.radiusAt(z) + kOffset;
    followTheRim(nc, z);
    for (int loop = 0; loop < loops; ++loop)
        goRoundTheCore(nc, loops == 1 ? wall : kOutermost + (wall - kOutermost) * loop / (loops - 1), z);
}

/// A helix down to `z`, then once along the wall.
void roughPocket(ProgramWriter& nc, double z) {
    const double radius = kPocketRadius - (kCore.topZ - z) * kPocketDraft - kOffset;
    const Vec2 upper = kPocketCentre + Vec2(0, kPocketHalfLength);
    const Vec2 lower = kPocketCentre - Vec2(0, kPocketHalfLength);
    const Vec2 right(radius, 0);
    nc.setFeed(600);
    nc.feed(at(kPocketCentre + right, nc.position().z));
    nc.arc(Turn::counterClockwise, at(kPocketCentre + right, z), kPocketCentre);
    nc.setFeed(1200);
    nc.feed(at(upper + right, z));
    nc.arc(Turn::counterClockwise, at(upper - right, z), upper);
    nc.feed(at(lower - right, z));
    nc.arc(Turn::counterClockwise, at(lower + right, z), lower);
    nc.feed(at(kPocketCentre + right, z));
}

void writeHead(ProgramWriter& nc) {
    nc.line("%");
    nc.comment("CORE INSERT - ROUGHING, EARLY STAGE");
    nc.comment("STOCK 140 X 140 X 50, X0 Y0 Z0 = LOWER LEFT CORNER OF THE TOP");
    nc.comment("T1 = BALL-END MILL D11 L50");
    nc.line("G21 G17 G90 G40 G49 G80 G94");
    nc.line("G54");
    nc.line("T1 M6");
    nc.line("S7500 M3");
    nc.line("M8");
}

void writeEnd(ProgramWriter& nc) {
    nc.rapid({nc.position().x, nc.position().y, 50});
    nc.line("M9");
    nc.line("M5");
    nc.line("M30");
    nc.line("%");
}

} // namespace

double coreInsertHeight(double x, double y) {
    const double fromBox = distanceFromCornerBox(x, y);
    const double core = draftedHeight(kCore.topZ, fromBox - kCore.cornerRadius, kCore.draft);
    const double base = draftedHeight(kBase.topZ, fromBox - kBase.cornerRadius, kBase.draft);
    const double pocketed = std::min(core, pocketHeight(x, y));
    return std::max({kPartingZ, base, pocketed, domeHeight(x, y), lugHeight(x, y)});
}

std::string coreInsertProgram() {
    ProgramWriter nc;
    writeHead(nc);
    nc.rapid({kOutside, 2, 50});
    nc.comment("FACING");
    face(nc, kFacedZ, 16);
    for (const double z : {-6.0, -9.0, -11.5}) {
        nc.comment("DOME AND SHOULDER, Z" + ncNumber(std::lround(z * 1000)));
        roughDome(nc, z);
    }
    for (const double z : {-7.5, -11.5, -15.0, -18.5}) {
        nc.comment("OUTSIDE OF THE CORE, Z" + ncNumber(std::lround(z * 1000)));
        roughOutside(nc, kCore, z, 3);
    }
    nc.comment("POCKET");
    goOver(nc, kPocketCentre);
    nc.setFeed(400);
    nc.feed(at(kPocketCentre, -11.5));
    for (const double z : {-15.0, -18.0})
        roughPocket(nc, z);
    writeEnd(nc);
    return nc.text();
}

} // namespace proveout::samples
