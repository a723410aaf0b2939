// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of cut() that hold for every motion, and edge cases.
#include "core/cutting/cut/cutting.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>
#include <stop_token>
#include <thread>
#include <vector>

#include "tests/core/cutting/oracle.h"
#include "tests/core/cutting/random_motion.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

const StockBox kStock{{-3, 5, 2}, 80, 70, 12};
/// Points far apart are computed in double precision, points close together in single precision and in
/// blocks.
struct Map {
    StockBox stock;
    double spacing;
    bool arcs; ///< whether to include arcs: they always use double precision, which is slow on many points
};
const Map kMaps[] = {{kStock, 0.9, true}, {{{-3, 5, 2}, 30, 26, 12}, 0.15, false}};
/// At least one of each kind of profile piece, including walls and hollows.
const std::vector<std::string> kShapes = {"flat", "ball", "bull", "cone", "taperball", "centre", "form"};

ZMap freshMap(const StockBox& stock = kStock, double spacing = 0.9) {
    return {stock, makeGrid(stock, spacing).value()};
}

ZMap freshMap(const Map& map) {
    return freshMap(map.stock, map.spacing);
}

std::vector<float> heightsOf(const ZMap& zmap) {
    const ZMapSnapshot moment = zmap.snapshot();
    std::vector<float> heights(static_cast<std::size_t>(zmap.grid().nx) *
                               static_cast<std::size_t>(zmap.grid().ny));
    moment.read({0, 0, zmap.grid().nx, zmap.grid().ny}, heights);
    return heights;
}

/// Every fourth motion is an arc, if arcs are allowed.
Motion randomMotion(Random& random, const StockBox& stock, bool arcs) {
    if (random() % 4 == 0 && arcs)
        return randomArc(random, stock, static_cast<Plane>(random() % 3), static_cast<ArcKind>(random() % 4));
    return randomStraight(random, stock, static_cast<StraightKind>(random() % 5));
}

struct Job {
    Cutter cutter;
    Motion motion;
};

std::vector<Job> randomJobs(Random& random, int count, const StockBox& stock = kStock, bool arcs = true) {
    std::vector<Job> jobs;
    for (int k = 0; k < count; ++k) {
        const Cutter cutter = randomCutter(random, kShapes[random() % kShapes.size()]);
        jobs.push_back({cutter, randomMotion(random, stock, arcs)});
    }
    return jobs;
}

/// Calls `check(job, random)` with one random motion per seed, from seed 1.
template<class Check>
void forRandomJobs(unsigned seeds, const StockBox& stock, const Check& check) {
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        Random random(seed);
        const Job job = randomJobs(random, 1, stock)[0];
        SCOPED_TRACE(fmt::format("seed {} {}", seed, reported(job.cutter, job.motion)));
        check(job, random);
    }
}

/// Calls `check(random, map, jobs)` with the given number of random motions per seed and map, from seed 1.
template<class Check>
void forRandomMaps(unsigned seeds, int motions, const Check& check) {
    for (const Map& map : kMaps) {
        for (unsigned seed = 1; seed <= seeds; ++seed) {
            SCOPED_TRACE(fmt::format("seed {} spacing {}", seed, map.spacing));
            Random random(seed);
            check(random, map, randomJobs(random, motions, map.stock, map.arcs));
        }
    }
}

/// The difference of a height from the envelope at a point. Any height within 2e-5 mm in plan is accepted,
/// which is the rounding error of a position: near a rim that is a large difference in height.
double differenceFromEnvelope(const Job& job, const StockBox& stock, const Vec2& at, double height) {
    const auto heightAt = [&](const Vec2& place) {
        const double z = envelope(job.cutter, job.motion, place.x, place.y) - stock.topZ();
        return std::clamp(z, -stock.height, 0.0);
    };
    constexpr double kAllowed = 2e-5;
    double lo = heightAt(at);
    double hi = lo;
    if (std::abs(height - lo) <= kAllowed)
        return std::abs(height - lo);
    constexpr int kDirections = 16;
    for (int k = 0; k < kDirections; ++k) {
        const double angle = 2 * std::numbers::pi * k / kDirections;
        const double z = heightAt(at + 2e-5 * Vec2(std::cos(angle), std::sin(angle)));
        lo = std::min(lo, z);
        hi = std::max(hi, z);
    }
    return std::max({0.0, lo - height, height - hi});
}

TEST(Cut, AgreesWithTheEnvelopeOfSinglePoints) {
    forRandomMaps(60, 1, [](Random& /*random*/, const Map& map, const std::vector<Job>& jobs) {
        const Job& job = jobs[0];
        SCOPED_TRACE(reported(job.cutter, job.motion));
        ZMap zmap = freshMap(map);
        (void)cut(zmap, job.cutter, job.motion);
        const ZMapSnapshot moment = zmap.snapshot();
        double largest = 0;
        for (int j = 0; j < zmap.grid().ny; ++j) {
            for (int i = 0; i < zmap.grid().nx; ++i) {
                const Vec2 at(zmap.grid().x(i), zmap.grid().y(j));
                largest = std::max(largest, differenceFromEnvelope(job, map.stock, at,
                                                                   static_cast<double>(moment.height(i, j))));
            }
        }
        EXPECT_LE(largest, 2e-5);
    });
}

TEST(Cut, NeverRaisesAPointAndIsDoneAfterOnce) {
    forRandomMaps(10, 12, [](Random& /*random*/, const Map& map, const std::vector<Job>& jobs) {
        ZMap zmap = freshMap(map);
        for (const Job& job : jobs) {
            SCOPED_TRACE(reported(job.cutter, job.motion));
            const std::vector<float> before = heightsOf(zmap);
            (void)cut(zmap, job.cutter, job.motion);
            const std::vector<float> after = heightsOf(zmap);
            for (std::size_t k = 0; k < before.size(); ++k)
                ASSERT_LE(after[k], before[k]);
            const CutRecord again = cut(zmap, job.cutter, job.motion);
            EXPECT_EQ(again.points, 0);
            EXPECT_EQ(again.removedMm3, 0);
            EXPECT_TRUE(again.changed.empty());
        }
    });
}

TEST(Cut, DoesNotDependOnTheOrderOfMotions) {
    forRandomMaps(20, 20, [](Random& random, const Map& map, std::vector<Job> jobs) {
        ZMap first = freshMap(map);
        for (const Job& job : jobs)
            (void)cut(first, job.cutter, job.motion);
        std::shuffle(jobs.begin(), jobs.end(), random);
        ZMap second = freshMap(map);
        for (const Job& job : jobs)
            (void)cut(second, job.cutter, job.motion);
        EXPECT_EQ(heightsOf(first), heightsOf(second));
    });
}

/// The part [t0, t1] of a motion.
Motion partOf(const Motion& motion, double t0, double t1) {
    Motion part = motion;
    part.start = oraclePoint(motion, t0);
    part.end = t1 == 1 ? motion.end : oraclePoint(motion, t1);
    part.sweep = motion.sweep * (t1 - t0);
    if (motion.kind == MotionKind::arc) {
        const int normal = motion.plane == Plane::xy ? 2 : motion.plane == Plane::zx ? 1 : 0;
        part.centre[normal] = part.start[normal];
    }
    return part;
}

TEST(Cut, SplittingAMotionChangesNothing) {
    forRandomMaps(60, 1, [](Random& random, const Map& map, const std::vector<Job>& jobs) {
        const Job& job = jobs[0];
        SCOPED_TRACE(reported(job.cutter, job.motion));
        ZMap whole = freshMap(map);
        (void)cut(whole, job.cutter, job.motion);
        ZMap split = freshMap(map);
        std::vector<double> places = {0, 1};
        for (int k = 0; k < 5; ++k)
            places.push_back(uniform(random, 0, 1));
        std::sort(places.begin(), places.end());
        for (std::size_t k = 0; k + 1 < places.size(); ++k)
            (void)cut(split, job.cutter, partOf(job.motion, places[k], places[k + 1]));
        const std::vector<float> a = heightsOf(whole);
        const std::vector<float> b = heightsOf(split);
        for (std::size_t k = 0; k < a.size(); ++k)
            ASSERT_NEAR(a[k], b[k], 2e-3) << "point " << k;
    });
}

/// Which part of the cutter's width along a straight path is engaged.
class Engagement {
public:
    explicit Engagement(const Motion& motion) : m_motion(motion) {}

    void add(const Vec2& point) {
        const Vec2 along = Vec2(m_motion.end) - Vec2(m_motion.start);
        const Vec2 to = point - Vec2(m_motion.start);
        const double length = std::hypot(along.x, along.y);
        const double beside =
            length > 1e-10 ? (along.x * to.y - along.y * to.x) / length : point.y - m_motion.start.y;
        m_from = std::min(m_from, beside);
        m_to = std::max(m_to, beside);
    }
    void expect(const CutRecord& record) const {
        if (m_motion.kind == MotionKind::arc)
            return;
        if (m_to < m_from) {
            EXPECT_EQ(record.radialEngagement(), 0);
            return;
        }
        EXPECT_NEAR(record.engagedFrom, m_from, 1e-4);
        EXPECT_NEAR(record.engagedTo, m_to, 1e-4);
    }

private:
    Motion m_motion;
    double m_from = std::numeric_limits<double>::infinity();
    double m_to = -std::numeric_limits<double>::infinity();
};

TEST(Cut, RecordsTheRadialEngagementOnArcs) {
    constexpr double kPi = std::numbers::pi;
    for (const double climb : {0.0, -1.0}) {
        for (const double sweep : {1.5 * kPi, -1.5 * kPi, 2 * kPi, -2 * kPi}) {
            SCOPED_TRACE(fmt::format("sweep {}, climb {}", sweep, climb));
            ZMap zmap = freshMap({{0, 0, 0}, 60, 60, 12}, 0.1);
            const Cutter cutter = cutterOf("flat:d=6");
            const auto round = [&](double radius) {
                return cut(zmap, cutter,
                           arcMotion(Plane::xy, {30, 30, -2}, radius, 0.3, sweep, climb, radius));
            };
            const CutRecord slot = round(15);
            EXPECT_NEAR(slot.engagedFrom, -3, 0.05);
            EXPECT_NEAR(slot.engagedTo, 3, 0.05);
            // The material is on the outer side: on the right if the path turns left. Open ends and steps of
            // a helix engage more.
            if (climb != 0 || std::abs(sweep) < 2 * kPi)
                continue;
            const CutRecord wider = round(16.5);
            EXPECT_NEAR(wider.radialEngagement(), 1.5, 0.15);
            EXPECT_NEAR(sweep > 0 ? wider.engagedFrom : -wider.engagedTo, -3, 0.05);
        }
    }
}

TEST(Cut, RecordsWhatTheMapLost) {
    forRandomMaps(40, 6, [](Random& /*random*/, const Map& map, const std::vector<Job>& jobs) {
        ZMap zmap = freshMap(map);
        for (const Job& job : jobs) {
            SCOPED_TRACE(reported(job.cutter, job.motion));
            const ZMapSnapshot before = zmap.snapshot();
            const CutRecord record = cut(zmap, job.cutter, job.motion);
            const ZMapSnapshot after = zmap.snapshot();
            EXPECT_NEAR(record.removedMm3, before.volume() - after.volume(), 1e-7 * before.volume() / 100);
            std::int64_t points = 0;
            double depth = 0;
            IndexRect changed;
            Engagement engagement(job.motion);
            for (int j = 0; j < zmap.grid().ny; ++j) {
                for (int i = 0; i < zmap.grid().nx; ++i) {
                    const float lost = before.height(i, j) - after.height(i, j);
                    if (!(lost > 0))
                        continue;
                    ++points;
                    depth = std::max(depth, static_cast<double>(lost));
                    changed = hull(changed, {i, j, i + 1, j + 1});
                    engagement.add({zmap.grid().x(i), zmap.grid().y(j)});
                }
            }
            engagement.expect(record);
            EXPECT_EQ(record.points, points);
            EXPECT_EQ(record.maxDepth, depth);
            EXPECT_EQ(record.changed.empty(), changed.empty());
            if (!changed.empty()) {
                EXPECT_EQ(record.changed, changed);
            }
        }
    });
}

TEST(Cut, TouchesNoTileThatItDoesNotChange) {
    ZMap zmap = freshMap();
    const Cutter cutter = cutterOf("ball:d=6");
    const Motion motion = straightMotion({10, 20, -2}, {60, 50, -3});
    (void)cut(zmap, cutter, motion);
    const ZMapSnapshot before = zmap.snapshot();
    (void)cut(zmap, cutter, motion);
    Motion higher = motion;
    higher.start.z += 1;
    higher.end.z += 1;
    (void)cut(zmap, cutter, higher);
    const ZMapSnapshot after = zmap.snapshot();
    for (std::size_t tile = 0; tile < before.tileCount(); ++tile)
        EXPECT_EQ(before.tile(tile), after.tile(tile));
}

TEST(Cut, LeavesMomentsAlone) {
    Random random(3);
    ZMap zmap = freshMap();
    std::vector<ZMapSnapshot> moments;
    std::vector<std::vector<float>> kept;
    for (const Job& job : randomJobs(random, 30)) {
        (void)cut(zmap, job.cutter, job.motion);
        moments.push_back(zmap.snapshot());
        kept.push_back(heightsOf(zmap));
    }
    for (std::size_t k = 0; k < moments.size(); ++k)
        EXPECT_EQ(heightsOf(ZMap(moments[k])), kept[k]);
}

TEST(Cut, StopsAtTheFloor) {
    ZMap zmap = freshMap();
    const CutRecord record = cut(zmap, cutterOf("flat:d=10"), straightMotion({20, 30, -50}, {40, 30, -50}));
    EXPECT_EQ(record.maxDepth, 12);
    const std::vector<float> heights = heightsOf(zmap);
    EXPECT_EQ(*std::min_element(heights.begin(), heights.end()), -12.0F);
    const ZMapSnapshot before = zmap.snapshot();
    EXPECT_EQ(cut(zmap, cutterOf("flat:d=10"), straightMotion({20, 30, -60}, {40, 30, -60})).points, 0);
    EXPECT_EQ(before.tile(0), zmap.snapshot().tile(0));
}

TEST(Cut, CutsAPointExactlyOnTheRim) {
    for (const char* spec : {"flat:d=10", "ball:d=10", "bull:d=10,r=1", "cone:d=10,angle=90"}) {
        for (const double origin : {0.0, 25.4 * 100, 1e5 + 0.1}) {
            SCOPED_TRACE(fmt::format("{} at {}", spec, origin));
            const StockBox stock{{origin, -origin, 0}, 20, 20, 20};
            ZMap zmap = freshMap(stock, 0.5);
            const Cutter cutter = cutterOf(spec);
            const double z = -cutter.rimHeight() - 1;
            (void)cut(zmap, cutter,
                      straightMotion({origin + 10, -origin + 10, z}, {origin + 10, -origin + 10, z}));
            const ZMapSnapshot moment = zmap.snapshot();
            // The rim passes through the points at 5 mm along the axes, and through those of the 3-4-5
            // triangle.
            for (const auto& [i, j] : {std::pair{30, 20}, {10, 20}, {20, 30}, {20, 10}, {26, 28}, {12, 14}})
                EXPECT_NEAR(moment.height(i, j), -1, 2e-3) << i << "," << j;
            EXPECT_EQ(moment.height(31, 20), 0.0F);
        }
    }
}

/// The largest difference between a motion on a grid and on a grid that is shifted by whole cells, so that
/// the points are at other places in their tiles.
double differenceAcrossTiles(double spacing, int shift) {
    const Cutter cutter = cutterOf("bull:d=9,r=2");
    const Motion motion = straightMotion({10.3, 8.7, -1}, {27.1, 21.9, -6});
    ZMap a = freshMap({{0, 0, 0}, 40, 32, 12}, spacing);
    (void)cut(a, cutter, motion);
    const ZMapSnapshot whole = a.snapshot();
    ZMap b = freshMap({{-spacing * shift, -spacing * shift, 0}, 40, 32, 12}, spacing);
    (void)cut(b, cutter, motion);
    const ZMapSnapshot part = b.snapshot();
    float largest = 0;
    for (int j = 0; j + shift < part.grid().ny; ++j) {
        for (int i = 0; i + shift < part.grid().nx; ++i)
            largest = std::max(largest, std::abs(part.height(i + shift, j + shift) - whole.height(i, j)));
    }
    return static_cast<double>(largest);
}

TEST(Cut, IsTheSameAcrossTileBoundaries) {
    for (const int shift : {1, 15, 31, 32, 33}) {
        EXPECT_EQ(differenceAcrossTiles(1, shift), 0) << shift;
        // Points close together are computed relative to their tile in single precision, so rounding depends
        // on the tile.
        EXPECT_LT(differenceAcrossTiles(0.125, shift), 5e-5) << shift;
    }
}

TEST(Cut, IsAsExactFarFromTheOrigin) {
    const StockBox stock{{25.4 * 400, -25.4 * 700, 25.4 * 80}, 24, 18, 30};
    forRandomJobs(6, stock, [&stock](const Job& job, Random& /*random*/) {
        EXPECT_LE(largestError(job.cutter, job.motion, stock, 1.5, 1000), 1e-4);
    });
}

TEST(Cut, CutsNothingWhereThePathIsNotKnown) {
    for (const bool atStart : {true, false}) {
        for (const std::uint8_t axis : {kAxisX, kAxisY, kAxisZ}) {
            Motion motion = straightMotion({10, 20, -2}, {60, 50, -3});
            std::uint8_t& known = atStart ? motion.startKnown : motion.endKnown;
            known = static_cast<std::uint8_t>(known & ~axis);
            ZMap zmap = freshMap();
            EXPECT_EQ(cut(zmap, cutterOf("ball:d=6"), motion).points, 0);
            EXPECT_EQ(envelope(cutterOf("ball:d=6"), motion, 20, 30),
                      std::numeric_limits<double>::infinity());
        }
    }
}

TEST(Cut, SurvivesAnyNumbers) {
    const std::vector<double> values = {0, 1e-300, 1, -1e9, 1e18, -1e18, 1e300, -1.7e308, NAN, INFINITY};
    for (unsigned seed = 1; seed <= 400; ++seed) {
        Random random(seed);
        SCOPED_TRACE(fmt::format("seed {}", seed));
        const auto value = [&] {
            return random() % 3 == 0 ? values[random() % values.size()] : uniform(random, 0, 40);
        };
        const auto place = [&] {
            const double x = value();
            const double y = value();
            return Vec3(x, y, value());
        };
        Motion motion = straightMotion(place(), place());
        if (seed % 2 == 0) {
            motion.kind = MotionKind::arc;
            motion.plane = static_cast<Plane>(random() % 3);
            motion.centre = place();
            motion.sweep = value();
        }
        ZMap zmap = freshMap(kStock, 5);
        (void)cut(zmap, randomCutter(random, kShapes[random() % kShapes.size()]), motion);
        for (const float height : heightsOf(zmap))
            ASSERT_TRUE(height <= 0 && height >= -12);
    }
}

TEST(Cut, CutsThroughAStockThatTheMotionPassesFromFarAway) {
    ZMap zmap = freshMap();
    (void)cut(zmap, cutterOf("flat:d=10"), straightMotion({-1e6, 40, -3}, {1e6, 40, -3}));
    const ZMapSnapshot moment = zmap.snapshot();
    const auto j = static_cast<int>(std::lround((40 - 5) / zmap.grid().hy));
    for (int i = 0; i < zmap.grid().nx; ++i)
        EXPECT_EQ(moment.height(i, j), -5.0F);
}

TEST(Cut, LeavesTheMapAsItWasWhereItIsStopped) {
    const std::uint32_t seed = randomSeed();
    Random random(seed);
    int stopped = 0;
    for (int round = 0; round < std::max(4, roundsOf(40)); ++round) {
        // Grids from coarse to fine; the first rounds are stopped before they start, and are long enough to
        // check for that.
        const double spacing = round % 2 == 0 ? 0.9 : 0.04;
        const Job job = round < 4 ? Job{cutterOf("ball:d=40"), straightMotion({-3, 20, -4}, {80, 50, -5})}
                                  : randomJobs(random, 1)[0];
        SCOPED_TRACE(fmt::format("seed {} round {} {}", seed, round, reported(job.cutter, job.motion)));
        ZMap zmap = freshMap(kStock, spacing);
        (void)cut(zmap, cutterOf("ball:d=6"), straightMotion({-3, 20, -2}, {80, 50, -3}));
        const std::vector<float> before = heightsOf(zmap);
        ZMap whole(zmap.snapshot());
        const CutRecord wanted = cut(whole, job.cutter, job.motion);
        std::stop_source source;
        std::jthread stopper([&source, delay = std::chrono::microseconds(round < 4 ? 0 : random() % 4000)] {
            std::this_thread::sleep_for(delay);
            source.request_stop();
        });
        if (round < 4)
            stopper.join();
        const auto record = cut(zmap, job.cutter, job.motion, source.get_token());
        if (record) {
            EXPECT_EQ(record->removedMm3, wanted.removedMm3);
            EXPECT_EQ(record->points, wanted.points);
            EXPECT_EQ(heightsOf(zmap), heightsOf(whole));
        } else {
            ++stopped;
            EXPECT_EQ(heightsOf(zmap), before);
        }
    }
    EXPECT_GT(stopped, 0) << "seed " << seed;
}

TEST(Cut, CutsTheLongestArcThatAProgramMayHave) {
    // Over 20 mm such an arc deviates from its tangent by less than a ten thousandth of a millimetre.
    const double radius = kLongestArc / (2 * std::numbers::pi) * 0.999999;
    const Motion arc = arcMotion(Plane::xy, {10 + radius, 20, -3}, radius, std::numbers::pi,
                                 -2 * std::numbers::pi, 0, radius);
    ASSERT_TRUE(withinLimits(arc));
    const Cutter cutter = cutterOf("ball:d=6");
    const Motion tangent = straightMotion({10, -1000, -3}, {10, 1000, -3});
    for (int k = 0; k < 200; ++k) {
        const double x = 7.5 + 0.025 * k;
        EXPECT_NEAR(envelope(cutter, arc, x, 20.3), envelope(cutter, tangent, x, 20.3), 1e-3) << x;
    }
    ZMap zmap = freshMap();
    EXPECT_GT(cut(zmap, cutter, arc).removedMm3, 100);
    Motion longer = arc;
    longer.centre.x += 10;
    longer.start.x = longer.end.x = 10;
    EXPECT_FALSE(withinLimits(longer));
}

} // namespace
} // namespace proveout
