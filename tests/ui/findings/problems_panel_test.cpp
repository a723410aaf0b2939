// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/findings/problems_panel.h"

#include <QFile>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include "tests/ui/opened.h"

namespace proveout {
namespace {

constexpr int kPatience = 20'000; ///< ms

/// It has no problems once its tool is defined.
const QByteArray kProgram =
    "G21 G90 G17\nT1 M6\nS1000 M3\nG43 H1\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX10\nG0 Z5\nM30\n";

struct Bench {
    QTemporaryDir folder;
    Session session;
    ProblemsPanel panel{session};

    Bench() { panel.show(); }
    bool open(const QByteArray& text) {
        const QString name = folder.filePath(QStringLiteral("p.nc"));
        QFile file(name);
        const bool written = file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
        file.close();
        return written && opened(session, name) &&
               QTest::qWaitFor([this] { return session.simulation().frame() != nullptr; }, kPatience);
    }
    bool defineTool() {
        Setup setup = session.job().setup();
        setup.tools.set(1, parseCutter("flat:d=4,l=20").value());
        return session.job().setSetup(setup).has_value() &&
               QTest::qWaitFor([this] { return session.problems().all().empty(); }, kPatience);
    }
    [[nodiscard]] QLabel& label() const { return *panel.findChild<QLabel*>(QStringLiteral("nothing-found")); }
    [[nodiscard]] QString text() const { return label().isVisible() ? label().text() : QString(); }
};

} // namespace

class ProblemsPanelTest : public QObject {
    Q_OBJECT

private slots:
    void nothingFoundMeansAsFarAsWasLooked() {
        Bench bench;
        QCOMPARE(bench.text(), QStringLiteral("Open a program to see its problems."));
        QVERIFY(bench.open(kProgram));
        QVERIFY(!bench.label().isVisible()); // its tool is missing
        QVERIFY(bench.defineTool());
        QTRY_COMPARE_WITH_TIMEOUT(
            bench.text(), QStringLiteral("Not simulated yet; no problems in the program text."), kPatience);
        QCOMPARE(bench.session.program().blockCount(), std::size_t{4});
        bench.session.playback().seek(2);
        QTRY_COMPARE_WITH_TIMEOUT(bench.text(), QStringLiteral("No problems up to block 2 of 4."), kPatience);
        bench.session.playback().seek(4);
        QTRY_COMPARE_WITH_TIMEOUT(bench.text(), QStringLiteral("No problems found."), kPatience);
        bench.session.playback().seek(1); // all blocks have been checked
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.simulation().block(), std::size_t{1}, kPatience);
        QTest::qWait(100);
        QCOMPARE(bench.text(), QStringLiteral("No problems found."));
        // An edit before the end: the part after it must be simulated again.
        bench.session.document().applyEdit(static_cast<std::size_t>(kProgram.indexOf("X10")), 3, "X12");
        QTRY_VERIFY_WITH_TIMEOUT(bench.text().startsWith(QStringLiteral("No problems up to block ")),
                                 kPatience);
        bench.session.playback().seek(4);
        QTRY_COMPARE_WITH_TIMEOUT(bench.text(), QStringLiteral("No problems found."), kPatience);
        bench.session.document().newFile();
        QVERIFY(bench.text() != QStringLiteral("No problems found."));
    }

    void aProgramThatIsStillReadIsNotFound() {
        Bench bench;
        bench.session.document().newFile();
        QCOMPARE(bench.text(), QStringLiteral("Reading the program; no problems so far."));
    }
};

} // namespace proveout

QTEST_MAIN(proveout::ProblemsPanelTest)
#include "problems_panel_test.moc"
