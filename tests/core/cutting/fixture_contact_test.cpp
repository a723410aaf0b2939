// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of tools with fixtures, against discs of the tool at many heights and many moments, and against
// points of meshes.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "core/cutting/fixtures/fixture_contact.h"
#include "core/cutting/fixtures/fixture_heights.h"
#include "core/cutting/fixtures/fixture_surface.h"
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
    const auto& cylinder = std::get<FixtureCylinder>(fixture); // no mesh is asked for
    return std::max(0.0, std::hypot(x - cylinder.x, y - cylinder.y) - cylinder.d / 2);
}

double topOf(const Fixture& fixture) {
    return boundsOf(fixture).hi.z;
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

    double between(double least, double most) {
        return std::uniform_real_distribution(least, most)(m_random);
    }
    bool either() { return std::bernoulli_distribution(0.5)(m_random); }

private:
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

// ---- meshes ----

FixtureMesh meshOf(std::vector<FixtureFacet> facets, double leastCell = FixtureSurface::kLeastCell) {
    return {.surface = std::make_shared<const FixtureSurface>(std::move(facets), Diagnostics(), leastCell)};
}
constexpr double kCoarse = 0.5; ///< mm; takes less time

/// Twelve facets around a box.
std::vector<FixtureFacet> boxFacets(const Vec3& lo, const Vec3& hi) {
    std::vector<FixtureFacet> facets;
    for (int axis = 0; axis < 3; ++axis)
        for (const Vec3& end : {lo, hi}) {
            std::array<glm::vec3, 4> corners;
            for (int k = 0; k < 4; ++k) {
                Vec3 corner = end;
                corner[(axis + 1) % 3] = k == 1 || k == 2 ? hi[(axis + 1) % 3] : lo[(axis + 1) % 3];
                corner[(axis + 2) % 3] = k >= 2 ? hi[(axis + 2) % 3] : lo[(axis + 2) % 3];
                corners[static_cast<std::size_t>(k)] = glm::vec3(corner);
            }
            facets.push_back({corners[0], corners[1], corners[2]});
            facets.push_back({corners[0], corners[2], corners[3]});
        }
    return facets;
}

/// A closed mesh around (0, 0, 0) with hollows and overhangs: an octahedron whose facets are divided in four,
/// and each corner moved along its ray.
std::vector<FixtureFacet> boulder(RandomCase& random) {
    std::map<std::array<int, 3>, glm::vec3> corners;
    const auto corner = [&](const Vec3& direction) {
        const std::array<int, 3> key{static_cast<int>(direction.x * 2), static_cast<int>(direction.y * 2),
                                     static_cast<int>(direction.z * 2)};
        const auto known = corners.find(key);
        return known != corners.end()
                   ? known->second
                   : corners.emplace(key, glm::vec3(glm::normalize(direction) * random.between(4, 20)))
                         .first->second;
    };
    std::vector<FixtureFacet> facets;
    for (const double sx : {-1.0, 1.0})
        for (const double sy : {-1.0, 1.0})
            for (const double sz : {-1.0, 1.0}) {
                const Vec3 x(sx, 0, 0);
                const Vec3 y(0, sy, 0);
                const Vec3 z(0, 0, sz);
                const Vec3 xy = (x + y) * 0.5;
                const Vec3 yz = (y + z) * 0.5;
                const Vec3 zx = (z + x) * 0.5;
                for (const auto& [a, b, c] : {std::array{x, xy, zx}, std::array{y, yz, xy},
                                              std::array{z, zx, yz}, std::array{xy, yz, zx}})
                    facets.push_back({corner(a), corner(b), corner(c)});
            }
    return facets;
}

/// The lowest height above the tip of what is as wide as this.
double lowestOf(const Sizes& tool, double distance) {
    if (distance <= tool.radius)
        return tool.ball ? tool.radius - std::sqrt(tool.radius * tool.radius - distance * distance) : 0;
    if (distance <= tool.shank)
        return tool.flutes;
    return distance <= tool.holder ? tool.stickOut : 1e9;
}

/// Points of all facets, and the largest distance of a point of the mesh from the nearest of them.
struct Samples {
    std::vector<Vec3> points;
    double apart = 0;
};

Samples samplesOf(const FixtureMesh& mesh) {
    constexpr int kParts = 6;
    Samples samples;
    const double angle = mesh.turn * std::numbers::pi / 180;
    const auto placed = [&](const glm::vec3& corner) {
        const Vec3 at = Vec3(corner) * mesh.scale;
        return Vec3(mesh.x + at.x * std::cos(angle) - at.y * std::sin(angle),
                    mesh.y + at.x * std::sin(angle) + at.y * std::cos(angle), mesh.z + at.z);
    };
    for (const FixtureFacet& facet : mesh.surface->facets()) {
        const Vec3 a = placed(facet[0]);
        const Vec3 b = placed(facet[1]);
        const Vec3 c = placed(facet[2]);
        samples.apart = std::max({samples.apart, glm::length(b - a) / kParts, glm::length(c - b) / kParts,
                                  glm::length(a - c) / kParts});
        for (int i = 0; i <= kParts; ++i)
            for (int k = 0; i + k <= kParts; ++k)
                samples.points.push_back(a + (b - a) * (1.0 * i / kParts) + (c - a) * (1.0 * k / kParts));
    }
    return samples;
}

constexpr int kMeshMoments = 60;

/// The deepest contact of samples at many moments, with a tool that is wider and lower by `wider`.
double sampledMeshDepth(const Sizes& tool, const Motion& motion, const std::vector<Vec3>& points,
                        double wider) {
    double deepest = 0;
    for (int i = 0; i <= kMeshMoments; ++i) {
        const Vec3 tip = pointAt(motion, static_cast<double>(i) / kMeshMoments);
        for (const Vec3& point : points) {
            const double away = std::max(0.0, std::hypot(point.x - tip.x, point.y - tip.y) - wider);
            deepest = std::max(deepest, point.z - tip.z - lowestOf(tool, away) + wider);
        }
    }
    return deepest;
}

TEST(FixtureMesh, IsTouchedWhereSamplesOfItAre) {
    const std::uint32_t seed = randomSeed();
    int contacts = 0;
    for (int round = 0; round < roundsOf(1500); ++round) {
        RandomCase random(seed + static_cast<std::uint32_t>(round));
        SCOPED_TRACE(fmt::format("seed {}, round {}", seed, round));
        const Sizes sizes = random.tool();
        const Motion motion = random.motion();
        FixtureMesh mesh = meshOf(boulder(random), kCoarse);
        mesh.x = random.between(-20, 20);
        mesh.y = random.between(-20, 20);
        mesh.z = random.between(-20, 10);
        mesh.turn = random.between(-360, 360);
        mesh.scale = random.between(0.5, 1.5);
        const double clearance = random.either() ? 0 : random.between(0.1, 3);
        const auto found = fixtureContact(ToolOutline(sizes.cutter()), motion, mesh, clearance);
        const double depth = found ? found->depth : 0;
        contacts += found ? 1 : 0;
        const Samples samples = samplesOf(mesh);
        const double apart = samples.apart + pathLength(motion) / kMeshMoments +
                             mesh.surface->heights(mesh)->tooWide() + clearance;
        EXPECT_GE(depth, sampledMeshDepth(sizes, motion, samples.points, clearance) - 2 * kFixtureExact);
        EXPECT_LE(depth, sampledMeshDepth(sizes, motion, samples.points, apart) + 2 * kFixtureExact);
    }
    EXPECT_GT(contacts, roundsOf(1500) / 8);
}

TEST(FixtureMesh, OfABoxIsTouchedAsTheBox) {
    const std::uint32_t seed = randomSeed();
    int contacts = 0;
    for (int round = 0; round < roundsOf(1000); ++round) {
        RandomCase random(seed + static_cast<std::uint32_t>(round));
        SCOPED_TRACE(fmt::format("seed {}, round {}", seed, round));
        const ToolOutline tool(random.tool().cutter());
        const Motion motion = random.motion();
        const FixtureBox box{random.between(-30, 20), random.between(-30, 20), random.between(-20, 0),
                             random.between(2, 30),   random.between(2, 30),   random.between(5, 40)};
        const auto small = [&](double x, double y, double z) { return Vec3(x, y, z) / 25.4; };
        FixtureMesh mesh = meshOf(boxFacets(small(0, 0, 0), small(box.w, box.d, box.h)), kCoarse);
        mesh.scale = 25.4;
        mesh.x = box.x;
        mesh.y = box.y;
        mesh.z = box.z;
        const double clearance = random.either() ? 0 : 1;
        const auto expected = fixtureContact(tool, motion, box, clearance);
        const auto found = fixtureContact(tool, motion, mesh, clearance);
        contacts += found ? 1 : 0;
        // The corners are rounded to float: by less than 1e-5 mm, over which a tool is not steep.
        EXPECT_NEAR(found ? found->depth : 0, expected ? expected->depth : 0, 0.02);
    }
    EXPECT_GT(contacts, roundsOf(1000) / 8);
}

TEST(FixtureMesh, IsNoWiderThanItSays) {
    const ToolOutline tool(parseCutter("flat:d=10,l=20").value());
    FixtureMesh jaw = meshOf(boxFacets(Vec3(0), Vec3(100, 30, 25)));
    EXPECT_FALSE(fixtureContact(tool, line({-60, -5, 0}, {160, -5, 0}), jaw)) << "along its side";
    EXPECT_TRUE(fixtureContact(tool, line({-60, -4.99, 0}, {160, -4.99, 0}), jaw));
    EXPECT_FALSE(fixtureContact(tool, line({-60, 10, 25}, {160, 10, 25}), jaw)) << "on its top";
    jaw.turn = 45; // its corner is now at (0, 0), and it reaches from there to both sides
    const double wide = jaw.surface->heights(jaw)->tooWide();
    EXPECT_LT(wide, 0.2);
    const Vec3 along(std::sqrt(0.5), std::sqrt(0.5), 0);
    const Vec3 beside(std::sqrt(0.5), -std::sqrt(0.5), 0);
    const auto passes = [&](double away) {
        return line(beside * away - along * 200.0, beside * away + along * 200.0);
    };
    EXPECT_TRUE(fixtureContact(tool, passes(4.999), jaw));
    EXPECT_FALSE(fixtureContact(tool, passes(5 + wide), jaw));
}

TEST(FixtureMesh, WithoutFacetsTouchesNothingAndIsReported) {
    const ToolOutline tool(parseCutter("flat:d=10,l=20").value());
    const Motion through = line({-60, 10, 0}, {160, 10, 0});
    EXPECT_FALSE(fixtureContact(tool, through, FixtureMesh{}));
    EXPECT_FALSE(fixtureContact(tool, through, meshOf({})));
    const Diagnostics findings = findingsOf({{"vice", FixtureMesh{}}});
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_TRUE(findings.front().unverified);
    EXPECT_TRUE(findingsOf({{"jaw", meshOf(boxFacets(Vec3(0), Vec3(1)))}, {"bar", FixtureBox{}}}).empty());
}

TEST(FixtureMesh, OfAnyShapeTakesNoMoreMemoryThanItSays) {
    // A wire across everything, a point-like part far away, and facets upright and without extent in plan.
    const std::vector<std::vector<FixtureFacet>> meshes{
        {{glm::vec3(-1e6F, 0, 0), glm::vec3(1e6F, 1e-3F, 5), glm::vec3(1e6F, 0, 0)}},
        boxFacets(Vec3(1e6 - 1), Vec3(1e6)),
        {{glm::vec3(0), glm::vec3(0, 0, 5), glm::vec3(0, 0, 9)}},
        {{glm::vec3(0), glm::vec3(30, 0, 5), glm::vec3(0, 0, 9)}}};
    for (const auto& facets : meshes) {
        const FixtureMesh mesh = meshOf(facets);
        const auto heights = mesh.surface->heights(mesh);
        const Box3 bounds = boundsOf(mesh);
        EXPECT_GE(heights->column(heights->whole()).top, bounds.hi.z);
        EXPECT_LE(heights->column(heights->whole()).top, bounds.hi.z + 0.1);
        EXPECT_LE(heights->tooWide(), 0.08 + 2e-3 * glm::length(Vec2(bounds.hi - bounds.lo)));
    }
    EXPECT_LT(FixtureHeights::mostBytes(FixtureSurface::kMostFacets), 60e6);
}

TEST(FixtureMesh, OfManyLayersHasACoarserGrid) {
    std::vector<FixtureFacet> spikes;
    for (int k = 0; k < 20'000; ++k) // each rises from one side to the other
        spikes.push_back({glm::vec3(0, 0, k), glm::vec3(100, 0, 20'000 - k), glm::vec3(0, 100, k % 7)});
    const FixtureMesh mesh = meshOf(spikes);
    const auto begin = std::chrono::steady_clock::now();
    const auto heights = mesh.surface->heights(mesh);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
    EXPECT_LT(heights->tooWide(), 10);
}

TEST(Fixture, IsReadBackAsItWasWritten) {
    for (const char* text : {"box:x=-20.5,y=0,z=-30,w=20,d=80.125,h=25", "cylinder:x=9,y=9,z=0,d=12,h=8",
                             "stl:x=1,y=0,z=-30.5,turn=90,scale=25.4,file=a folder/vice, left=2.stl"})
        EXPECT_EQ(fixtureText(parseFixture(text).value()), text);
    for (const char* bad :
         {"", "ball:d=3", "box", "box:x=1", "box:w=1,d=1,h=0", "box:w=1,d=1,h=nan", "box:w=1,d=1,h=1e9",
          "cylinder:d=1,h=1,w=1", "box:w=1,d=1,h=1,=,", "stl:x=1", "stl:file=", "stl:scale=0,file=a.stl",
          "stl:turn=361,file=a.stl", "stl:h=1,file=a.stl", "stl"})
        EXPECT_FALSE(parseFixture(bad)) << bad;
    const Fixture mesh = parseFixture("stl:file=vice.stl").value();
    EXPECT_EQ(std::get<FixtureMesh>(mesh).scale, 1);
    EXPECT_EQ(std::get<FixtureMesh>(mesh).file, "vice.stl");
    EXPECT_EQ(parseFixtureOption("left jaw=box:w=1,d=2,h=3").value().first, "left jaw");
    for (const char* bad : {"box:w=1,d=1,h=1", "=box:w=1,d=1,h=1", "jaw"})
        EXPECT_FALSE(parseFixtureOption(bad)) << bad;
}

} // namespace
} // namespace proveout
