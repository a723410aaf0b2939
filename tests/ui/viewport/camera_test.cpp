// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/camera.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <QTest>

using namespace proveout;

namespace {

constexpr unsigned kSeed = 20260717;
constexpr int kWidth = 1280;
constexpr int kHeight = 800;

class RandomScene {
public:
    RandomScene() : m_random(kSeed) {}

    double between(double lo, double hi) { return std::uniform_real_distribution(lo, hi)(m_random); }
    Vec3 point() { return {between(-200, 200), between(-200, 200), between(-80, 80)}; }
    Camera camera() {
        Camera camera;
        camera.setPicture(kWidth, kHeight, 1);
        camera.setPerspective(between(0, 1) < 0.5);
        camera.orbit(between(-3000, 3000), between(-3000, 3000));
        Box3 box;
        box.add(point());
        box.add(point());
        camera.fit(box);
        return camera;
    }

private:
    std::mt19937 m_random;
};

double apart(const Vec2& a, const Vec2& b) {
    return glm::distance(a, b);
}

/// The pixel of a point according to the matrices that the GPU uses.
Vec2 byMatrix(const Camera& camera, const Vec3& point) {
    Box3 scene;
    scene.add(Vec3(-300));
    scene.add(Vec3(300));
    const glm::dvec4 clip = camera.view(scene).clipFromWorld * glm::dvec4(point, 1);
    return {(clip.x / clip.w + 1) * 0.5 * kWidth, (1 - clip.y / clip.w) * 0.5 * kHeight};
}

} // namespace

class CameraTest : public QObject {
    Q_OBJECT

private slots:
    void standardViewsLookAlongTheAxes();
    void projectionAgreesWithTheMatrices();
    void raysPassThroughWhatTheyProjectTo();
    void zoomKeepsThePointUnderThePointer();
    void fitLeavesAMargin();
    void perspectiveKeepsTargetAndApparentSize();
    void panFollowsThePointer();
    void orbitStopsAtThePoles();
    void sceneLiesBetweenThePlanes();
};

void CameraTest::standardViewsLookAlongTheAxes() {
    struct Row {
        StandardView view;
        Vec3 back;
        Vec3 right;
        Vec3 up;
    };
    const double s = 1 / std::sqrt(2.0);
    const Row rows[] = {
        {StandardView::iso, Vec3(1, -1, 1) / std::sqrt(3.0), {s, s, 0}, Vec3(-1, 1, 2) / std::sqrt(6.0)},
        {StandardView::top, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
        {StandardView::bottom, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}},
        {StandardView::front, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
        {StandardView::back, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
        {StandardView::left, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
        {StandardView::right, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    };
    for (const Row& row : rows) {
        Camera camera;
        camera.setStandardView(row.view);
        const View view = camera.view({});
        QVERIFY(glm::distance(view.back, row.back) < 1e-6);
        QVERIFY(glm::distance(view.right, row.right) < 1e-6);
        QVERIFY(glm::distance(view.up, row.up) < 1e-6);
    }
}

void CameraTest::projectionAgreesWithTheMatrices() {
    RandomScene random;
    for (int k = 0; k < 300; ++k) {
        const Camera camera = random.camera();
        const Vec3 point = camera.atTargetDepth(random.between(0, kWidth), random.between(0, kHeight));
        QVERIFY2(apart(camera.project(point), byMatrix(camera, point)) < 1e-6, "seed 20260717");
    }
}

void CameraTest::raysPassThroughWhatTheyProjectTo() {
    RandomScene random;
    for (int k = 0; k < 300; ++k) {
        const Camera camera = random.camera();
        const Vec2 pixel(random.between(0, kWidth), random.between(0, kHeight));
        const Ray ray = camera.ray(pixel.x, pixel.y);
        const double depth = random.between(0.5, 1.5) * glm::distance(ray.origin, camera.target());
        QVERIFY2(apart(camera.project(ray.origin + ray.direction * depth), pixel) < 1e-6, "seed 20260717");
    }
}

void CameraTest::zoomKeepsThePointUnderThePointer() {
    RandomScene random;
    for (int k = 0; k < 300; ++k) {
        Camera camera = random.camera();
        const Vec2 pixel(random.between(0, kWidth), random.between(0, kHeight));
        // A point closer or farther than the target, as in a pick.
        const Ray ray = camera.ray(pixel.x, pixel.y);
        const Vec3 point = ray.origin + ray.direction * (random.between(0.6, 1.4) *
                                                         glm::distance(ray.origin, camera.target()));
        for (int step = 0; step < 10; ++step)
            camera.zoom(random.between(0.7, 1.3), point);
        QVERIFY2(apart(byMatrix(camera, point), pixel) < 0.01, "seed 20260717");
    }
}

void CameraTest::fitLeavesAMargin() {
    RandomScene random;
    for (int k = 0; k < 300; ++k) {
        Camera camera = random.camera();
        Box3 box;
        box.add(random.point());
        box.add(random.point());
        camera.fit(box);
        double margin = 1;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 at((corner & 1) != 0 ? box.hi.x : box.lo.x, (corner & 2) != 0 ? box.hi.y : box.lo.y,
                          (corner & 4) != 0 ? box.hi.z : box.lo.z);
            const Vec2 pixel = camera.project(at);
            margin = std::min(
                {margin, pixel.x / kWidth, 1 - pixel.x / kWidth, pixel.y / kHeight, 1 - pixel.y / kHeight});
        }
        QVERIFY2(margin >= 0.05 && margin <= 0.15, qPrintable(QString::number(margin)));
    }
}

void CameraTest::perspectiveKeepsTargetAndApparentSize() {
    RandomScene random;
    for (int k = 0; k < 100; ++k) {
        Camera camera = random.camera();
        const Vec3 beside = camera.atTargetDepth(0.7 * kWidth, 0.2 * kHeight);
        const Vec2 before = camera.project(beside);
        camera.setPerspective(!camera.perspective());
        QVERIFY(apart(camera.project(beside), before) < 1e-9);
    }
}

void CameraTest::panFollowsThePointer() {
    RandomScene random;
    for (int k = 0; k < 100; ++k) {
        Camera camera = random.camera();
        const Vec3 held = camera.atTargetDepth(300, 200);
        camera.pan(150, 77);
        QVERIFY(apart(camera.project(held), {450, 277}) < 1e-6);
    }
}

void CameraTest::orbitStopsAtThePoles() {
    Camera camera;
    camera.setPicture(kWidth, kHeight, 1);
    camera.orbit(0, 1e6);
    QVERIFY(std::abs(camera.view({}).back.z - 1) < 1e-12);
    camera.orbit(0, -1e6);
    QVERIFY(std::abs(camera.view({}).back.z + 1) < 1e-12);
}

void CameraTest::sceneLiesBetweenThePlanes() {
    RandomScene random;
    for (int k = 0; k < 200; ++k) {
        Camera camera = random.camera();
        Box3 scene;
        scene.add(random.point());
        scene.add(random.point());
        camera.fit(scene);
        const View view = camera.view(scene);
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 at((corner & 1) != 0 ? scene.hi.x : scene.lo.x,
                          (corner & 2) != 0 ? scene.hi.y : scene.lo.y,
                          (corner & 4) != 0 ? scene.hi.z : scene.lo.z);
            const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(at, 1);
            QVERIFY2(std::abs(clip.z) < clip.w, "seed 20260717");
        }
    }
}

QTEST_APPLESS_MAIN(CameraTest)
#include "camera_test.moc"
