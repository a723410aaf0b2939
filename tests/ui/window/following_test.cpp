// SPDX-License-Identifier: GPL-3.0-or-later
// The text follows the program during playback until the user works in it.
#include <functional>
#include <map>
#include <memory>

#include <QApplication>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeView>
#include <QWheelEvent>

#include "tests/ui/window/workstation.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/findings/problems_panel.h"

namespace proveout {
namespace {

constexpr int kCurrentArrow = 1 << 1;

/// A program with many lines during playback.
struct Playing {
    Workstation station{false};
    QTemporaryDir folder;
    NcEditor& editor{station.window.editor().editor()};
    QToolButton& again{*station.window.findChild<QToolButton*>(QStringLiteral("follow-again"))};

    Playing() {
        QFile file(folder.filePath(QStringLiteral("long.nc")));
        if (!file.open(QIODevice::WriteOnly))
            qFatal("no file");
        file.write("G21 G90 G17 F500\nT1 M6\nG0 X0 Y0 Z5\nG1 Z-1\n");
        for (int i = 0; i < 4000; ++i)
            file.write(QByteArray("G1 X") + QByteArray::number(i % 50) + " Y" + QByteArray::number(i % 7) +
                       "\n");
        file.write("M30\n");
        file.close();
        station.open(file.fileName());
        play();
    }
    void play() {
        station.session.playback().setSpeed(200);
        station.session.playback().play();
        const std::size_t from = station.session.simulation().block();
        if (!QTest::qWaitFor([&] { return station.session.simulation().block() > from + 10; }, kPatience))
            qFatal("it does not play");
    }
    [[nodiscard]] long firstLine() const { return editor.SendScintilla(NcEditor::SCI_GETFIRSTVISIBLELINE); }
    [[nodiscard]] int current() const { return editor.markerFindNext(0, kCurrentArrow); }
    [[nodiscard]] bool follows() const {
        const long shown = editor.SendScintilla(NcEditor::SCI_LINESONSCREEN);
        return current() >= firstLine() && current() < firstLine() + shown;
    }
    /// Continues playback until the current line must have left the visible part.
    [[nodiscard]] bool playsOutOfSight() const {
        const int from = current();
        const long shown = editor.SendScintilla(NcEditor::SCI_LINESONSCREEN);
        return QTest::qWaitFor([&] { return current() > from + 2 * shown; }, kPatience);
    }
    [[nodiscard]] QAction& follow() const { return *station.window.action(QStringLiteral("follow-program")); }
    void turnWheel() const {
        const QPointF at(90, 60);
        QWheelEvent event(at, editor.viewport()->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(editor.viewport(), &event);
    }
    /// T1 is not in the table, so the list has a problem from the first block on.
    void doubleClickProblem() {
        auto* panel = station.window.findChild<ProblemsPanel*>();
        for (QWidget* each = panel; each != nullptr; each = each->parentWidget())
            each->raise();
        auto* list = panel->findChild<QTreeView*>();
        if (!QTest::qWaitFor([&] { return list->isVisible(); }, kPatience))
            qFatal("no problem is shown");
        const QPoint at = list->visualRect(list->model()->index(0, 1)).center();
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(list->viewport(), Qt::LeftButton, {}, at);
    }
    void click(int line) {
        const long at =
            editor.SendScintilla(NcEditor::SCI_POSITIONFROMLINE, static_cast<unsigned long>(line));
        const long y = editor.SendScintilla(NcEditor::SCI_POINTYFROMPOSITION, 0UL, at);
        QTest::mouseClick(editor.viewport(), Qt::LeftButton, {}, QPoint(90, static_cast<int>(y) + 4));
    }
};

} // namespace

class FollowingTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void theTextFollowsAProgramThatPlays() {
        Playing playing;
        QVERIFY(playing.follow().isChecked());
        QVERIFY(playing.playsOutOfSight());
        QVERIFY(playing.follows());
        QVERIFY(!playing.again.isVisible());
    }

    void workInTheTextStopsFollowing_data() {
        QTest::addColumn<int>("work");
        const char* const names[] = {
            "typing",    "clicking a line", "moving the caret", "scrolling",
            "a problem", "a match",         "the wheel",        "a double click on a problem"};
        for (int work = 0; work < 8; ++work)
            QTest::newRow(names[work]) << work;
    }
    void workInTheTextStopsFollowing() {
        QFETCH(int, work);
        Playing playing;
        NcEditor& editor = playing.editor;
        editor.setFocus();
        const std::map<int, std::function<void()>> works{
            {0, [&] { QTest::keyClicks(&editor, QStringLiteral("(a)")); }},
            {1, [&] { playing.click(static_cast<int>(playing.firstLine()) + 3); }},
            {2, [&] { QTest::keyClick(&editor, Qt::Key_Down); }},
            {3, [&] { editor.verticalScrollBar()->triggerAction(QAbstractSlider::SliderPageStepAdd); }},
            {4, [&] { emit playing.station.session.navigation().lineRequested(12, 1); }},
            {5, [&] { editor.selectBytes(30, 34); }},
            {6, [&] { playing.turnWheel(); }},
            {7, [&] { playing.doubleClickProblem(); }}};
        works.at(work)();
        QVERIFY(playing.station.session.playback().state().playing);
        QTest::qWait(300); // a click goes to its line first
        const long first = playing.firstLine();
        QVERIFY(!playing.follow().isChecked());
        QVERIFY(playing.again.isVisible());
        QVERIFY(playing.playsOutOfSight());
        QCOMPARE(playing.firstLine(), first);
        QVERIFY(!playing.follows());
    }

    void followingIsTurnedOnAgainByItsButtonOrByPlayingAgain() {
        Playing playing;
        Session& session = playing.station.session;
        emit session.navigation().lineRequested(3, 1);
        QVERIFY(playing.playsOutOfSight());
        QVERIFY(!playing.follows());
        QTest::mouseClick(&playing.again, Qt::LeftButton);
        QVERIFY(playing.follow().isChecked());
        QVERIFY(playing.follows());
        QVERIFY(!playing.again.isVisible());
        emit session.navigation().lineRequested(3, 1);
        QVERIFY(!playing.follow().isChecked());
        session.playback().pause();
        QVERIFY(!playing.again.isVisible());
        playing.play();
        QVERIFY(playing.follow().isChecked());
        QTRY_VERIFY_WITH_TIMEOUT(playing.follows(), kPatience);
        // If the user turned following off, it stays off.
        playing.follow().trigger();
        QVERIFY(!playing.follow().isChecked());
        session.playback().pause();
        playing.play();
        QVERIFY(!playing.follow().isChecked());
        QVERIFY(playing.again.isVisible());
    }

    void theTextIsAtItsStartWhenTheProgramIs_data() {
        QTest::addColumn<bool>("cancels");
        QTest::newRow("after a pause") << false;
        QTest::newRow("after a cancelled run") << true;
    }
    void theTextIsAtItsStartWhenTheProgramIs() {
        QFETCH(bool, cancels);
        Playing playing;
        Session& session = playing.station.session;
        QVERIFY(playing.playsOutOfSight());
        playing.station.scale().setFocus();
        session.playback().pause();
        if (cancels) {
            session.playback().measure();
            session.work().cancel();
        }
        playing.station.window.action(QStringLiteral("to-start"))->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{0}, kPatience);
        QTRY_COMPARE_WITH_TIMEOUT(playing.current(), -1, kPatience);
        QCOMPARE(playing.firstLine(), 0L);
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::FollowingTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "following_test.moc"
