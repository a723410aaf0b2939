// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures within a limit of graphics memory, compared with those without one. The backdrop is magenta.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <utility>

#include <QOpenGLWidget>
#include <QTest>

#include "tests/random_seed.h"
#include "tests/ui/viewport/frame_builder.h"
#include "tests/ui/viewport/offscreen_picture.h"
#include "ui/gl/surface_buffer.h"
#include "ui/viewport/camera.h"
#include "ui/viewport/closer_look.h"
#include "ui/viewport/scene_picture.h"

using namespace proveout;

namespace {

constexpr std::size_t kLimit = 1'000'000; // of 2.8 million bytes of heights
const StockBox kStock{{0, 0, 0}, 100, 70, 20};
constexpr double kSpacing = 0.1;

Box3 stockBox() {
    Box3 box;
    box.add(Vec3(0, 0, -20));
    box.add(Vec3(100, 70, 0));
    return box;
}

/// Hills, a pocket with upright walls, a slot through the stock, and a narrow rib.
double part(double x, double y) {
    if (std::abs(x - 70) < 4 && std::abs(y - 35) < 20)
        return -30;
    if (std::hypot(x - 30, y - 35) < 15)
        return std::abs(y - 35) < 0.5 ? -3 : -12;
    return -2 + 1.5 * std::sin(x * 0.2) * std::cos(y * 0.17);
}

FrameBuilder cutPart(const DecimationParameters& parameters = {}) {
    FrameBuilder builder(kStock, kSpacing, parameters);
    builder.cutAll(part);
    builder.decimate();
    // Half of the stock is drawn from the z-map.
    builder.cut({0, 0, 500, 701}, [](double x, double y) { return part(x, y) - 0.2; });
    return builder;
}

Camera cameraAt(StandardView view, bool perspective, int width = 480, int height = 300) {
    return cameraFitted(stockBox(), view, perspective, width, height);
}

struct Difference {
    int largest = 0; ///< of a channel, of 255
    double mean = 0;
    double strong = 0; ///< the fraction of pixels that differ by more than 24
};

Difference differenceOf(const QImage& a, const QImage& b) {
    Difference difference;
    double sum = 0;
    int strong = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            const int most = std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                                       std::abs(qBlue(p) - qBlue(q))});
            difference.largest = std::max(difference.largest, most);
            sum += most;
            strong += most > 24 ? 1 : 0;
        }
    const double pixels = static_cast<double>(a.width()) * a.height();
    difference.mean = sum / pixels;
    difference.strong = strong / pixels;
    return difference;
}

/// Draws one frame by a ScenePicture.
class PictureWidget final : public QOpenGLWidget {
public:
    explicit PictureWidget(FramePtr frame) : m_frame(std::move(frame)) {
        QSurfaceFormat format;
        format.setVersion(3, 3);
        format.setProfile(QSurfaceFormat::CoreProfile);
        format.setDepthBufferSize(24);
        setFormat(format);
        resize(480, 300);
    }

    [[nodiscard]] ScenePicture& picture() { return m_picture; }
    [[nodiscard]] bool isDrawn() const { return m_isDrawn; }

protected:
    void initializeGL() override { m_picture.initialize(); }
    void paintGL() override {
        m_isDrawn = m_picture.paint(cameraAt(StandardView::iso, true).view(stockBox()), m_frame).has_value();
    }

private:
    FramePtr m_frame;
    CloserLook m_look;
    SceneOptions m_options;
    ScenePicture m_picture{*this, m_look, m_options, true};
    bool m_isDrawn = false;
};

} // namespace

class LimitedPictureTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase();
    void smallGridsAreHeldWhole();
    void farViewIsNearlyThePictureOfAllPoints();
    void nearViewIsThePictureOfAllPoints();
    void pagesArriveInSlices();
    void noTextureOfHeightsIsLargerThanAllowed();
    void texturesAreCreatedInSlices();
    void uploadsLeaveTheStateOfPainters();
    void theLimitHoldsAtAnyMoment();
    void meshesThatDoNotFitAreLeftOut();
    void meshesThatOutgrowTheirShareLeaveNoVertices();
    void slicesOfASurfaceThatDoesNotFitEnd();
    void trianglesThatOutgrowTheLimitLeaveParts();
    void aFinerGridTakesTheRoomOfTriangles();
    void aDetailRegionCountsToo();
    void tooManyTrianglesAreDrawnFromCoarserPoints_data();
    void tooManyTrianglesAreDrawnFromCoarserPoints();
    void trianglesOfAnyRegionSizeKeepTheLimit();
    void thePictureDoesNotChangeWithEachDecimation();
    void aFrameArrivesInSlicesAndIsNotReplacedMeanwhile();
    void theSlicesOfALargeFrameAreReported();

private:
    [[nodiscard]] QImage limited(const FramePtr& frame, const View& view) {
        return m_limited->draw(frame, view, testOptions());
    }
    [[nodiscard]] QImage unlimited(const FramePtr& frame, const View& view) {
        return m_unlimited->draw(frame, view, testOptions());
    }
    [[nodiscard]] bool coarser() const { return m_limited->renderer().coarseness().coarser; }
    [[nodiscard]] std::size_t held() const { return m_limited->renderer().memoryHeld(); }

    std::uint32_t m_seed = randomSeed();
    std::unique_ptr<OffscreenPicture> m_unlimited;
    std::unique_ptr<OffscreenPicture> m_limited;
};

void LimitedPictureTest::initTestCase() {
    qInfo("seed %u", m_seed);
    m_unlimited = std::make_unique<OffscreenPicture>();
    m_limited = std::make_unique<OffscreenPicture>();
    if (!m_limited->usable())
        QSKIP("no OpenGL 3.3 here");
    m_limited->renderer().setMemory(kLimit);
}

void LimitedPictureTest::cleanupTestCase() {
    m_limited.reset();
    m_unlimited.reset();
}

void LimitedPictureTest::smallGridsAreHeldWhole() {
    FrameBuilder builder(kStock, 0.5);
    builder.cutAll(part);
    builder.decimate();
    const View view = cameraAt(StandardView::iso, true).view(stockBox());
    QCOMPARE(limited(builder.frame(), view), unlimited(builder.frame(), view));
    QVERIFY(!coarser());
    QCOMPARE(held(), m_unlimited->renderer().memoryHeld());
}

void LimitedPictureTest::farViewIsNearlyThePictureOfAllPoints() {
    FrameBuilder builder = cutPart();
    for (const bool perspective : {false, true})
        for (const StandardView from : {StandardView::iso, StandardView::top, StandardView::front}) {
            const View view = cameraAt(from, perspective, 240, 150).view(stockBox());
            const Difference difference =
                differenceOf(limited(builder.frame(), view), unlimited(builder.frame(), view));
            QVERIFY(coarser());
            QVERIFY(held() <= kLimit);
            QVERIFY2(
                difference.mean < 3 && difference.strong < 0.03,
                qPrintable(QStringLiteral("mean %1, strong %2").arg(difference.mean).arg(difference.strong)));
        }
}

void LimitedPictureTest::nearViewIsThePictureOfAllPoints() {
    std::mt19937 random(m_seed);
    FrameBuilder builder = cutPart();
    for (int round = 0; round < 24; ++round) {
        const std::array<StandardView, 3> from{StandardView::iso, StandardView::top, StandardView::bottom};
        // In perspective the eye would be inside the stock, from that side.
        const bool perspective = round % 3 != 0 && round % 2 == 0;
        Camera camera = cameraAt(from[static_cast<std::size_t>(round) % 3], perspective);
        camera.zoom(0.06, {static_cast<double>(random() % 100), static_cast<double>(random() % 70), -5});
        const View view = camera.view(stockBox());
        const Difference difference =
            differenceOf(limited(builder.frame(), view), unlimited(builder.frame(), view));
        QVERIFY(!coarser());
        QVERIFY(held() <= kLimit);
        QVERIFY2(difference.largest <= 2, qPrintable(QString::number(difference.largest))); // rounding
    }
}

void LimitedPictureTest::pagesArriveInSlices() {
    FrameBuilder builder = cutPart();
    static_cast<void>(limited(builder.frame(), cameraAt(StandardView::top, false).view(stockBox())));
    Camera camera = cameraAt(StandardView::top, false);
    camera.zoom(0.12, {33, 35, -5});
    const View view = camera.view(stockBox());
    SceneRenderer& renderer = m_limited->renderer();
    renderer.refine(view, UploadBudget(std::chrono::seconds(0)));
    QVERIFY(renderer.coarseness().pending && renderer.coarseness().coarser);
    renderer.refine(view);
    QVERIFY(!renderer.coarseness().pending && !renderer.coarseness().coarser);
}

void LimitedPictureTest::noTextureOfHeightsIsLargerThanAllowed() {
    FrameBuilder builder = cutPart();
    OffscreenPicture picture;
    picture.renderer().setMostTextureBytes(kLimit);
    const View far = cameraAt(StandardView::iso, true, 240, 150).view(stockBox());
    const Difference smoother =
        differenceOf(picture.draw(builder.frame(), far, testOptions()), unlimited(builder.frame(), far));
    QVERIFY(picture.renderer().coarseness().coarser);
    QVERIFY2(smoother.mean < 3 && smoother.strong < 0.03,
             qPrintable(QStringLiteral("mean %1, strong %2").arg(smoother.mean).arg(smoother.strong)));
    Camera camera = cameraAt(StandardView::top, false);
    camera.zoom(0.06, {33, 35, -5});
    const View near = camera.view(stockBox());
    const Difference same =
        differenceOf(picture.draw(builder.frame(), near, testOptions()), unlimited(builder.frame(), near));
    QVERIFY(!picture.renderer().coarseness().coarser);
    QVERIFY2(same.largest <= 2, qPrintable(QString::number(same.largest))); // rounding
    // As soon as a larger one is allowed, there are all heights.
    picture.renderer().setMostTextureBytes(10 * kLimit);
    QCOMPARE(picture.draw(builder.frame(), far, testOptions()), unlimited(builder.frame(), far));
}

void LimitedPictureTest::texturesAreCreatedInSlices() {
    FrameBuilder builder = cutPart();
    const FramePtr frame = builder.frame();
    OffscreenPicture picture;
    SceneRenderer& renderer = picture.renderer();
    renderer.setMemory(kLimit);
    const UploadBudget none(std::chrono::seconds(0));
    QVERIFY(!renderer.upload(frame, none).whole);
    const std::size_t first = renderer.memoryHeld();
    QVERIFY2(first > 0 && first <= kLimit * 3 / 10, qPrintable(QString::number(first)));
    while (!renderer.upload(frame, none).whole) {
    }
    // Pages take no memory until a view needs them.
    QVERIFY(renderer.memoryHeld() < kLimit * 7 / 10);
    Camera camera = cameraAt(StandardView::top, false);
    camera.zoom(0.06, {33, 35, -5});
    const std::size_t before = renderer.memoryHeld();
    renderer.refine(camera.view(stockBox()));
    QVERIFY(renderer.memoryHeld() > before && renderer.memoryHeld() <= kLimit);
}

void LimitedPictureTest::uploadsLeaveTheStateOfPainters() {
    FrameBuilder builder = cutPart();
    static_cast<void>(limited(builder.frame(), cameraAt(StandardView::iso, true).view(stockBox())));
    Camera camera = cameraAt(StandardView::top, false);
    camera.zoom(0.06, {33, 35, -5});
    static_cast<void>(limited(builder.frame(), camera.view(stockBox())));
    const std::array<std::pair<GLenum, GLint>, 5> expected{{{GL_UNPACK_ALIGNMENT, 4},
                                                            {GL_UNPACK_ROW_LENGTH, 0},
                                                            {GL_UNPACK_SKIP_ROWS, 0},
                                                            {GL_UNPACK_SKIP_PIXELS, 0},
                                                            {GL_ACTIVE_TEXTURE, GL_TEXTURE0}}};
    for (const auto& [name, value] : expected) {
        GLint found = -1;
        currentGl()->glGetIntegerv(name, &found);
        QCOMPARE(found, value);
    }
}

void LimitedPictureTest::theLimitHoldsAtAnyMoment() {
    std::mt19937 random(m_seed);
    FrameBuilder builder = cutPart();
    for (int round = 0; round < 60; ++round) {
        const int i = static_cast<int>(random() % 900);
        const int j = static_cast<int>(random() % 600);
        builder.cut({i, j, i + 60, j + 60}, [&](double x, double y) { return part(x, y) - 0.02 * round; });
        if (round % 5 == 0)
            builder.decimate();
        Camera camera =
            cameraAt(static_cast<StandardView>(random() % kStandardViews), round % 2 == 0,
                     100 + static_cast<int>(random() % 500), 100 + static_cast<int>(random() % 300));
        const double zoom = 0.05 + 0.001 * static_cast<double>(random() % 950);
        camera.zoom(zoom, {static_cast<double>(random() % 100), static_cast<double>(random() % 70), -5});
        const View view = camera.view(stockBox());
        const QImage picture = limited(builder.frame(), view);
        QVERIFY2(held() <= kLimit, qPrintable(QString::number(held())));
        if (!coarser())
            QVERIFY(differenceOf(picture, unlimited(builder.frame(), view)).largest <= 2);
    }
}

void LimitedPictureTest::meshesThatDoNotFitAreLeftOut() {
    DecimationParameters fine;
    fine.allowance = 1e-5; // keeps nearly every vertex
    FrameBuilder builder(kStock, kSpacing, fine);
    builder.cutAll(part);
    builder.decimate();
    QVERIFY(builder.frame()->surface.faces * 12 > kLimit);
    const View view = cameraAt(StandardView::iso, true, 240, 150).view(stockBox());
    const Difference difference =
        differenceOf(limited(builder.frame(), view), unlimited(builder.frame(), view));
    QVERIFY(coarser());
    QVERIFY2(held() <= kLimit, qPrintable(QString::number(held())));
    QVERIFY2(difference.mean < 3 && difference.strong < 0.03,
             qPrintable(QStringLiteral("mean %1, strong %2").arg(difference.mean).arg(difference.strong)));
}

void LimitedPictureTest::meshesThatOutgrowTheirShareLeaveNoVertices() {
    constexpr std::size_t kLists = kLimit / 5; // GraphicsShares
    DecimationParameters fine;
    fine.allowance = 1e-5;
    FrameBuilder builder(kStock, kSpacing, fine);
    builder.decimate();
    const FramePtr flat = builder.frame();
    QVERIFY(SurfaceBuffer::bytesFor(flat->surface) < kLists);
    builder.cutAll(part);
    builder.decimate();
    const FramePtr cut = builder.frame();
    QVERIFY(SurfaceBuffer::bytesFor(cut->surface) > kLists);

    const View view = cameraAt(StandardView::iso, true, 240, 150).view(stockBox());
    OffscreenPicture fresh;
    OffscreenPicture outgrown;
    for (OffscreenPicture* picture : {&fresh, &outgrown})
        picture->renderer().setMemory(kLimit);
    static_cast<void>(outgrown.draw(flat, view, testOptions()));
    // The two may hold different pages.
    const Difference difference =
        differenceOf(outgrown.draw(cut, view, testOptions()), fresh.draw(cut, view, testOptions()));
    QVERIFY(outgrown.renderer().coarseness().coarser);
    QVERIFY2(difference.mean < 1 && difference.strong < 0.01,
             qPrintable(QStringLiteral("mean %1, strong %2").arg(difference.mean).arg(difference.strong)));
}

void LimitedPictureTest::slicesOfASurfaceThatDoesNotFitEnd() {
    constexpr int kMostCalls = 2000;
    DecimationParameters fine;
    fine.allowance = 1e-5;
    FrameBuilder builder({{0, 0, 0}, 20, 14, 20}, kSpacing, fine);
    builder.cutAll([](double x, double y) { return -2 + std::sin(x) * std::cos(y); });
    builder.decimate();
    const FramePtr frame = builder.frame();
    // Makes the context current.
    static_cast<void>(limited(frame, cameraAt(StandardView::top, false).view(stockBox())));
    Gl& gl = *currentGl();
    const UploadBudget oneRegion(std::chrono::seconds(0));
    SurfaceBuffer buffer;
    buffer.setLimit(SurfaceBuffer::bytesFor(frame->surface) / 4);
    int calls = 0;
    for (bool fits = true; fits && calls < kMostCalls; ++calls)
        fits = buffer.update(gl, frame->surface, oneRegion).fits;
    QVERIFY(calls < kMostCalls);

    buffer.setLimit(2 * SurfaceBuffer::bytesFor(frame->surface));
    SurfaceBuffer::Uploaded uploaded;
    calls = 0;
    do {
        uploaded = buffer.update(gl, frame->surface, oneRegion);
    } while (uploaded.fits && !uploaded.whole && ++calls < kMostCalls);
    QVERIFY(uploaded.fits && uploaded.whole);
    buffer.release(gl);
}

void LimitedPictureTest::trianglesThatOutgrowTheLimitLeaveParts() {
    DecimationParameters fine;
    fine.allowance = 1e-5;
    FrameBuilder builder(kStock, 0.2, fine); // 0.7 million bytes of heights
    builder.decimate();
    const View view = cameraAt(StandardView::iso, true, 240, 150).view(stockBox());
    static_cast<void>(limited(builder.frame(), view));
    QVERIFY(!coarser());
    for (int j = 0; j < 350; j += 50) {
        builder.cut({0, j, 501, j + 51}, part);
        builder.decimate();
        const QImage picture = limited(builder.frame(), view);
        QVERIFY2(held() <= kLimit, qPrintable(QString::number(held())));
        QVERIFY(differenceOf(picture, unlimited(builder.frame(), view)).mean < 3);
    }
    QVERIFY(coarser());
}

void LimitedPictureTest::aFinerGridTakesTheRoomOfTriangles() {
    DecimationParameters fine;
    fine.allowance = 1e-5;
    FrameBuilder many(kStock, 0.5, fine); // 0.1 million bytes of heights, most of the rest is for triangles
    many.cutAll(part);
    many.decimate();
    const View view = cameraAt(StandardView::iso, true, 240, 150).view(stockBox());
    static_cast<void>(limited(many.frame(), view));
    QVERIFY2(held() > 420'000, qPrintable(QString::number(held())));
    FrameBuilder finer(kStock, 0.2); // 0.7 million bytes of heights
    finer.decimate();
    static_cast<void>(limited(finer.frame(), view));
    QVERIFY2(held() <= kLimit, qPrintable(QString::number(held())));
    QVERIFY(!coarser());
}

void LimitedPictureTest::aDetailRegionCountsToo() {
    FrameBuilder builder = cutPart();
    FrameBuilder box({{40, 20, 0}, 20, 20, 20}, 0.02);
    box.cutAll(part);
    const View view = cameraAt(StandardView::iso, true).view(stockBox());
    const QImage without = limited(builder.frame(), view);
    const std::size_t heldWithout = held();
    for (const FramePtr& shown : {box.frame(), FramePtr(), box.frame()}) {
        static_cast<void>(m_limited->draw(builder.frame(), view, testOptions(), shown));
        QVERIFY2(held() <= kLimit, qPrintable(QString::number(held())));
    }
    QVERIFY(held() > kLimit / 2);
    m_limited->renderer().releaseBox();
    QCOMPARE(limited(builder.frame(), view), without);
    QCOMPARE(held(), heldWithout);
}

void LimitedPictureTest::tooManyTrianglesAreDrawnFromCoarserPoints_data() {
    QTest::addColumn<qulonglong>("memory");
    QTest::newRow("all heights") << qulonglong{100'000'000};
    QTest::newRow("heights in parts") << qulonglong{kLimit};
}

void LimitedPictureTest::tooManyTrianglesAreDrawnFromCoarserPoints() {
    constexpr std::size_t kMost = 50'000;
    QFETCH(qulonglong, memory);
    FrameBuilder builder(kStock, kSpacing);
    builder.cutAll(part); // 1.4 million triangles, until the surface is decimated
    OffscreenPicture picture;
    SceneRenderer& renderer = picture.renderer();
    renderer.setMemory(memory);
    renderer.setMostTriangles(kMost);
    const View view = cameraAt(StandardView::iso, true, 240, 150).view(stockBox());
    const QImage coarse = picture.draw(builder.frame(), view, testOptions());
    const std::size_t drawn = renderer.triangles(SurfaceBuffer::Part::fromZMap);
    QVERIFY2(drawn > kMost / 5 && drawn <= kMost, qPrintable(QString::number(drawn)));
    QCOMPARE(renderer.triangles(SurfaceBuffer::Part::decimated), std::size_t{0});
    QVERIFY(renderer.coarseness().coarser && renderer.coarseness().tooManyTriangles);
    const Difference difference = differenceOf(coarse, unlimited(builder.frame(), view));
    QVERIFY2(difference.mean < 3 && difference.strong < 0.03,
             qPrintable(QStringLiteral("mean %1, strong %2").arg(difference.mean).arg(difference.strong)));

    builder.decimate();
    QVERIFY(builder.frame()->surface.faces < kMost);
    const QImage decimated = picture.draw(builder.frame(), view, testOptions());
    QVERIFY(!renderer.coarseness().tooManyTriangles);
    if (memory > kLimit)
        QCOMPARE(decimated, unlimited(builder.frame(), view));
}

void LimitedPictureTest::trianglesOfAnyRegionSizeKeepTheLimit() {
    constexpr std::size_t kMost = 100'000;
    const View view = cameraAt(StandardView::iso, true, 240, 150).view(stockBox());
    for (const int cells : {7, 10, 16, 33}) {
        DecimationParameters parameters;
        parameters.regionCells = cells;
        FrameBuilder builder(kStock, kSpacing, parameters);
        builder.cutAll(part);
        OffscreenPicture picture;
        picture.renderer().setMostTriangles(kMost);
        static_cast<void>(picture.draw(builder.frame(), view, testOptions()));
        const std::size_t drawn = picture.renderer().triangles(SurfaceBuffer::Part::fromZMap);
        const std::size_t regions = builder.frame()->surface.grid.regionCount();
        QVERIFY2(drawn == 2 * regions || (drawn <= kMost && drawn > kMost / 8),
                 qPrintable(QStringLiteral("%1 of %2 regions").arg(drawn).arg(regions)));
    }
}

void LimitedPictureTest::thePictureDoesNotChangeWithEachDecimation() {
    const View view = cameraAt(StandardView::iso, true, 240, 150).view(stockBox());
    FrameBuilder builder = cutPart();
    const auto few = std::make_shared<Frame>(*builder.frame());
    builder.cut({450, 0, 560, 701}, [](double x, double y) { return part(x, y) - 0.2; });
    const auto more = std::make_shared<Frame>(*builder.frame());
    few->playing = more->playing = true;
    const auto paused = std::make_shared<Frame>(*few);
    paused->playing = false;
    builder.decimate();
    const FramePtr fewest = builder.frame();
    QVERIFY(few->surface.faces < more->surface.faces && fewest->surface.faces < few->surface.faces / 2);
    OffscreenPicture picture;
    SceneRenderer& renderer = picture.renderer();
    renderer.setMostTriangles((few->surface.faces + more->surface.faces) / 2);
    const auto isCoarse = [&](const FramePtr& frame) {
        static_cast<void>(picture.draw(frame, view, testOptions()));
        return renderer.coarseness().tooManyTriangles;
    };
    QVERIFY(!isCoarse(few));
    QVERIFY(isCoarse(more));
    QVERIFY(isCoarse(few));
    QVERIFY(isCoarse(more));
    QVERIFY(!isCoarse(paused)); // at rest, the best picture
    QVERIFY(!isCoarse(few));
    QVERIFY(isCoarse(more));
    const auto playing = std::make_shared<Frame>(*fewest);
    playing->playing = true;
    QVERIFY(!isCoarse(playing));
}

void LimitedPictureTest::aFrameArrivesInSlicesAndIsNotReplacedMeanwhile() {
    constexpr int kMostCalls = 30'000;
    const UploadBudget oneTile(std::chrono::seconds(0));
    FrameBuilder builder = cutPart();
    const FramePtr first = builder.frame();
    builder.cut({0, 0, 700, 300}, [](double x, double y) { return part(x, y) - 1; });
    builder.decimate();
    const FramePtr second = builder.frame();
    const View view = cameraAt(StandardView::iso, true).view(stockBox());
    for (const std::size_t memory : {std::size_t{100'000'000}, kLimit}) {
        OffscreenPicture whole;
        whole.renderer().setMemory(memory);
        OffscreenPicture picture; // its context is the current one
        SceneRenderer& renderer = picture.renderer();
        renderer.setMemory(memory);
        renderer.upload(first, oneTile);
        for (const FramePtr& frame : {first, second}) {
            QVERIFY(renderer.framePending() || frame == second);
            int calls = 0;
            do
                renderer.upload(second, oneTile);
            while ((renderer.framePending() || renderer.frame() != frame) && ++calls < kMostCalls);
            QVERIFY2(calls > 1 && calls < kMostCalls, qPrintable(QString::number(calls)));
            const QImage expected = whole.draw(frame, view, testOptions());
            QCOMPARE(picture.draw(frame, view, testOptions()), expected);
        }
        // A frame with another grid does not wait.
        renderer.upload(first, oneTile);
        QVERIFY(renderer.framePending());
        FrameBuilder other(kStock, 1);
        renderer.upload(other.frame());
        QVERIFY(!renderer.framePending());
        QCOMPARE(renderer.frame()->zmap.grid(), other.grid());
    }
}

void LimitedPictureTest::theSlicesOfALargeFrameAreReported() {
    const FramePtr large = FrameBuilder(kStock, 0.016).frame(); // 27 million points
    for (const auto& [frame, isLarge] : {std::pair(large, true), std::pair(cutPart().frame(), false)}) {
        PictureWidget widget(frame);
        int parts = 0;
        connect(&widget.picture(), &ScenePicture::partUploaded, this, [&] {
            QVERIFY(!widget.isDrawn());
            ++parts;
        });
        widget.show();
        QTRY_VERIFY_WITH_TIMEOUT(widget.isDrawn(), 30'000);
        QCOMPARE(parts > 0, isLarge);
    }
}

QTEST_MAIN(LimitedPictureTest)
#include "limited_picture_test.moc"
