// SPDX-License-Identifier: GPL-3.0-or-later
// The geometry of cutter compensation: the distance of the tool's centre from the path.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iostream>
#include <limits>
#include <numbers>
#include <vector>

#include "core/nc/run/interpreter.h"
#include "tests/core/nc/random_path.h"
#include "tests/random_seed.h"

namespace proveout::test {

namespace {

constexpr double kRadius = 3;
constexpr double kExact = 1e-6;
constexpr int kPointsOfMotion = 50;

std::shared_ptr<const Program> interpreted(const std::string& text) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    options.lint = false;
    options.tools = ToolOffsets({{1, {Vec3(0), 2 * kRadius}}});
    return interpret(NcText(text), options);
}

bool reportedId(const Program& program, const std::string& id) {
    return std::ranges::any_of(program.diagnostics(),
                               [&](const Diagnostic& d) { return std::string(d.id) == id; });
}

bool reported(const Program& program) {
    return std::ranges::any_of(program.diagnostics(), [](const Diagnostic& d) {
        return std::string(d.id) != "compensation-at-end";
    });
}

/// Angle from `from` to `to` in the direction of the sweep, in [0, 2 pi).
double angleAlong(const PlanePath& arc, const Vec2& to) {
    const Vec2 a = arc.start - arc.centre;
    const Vec2 b = to - arc.centre;
    const double angle = std::atan2(b.y, b.x) - std::atan2(a.y, a.x);
    constexpr double kTurn = 2 * std::numbers::pi;
    const double along = std::fmod(arc.sweep > 0 ? angle : -angle, kTurn);
    return along < 0 ? along + kTurn : along;
}

double distanceTo(const PlanePath& path, const Vec2& point) {
    const double ends = std::min(glm::distance(point, path.start), glm::distance(point, path.end));
    if (path.arc()) {
        if (angleAlong(path, point) > std::abs(path.sweep))
            return ends;
        return std::min(ends,
                        std::abs(glm::distance(point, path.centre) - glm::distance(path.start, path.centre)));
    }
    const Vec2 along = path.end - path.start;
    const double t = glm::dot(point - path.start, along) / glm::dot(along, along);
    return t > 0 && t < 1 ? glm::distance(point, path.start + along * t) : ends;
}

/// Expects that every point of the motions of a line keeps the radius as its distance from that line's path
/// and its neighbours.
void expectDistance(const Program& program, const std::vector<PlanePath>& paths) {
    constexpr std::size_t kFirstLine = 3;
    for (std::size_t i = 0; i < program.motionCount(); ++i) {
        const Motion motion = program.motion(i);
        if (motion.line <= kFirstLine || motion.line >= kFirstLine + paths.size())
            continue;
        const std::size_t own = motion.line - kFirstLine;
        for (int k = 0; k <= kPointsOfMotion; ++k) {
            const Vec2 point(pointAt(motion, static_cast<double>(k) / kPointsOfMotion));
            const double before = distanceTo(paths[own - 1], point);
            double nearest = std::min(before, distanceTo(paths[own], point));
            EXPECT_NEAR(nearest, kRadius, kExact) << "motion " << i << " of line " << motion.line;
            if (own + 1 < paths.size())
                nearest = std::min(nearest, distanceTo(paths[own + 1], point));
            // The entry motion is still approaching that distance.
            if (own > 1) {
                EXPECT_GE(nearest, kRadius - kExact) << "motion " << i << " of line " << motion.line;
            }
        }
    }
}

std::string programAlong(const std::vector<PlanePath>& paths, bool left) {
    std::string text = "G21 G90 F100 T1 M6\n";
    text += left ? "G41\n" : "G42\n";
    for (const PlanePath& path : paths)
        text += wordsOf(path) + "\n";
    return text + "M2\n";
}

} // namespace

TEST(Compensation, KeepsTheRadiusFromThePath) {
    const auto seed = randomSeed();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937 random(seed);
    // Corners that can be joined, and paths that do not turn back towards their neighbours.
    const RandomPathShape shape{6, 15, 60, 1.0, 0.06, 15, 1.2};
    int kept = 0;
    for (int i = 0; i < 2000; ++i) {
        const std::vector<PlanePath> paths = randomPath(random, shape);
        const std::string text = programAlong(paths, i % 2 == 0);
        const auto program = interpreted(text);
        if (reported(*program))
            continue;
        ++kept;
        expectDistance(*program, paths);
        if (HasFailure()) {
            std::cout << "seed " << seed << "\n" << text;
            break;
        }
    }
    EXPECT_GT(kept, 400);
}

TEST(Compensation, KeepsTheProgrammedEnds) {
    std::mt19937 random(7);
    for (int i = 0; i < 200; ++i) {
        const std::vector<PlanePath> paths = randomPath(random, {8, 2, 40, 3, 0});
        const auto program = interpreted(programAlong(paths, true));
        for (std::size_t k = 0; k < program->motionCount() && !reported(*program); ++k) {
            const std::size_t line = program->motion(k).line;
            const bool corner = k + 1 < program->motionCount() && program->motion(k + 1).line == line;
            const Vec2 end = corner ? paths[line - 3].start : paths[line - 3].end;
            EXPECT_LT(glm::distance(Vec2(program->programmedEnd(k)), end), kExact);
        }
    }
}

TEST(Compensation, BoundsHoldTheShortenedMotions) {
    const auto program = interpreted("G21 G90 F100 T1 M6\nG41\nG1 X20\nG1 Y20\nG1 X0\nM2\n");
    // The second motion ended at Y20 until the corner was computed.
    EXPECT_DOUBLE_EQ(program->bounds().hi.y, 17);
    EXPECT_DOUBLE_EQ(program->motion(1).end.y, 17);
    EXPECT_DOUBLE_EQ(program->programmedEnd(1).y, 20);
    EXPECT_TRUE(reportedId(*program, "compensation-at-end"));
}

TEST(Compensation, FromAnUnknownPlaceIsReported) {
    const auto program = interpret(NcText("G41.1 D6\nG0 X10 Y0 Z0\nG1 F100 X50\nG1 Y50\nG40 G1 X0\nM2\n"));
    EXPECT_TRUE(reportedId(*program, "compensation-from-unknown"));
    EXPECT_TRUE(program->unverified());
    // The next motion starts compensation.
    EXPECT_EQ(program->motion(1).end, Vec3(47, 3, 0));
}

TEST(Compensation, OfZeroSaysWhetherTheDiameterIsKnown) {
    const std::string text = "G41\nG0 X10 Y0 Z0\nM2\n";
    EXPECT_TRUE(reportedId(*interpret(NcText(text)), "compensation-diameter-unknown"));
    EXPECT_TRUE(reportedId(*interpreted(text), "compensation-without-diameter"));
}

} // namespace proveout::test
