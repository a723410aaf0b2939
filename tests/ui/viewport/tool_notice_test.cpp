// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/tool_notice.h"

#include <algorithm>

#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "tests/ui/opened.h"

namespace proveout {
namespace {

constexpr int kPatience = 20'000; ///< ms

/// A session with a notice over a plain widget in place of the view.
struct Bench {
    QTemporaryDir folder;
    Session session;
    QWidget view;
    ToolNotice notice{session, &view};

    bool open(const QByteArray& text) {
        const QString name = folder.filePath(QStringLiteral("p.nc"));
        QFile file(name);
        const bool written = file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
        file.close();
        return written && opened(session, name) &&
               QTest::qWaitFor([this] { return session.simulation().frame() != nullptr; }, kPatience);
    }
    /// Plays to the end, so that all findings are complete.
    bool finish() {
        session.playback().seek(session.program().blockCount());
        return QTest::qWaitFor(
            [this] {
                return session.simulation().block() == session.program().blockCount() &&
                       !session.work().current();
            },
            kPatience);
    }
    [[nodiscard]] QString text() const {
        return notice.findChild<QLabel*>(QStringLiteral("noticeText"))->text();
    }
    void click(const char* name) {
        QTest::mouseClick(notice.findChild<QPushButton*>(QLatin1String(name)), Qt::LeftButton);
    }
    [[nodiscard]] bool isShown() const { return !notice.isHidden(); }
    [[nodiscard]] bool has(Severity severity) const {
        const Diagnostics& problems = session.problems().all();
        return std::ranges::any_of(problems, [&](const Diagnostic& d) { return d.severity == severity; });
    }
};

/// Contains rapids into the stock.
const char* const kMissing = "G21 G90\nT3 M6\nG0 X0 Y0 Z5\nG1 Z-2 F100\nX20\nG0 X0\nZ5\nM30\n";
const char* const kCommented =
    "(T3 D=6. CR=0. - FLAT END MILL)\nG21 G90\nT3 M6\nG0 X0 Y0 Z5\nG1 Z-2 F100\nX20\nG0 X0 Y20\nZ5\nM30\n";

} // namespace

class ToolNoticeTest : public QObject {
    Q_OBJECT

private slots:
    void saysWhyNothingIsCutAndMendsIt() {
        Bench bench;
        QVERIFY(bench.open(kMissing));
        QTRY_VERIFY(bench.isShown());
        QCOMPARE(bench.text(),
                 QStringLiteral("Nothing is cut. T3 is not in the tool table; its moves are not "
                                "simulated."));
        QVERIFY(!bench.session.problems().all().empty()); // so the panel does not show "No problems"

        QSignalSpy asked(&bench.session.navigation(), &NavigationHub::toolRequested);
        bench.click("toolNoticeDefine");
        QCOMPARE(asked.size(), 1);
        QCOMPARE(asked[0][0].toInt(), 3);

        bench.click("toolNoticeMend");
        const ToolTable& tools = bench.session.job().setup().tools;
        QVERIFY(tools.find(3) != nullptr);
        QCOMPARE(tools.unconfirmedOrigin(3)->source, ToolSource::assumed);
        QVERIFY(bench.finish());
        QVERIFY(bench.session.simulation().frame()->removedMm3 > 0);
        QVERIFY(bench.isShown());
        QVERIFY(bench.text().startsWith(QStringLiteral("The sizes of T3 are assumed")));
        QVERIFY(!bench.has(Severity::fault));
        QVERIFY(bench.has(Severity::warning));
    }

    void aProgramThatCallsNoToolIsReported() {
        Bench bench;
        QVERIFY(bench.open("G21 G90\nG0 X0 Y0 Z5\nG1 Z-2 F100\nX20\nM30\n"));
        QTRY_VERIFY(bench.isShown());
        QCOMPARE(bench.text(),
                 QStringLiteral("Nothing is cut. The program calls no tool; its moves are not simulated."));
        QVERIFY(bench.open("G21 G90\nG0 X0 Y0 Z5\nG1 Z-2 F100\nT3 M6\nX20\nM30\n"));
        QTRY_VERIFY(bench.text().contains(QStringLiteral("cuts before it calls a tool")));
    }

    void aToolOfACommentIsUsedAtOnceAndConfirmed() {
        Bench bench;
        QVERIFY(bench.open(kCommented));
        QVERIFY(!bench.session.document().modified());
        QCOMPARE(bench.session.job().setup().tools.find(3)->spec(), std::string("flat:d=6"));
        QVERIFY(bench.finish());
        QVERIFY(bench.session.simulation().frame()->removedMm3 > 0);
        QTRY_VERIFY(bench.isShown());
        QVERIFY(bench.text().startsWith(QStringLiteral("T3 was read from the comment in line 1")));
        QVERIFY(!bench.has(Severity::fault)); // the rapid cuts with an unconfirmed tool
        QVERIFY(bench.has(Severity::warning));

        bench.click("toolNoticeMend");
        QVERIFY(bench.session.job().setup().tools.unconfirmed().empty());
        QTRY_VERIFY_WITH_TIMEOUT(bench.has(Severity::fault), kPatience);
        QVERIFY(!bench.isShown());
    }

    void aGivenToolOutranksTheComment() {
        Bench bench;
        QVERIFY(bench.open(kCommented));
        Setup setup = bench.session.job().setup();
        setup.tools.set(3, parseCutter("ball:d=4").value());
        QVERIFY(bench.session.job().setSetup(setup).has_value());
        bench.session.document().applyEdit(0, 0, "(T3 D=8. FLAT)\n");
        QSignalSpy read(&bench.session.program(), &ProgramHub::changed);
        QTRY_VERIFY_WITH_TIMEOUT(!read.isEmpty(), kPatience);
        QCOMPARE(bench.session.job().setup().tools.find(3)->spec(), std::string("ball:d=4"));
    }

    void aRemovedToolStaysAwayWhenTheProgramIsEdited() {
        Bench bench;
        QVERIFY(bench.open(kCommented));
        Setup setup = bench.session.job().setup();
        setup.tools.remove(3);
        QVERIFY(bench.session.job().setSetup(setup).has_value());
        QSignalSpy read(&bench.session.program(), &ProgramHub::changed);
        bench.session.document().applyEdit(0, 0, "(shifted)\n");
        QTRY_VERIFY_WITH_TIMEOUT(!read.isEmpty(), kPatience);
        QVERIFY(bench.session.job().setup().tools.find(3) == nullptr);
        QTRY_VERIFY(bench.isShown());
        QVERIFY(bench.text().contains(QStringLiteral("T3 is not in the tool table")));
    }

    void isHiddenForAWhileOnlyWhereNothingIsMissing() {
        Bench bench;
        QVERIFY(bench.open(kCommented));
        QTRY_VERIFY(bench.isShown());
        QTest::mouseClick(bench.notice.findChild<QToolButton*>(), Qt::LeftButton);
        QVERIFY(!bench.isShown());
        Setup setup = bench.session.job().setup();
        setup.tools.remove(3);
        QVERIFY(bench.session.job().setSetup(setup).has_value());
        QVERIFY(bench.isShown());
    }

    void staysInTheViewAndOutOfItsWay() {
        Bench bench;
        QVERIFY(bench.open(kMissing));
        for (const QSize size : {QSize(1000, 700), QSize(300, 220)}) {
            bench.view.resize(size);
            bench.view.show();
            QVERIFY(QTest::qWaitForWindowExposed(&bench.view));
            QVERIFY(bench.view.rect().contains(bench.notice.geometry()));
            QVERIFY(bench.notice.geometry().top() > bench.view.height() / 3);
        }
    }
};

} // namespace proveout

QTEST_MAIN(proveout::ToolNoticeTest)
#include "tool_notice_test.moc"
