// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <utility>

#include <QApplication>
#include <QFile>
#include <QHelpEvent>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolTip>
#include <QWheelEvent>

#include "core/nc/run/interpreter.h"
#include "tests/ui/opened.h"
#include "ui/look/theme.h"
#include "ui/readout/cycle_time_text.h"
#include "ui/timeline/timeline_panel.h"
#include "ui/timeline/timeline_scale.h"

namespace proveout {

class TimelineTest : public QObject {
    Q_OBJECT

private slots:
    void everyBlockIsReachable() {
        TimelineScale scale;
        scale.resize(800, scale.sizeHint().height());
        for (const std::size_t blocks : {1U, 2U, 255U, 700U}) {
            scale.setBlockCount(blocks);
            for (std::size_t block = 0; block <= blocks; ++block)
                QCOMPARE(scale.blockAt(scale.positionOf(block)), block);
        }
        scale.setBlockCount(10'273);
        QCOMPARE(scale.blockAt(-5), std::size_t{0});
        QCOMPARE(scale.blockAt(900), std::size_t{10'273});
    }

    void scrubbingShowsTheBlockUnderTheMouse() {
        TimelineScale scale;
        scale.resize(800, scale.sizeHint().height());
        scale.setBlockCount(255);
        QList<std::size_t> blocks;
        connect(&scale, &TimelineScale::scrubbed, &scale, [&](std::size_t block) { blocks << block; });
        const auto place = [&](std::size_t block) {
            return QPoint(static_cast<int>(std::lround(scale.positionOf(block))), 12);
        };
        QTest::mousePress(&scale, Qt::LeftButton, {}, place(100));
        scale.setBlock(3); // a frame from before the drag must not move the marker
        QTest::mouseMove(&scale, place(200));
        QTest::mouseRelease(&scale, Qt::LeftButton, {}, place(200));
        QCOMPARE(blocks.front(), std::size_t{100});
        QCOMPARE(blocks.back(), std::size_t{200});
        QTest::mouseMove(&scale, place(50)); // no button pressed
        QCOMPARE(blocks.back(), std::size_t{200});
    }

    void aTouchpadStepsAfterAWholeNotch() {
        TimelineScale scale;
        scale.resize(300, scale.sizeHint().height());
        scale.setBlockCount(100);
        QSignalSpy stepped(&scale, &TimelineScale::stepped);
        for (int k = 0; k < 16; ++k) {
            QWheelEvent event(QPointF(10, 10), scale.mapToGlobal(QPointF(10, 10)), {}, {0, -15}, Qt::NoButton,
                              Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(&scale, &event);
        }
        QCOMPARE(stepped.count(), 2);
        QCOMPARE(stepped.front().front().value<std::ptrdiff_t>(), std::ptrdiff_t{1});
    }

    /// Hidden behind a mark farther right, and among others on its pixel.
    void theWorstOfAPixelIsSeen() {
        TimelineScale scale;
        scale.resize(800, scale.sizeHint().height());
        scale.setBlockCount(100'000);
        constexpr auto kProblem = TimelineMark::Kind::problem;
        scale.setMarks({{100, kProblem, Severity::fault},
                        {90'000, kProblem, Severity::warning},
                        {50'000, kProblem, Severity::fault},
                        {50'010, kProblem, Severity::note},
                        {99, kProblem, Severity::note}});
        const QImage image = scale.grab().toImage();
        const QColor fault = severityColor(meaningColors(scale.palette()), Severity::fault);
        for (const std::size_t block : {100U, 50'000U})
            QCOMPARE(image.pixelColor(static_cast<int>(scale.positionOf(block)), 4), fault);
    }

    void theStripShowsARunAndSeeks() {
        Session session;
        const PlaybackCommands commands(session);
        TimelinePanel panel(session, commands);
        panel.resize(1400, panel.sizeHint().height());
        panel.show();
        QVERIFY(
            opened(session, QStringLiteral(PROVEOUT_SOURCE_DIR "/resources/samples/core-insert.proveout")));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kOpeningPatience);
        session.playback().seek(120);
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{120}, kOpeningPatience);
        TimelineScale& scale = panel.scale();
        constexpr int kInStrip = 28;
        const QColor ground = scale.palette().color(QPalette::Base);
        const auto middleOf = [&](std::size_t block) {
            return QPoint(static_cast<int>((scale.positionOf(block - 1) + scale.positionOf(block)) / 2),
                          kInStrip);
        };
        const auto ink = [&](std::size_t block) {
            return scale.grab().toImage().pixelColor(middleOf(block));
        };
        const auto cutting = meaningColors(scale.palette()).cutting;
        QTRY_COMPARE_WITH_TIMEOUT(ink(60), cutting, kOpeningPatience);
        QCOMPARE(ink(200), ground); // not simulated yet
        QTest::mouseClick(&scale, Qt::LeftButton, {},
                          QPoint(static_cast<int>(std::lround(scale.positionOf(200))), kInStrip));
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{200}, kOpeningPatience);
        QTRY_VERIFY_WITH_TIMEOUT(ink(190) != ground, kOpeningPatience);
        QHelpEvent help(QEvent::ToolTip, middleOf(60), scale.mapToGlobal(middleOf(60)));
        QApplication::sendEvent(&scale, &help);
        QVERIFY2(QToolTip::text().contains(QStringLiteral("Block 60: Cutting")),
                 qPrintable(QToolTip::text()));
    }

    /// For a program without tool calls.
    void theTipNamesTheToolThatIsAssumed() {
        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("p.nc")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("(T1 D=6. FLAT)\nG21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX20\nM30\n");
        file.close();
        Session session;
        const PlaybackCommands commands(session);
        TimelinePanel panel(session, commands);
        panel.resize(1400, panel.sizeHint().height());
        panel.show();
        QVERIFY(opened(session, file.fileName()));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kOpeningPatience);
        const auto tip = [&] {
            TimelineScale& scale = panel.scale();
            const QPoint place(static_cast<int>(scale.positionOf(2)), 12);
            QHelpEvent help(QEvent::ToolTip, place, scale.mapToGlobal(place));
            QApplication::sendEvent(&scale, &help);
            return QToolTip::text();
        };
        QVERIFY2(tip().contains(QStringLiteral("line 4 · T1 (assumed)")), qPrintable(tip()));
        Setup setup = session.job().setup();
        setup.startTool = 1;
        QSignalSpy read(&session.program(), &ProgramHub::changed);
        QVERIFY(session.job().setSetup(setup).has_value());
        QTRY_VERIFY_WITH_TIMEOUT(!read.isEmpty(), kOpeningPatience);
        QVERIFY2(tip().contains(QStringLiteral("line 4 · T1<")) || tip().contains(QStringLiteral("T1</p>")),
                 qPrintable(tip()));
        setup.startTool = 0;
        read.clear();
        QVERIFY(session.job().setSetup(setup).has_value());
        QTRY_VERIFY_WITH_TIMEOUT(!read.isEmpty(), kOpeningPatience);
        QVERIFY2(tip().contains(QStringLiteral("line 4 · no tool")), qPrintable(tip()));
    }

    /// The machine time by tool.
    void theTimeNamesTheToolThatIsAssumed() {
        MachineTimes times;
        times.tools = {{0, {}, 0}, {1, {}, 0}};
        Setup setup;
        setup.tools.set(0, parseCutter("flat:d=3").value());
        setup.tools.set(1, parseCutter("flat:d=4").value());
        const auto program = interpret(NcText("G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\nT1 M6\nG1 X5\n"));
        const auto lines = [&] {
            return timeTip(times, false, ToolChoice(*program, setup), setup.tools).split(u'\n').mid(2);
        };
        QCOMPARE(lines(),
                 QStringList({QStringLiteral("T0 (assumed): 0:00:00"), QStringLiteral("T1: 0:00:00")}));
        setup.tools.remove(0);
        QCOMPARE(lines().front(), QStringLiteral("no tool: 0:00:00"));
    }

    void aLagIsReportedInPlainNumbersAndMovesNothing() {
        Session session;
        const PlaybackCommands commands(session);
        TimelinePanel panel(session, commands);
        panel.resize(1280, panel.sizeHint().height());
        panel.show();
        auto frame = std::make_shared<Frame>();
        frame->program = std::make_shared<const Program>();
        frame->playing = true;
        auto& lag = *panel.findChild<QLabel*>(QStringLiteral("playback-lag"));
        emit session.playback().tick(frame); // keeps up with its speed
        QVERIFY(!lag.isVisible());
        const QRect before = panel.scale().geometry();
        session.playback().setSpeed(1000 * kUnitBlocksPerSecond);
        for (const auto& [kept, reported] : {std::pair{0.5, "500×"},
                                             {0.1234, "120×"},
                                             {0.0012, "1.2×"},
                                             {0.00004, "0.040×"},
                                             {0.94, "940×"}}) {
            frame->keptSpeed = kept;
            emit session.playback().tick(frame);
            QVERIFY(lag.isVisible());
            QVERIFY2(lag.text().endsWith(u' ' + QString::fromUtf8(reported)), qPrintable(lag.text()));
            QCoreApplication::processEvents();
            QCOMPARE(panel.scale().geometry(), before);
        }
    }

    void clocksShowAnyTime() {
        QCOMPARE(clockText(3723.4), QStringLiteral("1:02:03"));
        for (const double seconds : {1e10, 1e300, std::numeric_limits<double>::infinity()})
            QCOMPARE(clockText(seconds), QStringLiteral("> 999999:59:59"));
    }

    void anEmptyRangeDoesNothing() {
        TimelineScale scale;
        scale.resize(300, scale.sizeHint().height());
        QSignalSpy scrubbed(&scale, &TimelineScale::scrubbed);
        QTest::mouseClick(&scale, Qt::LeftButton, {}, QPoint(150, 12));
        QCOMPARE(scrubbed.count(), 0);
        const QImage without = scale.grab().toImage();
        scale.setMarks({{0, TimelineMark::Kind::toolChange, Severity::note}});
        QVERIFY(scale.grab().toImage() != without);
    }
};

} // namespace proveout

QTEST_MAIN(proveout::TimelineTest)
#include "timeline_test.moc"
