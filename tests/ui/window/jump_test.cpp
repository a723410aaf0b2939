// SPDX-License-Identifier: GPL-3.0-or-later
// From the stock in the 3D view to the program line that cut it, with the mouse.
#include <algorithm>
#include <memory>

#include <QApplication>
#include <QContextMenuEvent>
#include <QDockWidget>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QStatusBar>
#include <QTest>

#include "core/simulation/run/simulation.h"
#include "tests/ui/window/workstation.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/gl/gl_functions.h"
#include "ui/viewport/box_choice.h"
#include "ui/viewport/place_label.h"
#include "ui/viewport/surface_pick.h"
#include "ui/viewport/viewport.h"

namespace proveout {
namespace {

constexpr std::size_t kStart = 200;
constexpr std::size_t kFacing = 15; ///< part of the top is still raw

/// The block, from 1, that last lowered a point; found by checking the point after each block.
std::size_t lastCut(const Frame& moment, const MapPoint& point) {
    DecimationParameters undecimated;
    undecimated.method = DecimationMethod::none;
    const auto simulation = std::move(Simulation::create(moment.program, moment.setup, undecimated).value());
    std::size_t last = 0;
    float before = 0;
    while (simulation->position() < moment.block) {
        simulation->step();
        const float height = simulation->zmap().height(point.i, point.j);
        if (height < before - 0.002F)
            last = simulation->position();
        before = height;
    }
    return last;
}

/// Counts the paint events of a widget.
class PaintCounter : public QObject {
public:
    PaintCounter(QWidget& widget, int& count) : m_count(count) { widget.installEventFilter(this); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        m_count += event->type() == QEvent::Paint ? 1 : 0;
        return QObject::eventFilter(watched, event);
    }

private:
    int& m_count;
};

} // namespace

class JumpTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (!probeGl().usable)
            QSKIP("no OpenGL 3.3 here");
    }

    void init() {
        m_settings = std::make_unique<OwnSettings>();
        m_station = std::make_unique<Workstation>(true);
        goTo(kStart);
    }

    void cleanup() {
        m_station.reset();
        m_settings.reset();
    }

    void ctrlClickShowsTheBlockAndBackspaceReturns() {
        const QPoint at = placeOf(true);
        const std::size_t expected = expectedAt(at);
        const double azimuth = view().camera().azimuth();
        m_station->window.findChild<QDockWidget*>(QStringLiteral("dock-setup"))->raise();
        QTest::mouseClick(&view(), Qt::LeftButton, Qt::ControlModifier, at);
        wentTo(expected);
        QCOMPARE(view().camera().azimuth(), azimuth);
        QTRY_VERIFY(m_station->window.editor().isVisible());
        QAction* back = m_station->window.action(QStringLiteral("jump-back"));
        QVERIFY(back->isEnabled());
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_Backspace);
        QTRY_COMPARE_WITH_TIMEOUT(session().simulation().block(), kStart, kPatience);
        QVERIFY(!back->isEnabled());
    }

    void theMenuOfTheRightButtonAsksAboutItsPlace() {
        const QPoint at = placeOf(true);
        const std::size_t expected = expectedAt(at);
        QTest::mouseClick(&view(), Qt::RightButton, {}, at);
        QMenu* menu = shownMenu();
        QVERIFY(menu != nullptr);
        QVERIFY(menu->actions().front()->text().startsWith(
            m_station->window.action(QStringLiteral("go-to-block"))->text()));
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(menu->actions().front()).center());
        wentTo(expected);
    }

    void aDragWithTheRightButtonOpensNoMenu() {
        const QPoint at = placeOf(true);
        QTest::mousePress(&view(), Qt::RightButton, {}, at);
        QContextMenuEvent pressed(QContextMenuEvent::Mouse, at, view().mapToGlobal(at)); // as sent by X11
        QApplication::sendEvent(&view(), &pressed);
        QVERIFY(shownMenu() == nullptr);
        QTest::mouseMove(&view(), at + QPoint(40, 10));
        QTest::mouseMove(&view(), at);
        QTest::mouseRelease(&view(), Qt::RightButton, {}, at);
        QVERIFY(shownMenu() == nullptr);
        // The keyboard's menu key opens it.
        QContextMenuEvent key(QContextMenuEvent::Keyboard, at, view().mapToGlobal(at));
        QApplication::sendEvent(&view(), &key);
        QVERIFY(shownMenu() != nullptr);
        shownMenu()->close();
    }

    void theCommandWaitsForAClick() {
        const QPoint at = placeOf(true);
        const std::size_t expected = expectedAt(at);
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_G);
        QCOMPARE(view().cursor().shape(), Qt::CrossCursor);
        QTest::keyClick(&view(), Qt::Key_Escape);
        QCOMPARE(view().cursor().shape(), Qt::ArrowCursor);
        QTest::mouseClick(&view(), Qt::LeftButton, {}, at);
        m_station->window.action(QStringLiteral("go-to-block"))->trigger();
        QVERIFY(!m_station->window.statusBar()->currentMessage().isEmpty());
        // The view can be turned meanwhile.
        QTest::mousePress(&view(), Qt::LeftButton, {}, {60, 60});
        QTest::mouseMove(&view(), {90, 60});
        QTest::mouseMove(&view(), {60, 60});
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, {60, 60});
        QCOMPARE(view().cursor().shape(), Qt::CrossCursor);
        QTest::mouseClick(&view(), Qt::LeftButton, {}, at);
        QCOMPARE(view().cursor().shape(), Qt::ArrowCursor);
        wentTo(expected);
    }

    void thePointerShowsThePlaceAndItsLine() {
        const QPoint at = placeOf(true);
        const std::uint32_t line = session().program().current()->blockLine(expectedAt(at) - 1);
        const auto place = pickSurface(session().simulation().frame(), nullptr, rayAt(at));
        QTest::mouseMove(&view(), at);
        const QString position = QStringLiteral("X %1  Y %2  Z %3 mm (G54)")
                                     .arg(number(place->at.x), number(place->at.y), number(place->at.z));
        const QString cut = QStringLiteral("Line %1, T1").arg(line);
        QTRY_VERIFY2_WITH_TIMEOUT(status().contains(position) && status().contains(cut), qPrintable(status()),
                                  kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(label().isVisible(), kPatience);
        QCOMPARE(label().text(), position + u'\n' + cut);
        QVERIFY(label().isWindow()); // otherwise every move would compose the window again
        QVERIFY(!label().geometry().contains(view().mapToGlobal(at)));
        // A command of the menu hides it; the status line stays.
        m_station->window.action(QStringLiteral("view-place"))->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(!label().isVisible(), kPatience);
        QVERIFY(status().contains(cut));
        m_station->window.action(QStringLiteral("view-place"))->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(label().isVisible(), kPatience);
        // It is hidden while the view is turned, and next to the stock.
        QTest::mousePress(&view(), Qt::LeftButton, {}, at);
        QVERIFY(!label().isVisible());
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, at);
        QTRY_VERIFY_WITH_TIMEOUT(label().isVisible(), kPatience);
        QTest::mouseMove(&view(), QPoint(view().width() - 4, view().height() - 4));
        QTRY_VERIFY_WITH_TIMEOUT(!label().isVisible() && status().isEmpty(), kPatience);
    }

    void thePointerKnowsRawStockSidesAndDetailRegions() {
        goTo(kFacing);
        QTest::mouseMove(&view(), placeOf(false));
        QTRY_VERIFY2_WITH_TIMEOUT(status().contains(QLatin1String("Raw stock")), qPrintable(status()),
                                  kPatience);
        view().setStandardView(StandardView::front);
        const StockBox stock = session().simulation().frame()->zmap.stock();
        const Vec2 side = view().camera().project(
            {stock.corner.x + 0.4 * stock.width, stock.corner.y, stock.floorZ() + 0.3 * stock.height});
        QTest::mouseMove(&view(), (QPointF(side.x, side.y) / view().devicePixelRatioF()).toPoint());
        QTRY_VERIFY2_WITH_TIMEOUT(status().contains(QLatin1String("Raw stock")) &&
                                      status().contains(QStringLiteral("Y %1").arg(number(stock.corner.y))),
                                  qPrintable(status()), kPatience);
        goTo(kStart);
        view().setStandardView(StandardView::top);
        const QPoint at = placeOf(true);
        const auto coarse = pickSurface(session().simulation().frame(), nullptr, rayAt(at));
        view().closerLook().look({boxAbout(Vec2(coarse->at), {6, 6}, stock), 0.05});
        QTRY_VERIFY_WITH_TIMEOUT(view().closerLook().picture() != nullptr, kPatience);
        QTest::mouseMove(&view(), at + QPoint(1, 0));
        QTest::mouseMove(&view(), at);
        const auto fine =
            pickSurface(session().simulation().frame(), view().closerLook().picture(), rayAt(at));
        QTRY_VERIFY2_WITH_TIMEOUT(status().contains(QStringLiteral("Z %1 mm").arg(number(fine->at.z))) &&
                                      status().contains(QLatin1String("Line ")),
                                  qPrintable(status()), kPatience);
    }

    void thePointerPaintsWithTheTickOnly() {
        QTest::mouseMove(&view(), placeOf(true));
        QTRY_VERIFY_WITH_TIMEOUT(status().contains(QLatin1String("Line ")), kPatience);
        int drawn = 0;
        int ticks = 0;
        QObject context;
        QObject::connect(&session().playback(), &PlaybackHub::tick, &context, [&] { ++ticks; });
        // Counts paint events and not compositions: without a compositor the label uncovers parts of the
        // window at every move.
        const PaintCounter counter(view(), drawn);
        const QPoint from = placeOf(true);
        for (int k = 0; k < 60; ++k) {
            QTest::mouseMove(&view(), from + QPoint(k % 30, k / 30));
            QTest::qWait(5);
        }
        QVERIFY(ticks > 2);
        QVERIFY2(drawn <= 2 * ticks + 4, qPrintable(QStringLiteral("%1 %2").arg(drawn).arg(ticks)));
    }

    void thePointerDoesNotHoldUpPlayback() {
        const QPoint at = placeOf(true);
        session().playback().seek(0);
        QTRY_COMPARE_WITH_TIMEOUT(session().simulation().block(), std::size_t{0}, kPatience);
        session().playback().setSpeed(2000);
        session().playback().play();
        QTest::mouseMove(&view(), at);
        QTRY_VERIFY_WITH_TIMEOUT(session().simulation().block() > 150, kPatience);
        QTest::mouseMove(&view(), at + QPoint(1, 1));
        QTRY_VERIFY_WITH_TIMEOUT(session().simulation().block() == session().program().blockCount(),
                                 kPatience);
        session().playback().pause();
        QTRY_VERIFY2_WITH_TIMEOUT(status().contains(QLatin1String("Line ")), qPrintable(status()), kPatience);
    }

    void rawStockAndNoStockAreReported() {
        goTo(kFacing);
        const QPoint at = placeOf(false);
        QTest::mouseClick(&view(), Qt::LeftButton, Qt::ControlModifier, at);
        QTRY_VERIFY2_WITH_TIMEOUT(message().startsWith(QLatin1String("Raw stock")), qPrintable(message()),
                                  kPatience);
        QTest::mouseClick(&view(), Qt::LeftButton, Qt::ControlModifier, QPoint(view().width() - 4, 4));
        QTRY_VERIFY2_WITH_TIMEOUT(message().startsWith(QLatin1String("There is no stock")),
                                  qPrintable(message()), kPatience);
        QCOMPARE(session().simulation().block(), kFacing);
    }

    void aCloserLookCanBeAsked() {
        const QPoint at = placeOf(true);
        const std::size_t expected = expectedAt(at);
        const PickedPlace coarse = pick(at);
        const Grid& grid = coarse.moment->zmap.grid();
        const Vec2 middle(grid.x(coarse.point->i), grid.y(coarse.point->j));
        view().closerLook().look({boxAbout(middle, {6, 6}, coarse.moment->zmap.stock()), 0.05});
        QTRY_VERIFY_WITH_TIMEOUT(view().closerLook().picture() != nullptr, kPatience);
        const PickedPlace fine = pick(at);
        QCOMPARE(fine.moment, view().closerLook().picture());
        QTest::mouseClick(&view(), Qt::LeftButton, Qt::ControlModifier, at);
        wentTo(expected);
    }

private:
    Session& session() { return m_station->session; }
    Viewport& view() { return dynamic_cast<Viewport&>(m_station->window.viewport()); }
    QString message() { return m_station->window.statusBar()->currentMessage(); }
    QMenu* shownMenu() {
        const auto menus = view().findChildren<QMenu*>();
        const auto shown =
            std::find_if(menus.begin(), menus.end(), [](QMenu* menu) { return menu->isVisible(); });
        return shown == menus.end() ? nullptr : *shown;
    }

    Ray rayAt(const QPoint& at) {
        const double ratio = view().devicePixelRatioF();
        return view().camera().ray(at.x() * ratio, at.y() * ratio);
    }
    QLabel& label() { return *view().findChild<PlaceLabel*>(); }
    QString status() { return m_station->window.findChild<QLabel*>(QStringLiteral("status-place"))->text(); }
    static QString number(double value) { return QLocale().toString(value, 'f', 3); }

    void goTo(std::size_t block) {
        session().playback().seek(block);
        QTRY_COMPARE_WITH_TIMEOUT(session().simulation().block(), block, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(view().atRest(), kPatience);
    }

    PickedPlace pick(const QPoint& at) {
        const double ratio = view().devicePixelRatioF();
        return pickPlace(session().simulation().frame(), view().closerLook().picture(),
                         view().camera().ray(at.x() * ratio, at.y() * ratio));
    }

    /// A position in the view where the stock was cut some blocks ago, or where it was not cut.
    QPoint placeOf(bool cut) {
        for (int y = view().height() / 3; y < view().height(); y += 7) {
            for (int x = view().width() / 4; x < view().width(); x += 13) {
                const PickedPlace place = pick({x, y});
                if (!place.point)
                    continue;
                const auto block = blockThatMade(*place.moment, *place.point);
                if (cut ? block && *block + 20 < kStart : !block)
                    return {x, y};
            }
        }
        qFatal("there is no such place");
        return {};
    }

    std::size_t expectedAt(const QPoint& at) {
        const PickedPlace place = pick(at);
        const std::size_t last = lastCut(*place.moment, *place.point);
        if (last == 0)
            qFatal("nothing has cut there");
        return last;
    }

    void wentTo(std::size_t block) {
        QTRY_COMPARE_WITH_TIMEOUT(session().simulation().block(), block, kPatience);
        const auto line = static_cast<int>(session().program().current()->blockLine(block - 1));
        NcEditor& editor = m_station->window.editor().editor();
        QCOMPARE(editor.caretLine(), line);
        QTRY_COMPARE_WITH_TIMEOUT(editor.markerFindNext(0, 1 << 1), line - 1, kPatience);
        QVERIFY2(message().contains(QString::number(block)) && message().contains(QString::number(line)) &&
                     message().contains(QLatin1String("T1")),
                 qPrintable(message()));
    }

    std::unique_ptr<OwnSettings> m_settings;
    std::unique_ptr<Workstation> m_station;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::JumpTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "jump_test.moc"
