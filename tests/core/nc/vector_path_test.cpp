// SPDX-License-Identifier: GPL-3.0-or-later
// Compares cutter compensation by vectors with distances found point by point.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iostream>
#include <numbers>
#include <vector>

#include "core/nc/run/interpreter.h"
#include "tests/core/nc/random_path.h"
#include "tests/random_seed.h"

namespace proveout::test {

namespace {

constexpr double kRadius = 3;
constexpr double kExact = 1e-6;
/// Corner moves up to this length are omitted, so a motion may start that far from its exact position.
constexpr double kSmallMove = 1e-3;
constexpr double kFewMotions = 0.01; ///< share of the motions that follow such a corner
constexpr int kPointsOfMotion = 40;
constexpr std::size_t kFirstLine = 2; ///< first line of the paths in the text, which is the lead-in

std::shared_ptr<const Program> interpreted(const std::string& text) {
    InterpretOptions options;
    options.assumeStartAtZero = true;
    options.lint = false;
    options.dialect = DialectId::fanuc;
    options.tools = ToolOffsets({{1, {Vec3(0), 2 * kRadius}}});
    return interpret(NcText(text), options);
}

std::string programAlong(const std::vector<PlanePath>& paths, bool left) {
    std::string text = "G21 G90 F100.\n";
    for (std::size_t i = 0; i < paths.size(); ++i) {
        text += i == 0 ? (left ? "G41 D1 " : "G42 D1 ") : "";
        text += wordsOf(paths[i]) + "\n";
    }
    return text + "G40 G1 X-500. Y-500.\nM30\n";
}

/// Distance from the line or circle that contains a path.
double distanceToCarrier(const PlanePath& path, const Vec2& point) {
    if (path.arc())
        return std::abs(glm::distance(point, path.centre) - glm::distance(path.start, path.centre));
    const Vec2 along = glm::normalize(path.end - path.start);
    const Vec2 way = point - path.start;
    return std::abs(along.x * way.y - along.y * way.x);
}

/// Distance from the path itself, by bisection of many pieces and not by a formula for its kind.
double distanceTo(const PlanePath& path, const Vec2& point) {
    constexpr int kPieces = 64;
    const auto at = [&](double t) {
        if (!path.arc())
            return path.start + (path.end - path.start) * t;
        const Vec2 spoke = path.start - path.centre;
        const double c = std::cos(path.sweep * t);
        const double s = std::sin(path.sweep * t);
        return path.centre + Vec2(spoke.x * c - spoke.y * s, spoke.x * s + spoke.y * c);
    };
    double nearest = 0;
    for (int k = 0; k <= kPieces; ++k) {
        const double t = static_cast<double>(k) / kPieces;
        if (glm::distance(at(t), point) < glm::distance(at(nearest), point))
            nearest = t;
    }
    double low = std::max(0.0, nearest - 1.0 / kPieces);
    double high = std::min(1.0, nearest + 1.0 / kPieces);
    for (int k = 0; k < 60; ++k) {
        const double a = low + (high - low) / 3;
        const double b = high - (high - low) / 3;
        (glm::distance(at(a), point) < glm::distance(at(b), point) ? high : low) =
            glm::distance(at(a), point) < glm::distance(at(b), point) ? b : a;
    }
    return glm::distance(at((low + high) / 2), point);
}

/// Deviations of motions from their exact positions: all within the length of omitted corner moves, nearly
/// all exact.
struct Deviations {
    int motions = 0;
    int inexact = 0;

    void add(double deviation) {
        ++motions;
        inexact += deviation > kExact ? 1 : 0;
    }
};

/// Checks the motions of a line of text: the corner before its path, and then the offset path.
void expectBeside(const Program& program, const std::vector<PlanePath>& paths, Deviations& deviations) {
    for (std::size_t i = 0; i < program.motionCount(); ++i) {
        const Motion motion = program.motion(i);
        if (motion.line <= kFirstLine || motion.line >= kFirstLine + paths.size())
            continue;
        const std::size_t own = motion.line - kFirstLine;
        const bool corner = program.motion(i + 1).line == motion.line;
        double deviation = 0;
        for (int k = 0; k <= kPointsOfMotion; ++k) {
            const Vec2 point(pointAt(motion, static_cast<double>(k) / kPointsOfMotion));
            double nearest = distanceTo(paths[own], point);
            if (own > 1) // the lead-in need not keep the distance
                nearest = std::min(nearest, distanceTo(paths[own - 1], point));
            if (own + 1 < paths.size())
                nearest = std::min(nearest, distanceTo(paths[own + 1], point));
            // A corner of the offset path is at most √2 radii from the programmed path.
            deviation = std::max({deviation, kRadius - nearest, nearest - kRadius * std::numbers::sqrt2});
            if (!corner)
                deviation = std::max(deviation, std::abs(distanceToCarrier(paths[own], point) - kRadius));
        }
        EXPECT_LE(deviation, kSmallMove) << "motion " << i << " of line " << motion.line;
        deviations.add(deviation);
    }
}

/// The number of random contours of a shape that could be compensated; each is checked point by point.
int keptOf(std::mt19937& random, const RandomPathShape& shape, int count) {
    int kept = 0;
    Deviations deviations;
    for (int i = 0; i < count; ++i) {
        const std::vector<PlanePath> paths = randomPath(random, shape);
        const std::string text = programAlong(paths, i % 2 == 0);
        const auto program = interpreted(text);
        if (!program->diagnostics().empty())
            continue;
        ++kept;
        EXPECT_FALSE(program->unverified());
        expectBeside(*program, paths, deviations);
        if (testing::Test::HasFailure()) {
            std::cout << text;
            return kept;
        }
    }
    EXPECT_LE(deviations.inexact, deviations.motions * kFewMotions);
    std::cout << fmt::format("{} motions, {} of them within {} mm only\n", deviations.motions,
                             deviations.inexact, kSmallMove);
    return kept;
}

bool reportedId(const Program& program, const std::string& id) {
    return std::ranges::any_of(program.diagnostics(),
                               [&](const Diagnostic& d) { return std::string(d.id) == id; });
}

} // namespace

TEST(VectorPath, KeepsTheRadiusFromLinesAndArcs) {
    const auto seed = randomSeed();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937 random(seed);
    const RandomPathShape shape{6, 15, 60, 1.2, 0.001, 15, 1.2};
    const int kept = keptOf(random, shape, 400);
    std::cout << fmt::format("seed {}, {} of 400 contours compensated\n", seed, kept);
    EXPECT_GT(kept, 350);
}

TEST(VectorPath, KeepsTheRadiusAtSharpCornersOfLines) {
    const auto seed = randomSeed();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937 random(seed);
    RandomPathShape shape{6, 20, 60, 2.9, 0.001, 15, 1.2};
    shape.lines = true;
    const int kept = keptOf(random, shape, 400);
    std::cout << fmt::format("seed {}, {} of 400 contours compensated\n", seed, kept);
    EXPECT_GT(kept, 300);
}

TEST(VectorPath, ReportsWhereTheToolDoesNotFit) {
    // A slot of 4 mm for a tool of 6 mm, and a step of 1 mm between two inside corners.
    EXPECT_TRUE(reportedId(*interpreted("G21 G90 F100.\nG41 D1 G1 X10. Y0\nX50.\nY4.\nX10.\nG40 Y20.\nM30\n"),
                           "compensation-gouge"));
    EXPECT_TRUE(
        reportedId(*interpreted("G21 G90 F100.\nG41 D1 G1 X10. Y0\nX50.\nG3 X50. Y4. R2.\nG1 X10.\nM30\n"),
                   "compensation-arc-small"));
}

} // namespace proveout::test
