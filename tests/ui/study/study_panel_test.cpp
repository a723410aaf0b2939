// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep and an optimisation in the panel: drawn while they run, cancelled, exported.
#include <QFile>
#include <QImage>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/opened.h"
#include "ui/study/chart_view.h"
#include "ui/study/study_panel.h"
#include "ui/viewport/offscreen_drawing.h"

namespace proveout {
namespace {

constexpr int kLong = 120'000; ///< ms

Result<std::unique_ptr<DrawCost>> rated(QThread*) {
    return std::make_unique<RatedDrawing>();
}

QString program(int rows) {
    QString text = QStringLiteral("G21 G90\nT1 M6\nG0 X0 Y0 Z5\nG1 Z-2 F500\n");
    for (int row = 0; row < rows; ++row)
        text += QStringLiteral("Y%1\nX%2\n").arg(row).arg(row % 2 == 0 ? 60 : 0);
    return text + QStringLiteral("M30\n");
}

} // namespace

class StudyPanelTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    /// A session with a small job that is ready for a study.
    std::unique_ptr<Session> ready(int rows = 20, double grid = 1.0) {
        QFile nc(m_folder.filePath(QStringLiteral("a.nc")));
        [&] { QVERIFY(nc.open(QIODevice::WriteOnly)); }();
        nc.write(program(rows).toUtf8());
        nc.close();
        QFile job(m_folder.filePath(QStringLiteral("a.proveout")));
        [&] { QVERIFY(job.open(QIODevice::WriteOnly)); }();
        job.write(QStringLiteral(
                      R"({"proveout": 1, "program": "a.nc", "grid": %1, "tools": {"1": "ball:d=6,l=20"},
                      "stock": {"corner": [0, 0, 0], "width": 60, "depth": 40, "height": 10}})")
                      .arg(grid)
                      .toUtf8());
        job.close();
        auto session = std::make_unique<Session>();
        [&] {
            QVERIFY(opened(*session, job.fileName()));
            QTRY_VERIFY_WITH_TIMEOUT(session->program().blockCount() > 0, kLong);
        }();
        return session;
    }

private slots:
    void sweepsAreDrawnWhileTheyRun() {
        const auto session = ready();
        StudyPanel panel(*session, rated);
        QSignalSpy ran(&panel.runner(), &StudyRunner::ran);
        QSignalSpy ended(&panel.runner(), &StudyRunner::ended);
        panel.findChild<QPushButton*>(QStringLiteral("study-run"))->click();
        QVERIFY(panel.runner().busy());
        QTRY_VERIFY_WITH_TIMEOUT(ran.count() >= 3, kLong);
        QVERIFY(!panel.view().empty());
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kLong);
        QCOMPARE(ran.count(), static_cast<int>(studiedAllowances().size()));
        QCOMPARE(panel.view().chart().curves.front().points.size(), studiedAllowances().size());
        QVERIFY(!panel.runner().busy());

        for (const char* ending : {".svg", ".png", ".csv"}) {
            const QString file = m_folder.filePath(QStringLiteral("figure") + QLatin1String(ending));
            QVERIFY(panel.exportTo(file));
            QVERIFY(QFile(file).size() > 100);
        }
        QCOMPARE(QImage(m_folder.filePath(QStringLiteral("figure.png"))).width(), 1800);
    }

    void cancelsSoon() {
        const auto session = ready(80, 0.05); // each run takes much longer than the delivery of a signal
        StudyPanel panel(*session, rated);
        QSignalSpy ran(&panel.runner(), &StudyRunner::ran);
        QSignalSpy ended(&panel.runner(), &StudyRunner::ended);
        panel.findChild<QPushButton*>(QStringLiteral("study-run"))->click();
        QTRY_VERIFY_WITH_TIMEOUT(ran.count() >= 1, kLong);
        panel.runner().cancel();
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 5000);
        QVERIFY(ran.count() < static_cast<int>(studiedAllowances().size()));
        QVERIFY2(session->problems().all().empty(), "what the user asked for is no problem");
    }

    void endsWithThePanel() {
        const auto session = ready(400);
        StudyPanel panel(*session, rated);
        panel.findChild<QPushButton*>(QStringLiteral("study-run"))->click();
        QVERIFY(panel.runner().busy());
    }

    void optimisingShowsPredictionAndReality() {
        const auto session = ready();
        StudyPanel panel(*session, rated);
        QSignalSpy ended(&panel.runner(), &StudyRunner::ended);
        QSignalSpy measured(&panel.runner(), &StudyRunner::measured);
        panel.findChild<QPushButton*>(QStringLiteral("study-optimise"))->click();
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kLong);
        QCOMPARE(measured.count(), 1);
        QVERIFY(panel.view().chart().curves.size() >= 4U);
    }

    void drawsWithTheRendererOfTheViewport() {
        if (!OffscreenDrawing::create(64, 48))
            QSKIP("no OpenGL 3.3 here");
        const auto session = ready();
        StudyPanel panel(*session,
                         [](QThread* thread) { return OffscreenDrawing::create(160, 100, thread); });
        QSignalSpy ran(&panel.runner(), &StudyRunner::ran);
        QSignalSpy ended(&panel.runner(), &StudyRunner::ended);
        for (int round = 1; round <= 2; ++round) { // the second round uses another thread
            panel.findChild<QPushButton*>(QStringLiteral("study-run"))->click();
            QTRY_COMPARE_WITH_TIMEOUT(ended.count(), round, kLong);
        }
        QCOMPARE(ran.count(), 2 * static_cast<int>(studiedAllowances().size()));
        const auto run = ran.last().at(0).value<std::shared_ptr<const StudyRun>>();
        QVERIFY(run->seconds.draw > 0);
    }
};

} // namespace proveout

QTEST_MAIN(proveout::StudyPanelTest)
#include "study_panel_test.moc"
