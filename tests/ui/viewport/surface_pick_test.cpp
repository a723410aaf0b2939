// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/surface_pick.h"

#include <cmath>
#include <random>

#include <QTest>

#include "tests/ui/viewport/frame_builder.h"

using namespace proveout;

namespace {

/// Height of the stock at a position, by the definition of the canonical full mesh; the floor outside.
double stockTop(const ZMapSnapshot& zmap, double x, double y) {
    const Grid& grid = zmap.grid();
    const double u = (x - grid.x0) / grid.hx;
    const double v = (y - grid.y0) / grid.hy;
    if (u < 0 || v < 0 || u > grid.nx - 1 || v > grid.ny - 1)
        return zmap.stock().floorZ();
    const int i = std::min(static_cast<int>(u), grid.nx - 2);
    const int j = std::min(static_cast<int>(v), grid.ny - 2);
    const auto at = [&](int di, int dj) {
        return Vec3(i + di, j + dj, double{zmap.height(i + di, j + dj)} + zmap.stock().topZ());
    };
    const bool rising = (i + j) % 2 == 0;
    const std::array<std::array<Vec3, 3>, 2> triangles =
        rising
            ? std::array{std::array{at(0, 0), at(1, 0), at(1, 1)}, std::array{at(0, 0), at(1, 1), at(0, 1)}}
            : std::array{std::array{at(0, 0), at(1, 0), at(0, 1)}, std::array{at(1, 0), at(1, 1), at(0, 1)}};
    for (const auto& [a, b, c] : triangles) {
        const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        const double wb = ((u - a.x) * (c.y - a.y) - (v - a.y) * (c.x - a.x)) / area;
        const double wc = ((b.x - a.x) * (v - a.y) - (b.y - a.y) * (u - a.x)) / area;
        if (wb >= -1e-9 && wc >= -1e-9 && wb + wc <= 1 + 1e-9)
            return a.z + wb * (b.z - a.z) + wc * (c.z - a.z);
    }
    return zmap.stock().floorZ();
}

bool inStock(const ZMapSnapshot& zmap, const Vec3& point) {
    const double top = stockTop(zmap, point.x, point.y);
    return top > zmap.stock().floorZ() && point.z <= top && point.z >= zmap.stock().floorZ();
}

FramePtr randomStock(std::mt19937& random) {
    std::uniform_real_distribution<double> depth(-24, 3); // some below the floor at -20, some above the top
    FrameBuilder builder({{10, -5, 7}, 40, 30, 20}, 2.5);
    builder.cutAll([&](double, double) { return 7 + depth(random); });
    return builder.frame();
}

} // namespace

class SurfacePickTest : public QObject {
    Q_OBJECT

private slots:
    void hitsWhatAMarchOfSmallStepsHits();
    void missesBesideTheStock();
    void seesThroughHoles();
    void aPlaceMeansTheFootOfItsWall();
    void theOutsideOfTheStockIsNoPointOfTheMap();
    void aCloserLookIsMetInThePlaceOfTheStock();
};

void SurfacePickTest::hitsWhatAMarchOfSmallStepsHits() {
    constexpr unsigned kSeed = 77;
    constexpr double kStep = 2e-3;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> unit(-1, 1);
    int hits = 0;
    for (int k = 0; k < 300; ++k) {
        const FramePtr frame = randomStock(random);
        const Vec3 aim(30 + 25 * unit(random), 10 + 20 * unit(random), -3 + 12 * unit(random));
        const Vec3 direction = glm::normalize(Vec3(unit(random), unit(random), unit(random)));
        const Ray ray{aim - direction * 90.0, direction};
        double marched = 0;
        while (marched < 180 && !inStock(frame->zmap, ray.origin + direction * marched))
            marched += kStep;
        const auto picked = pickStock(frame->zmap, ray);
        const QByteArray where = "seed 77, ray " + QByteArray::number(k);
        if (marched >= 180) {
            // The march may miss a sliver; a picked point must still be stock.
            QVERIFY2(!picked || inStock(frame->zmap, *picked + direction * 1e-6), where);
            continue;
        }
        ++hits;
        QVERIFY2(picked.has_value(), where);
        const double distance = glm::distance(ray.origin, *picked);
        QVERIFY2(distance <= marched + 1e-6, where);
        QVERIFY2(distance >= marched - 2 * kStep || inStock(frame->zmap, *picked + direction * 1e-6), where);
    }
    QVERIFY(hits > 150);
}

void SurfacePickTest::missesBesideTheStock() {
    FrameBuilder builder({{0, 0, 0}, 20, 20, 10}, 1);
    const FramePtr frame = builder.frame();
    QVERIFY(!pickStock(frame->zmap, {{25, 10, 50}, {0, 0, -1}}));
    QVERIFY(!pickStock(frame->zmap, {{10, 10, 50}, {0, 0, 1}}));
    QVERIFY(!pickStock({}, {{10, 10, 50}, {0, 0, -1}}));
    const auto top = pickStock(frame->zmap, {{10.3, 10.7, 50}, {0, 0, -1}});
    QVERIFY(top && glm::distance(*top, Vec3(10.3, 10.7, 0)) < 1e-9);
}

void SurfacePickTest::seesThroughHoles() {
    FrameBuilder builder({{0, 0, 0}, 20, 20, 10}, 1);
    builder.cutAll([](double x, double y) { return std::hypot(x - 10, y - 10) < 4 ? -10.0 : 0.0; });
    const FramePtr frame = builder.frame();
    QVERIFY(!pickStock(frame->zmap, {{10, 10, 50}, {0, 0, -1}}));
    QVERIFY(!pickStock(frame->zmap, {{10, 10, -50}, {0, 0, 1}}));
    QVERIFY(pickStock(frame->zmap, {{3, 3, -50}, {0, 0, 1}}));
}

void SurfacePickTest::aPlaceMeansTheFootOfItsWall() {
    FrameBuilder builder({{0, 0, 0}, 20, 20, 10}, 1);
    builder.cutAll([](double x, double) { return x < 9.5 ? 0.0 : -6.0; });
    const ZMapSnapshot zmap = builder.frame()->zmap;
    for (const double height : {-0.01, -1., -3., -5.99}) {
        const auto wall = pickStock(zmap, {{30, 7.2, height}, {-1, 0, 0}});
        QVERIFY(wall && wall->x > 9 && wall->x < 10);
        QCOMPARE(mapPointAt(zmap, *wall), (std::optional<MapPoint>({10, 7})));
    }
    // On a level surface, the nearest point.
    QCOMPARE(mapPointAt(zmap, {14.6, 3.4, -6}), (std::optional<MapPoint>({15, 3})));
    QCOMPARE(mapPointAt(zmap, {20, 20, -6}), (std::optional<MapPoint>({20, 20})));
}

void SurfacePickTest::theOutsideOfTheStockIsNoPointOfTheMap() {
    const FramePtr frame = FrameBuilder({{0, 0, 0}, 20, 20, 10}, 1).frame();
    for (const Ray& ray : {Ray{{10, -5, -4}, {0, 1, 0}}, Ray{{10, 10, -50}, {0, 0, 1}}}) {
        const PickedPlace place = pickPlace(frame, nullptr, ray);
        QVERIFY(place.moment == frame && !place.point);
    }
    QVERIFY(pickPlace(frame, nullptr, {{30, 10, 50}, {0, 0, -1}}).moment == nullptr);
    QVERIFY(pickPlace(nullptr, nullptr, {{10, 10, 50}, {0, 0, -1}}).moment == nullptr);
}

void SurfacePickTest::aCloserLookIsMetInThePlaceOfTheStock() {
    // A ridge next to the detail region, in which the fine map is slightly higher or lower.
    const auto height = [](double x, double) { return x < 8 ? 0.0 : -6.0; };
    FrameBuilder builder({{0, 0, 0}, 20, 20, 10}, 1);
    builder.cutAll(height);
    const FramePtr whole = builder.frame();
    for (const double off : {-0.05, 0.05}) {
        FrameBuilder part({{10, 5, 0}, 5, 5, 10}, 0.1);
        part.cutAll([&](double x, double y) { return height(x, y) + off; });
        const FramePtr closer = part.frame();
        const auto at = [&](const Vec3& eye, const Vec3& target) {
            return pickPlace(whole, closer, {eye, glm::normalize(target - eye)});
        };
        const PickedPlace inside = at({12.04, 7.31, 40}, {12.04, 7.31, 0});
        QVERIFY(inside.moment == closer);
        QCOMPARE(inside.point, (std::optional<MapPoint>({20, 23})));
        const PickedPlace beside = at({17.2, 7.3, 40}, {17.2, 7.3, 0});
        QVERIFY(beside.moment == whole);
        QCOMPARE(beside.point, (std::optional<MapPoint>({17, 7})));
        // The ridge hides the detail region.
        QVERIFY(at({-20, 7.3, 0}, {12, 7.3, -6}).moment == whole);
        QVERIFY(at({40, 7.3, 10}, {12, 7.3, -6}).moment == closer);
    }
}

QTEST_APPLESS_MAIN(SurfacePickTest)
#include "surface_pick_test.moc"
