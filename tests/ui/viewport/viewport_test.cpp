// SPDX-License-Identifier: GPL-3.0-or-later
// The 3D view with a session that runs a sample: gestures, keys, and what it reports to the session.
#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMainWindow>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/ui/opened.h"
#include "ui/gl/gl_functions.h"
#include "ui/viewport/surface_pick.h"
#include "ui/viewport/viewport.h"

using namespace proveout;

namespace {

constexpr int kPatience = 30'000; // ms
constexpr int kQuiet = 150;       // ms; pending repaints are done within this time
const QString kSample = QStringLiteral(PROVEOUT_SOURCE_DIR "/resources/samples/core-insert.proveout");

void wheel(QWidget& widget, const QPointF& at, int angle) {
    QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, angle}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
}

QAction* command(const QWidget& widget, const char* id) {
    for (QAction* action : widget.actions())
        if (action->objectName() == QLatin1String(id))
            return action;
    return nullptr;
}

/// The number of pixels in the colour of a detail region's edge.
std::size_t boxPixels(const QImage& image) {
    constexpr int kNear = 8;
    const glm::vec3 colour = 255.0F * SceneColours().box;
    std::size_t count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            const glm::vec3 off = glm::abs(glm::vec3(pixel.red(), pixel.green(), pixel.blue()) - colour);
            count += std::max({off.r, off.g, off.b}) < kNear ? 1 : 0;
        }
    return count;
}

} // namespace

class ViewportTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();
    void fitsTheStockAtFirst();
    void reportsDrawingTimesToTheSession();
    void wheelKeepsThePointUnderThePointer();
    void dragsTurnAndMove();
    void doubleMiddleClickCentres();
    void keysChooseViewsAndSwitches();
    void repaintsOnNewFramesOnly();
    void grabsLookLikeTheScreen();
    void survivesAnotherWindow();
    void followsThePalette();
    void aClickLooksCloser();

private:
    GlSupport m_support;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<QMainWindow> m_window;
    Viewport* m_view = nullptr;
};

void ViewportTest::initTestCase() {
    m_support = probeGl();
    if (!m_support.usable)
        QSKIP("no OpenGL 3.3 here");
}

void ViewportTest::init() {
    m_session = std::make_unique<Session>();
    m_window = std::make_unique<QMainWindow>();
    m_window->resize(900, 640);
    m_view = new Viewport(*m_session, m_support, m_window.get());
    m_window->setCentralWidget(m_view);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_view->setFocus();
    QVERIFY(opened(*m_session, kSample));
    QTRY_VERIFY_WITH_TIMEOUT(m_session->simulation().frame() != nullptr, 10000);
    m_session->playback().seek(100);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->simulation().block(), std::size_t{100}, 10000);
}

void ViewportTest::cleanup() {
    m_window.reset();
    m_session.reset();
}

void ViewportTest::fitsTheStockAtFirst() {
    const StockBox& stock = m_session->simulation().frame()->zmap.stock();
    const double ratio = m_view->devicePixelRatioF();
    for (const double x : {stock.corner.x, stock.corner.x + stock.width})
        for (const double y : {stock.corner.y, stock.corner.y + stock.depth}) {
            const Vec2 pixel = m_view->camera().project({x, y, stock.floorZ()});
            QVERIFY(pixel.x > 0 && pixel.x < m_view->width() * ratio);
            QVERIFY(pixel.y > 0 && pixel.y < m_view->height() * ratio);
        }
}

void ViewportTest::reportsDrawingTimesToTheSession() {
    QTRY_VERIFY_WITH_TIMEOUT(!m_session->playback().frameStatistics().empty(), kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->playback().frameStatistics().back().lastBlock, 100u, kPatience);
    QVERIFY(m_session->playback().frameStatistics().back().drawSeconds > 0);
}

void ViewportTest::wheelKeepsThePointUnderThePointer() {
    for (const bool perspective : {true, false}) {
        m_view->setPerspective(perspective);
        for (const QPointF at : {QPointF(450, 330), QPointF(300, 300), QPointF(620, 350)}) {
            m_view->fit();
            const double ratio = m_view->devicePixelRatioF();
            const Ray ray = m_view->camera().ray(at.x() * ratio, at.y() * ratio);
            const auto point = pickStock(m_session->simulation().frame()->zmap, ray);
            QVERIFY(point.has_value());
            for (const int angle : {120, 120, -120, 240, -360}) {
                wheel(*m_view, at, angle);
                const Vec2 now = m_view->camera().project(*point);
                QVERIFY(std::hypot(now.x - at.x() * ratio, now.y - at.y() * ratio) < 1);
            }
        }
    }
}

void ViewportTest::dragsTurnAndMove() {
    const double azimuth = m_view->camera().azimuth();
    const Vec3 target = m_view->camera().target();
    QTest::mousePress(m_view, Qt::LeftButton, {}, {400, 300});
    QTest::mouseMove(m_view, {460, 300});
    QTest::mouseRelease(m_view, Qt::LeftButton, {}, {460, 300});
    QVERIFY(std::abs(m_view->camera().azimuth() - azimuth) > 0.1);
    QCOMPARE(glm::distance(m_view->camera().target(), target), 0.0);
    for (const auto& [button, modifiers] :
         {std::pair{Qt::MiddleButton, Qt::KeyboardModifiers()},
          std::pair{Qt::LeftButton, Qt::KeyboardModifiers(Qt::ShiftModifier)}}) {
        const Vec3 before = m_view->camera().target();
        const double angle = m_view->camera().azimuth();
        QTest::mousePress(m_view, button, modifiers, {400, 300});
        QTest::mouseMove(m_view, {440, 320});
        QTest::mouseRelease(m_view, button, modifiers, {440, 320});
        QVERIFY(glm::distance(m_view->camera().target(), before) > 1);
        QCOMPARE(m_view->camera().azimuth(), angle);
    }
}

void ViewportTest::doubleMiddleClickCentres() {
    const QPoint at(380, 340);
    const double ratio = m_view->devicePixelRatioF();
    const auto point = pickStock(m_session->simulation().frame()->zmap,
                                 m_view->camera().ray(at.x() * ratio, at.y() * ratio));
    QVERIFY(point.has_value());
    QTest::mouseDClick(m_view, Qt::MiddleButton, {}, at);
    const Vec2 now = m_view->camera().project(*point);
    QVERIFY(std::hypot(now.x - 0.5 * m_view->width() * ratio, now.y - 0.5 * m_view->height() * ratio) < 2);
}

void ViewportTest::keysChooseViewsAndSwitches() {
    QTest::keyClick(m_view, Qt::Key_1);
    QVERIFY(std::abs(m_view->camera().elevation() - 1.5707963) < 1e-6);
    QTest::keyClick(m_view, Qt::Key_3);
    QVERIFY(std::abs(m_view->camera().elevation()) < 1e-6);
    QTest::keyClick(m_view, Qt::Key_0);
    QVERIFY(std::abs(m_view->camera().azimuth() + 0.7853982) < 1e-6);
    const bool perspective = m_view->camera().perspective();
    QTest::keyClick(m_view, Qt::Key_P);
    QCOMPARE(m_view->camera().perspective(), !perspective);
    QTest::keyClick(m_view, Qt::Key_W);
    QVERIFY(m_view->options().wireframe && command(*m_view, "view-wireframe")->isChecked());
    QTest::keyClick(m_view, Qt::Key_T);
    QVERIFY(m_view->options().tint && command(*m_view, "view-tint")->isChecked());
    QTest::keyClick(m_view, Qt::Key_L);
    QVERIFY(!m_view->legendShown());
    const QImage shown = m_view->grabFramebuffer();
    QTest::keyClick(m_view, Qt::Key_W);
    QTest::keyClick(m_view, Qt::Key_T);
    QTest::keyClick(m_view, Qt::Key_L);
    QVERIFY(!m_view->options().wireframe && !m_view->options().tint && m_view->legendShown());
    QVERIFY(m_view->grabFramebuffer() != shown);
    // The path commands are exclusive.
    command(*m_view, "path-whole")->trigger();
    QCOMPARE(m_view->options().path, PathShown::whole);
    QVERIFY(!command(*m_view, "path-near")->isChecked());
    const double turned = m_view->camera().azimuth();
    QTest::keyClick(m_view, Qt::Key_Left, Qt::AltModifier);
    QVERIFY(m_view->camera().azimuth() != turned);
}

void ViewportTest::repaintsOnNewFramesOnly() {
    // The refined surface is the last new frame while nothing happens.
    QTRY_VERIFY_WITH_TIMEOUT(m_session->simulation().frame()->level == ErrorLevel::surface, kPatience);
    int painted = 0;
    connect(m_view, &QOpenGLWidget::aboutToCompose, this, [&] { ++painted; });
    // Pending repaints are done some milliseconds later; then the antialiased image follows.
    for (int before = -1; std::exchange(before, painted) != painted || !m_view->atRest();)
        QTest::qWait(kQuiet);
    painted = 0;
    QSignalSpy ticks(&m_session->playback(), &PlaybackHub::tick);
    for (int k = 1; k <= 3; ++k) {
        m_session->playback().requestTick();
        QTRY_COMPARE_WITH_TIMEOUT(ticks.count(), k, kPatience);
        QTest::qWait(kQuiet); // does the repaint requested by the tick
    }
    QCOMPARE(painted, 0);
    m_session->playback().step(1);
    QTRY_VERIFY_WITH_TIMEOUT(painted > 0, kPatience);
}

void ViewportTest::grabsLookLikeTheScreen() {
    // With legend and axes, and opaque: blending must not leave transparent pixels for the window system.
    const QImage all = m_window->grab().toImage();
    m_view->setLegendShown(false);
    const QImage withoutLegend = m_window->grab().toImage();
    QVERIFY(all.pixel(20, 20) != withoutLegend.pixel(20, 20));
    const QImage picture = m_view->grabFramebuffer();
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            QCOMPARE(qAlpha(picture.pixel(x, y)), 255);
}

void ViewportTest::survivesAnotherWindow() {
    // A widget that moves to another window may lose its context, and then the GPU resources are created
    // again.
    QMainWindow other;
    other.resize(900, 640);
    other.setCentralWidget(m_view);
    other.show();
    QVERIFY(QTest::qWaitForWindowExposed(&other));
    m_view->fit();
    const QImage after = m_view->grabFramebuffer();
    int colours = 0;
    for (int x = 0; x + 1 < after.width(); ++x)
        colours += after.pixel(x, after.height() / 2) != after.pixel(x + 1, after.height() / 2) ? 1 : 0;
    QVERIFY(colours > 50);
    m_window->setCentralWidget(m_view);
}

void ViewportTest::followsThePalette() {
    const QRgb before = m_view->grabFramebuffer().pixel(2, 2);
    QPalette palette = m_view->palette();
    const bool wasDark = palette.color(QPalette::Window).lightness() < 128;
    palette.setColor(QPalette::Window, wasDark ? Qt::white : Qt::black);
    palette.setColor(QPalette::WindowText, wasDark ? Qt::black : Qt::white);
    palette.setColor(QPalette::Base, wasDark ? Qt::white : Qt::black);
    palette.setColor(QPalette::Text, wasDark ? Qt::black : Qt::white);
    m_view->setPalette(palette);
    const QRgb after = m_view->grabFramebuffer().pixel(2, 2);
    QCOMPARE(qGray(after) > qGray(before), wasDark);
}

void ViewportTest::aClickLooksCloser() {
    const QPoint at(450, 330);
    const double ratio = m_view->devicePixelRatioF();
    const auto point = pickStock(m_session->simulation().frame()->zmap,
                                 m_view->camera().ray(at.x() * ratio, at.y() * ratio));
    QVERIFY(point.has_value());
    m_view->setLegendShown(false);
    // At rest: until then, some of the walls are shown.
    QTRY_VERIFY_WITH_TIMEOUT(m_session->simulation().frame()->level == ErrorLevel::surface, kPatience);
    const QImage before = m_view->grabFramebuffer();
    const double azimuth = m_view->camera().azimuth();
    QTest::keyClick(m_view, Qt::Key_B);
    QVERIFY(command(*m_view, "look-closer")->isChecked() && m_view->looksCloser());
    auto* spacing = m_view->findChild<QDoubleSpinBox*>(QStringLiteral("closerSpacing"));
    QVERIFY(spacing != nullptr && spacing->isVisible());
    QCOMPARE(spacing->value(), 0.01);
    QTest::mousePress(m_view, Qt::LeftButton, {}, at);
    QTest::mouseMove(m_view, at + QPoint(2, 1));
    QTest::mouseRelease(m_view, Qt::LeftButton, {}, at + QPoint(2, 1));
    QCOMPARE(m_view->camera().azimuth(), azimuth);
    CloserLook& look = m_view->closerLook();
    QTRY_VERIFY_WITH_TIMEOUT(look.picture() != nullptr, kPatience);
    const PlanBox box = look.box()->box;
    QVERIFY(box.lo.x < point->x && point->x < box.hi.x && box.lo.y < point->y && point->y < box.hi.y);
    QVERIFY(std::abs(look.picture()->zmap.grid().hx - 0.01) < 1e-3);
    QVERIFY(m_view->grabFramebuffer() != before);

    // With other numbers the centre stays.
    spacing->setValue(0.05);
    QVERIFY(look.working() && look.picture() == nullptr);
    // The outline of the region that is being cut.
    QCOMPARE(boxPixels(before), std::size_t{0});
    QVERIFY(boxPixels(m_view->grabFramebuffer()) > 50);
    QTRY_VERIFY_WITH_TIMEOUT(look.picture() != nullptr, kPatience);
    QVERIFY(std::abs(look.picture()->zmap.grid().hx - 0.05) < 5e-3);
    m_view->findChild<QDoubleSpinBox*>(QStringLiteral("closerWidth"))->setValue(6);
    QVERIFY(std::abs(look.box()->box.hi.x - look.box()->box.lo.x - 6) < 1e-9);

    // At another block the old region is hidden, and the new one appears when it is complete.
    m_session->playback().seek(60);
    QTRY_VERIFY_WITH_TIMEOUT(look.picture() != nullptr && look.picture()->block == 60, kPatience);
    QTest::keyClick(m_view, Qt::Key_Escape);
    QVERIFY(!look.box() && !m_view->looksCloser() && !spacing->isVisible());
    QVERIFY(!command(*m_view, "look-closer")->isChecked());
    m_session->playback().seek(100);
    QTRY_VERIFY_WITH_TIMEOUT(
        m_session->simulation().frame()->block == 100 && m_view->grabFramebuffer() == before, kPatience);
}

QTEST_MAIN(ViewportTest)
#include "viewport_test.moc"
