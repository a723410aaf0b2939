// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the renderer's images pixel by pixel. The backdrop is magenta, a colour that nothing else has.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <QTest>

#include "core/decimation/surface/refined_surface.h"
#include "tests/ui/viewport/frame_builder.h"
#include "tests/ui/viewport/offscreen_picture.h"
#include "ui/viewport/camera.h"
#include "ui/viewport/view_bounds.h"

using namespace proveout;

namespace {

const StockBox kStock{{0, 0, 0}, 100, 70, 20};
const StockBox kBoxStock{{40, 20, 0}, 20, 20, 20}; // contains a detail region

Box3 stockBox() {
    Box3 box;
    box.add(Vec3(0, 0, -20));
    box.add(Vec3(100, 70, 0));
    return box;
}

/// Violet, as fixtures are in any light.
bool isFixture(QRgb pixel) {
    return qBlue(pixel) < 250 && qBlue(pixel) - qGreen(pixel) > 20 && qBlue(pixel) - qRed(pixel) > 10;
}

bool isHit(QRgb pixel) {
    return qRed(pixel) - qGreen(pixel) > 60 && qRed(pixel) - qBlue(pixel) > 60;
}

bool isGrey(QRgb pixel) {
    return std::max({qRed(pixel), qGreen(pixel), qBlue(pixel)}) -
               std::min({qRed(pixel), qGreen(pixel), qBlue(pixel)}) <
           25;
}

bool isBackdrop(QRgb pixel) {
    return qRed(pixel) > 250 && qGreen(pixel) < 5 && qBlue(pixel) > 250;
}

Camera cameraAt(StandardView view, bool perspective, int width = 640, int height = 400) {
    return cameraFitted(stockBox(), view, perspective, width, height);
}

QRgb pixelAt(const QImage& picture, const Camera& camera, const Vec3& point) {
    const Vec2 pixel = camera.project(point);
    return picture.pixel(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
}

double hills(double x, double y) {
    return -6 + 3 * std::sin(x * 0.13) * std::cos(y * 0.11) + (std::hypot(x - 60, y - 30) < 15 ? -5 : 0);
}

/// At least part of the pixel is backdrop; the stock itself is grey.
bool showsBackdrop(QRgb pixel) {
    return std::min(qRed(pixel), qBlue(pixel)) - qGreen(pixel) > 40;
}

/// Backdrop pixels of `picture` that are completely surrounded by stock in `reference`.
int cracks(const QImage& picture, const QImage& reference, bool (*open)(QRgb) = isBackdrop) {
    int count = 0;
    for (int y = 2; y < picture.height() - 2; ++y)
        for (int x = 2; x < picture.width() - 2; ++x) {
            if (!open(picture.pixel(x, y)))
                continue;
            bool inside = true;
            for (int dy = -2; dy <= 2 && inside; ++dy)
                for (int dx = -2; dx <= 2 && inside; ++dx)
                    inside = !isBackdrop(reference.pixel(x + dx, y + dy));
            count += inside ? 1 : 0;
        }
    return count;
}

/// A stock of which about half is decimated, and the same heights drawn from the z-map only.
struct HalfDirty {
    FramePtr frame;
    FramePtr full;
};

HalfDirty halfDirty(unsigned seed, const DecimationParameters& parameters) {
    std::mt19937 random(seed);
    DecimationParameters none;
    none.method = DecimationMethod::none;
    FrameBuilder builder(kStock, 1, parameters);
    FrameBuilder full(kStock, 1, none);
    const auto cutBoth = [&](const IndexRect& rect, double lower) {
        const auto height = [=](double x, double y) { return hills(x, y) - lower; };
        builder.cut(rect, height);
        full.cut(rect, height);
    };
    cutBoth({0, 0, 101, 71}, 0);
    builder.decimate();
    for (int k = 0; k < 6; ++k) {
        const int i = static_cast<int>(random() % 90);
        const int j = static_cast<int>(random() % 60);
        cutBoth({i, j, i + 3 + static_cast<int>(random() % 8), j + 3 + static_cast<int>(random() % 8)},
                0.1 * k);
    }
    return {builder.frame(), full.frame()};
}

} // namespace

class SceneRendererTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase() { m_picture.reset(); }
    void emptySceneIsBackdrop();
    void uncutBlockFillsItsOutline();
    void slotIsCutAway();
    void holesShowWhatIsBehind();
    void cutterIsDrawnToScale();
    void holderAndShankHaveTheirColours();
    void fixturesAreSolidsBesideTheStock();
    void whatIsHitIsRed();
    void pathHasTheColourOfItsMotion();
    void hiddenPathIsSeenThroughTheStock();
    void tintDistinguishesDirtyFromDecimated();
    void wireframeShowsRegionBorders();
    void decimationDoesNotShow();
    void indicesOfAnyWidthDrawTheSame();
    void mergedRegionsAreDrawnWhole();
    void noCracksInHalfDirtyStates();
    void cracksWouldBeSeen();
    void uploadsOnlyWhatChanged();
    void anotherGridReplacesTheOldOne();
    void pagesHoldEveryPointAndItsNeighbours();
    void pagesLookLikeOneTexture();
    void staysRightFarFromTheOrigin();
    void boxReplacesWhatIsThere();
    void boxComesInPartsAndIsShownWhole();
    void boxLeavesNoCracks();
    void boxAtTheEdgeOfTheStockLeavesNoCracks();
    void boxThatIsCutThroughIsAHole();

private:
    [[nodiscard]] QImage draw(const FramePtr& frame, const Camera& camera, const SceneOptions& options,
                              const FramePtr& box = nullptr, int samples = 0) {
        m_picture->setSamples(samples);
        return m_picture->draw(frame, camera.view(stockBox()), options, box);
    }
    std::unique_ptr<OffscreenPicture> m_picture;
};

void SceneRendererTest::initTestCase() {
    m_picture = std::make_unique<OffscreenPicture>();
    if (!m_picture->usable())
        QSKIP("no OpenGL 3.3 here");
}

void SceneRendererTest::emptySceneIsBackdrop() {
    const QImage picture = draw(nullptr, cameraAt(StandardView::iso, true), testOptions());
    QVERIFY(isBackdrop(picture.pixel(0, 0)) && isBackdrop(picture.pixel(320, 200)));
}

void SceneRendererTest::uncutBlockFillsItsOutline() {
    FrameBuilder builder(kStock, 1);
    builder.decimate();
    for (const bool perspective : {false, true})
        for (std::size_t view = 0; view < kStandardViews; ++view) {
            const Camera camera = cameraAt(static_cast<StandardView>(view), perspective);
            const QImage picture = draw(builder.frame(), camera, testOptions());
            // A pixel shows stock if the ray through it hits the box.
            int wrong = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x) {
                    const auto hits = [&](double dx, double dy) {
                        const Ray ray = camera.ray(x + 0.5 + dx, y + 0.5 + dy);
                        double from = -1e300;
                        double to = 1e300;
                        for (int axis = 0; axis < 3; ++axis) {
                            const double inverse = 1 / (ray.direction[axis] + 1e-18);
                            const double a = (stockBox().lo[axis] - ray.origin[axis]) * inverse;
                            const double b = (stockBox().hi[axis] - ray.origin[axis]) * inverse;
                            from = std::max(from, std::min(a, b));
                            to = std::min(to, std::max(a, b));
                        }
                        return from < to;
                    };
                    const bool inside =
                        hits(-0.6, -0.6) && hits(0.6, -0.6) && hits(-0.6, 0.6) && hits(0.6, 0.6);
                    const bool outside =
                        !hits(-0.6, -0.6) && !hits(0.6, -0.6) && !hits(-0.6, 0.6) && !hits(0.6, 0.6);
                    const bool stock = !isBackdrop(picture.pixel(x, y));
                    wrong += (inside && !stock) || (outside && stock) ? 1 : 0;
                }
            QCOMPARE(wrong, 0);
        }
}

void SceneRendererTest::slotIsCutAway() {
    FrameBuilder builder(kStock, 1);
    builder.cutAll([](double x, double) { return std::abs(x - 50) < 8 ? -12.0 : 0.0; });
    const Camera camera = cameraAt(StandardView::front, false);
    const QImage picture = draw(builder.frame(), camera, testOptions());
    QVERIFY(isBackdrop(pixelAt(picture, camera, {50, 0, -5})));
    QVERIFY(isBackdrop(pixelAt(picture, camera, {50, 0, -11})));
    QVERIFY(!isBackdrop(pixelAt(picture, camera, {50, 0, -13})));
    QVERIFY(!isBackdrop(pixelAt(picture, camera, {30, 0, -5})));
    QVERIFY(!isBackdrop(pixelAt(picture, camera, {70, 0, -5})));
}

void SceneRendererTest::holesShowWhatIsBehind() {
    FrameBuilder builder(kStock, 1);
    builder.cutAll([](double x, double y) { return std::hypot(x - 40, y - 30) < 12 ? -25.0 : 0.0; });
    for (const bool decimated : {false, true}) {
        if (decimated)
            builder.decimate();
        for (const StandardView view : {StandardView::top, StandardView::bottom}) {
            const Camera camera = cameraAt(view, false);
            for (const bool wireframe : {false, true}) {
                SceneOptions options = testOptions();
                options.wireframe = wireframe;
                const QImage picture = draw(builder.frame(), camera, options);
                QVERIFY(isBackdrop(pixelAt(picture, camera, {40, 30, -10})));
                QVERIFY(isBackdrop(pixelAt(picture, camera, {48, 30, -10})));
                QVERIFY(!isBackdrop(pixelAt(picture, camera, {55, 30, -10})));
            }
        }
    }
}

void SceneRendererTest::cutterIsDrawnToScale() {
    FrameBuilder builder(kStock, 1);
    builder.setCutter(parseCutter("flat:d=12,l=30").value(), {50, 35, 2});
    Box3 scene = stockBox();
    scene.add(Vec3(50, 35, 70));
    Camera camera = cameraAt(StandardView::front, false);
    camera.fit(scene);
    const QImage picture = m_picture->draw(builder.frame(), camera.view(scene), testOptions());
    const int row = static_cast<int>(camera.project({50, 35, 10}).y);
    int width = 0;
    for (int x = 0; x < picture.width(); ++x)
        width += isBackdrop(picture.pixel(x, row)) ? 0 : 1;
    QVERIFY(std::abs(width - 12 * camera.view(scene).pixelsPerMm) < 2);
    SceneOptions hidden = testOptions();
    hidden.cutter = CutterShown::hidden;
    QVERIFY(isBackdrop(m_picture->draw(builder.frame(), camera.view(scene), hidden)
                           .pixel(static_cast<int>(camera.project({50, 35, 10}).x), row)));
}

void SceneRendererTest::holderAndShankHaveTheirColours() {
    FrameBuilder builder(kStock, 1);
    builder.setCutter(parseCutter("flat:d=12,l=20,sd=8,so=40,holder=30x20+50x30").value(), {50, 35, 2});
    Box3 scene = stockBox();
    scene.add(Vec3(50, 35, 100));
    Camera camera = cameraAt(StandardView::front, false);
    camera.fit(scene);
    const QImage picture = m_picture->draw(builder.frame(), camera.view(scene), testOptions());
    const auto widthAt = [&](double z) {
        const int row = static_cast<int>(camera.project({50, 35, z}).y);
        int width = 0;
        for (int x = 0; x < picture.width(); ++x)
            width += isBackdrop(picture.pixel(x, row)) ? 0 : 1;
        return width / camera.view(scene).pixelsPerMm;
    };
    QVERIFY(std::abs(widthAt(10) - 12) < 1);
    QVERIFY(std::abs(widthAt(30) - 8) < 1);
    QVERIFY(std::abs(widthAt(50) - 30) < 1);
    QVERIFY(std::abs(widthAt(75) - 50) < 1);
    QVERIFY(std::abs(widthAt(91) - 50) < 1);
    QVERIFY(widthAt(94) < 1);
    const QRgb shank = pixelAt(picture, camera, {50, 35, 30});
    const QRgb holder = pixelAt(picture, camera, {50, 35, 60});
    QVERIFY2(qGray(shank) - qGray(holder) > 40, qPrintable(QString::number(qGray(shank) - qGray(holder))));
}

void SceneRendererTest::fixturesAreSolidsBesideTheStock() {
    FrameBuilder builder(kStock, 1);
    builder.cutAll([](double x, double) { return std::abs(x - 50) < 8 ? -12.0 : 0.0; });
    builder.setFixtures({{"jaw", FixtureBox{-30, 0, -20, 25, 70, 30}},
                         {"pin", FixtureCylinder{50, 100, -20, 20, 16}},
                         {"clamp", FixtureBox{80, 10, 0, 40, 10, 8}}});
    const FramePtr frame = builder.frame();
    SceneOptions options = testOptions();
    const Box3 work = workBounds(*frame, options);
    QVERIFY(work.lo == Vec3(-30, 0, -20) && work.hi == Vec3(120, 110, 10));
    const Camera above = cameraFitted(work, StandardView::top, false, 640, 480);
    const QImage fromAbove = m_picture->draw(frame, above.view(work), options);
    QVERIFY(isFixture(pixelAt(fromAbove, above, {-15, 35, 10})));
    QVERIFY(isFixture(pixelAt(fromAbove, above, {90, 15, 8}))); // on the stock
    QVERIFY(isGrey(pixelAt(fromAbove, above, {90, 40, 0})));
    QVERIFY(isBackdrop(pixelAt(fromAbove, above, {-2, 35, 0})));
    QVERIFY(isFixture(pixelAt(fromAbove, above, {50, 109, 0})));  // a circle …
    QVERIFY(isBackdrop(pixelAt(fromAbove, above, {59, 109, 0}))); // … not a square

    // The stock hides the pin, except through the slot: its top is at -4, the bottom of the slot at -12.
    const Camera front = cameraFitted(work, StandardView::front, false, 640, 480);
    const QImage fromFront = m_picture->draw(frame, front.view(work), options);
    QVERIFY(isFixture(pixelAt(fromFront, front, {50, 0, -8})));
    QVERIFY(isBackdrop(pixelAt(fromFront, front, {50, 0, -2})));
    QVERIFY(isGrey(pixelAt(fromFront, front, {50, 0, -15})));
    QVERIFY(isFixture(pixelAt(fromFront, front, {-15, 0, 5})));

    options.fixtures = false;
    QVERIFY(workBounds(*frame, options).hi == Vec3(100, 70, 0));
    const QImage without = m_picture->draw(frame, above.view(work), options);
    QVERIFY(isBackdrop(pixelAt(without, above, {-15, 35, 10})));
    QVERIFY(isGrey(pixelAt(without, above, {90, 15, 8})));
    // Others replace them, also at another place of the stock.
    builder.setFixtures({{"jaw", FixtureBox{105, 0, -20, 15, 70, 30}}});
    const QImage other = m_picture->draw(builder.frame(), above.view(work), testOptions());
    QVERIFY(isBackdrop(pixelAt(other, above, {-15, 35, 10})));
    QVERIFY(isFixture(pixelAt(other, above, {112, 35, 10})));
}

void SceneRendererTest::whatIsHitIsRed() {
    FrameBuilder builder(kStock, 1);
    builder.setCutter(parseCutter("flat:d=12,l=20,so=40,holder=30x20").value(), {80, 35, 2});
    builder.setFixtures(
        {{"jaw", FixtureBox{-30, 0, -20, 25, 70, 30}}, {"clamp", FixtureBox{10, 50, 0, 10, 10, 8}}});
    const FramePtr frame = builder.frame();
    Box3 scene = workBounds(*frame, testOptions());
    scene.add(Vec3(50, 35, 70));
    const Camera camera = cameraFitted(scene, StandardView::front, false, 640, 480);
    const auto drawn = [&](const SceneOptions& options) {
        return m_picture->draw(frame, camera.view(scene), options);
    };
    SceneOptions options = testOptions();
    const QImage before = drawn(options);
    QVERIFY(!isBackdrop(pixelAt(before, camera, {80, 35, 55})) &&
            !isHit(pixelAt(before, camera, {80, 35, 55})));
    options.contact = ContactShown{{40, 35, 2}, ToolPart::holder, "jaw"};
    options.cutter = CutterShown::hidden; // the contact shows it all the same
    const QImage picture = drawn(options);
    QVERIFY(isBackdrop(pixelAt(picture, camera, {80, 35, 55})));
    QVERIFY(isHit(pixelAt(picture, camera, {40, 35, 55})));
    QVERIFY(!isHit(pixelAt(picture, camera, {40, 35, 30})));
    QVERIFY(isHit(pixelAt(picture, camera, {-15, 0, 5})));
    QVERIFY(isFixture(pixelAt(picture, camera, {15, 50, 4})));
    options.contact->part = ToolPart::shank;
    QVERIFY(isHit(pixelAt(drawn(options), camera, {40, 35, 30})));
    options = testOptions();
    QCOMPARE(drawn(options), before);
}

void SceneRendererTest::pathHasTheColourOfItsMotion() {
    auto program = std::make_shared<Program>();
    Motion feed;
    feed.kind = MotionKind::feed;
    feed.startKnown = feed.endKnown = kAllAxes;
    feed.start = {10, 35, 5};
    feed.end = {90, 35, 5};
    program->beginBlock(1);
    program->append(feed);
    FrameBuilder builder(kStock, 1);
    builder.setProgram(program, 0);
    SceneOptions options = testOptions();
    options.colours.feed = {0, 1, 0};
    const Camera camera = cameraAt(StandardView::top, false);
    for (const PathShown shown : {PathShown::none, PathShown::nearCutter, PathShown::whole}) {
        options.path = shown;
        Box3 scene = stockBox();
        scene.add(Vec3(0, 0, 10));
        const QImage picture = m_picture->draw(builder.frame(), camera.view(scene), options);
        const Vec2 at = camera.project({50, 35, 5});
        int greenest = 0;
        for (int dy = -2; dy <= 2; ++dy) {
            const QRgb pixel = picture.pixel(static_cast<int>(at.x), static_cast<int>(at.y) + dy);
            greenest = std::max(greenest, qGreen(pixel) - std::max(qRed(pixel), qBlue(pixel)));
        }
        QCOMPARE(greenest > 100, shown != PathShown::none);
    }
}

void SceneRendererTest::hiddenPathIsSeenThroughTheStock() {
    // Far from the current block, so that it is not part of the path near the cutter.
    auto program = std::make_shared<Program>();
    const auto append = [&](const Vec3& from, const Vec3& to) {
        Motion feed;
        feed.kind = MotionKind::feed;
        feed.startKnown = feed.endKnown = kAllAxes;
        feed.start = from;
        feed.end = to;
        program->beginBlock(1);
        program->append(feed);
    };
    for (int k = 0; k < 400; ++k)
        append({10 + 0.2 * k, 60, 5}, {10 + 0.2 * (k + 1), 60, 5});
    append({90, 60, 5}, {90, 20, -10});
    append({90, 20, -10}, {10, 20, -10});
    FrameBuilder builder(kStock, 1);
    builder.setProgram(program, 0);
    Box3 scene = stockBox();
    scene.add(Vec3(0, 0, 10));
    const Camera camera = cameraAt(StandardView::top, false);
    const auto draws = [&](const SceneOptions& options) {
        m_picture->renderer().advancePath({});
        return m_picture->draw(builder.frame(), camera.view(scene), options);
    };
    const auto inkAt = [&](const QImage& picture, const QImage& without, const Vec3& place) {
        const Vec2 at = camera.project(place);
        int most = 0;
        for (int dy = -2; dy <= 2; ++dy) {
            const QPoint pixel(static_cast<int>(at.x), static_cast<int>(at.y) + dy);
            most = std::max(most, std::abs(qRed(picture.pixel(pixel)) - qRed(without.pixel(pixel))));
        }
        return most;
    };
    for (const SceneColours& colours : {lightColours(), darkColours()}) {
        SceneOptions options;
        options.colours = colours;
        options.path = PathShown::none;
        static_cast<void>(draws(options)); // uploads the program
        const QImage none = draws(options);
        options.path = PathShown::nearCutter;
        options.pathThroughStock = false;
        const QImage solid = draws(options);
        options.pathThroughStock = true;
        const QImage through = draws(options);
        const Vec3 near(20, 60, 5);
        const Vec3 hidden(50, 20, -10);
        QVERIFY(inkAt(solid, none, near) > 60);
        QCOMPARE(inkAt(solid, none, hidden), 0);
        const int dimmed = inkAt(through, none, hidden);
        QVERIFY2(dimmed > 15 && dimmed < inkAt(through, none, near) / 2, qPrintable(QString::number(dimmed)));
        // Next to the stock, where nothing hides the path, it is only drawn near the cutter.
        QCOMPARE(inkAt(through, solid, near), 0);
    }
}

void SceneRendererTest::tintDistinguishesDirtyFromDecimated() {
    FrameBuilder builder(kStock, 1);
    builder.decimate();
    builder.cut({0, 0, 40, 71}, [](double, double) { return -3.0; });
    SceneOptions options = testOptions();
    options.tint = true;
    const Camera camera = cameraAt(StandardView::top, false);
    const QImage picture = draw(builder.frame(), camera, options);
    const QRgb dirty = pixelAt(picture, camera, {20, 35, -3});
    const QRgb decimated = pixelAt(picture, camera, {80, 35, 0});
    QVERIFY(qRed(dirty) > qBlue(dirty) + 60);
    QVERIFY(qBlue(decimated) > qRed(decimated) + 60);
    options.tint = false;
    const QRgb plain = pixelAt(draw(builder.frame(), camera, options), camera, {20, 35, -3});
    QVERIFY(std::abs(qRed(plain) - qBlue(plain)) < 20);
}

void SceneRendererTest::wireframeShowsRegionBorders() {
    DecimationParameters parameters;
    parameters.regionCells = 20;
    FrameBuilder builder(kStock, 1, parameters);
    builder.decimate();
    SceneOptions options = testOptions();
    options.wireframe = true;
    options.colours.regionLine = {1, 0, 0};
    const Camera camera = cameraAt(StandardView::top, false);
    const QImage picture = draw(builder.frame(), camera, options);
    const auto red = [&](double x, double y) {
        int most = 0;
        for (double d = -0.3; d <= 0.3; d += 0.1) {
            const QRgb pixel = pixelAt(picture, camera, {x + d, y, 0});
            most = std::max(most, qRed(pixel) - qGreen(pixel));
        }
        return most > 90;
    };
    QVERIFY(red(20, 33) && red(40, 33) && red(80, 51));
    QVERIFY(!red(30, 33) && !red(50, 33));
}

void SceneRendererTest::decimationDoesNotShow() {
    DecimationParameters parameters;
    FrameBuilder builder(kStock, 1, parameters);
    builder.cutAll(hills);
    const Camera camera = cameraAt(StandardView::iso, true);
    const QImage full = draw(builder.frame(), camera, testOptions());
    builder.decimate();
    const FramePtr decimatedFrame = builder.frame();
    QVERIFY(decimatedFrame->surface.faces * 2 < decimatedFrame->surface.facesFull);
    const QImage decimated = draw(decimatedFrame, camera, testOptions());
    double sum = 0;
    int unlike = 0;
    for (int y = 0; y < full.height(); ++y)
        for (int x = 0; x < full.width(); ++x) {
            const int difference = std::abs(qGreen(full.pixel(x, y)) - qGreen(decimated.pixel(x, y)));
            sum += difference;
            unlike += difference > 24 ? 1 : 0;
        }
    const int pixels = full.width() * full.height();
    QVERIFY2(sum / pixels < 1, qPrintable(QString::number(sum / pixels)));
    QVERIFY2(unlike < pixels / 200, qPrintable(QString::number(unlike)));
}

void SceneRendererTest::indicesOfAnyWidthDrawTheSame() {
    // 501 points per row: 16-bit indices are sufficient for 100 rows, but not for 256.
    const Camera camera = cameraAt(StandardView::iso, true);
    std::vector<QImage> pictures;
    for (const int cells : {100, 256}) {
        DecimationParameters parameters;
        parameters.regionCells = cells;
        FrameBuilder builder(kStock, 0.2, parameters);
        builder.cutAll(hills);
        const QImage full = draw(builder.frame(), camera, testOptions());
        pictures.push_back(full);
        builder.decimate();
        QCOMPARE(cracks(draw(builder.frame(), camera, testOptions()), full), 0);
        builder.cut({120, 120, 140, 140},
                    [](double, double) { return -6.0; }); // one dirty region among decimated ones
        QCOMPARE(cracks(draw(builder.frame(), camera, testOptions()), full), 0);
    }
    QCOMPARE(pictures[0], pictures[1]);
}

void SceneRendererTest::mergedRegionsAreDrawnWhole() {
    // 16-bit indices are sufficient for the points of a region, but not for those of all regions.
    DecimationParameters parameters;
    FrameBuilder builder(kStock, 0.2, parameters);
    builder.cutAll(hills);
    const Camera camera = cameraAt(StandardView::iso, true);
    const FramePtr full = builder.frame();
    const QImage reference = draw(full, camera, testOptions());
    Frame merged = *full;
    RefinedSurface refined(builder.grid().nx, builder.grid().ny, parameters);
    QVERIFY(refined.follow(full->zmap, {}));
    merged.surface = refined.snapshot();
    const FramePtr atRest = std::make_shared<const Frame>(merged);
    QCOMPARE(cracks(draw(atRest, camera, testOptions()), reference), 0);
    // From one to the other and back, in the same buffer.
    builder.decimate();
    QCOMPARE(cracks(draw(builder.frame(), camera, testOptions()), reference), 0);
    QCOMPARE(cracks(draw(atRest, camera, testOptions()), reference), 0);
    // The edges between the top and the sides.
    for (const StandardView view : {StandardView::iso, StandardView::right, StandardView::front})
        for (const double zoom : {0.7, 0.3, 0.1}) {
            Camera near = cameraAt(view, true);
            near.setTarget({99, 30, -12});
            near.zoom(zoom, {99, 30, -12});
            near.orbit(11, 17);
            const QImage whole = draw(full, near, testOptions());
            QCOMPARE(cracks(draw(atRest, near, testOptions()), whole), 0);
        }
}

void SceneRendererTest::noCracksInHalfDirtyStates() {
    for (const int cells : {8, 13, 30}) {
        DecimationParameters parameters;
        parameters.regionCells = cells;
        for (unsigned seed = 1; seed <= 4; ++seed) {
            const HalfDirty state = halfDirty(seed, parameters);
            QVERIFY(state.frame->surface.dirtyRegions > 0);
            QVERIFY(state.frame->surface.dirtyRegions < state.frame->surface.meshes.size());
            Camera camera = cameraAt(StandardView::iso, seed % 2 == 0);
            for (int turn = 0; turn < 4; ++turn) {
                camera.orbit(131, turn % 2 == 0 ? 35 : -45);
                const QImage reference = draw(state.full, camera, testOptions());
                QCOMPARE(cracks(draw(state.frame, camera, testOptions()), reference), 0);
            }
        }
    }
}

void SceneRendererTest::cracksWouldBeSeen() {
    // The paper's borders do crack; the test must detect that.
    DecimationParameters parameters;
    parameters.borders = BorderRule::paper;
    parameters.allowance = 0.5;
    int seen = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const HalfDirty state = halfDirty(seed, parameters);
        const Camera camera = cameraAt(StandardView::iso, true, 1280, 800);
        seen += cracks(draw(state.frame, camera, testOptions()), draw(state.full, camera, testOptions()));
    }
    QVERIFY(seen > 0);
}

void SceneRendererTest::uploadsOnlyWhatChanged() {
    OffscreenPicture picture; // a renderer without any previous upload
    const Camera camera = cameraAt(StandardView::iso, true);
    const View view = camera.view(stockBox());
    FrameBuilder builder({{0, 0, 0}, 200, 200, 20}, 1);
    builder.decimate();
    const std::size_t regions = builder.frame()->surface.meshes.size();
    static_cast<void>(picture.draw(builder.frame(), view));
    QCOMPARE(picture.uploaded().tiles, std::size_t{16});
    QCOMPARE(picture.uploaded().lists, regions);

    static_cast<void>(picture.draw(builder.frame(), view));
    QCOMPARE(picture.uploaded().tiles, std::size_t{0});
    QCOMPARE(picture.uploaded().lists, std::size_t{0});
    QCOMPARE(picture.uploaded().indices, std::size_t{0});

    // One region becomes dirty: this uploads its heights, a list that matches its neighbours' polylines, and,
    // once for all regions of this size, the pattern that fills it.
    builder.cut({81, 81, 87, 87}, [](double, double) { return -2.0; });
    static_cast<void>(picture.draw(builder.frame(), view));
    QCOMPARE(picture.uploaded().tiles, std::size_t{1});
    QCOMPARE(picture.uploaded().lists, std::size_t{2});
    builder.cut({145, 145, 151, 151}, [](double, double) { return -2.0; });
    static_cast<void>(picture.draw(builder.frame(), view));
    QCOMPARE(picture.uploaded().lists, std::size_t{1});
    const auto cells = static_cast<std::size_t>(builder.frame()->surface.grid.cells());
    QVERIFY(picture.uploaded().indices <= 6 * 4 * (cells - 1)); // those of the cells along its borders

    // Cut again while it is dirty: only heights are uploaded.
    builder.cut({81, 81, 87, 87}, [](double, double) { return -3.0; });
    static_cast<void>(picture.draw(builder.frame(), view));
    QCOMPARE(picture.uploaded().tiles, std::size_t{1});
    QCOMPARE(picture.uploaded().lists, std::size_t{0});

    builder.decimate();
    static_cast<void>(picture.draw(builder.frame(), view));
    QCOMPARE(picture.uploaded().tiles, std::size_t{0});
    QCOMPARE(picture.uploaded().lists, std::size_t{2});
}

void SceneRendererTest::anotherGridReplacesTheOldOne() {
    const Camera camera = cameraAt(StandardView::iso, true);
    FrameBuilder fine(kStock, 0.5);
    fine.cutAll(hills);
    FrameBuilder coarse(kStock, 2);
    coarse.cutAll(hills);
    const QImage first = draw(coarse.frame(), camera, testOptions());
    static_cast<void>(draw(fine.frame(), camera, testOptions()));
    QCOMPARE(draw(coarse.frame(), camera, testOptions()), first);
}

void SceneRendererTest::pagesHoldEveryPointAndItsNeighbours() {
    for (const auto& [nx, ny, most] :
         {std::array{100, 70, 100}, {101, 70, 100}, {500, 3, 16}, {20001, 10001, 16384}, {64, 65, 8}}) {
        Grid grid;
        grid.nx = nx;
        grid.ny = ny;
        const HeightPages pages = HeightPages::of(grid, most);
        QVERIFY(pages.texels().x <= most && pages.texels().y <= most);
        QCOMPARE(pages.count() == 1, pages.margin == 0);
        for (int i = 0; i < nx; ++i)
            for (const int reach : {-2, 0, 2}) {
                const int near = std::clamp(i + reach, 0, nx - 1);
                const IndexRect held = pages.held(i / pages.points.x, 0, grid);
                QVERIFY(near >= held.i0 && near < held.i1);
                const IndexRect at = pages.pagesAt({near, 0, near + 1, 1});
                QVERIFY(i / pages.points.x >= at.i0 && i / pages.points.x < at.i1);
                QVERIFY(at.i0 >= 0 && at.i1 <= pages.columns);
            }
    }
}

void SceneRendererTest::pagesLookLikeOneTexture() {
    DecimationParameters parameters;
    parameters.regionCells = 8;
    const HalfDirty dirty = halfDirty(3, parameters);
    FrameBuilder holed(kStock, 1, parameters);
    holed.cutAll([](double x, double y) { return std::hypot(x - 37, y - 33) < 12 ? -25 : hills(x, y); });
    holed.decimate();
    OffscreenPicture paged(40); // 3 × 3 pages
    for (const FramePtr& frame : {dirty.frame, holed.frame()})
        for (const bool wireframe : {false, true})
            for (const StandardView from : {StandardView::iso, StandardView::top, StandardView::bottom}) {
                SceneOptions options = testOptions();
                options.wireframe = wireframe;
                const View view = cameraAt(from, true).view(stockBox());
                const QImage one = m_picture->draw(frame, view, options);
                const QImage many = paged.draw(frame, view, options);
                int different = 0;
                for (int y = 0; y < one.height(); ++y)
                    for (int x = 0; x < one.width(); ++x) {
                        const QRgb a = one.pixel(x, y);
                        const QRgb b = many.pixel(x, y);
                        constexpr int kRounding = 2;
                        different += std::abs(qRed(a) - qRed(b)) > kRounding ||
                                             std::abs(qGreen(a) - qGreen(b)) > kRounding ||
                                             std::abs(qBlue(a) - qBlue(b)) > kRounding
                                         ? 1
                                         : 0;
                    }
                QCOMPARE(different, 0);
            }
}

void SceneRendererTest::staysRightFarFromTheOrigin() {
    // The same stock 80 m away looks the same, because positions on the GPU are relative to the stock.
    FrameBuilder here(kStock, 1);
    here.cutAll(hills);
    const Vec3 away(80000, -80000, 500);
    FrameBuilder there({away, 100, 70, 20}, 1);
    there.cutAll([&](double x, double y) { return hills(x - away.x, y - away.y) + away.z; });
    Box3 box;
    box.add(stockBox().lo + away);
    box.add(stockBox().hi + away);
    Camera camera = cameraAt(StandardView::iso, true);
    const QImage first = draw(here.frame(), camera, testOptions());
    camera.fit(box);
    const QImage second = m_picture->draw(there.frame(), camera.view(box), testOptions());
    int unlike = 0;
    for (int y = 0; y < first.height(); ++y)
        for (int x = 0; x < first.width(); ++x)
            unlike += std::abs(qGreen(first.pixel(x, y)) - qGreen(second.pixel(x, y))) > 8 ? 1 : 0;
    QVERIFY2(unlike < 200, qPrintable(QString::number(unlike)));
}

void SceneRendererTest::boxReplacesWhatIsThere() {
    FrameBuilder around(kStock, 1);
    around.decimate();
    // A groove between the points of the grid around it, in one half of the detail region.
    FrameBuilder box(kBoxStock, 0.1);
    box.cutAll([](double x, double) { return std::abs(x - 44.5) < 0.45 ? -8.0 : 0.0; });
    box.decimate();
    const Camera camera = cameraAt(StandardView::top, false);
    const QImage without = draw(around.frame(), camera, testOptions());
    SceneOptions options = testOptions();
    options.colours.box = {0, 1, 0};
    const QImage with = draw(around.frame(), camera, options, box.frame());
    const QRgb groove = pixelAt(with, camera, {44.5, 30, 0});
    QVERIFY(groove != pixelAt(without, camera, {44.5, 30, 0}) && !isBackdrop(groove));
    QVERIFY(pixelAt(with, camera, {52, 30, 0}) == pixelAt(without, camera, {52, 30, 0}));
    const auto isGreen = [](QRgb pixel) { return qGreen(pixel) > 150 && qRed(pixel) < 100; };
    int changedFarAway = 0;
    int frame = 0;
    for (int y = 0; y < with.height(); ++y)
        for (int x = 0; x < with.width(); ++x) {
            const Ray ray = camera.ray(x + 0.5, y + 0.5);
            const bool far = std::abs(ray.origin.x - 50) > 11 || std::abs(ray.origin.y - 30) > 11;
            changedFarAway += far && with.pixel(x, y) != without.pixel(x, y) ? 1 : 0;
            frame += isGreen(with.pixel(x, y)) ? 1 : 0;
        }
    QCOMPARE(changedFarAway, 0);
    const double side = 20 * camera.view(stockBox()).pixelsPerMm;
    QVERIFY2(frame > 3 * side && frame < 20 * side, qPrintable(QString::number(frame)));
    QCOMPARE(draw(around.frame(), camera, testOptions()), without);
}

void SceneRendererTest::boxComesInPartsAndIsShownWhole() {
    FrameBuilder around(kStock, 1);
    around.cutAll(hills);
    around.decimate();
    const FramePtr frame = around.frame();
    const auto boxOf = [](double off) {
        FrameBuilder box(kBoxStock, 0.05);
        box.cutAll([&](double x, double y) { return hills(x, y) + off * std::sin(9 * x); });
        box.decimate();
        return box.frame();
    };
    const FramePtr box = boxOf(0.4);
    const FramePtr other = boxOf(-0.3);
    const View view = cameraAt(StandardView::iso, true).view(stockBox());
    const auto drawn = [&](const FramePtr& shown, const UploadBudget& budget) {
        return m_picture->draw(frame, view, testOptions(), shown, budget);
    };
    const QImage without = drawn(nullptr, {});
    const QImage with = drawn(box, {});
    const QImage withOther = drawn(other, {});
    QVERIFY(with != without && withOther != with && withOther != without);
    // One step per frame; the second region replaces the first during its upload.
    const UploadBudget none(std::chrono::seconds(0));
    const auto bring = [&](const FramePtr& wanted, int most) {
        int steps = 0;
        for (; steps < most; ++steps) {
            const QImage picture = drawn(wanted, none);
            if (!m_picture->renderer().boxPending())
                return std::pair(steps, picture);
            if (picture != without)
                return std::pair(-1, picture); // part of it is shown
        }
        return std::pair(steps, QImage());
    };
    QCOMPARE(bring(box, 5).first, 5);
    const auto [back, picture] = bring(other, 1000);
    QCOMPARE(back, 5); // the rest was still uploaded
    QCOMPARE(picture, withOther);
    QCOMPARE(drawn(nullptr, {}), without);
    const auto [steps, again] = bring(box, 1000);
    QVERIFY2(steps > 20, qPrintable(QString::number(steps)));
    QCOMPARE(again, with);
    // After its release it is uploaded again.
    m_picture->renderer().releaseBox();
    QCOMPARE(drawn(nullptr, {}), without);
    QCOMPARE(drawn(box, {}), with);
}

void SceneRendererTest::boxLeavesNoCracks() {
    // Fine ridges cause steps up and down to the surface around.
    FrameBuilder around(kStock, 1);
    around.cutAll(hills);
    around.decimate();
    FrameBuilder box(kBoxStock, 0.1);
    box.cutAll([](double x, double y) { return hills(x, y) + 0.4 * std::sin(9 * x) * std::cos(7 * y); });
    box.decimate();
    for (const bool perspective : {false, true}) {
        Camera camera = cameraAt(StandardView::iso, perspective);
        for (int turn = 0; turn < 6; ++turn) {
            camera.orbit(131, turn % 2 == 0 ? 35 : -45);
            const QImage reference = draw(around.frame(), camera, testOptions());
            QCOMPARE(cracks(draw(around.frame(), camera, testOptions(), box.frame()), reference), 0);
        }
    }
}

void SceneRendererTest::boxAtTheEdgeOfTheStockLeavesNoCracks() {
    // Both surfaces are equal, so a detail region must cover the same pixels as the stock without it. Far
    // from the origin of the stock, where single precision is coarsest.
    FrameBuilder around(kStock, 1);
    around.cutAll(hills);
    around.decimate();
    const StockBox rim{{87.3, 41.7, 0}, 12.7, 28.3, 20}; // reaches the right and back sides
    FrameBuilder box(rim, 0.1);
    box.cutAll(hills);
    box.decimate();
    SceneOptions options = testOptions();
    options.colours.box = {0.5F, 0.5F, 0.5F};
    struct Seam {
        StandardView view;
        Vec3 at;
    };
    const std::array seams{
        Seam{StandardView::right, {100, 41.7, -16}}, Seam{StandardView::back, {87.3, 70, -16}},
        Seam{StandardView::bottom, {90, 41.7, -20}}, Seam{StandardView::bottom, {87.3, 60, -20}},
        Seam{StandardView::top, {87.3, 60, hills(87.3, 60)}}};
    for (const bool perspective : {false, true})
        for (const int samples : {0, 4})
            for (const Seam& seam : seams)
                for (const double zoom : {1.0, 0.05, 0.004})
                    for (const double turn : {0.0, -41.0}) {
                        Camera camera = cameraAt(seam.view, perspective);
                        camera.setTarget(seam.at);
                        camera.zoom(zoom, seam.at);
                        camera.orbit(turn, 0.7 * turn);
                        const QImage without = draw(around.frame(), camera, options, nullptr, samples);
                        const QImage with = draw(around.frame(), camera, options, box.frame(), samples);
                        const int seen = cracks(with, without, showsBackdrop);
                        QVERIFY2(seen == 0,
                                 qPrintable(QStringLiteral("%1 pixels, view %2, zoom %3, turn %4, %5 samples")
                                                .arg(seen)
                                                .arg(static_cast<int>(seam.view))
                                                .arg(zoom)
                                                .arg(turn)
                                                .arg(samples)));
                    }
}

void SceneRendererTest::boxThatIsCutThroughIsAHole() {
    FrameBuilder around(kStock, 1);
    around.decimate();
    FrameBuilder box(kBoxStock, 0.1);
    box.cutAll([](double x, double y) { return std::hypot(x - 50, y - 30) < 5 ? -25.0 : 0.0; });
    box.decimate();
    for (const StandardView view : {StandardView::top, StandardView::bottom})
        for (const bool wireframe : {false, true}) {
            const Camera camera = cameraAt(view, false);
            SceneOptions options = testOptions();
            options.wireframe = wireframe;
            const QImage picture = draw(around.frame(), camera, options, box.frame());
            QVERIFY(isBackdrop(pixelAt(picture, camera, {51, 31, -10})));
            QVERIFY(!isBackdrop(pixelAt(picture, camera, {57, 30, -10})));
            QVERIFY(!isBackdrop(pixelAt(picture, camera, {70, 30, -10})));
        }
}

QTEST_MAIN(SceneRendererTest)
#include "scene_renderer_test.moc"
