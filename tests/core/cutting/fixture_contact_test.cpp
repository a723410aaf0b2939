// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of tools with fixtures, against discs of the tool at many heights and many moments.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "core/cutting/fixtures/fixture_contact.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

/// A tool by its sizes, and the radius of the disc at a height above its tip.
struct Sizes {
    bool ball = false;
    double radius = 0;
    double flutes = 0;
    double shank = 0; ///< radius
    double stickOut = 0;
    double holder = 0; ///< radius
    double holderLength = 0;

    [[nodiscard]] Cutter cutter() const {
        return parseCutter(fmt::format("{}:d={},l={},sd={},so={},holder={}x{}", ball ? "ball" : "flat",
                                       2 * radius, flutes, 2 * shank, stickOut, 2 * holder, holderLength))
            .value();
    }
    [[nodiscard]] double radiusAt(double z) const {
        if (z >= stickOut)
            return holder;
        if (z >= flutes)
            return shank;
        return ball && z < radius ? std::sqrt(z * (2 * radius - z)) : radius;
    }
};

double distanceTo(const Fixture& fixture, double x, double y) {
    if (const auto* box = std::get_if<FixtureBox>(&fixture)) {
        const double dx = std::max({box->x - x, 0.0, x - box->x - box->w});
        const double dy = std::max({box->y - y, 0.0, y - box->y - box->d});
        return std::hypot(dx, dy);
    }
    const auto& cylinder = std::get<FixtureCylinder>(fixture);
    return std::max(0.0, std::hypot(x - cylinder.x, y - cylinder.y) - cylinder.d / 2);
}

double topOf(const Fixture& fixture) {
    return std::visit([](const auto& shape) { return shape.z + shape.h; }, fixture);
}

constexpr int kMoments = 250;
constexpr int kHeights = 150;

/// The deepest contact among samples, if each tool is wider and lower by `wider`.
double sampledDepth(const Sizes& tool, const Motion& motion, const Fixture& fixture, double wider) {
    double deepest = 0;
    const double highest = tool.stickOut + 0.1;
    for (int i = 0; i <= kMoments; ++i) {
        const Vec3 tip = pointAt(motion, static_cast<double>(i) / kMoments);
        const double away = distanceTo(fixture, tip.x, tip.y);
        for (int k = 0; k <= kHeights; ++k) {
            const double z = highest * k / kHeights;
            if (tool.radiusAt(z) + wider >= away)
                deepest = std::max(deepest, topOf(fixture) - tip.z - z + wider);
        }
    }
    return deepest;
}

/// The depth while the tool is wider by `wider` and its tip is at `tip`.
double depthAt(const Sizes& tool, const Vec3& tip, const Fixture& fixture, double wider) {
    const double away = distanceTo(fixture, tip.x, tip.y);
    constexpr int kFine = 20000;
    for (int k = 0; k <= kFine; ++k) {
        const double z = (tool.stickOut + 0.1) * k / kFine;
        if (tool.radiusAt(z) + wider >= away)
            return topOf(fixture) - tip.z - z;
    }
    return 0;
}

class RandomCase {
public:
    explicit RandomCase(std::uint_fast32_t seed) : m_random(seed) {}

    Sizes tool() {
        Sizes sizes{.ball = either(), .radius = between(1, 6)};
        sizes.flutes = sizes.radius * between(1.5, 4);
        sizes.shank = sizes.radius * between(1, 2);
        sizes.stickOut = sizes.flutes + between(1, 20);
        sizes.holder = std::max(sizes.shank, sizes.radius) + between(1, 15);
        sizes.holderLength = between(5, 40);
        return sizes;
    }
    Motion motion() {
        Motion motion;
        motion.startKnown = motion.endKnown = kAllAxes;
        motion.start = Vec3(between(-40, 40), between(-40, 40), between(-5, 30));
        motion.end = Vec3(between(-40, 40), between(-40, 40), either() ? motion.start.z : between(-5, 30));
        motion.kind = either() ? MotionKind::rapid : MotionKind::feed;
        if (either()) {
            motion.kind = MotionKind::arc;
            motion.centre = Vec3(between(-30, 30), between(-30, 30), motion.start.z);
            motion.sweep = between(-6.2, 6.2);
            const Vec2 arm = Vec2(motion.start - motion.centre);
            const double c = std::cos(motion.sweep);
            const double s = std::sin(motion.sweep);
            motion.end.x = motion.centre.x + arm.x * c - arm.y * s;
            motion.end.y = motion.centre.y + arm.x * s + arm.y * c;
        }
        return motion;
    }
    Fixture fixture() {
        const double z = between(-20, 0);
        const double h = between(5, 40);
        if (either())
            return FixtureBox{between(-30, 20), between(-30, 20), z, between(2, 30), between(2, 30), h};
        return FixtureCylinder{between(-30, 30), between(-30, 30), z, between(2, 30), h};
    }

private:
    double between(double least, double most) {
        return std::uniform_real_distribution(least, most)(m_random);
    }
    bool either() { return std::bernoulli_distribution(0.5)(m_random); }

    std::mt19937 m_random;
};

TEST(FixtureContact, IsBetweenSamplesAndSamplesOfAWiderTool) {
    const std::uint32_t seed = randomSeed();
    int contacts = 0;
    for (int round = 0; round < roundsOf(10000); ++round) {
        RandomCase random(seed + static_cast<std::uint32_t>(round));
        const Sizes sizes = random.tool();
        const Motion motion = random.motion();
        const Fixture fixture = random.fixture();
        SCOPED_TRACE(fmt::format("seed {}, round {}", seed, round));
        const auto found = fixtureContact(ToolOutline(sizes.cutter()), motion, fixture);
        const double depth = found ? found->depth : 0;
        contacts += found ? 1 : 0;
        // Between two samples the tool moves, and its surface rises, by less than this.
        const double apart = std::max(pathLength(motion) / kMoments, (sizes.stickOut + 0.1) / kHeights);
        EXPECT_GE(depth, sampledDepth(sizes, motion, fixture, 0) - kFixtureExact);
        EXPECT_LE(depth, sampledDepth(sizes, motion, fixture, apart) + kFixtureExact);
        if (found) { // it has this depth where its tip is, except where its surface is steep
            EXPECT_GE(depthAt(sizes, found->tip, fixture, 1e-3), depth - 5e-3);
        }
    }
    EXPECT_GT(contacts, roundsOf(10000) / 8);
}

Motion line(const Vec3& start, const Vec3& end) {
    Motion motion;
    motion.startKnown = motion.endKnown = kAllAxes;
    motion.start = start;
    motion.end = end;
    return motion;
}

TEST(FixtureContact, OfAToolAlongAJawIsExact) {
    const ToolOutline tool(parseCutter("flat:d=10,l=20,sd=10,so=30,holder=40x50").value());
    const Fixture jaw = parseFixture("box:x=-50,y=0,z=-20,w=100,d=30,h=25").value(); // its top is at Z5
    EXPECT_FALSE(fixtureContact(tool, line({-60, -5, 0}, {60, -5, 0}), jaw)) << "along its side";
    const auto beside = fixtureContact(tool, line({-60, -4.99, 0}, {60, -4.99, 0}), jaw);
    ASSERT_TRUE(beside);
    EXPECT_NEAR(beside->depth, 5, 1e-3);
    EXPECT_LE(std::abs(beside->tip.x), 55) << "at the jaw";
    EXPECT_FALSE(fixtureContact(tool, line({-60, -21, -26}, {60, -21, -26}), jaw));
    const auto holder = fixtureContact(tool, line({-60, -19, -26}, {60, -19, -26}), jaw);
    ASSERT_TRUE(holder);
    EXPECT_NEAR(holder->depth, 1, 1e-3) << "the face of the holder is at Z4";
    EXPECT_TRUE(fixtureContact(tool, line({-60, -5.5, 0}, {60, -5.5, 0}), jaw, 1)) << "within the clearance";
    EXPECT_FALSE(fixtureContact(tool, line({-60, 10, 5}, {60, 10, 5}), jaw)) << "on its top";
    EXPECT_TRUE(fixtureContact(tool, line({-60, 10, 5}, {60, 10, 5}), jaw, 0.5));
}

TEST(FixtureContact, OfAHelixAroundAScrewIsAtItsEnd) {
    const ToolOutline tool(parseCutter("flat:d=6,l=20").value());
    const Fixture screw = parseFixture("cylinder:x=0,y=0,z=0,d=10,h=8").value();
    Motion helix = line({7, 0, 12}, {7, 0, 2});
    helix.kind = MotionKind::arc;
    helix.centre = Vec3(0, 0, 12);
    helix.sweep = 6 * std::numbers::pi;
    const auto contact = fixtureContact(tool, helix, screw);
    ASSERT_TRUE(contact);
    EXPECT_NEAR(contact->depth, 6, 1e-3);
    helix.start.x = helix.end.x = 8.001;
    EXPECT_FALSE(fixtureContact(tool, helix, screw));
}

TEST(Fixture, IsReadBackAsItWasWritten) {
    for (const char* text : {"box:x=-20.5,y=0,z=-30,w=20,d=80.125,h=25", "cylinder:x=9,y=9,z=0,d=12,h=8"})
        EXPECT_EQ(fixtureText(parseFixture(text).value()), text);
    for (const char* bad : {"", "ball:d=3", "box", "box:x=1", "box:w=1,d=1,h=0", "box:w=1,d=1,h=nan",
                            "box:w=1,d=1,h=1e9", "cylinder:d=1,h=1,w=1", "box:w=1,d=1,h=1,=,"})
        EXPECT_FALSE(parseFixture(bad)) << bad;
    EXPECT_EQ(parseFixtureOption("left jaw=box:w=1,d=2,h=3").value().first, "left jaw");
    for (const char* bad : {"box:w=1,d=1,h=1", "=box:w=1,d=1,h=1", "jaw"})
        EXPECT_FALSE(parseFixtureOption(bad)) << bad;
}

} // namespace
} // namespace proveout
