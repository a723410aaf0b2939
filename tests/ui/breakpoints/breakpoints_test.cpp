// SPDX-License-Identifier: GPL-3.0-or-later
// Breakpoints and the machine's time, from the panel to the frame that stops.
#include <limits>
#include <memory>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include "tests/ui/opened.h"
#include "ui/breakpoints/breakpoints_panel.h"
#include "ui/kept_breakpoints.h"
#include "ui/session.h"

namespace proveout {
namespace {

constexpr int kPatience = 20'000;
const QString kSample = QStringLiteral(PROVEOUT_SOURCE_DIR "/resources/samples/core-insert.proveout");

Breakpoint atLine(std::uint32_t line, bool enabled = true) {
    Breakpoint breakpoint;
    breakpoint.line = line;
    breakpoint.enabled = enabled;
    return breakpoint;
}

std::vector<std::uint32_t> linesOf(const Session& session) {
    std::vector<std::uint32_t> lines;
    for (const Breakpoint& breakpoint : session.breakpoints())
        lines.push_back(breakpoint.line);
    return lines;
}

} // namespace

class BreakpointsTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder->path());
        QCoreApplication::setOrganizationName(QStringLiteral("Proveout"));
        QCoreApplication::setApplicationName(QStringLiteral("Proveout"));
    }

    void aRunStopsBeforeItsLineAndTellsWhy() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.frame() != nullptr, kPatience);
        const std::uint32_t line = session.program()->blockLine(120);
        session.toggleBreakpoint(line);
        QCOMPARE(linesOf(session), std::vector<std::uint32_t>{line});
        std::vector<std::size_t> stops;
        connect(&session, &Session::stoppedAt, this,
                [&](const BreakpointHit& hit) { stops.push_back(hit.block); });
        session.setSpeed(std::numeric_limits<double>::infinity());
        session.play();
        QTRY_VERIFY_WITH_TIMEOUT(!session.playback().playing, kPatience);
        QCOMPARE(session.block(), std::size_t{120});
        QCOMPARE(stops, std::vector<std::size_t>{120});
        session.play(); // goes on from there
        QTRY_VERIFY_WITH_TIMEOUT(!session.playback().playing, kPatience);
        QCOMPARE(session.block(), session.blockCount());
        QCOMPARE(stops.size(), std::size_t{1});
        session.toggleBreakpoint(line);
        QVERIFY(session.breakpoints().empty());
    }

    void breakpointsHoldThroughALoad() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.frame() != nullptr, kPatience);
        session.toggleBreakpoint(session.program()->blockLine(50));
        Setup setup = session.setup();
        setup.automaticGrid = false;
        setup.spacing = 2; // another map is loaded
        QVERIFY(session.setSetup(setup).has_value());
        session.setSpeed(std::numeric_limits<double>::infinity());
        session.play();
        QTRY_VERIFY_WITH_TIMEOUT(!session.playback().playing, kPatience);
        QCOMPARE(session.block(), std::size_t{50});
    }

    void editsMoveThemAlong() {
        Session session;
        const std::vector<Breakpoint> before{atLine(3), atLine(5), atLine(9)};
        const auto after = [&](std::uint32_t line, bool fromItsStart, std::ptrdiff_t added) {
            session.setBreakpoints(before);
            session.moveBreakpoints(line, fromItsStart, added);
            return linesOf(session);
        };
        using Lines = std::vector<std::uint32_t>;
        QCOMPARE(after(5, true, 2), (Lines{3, 7, 11})); // whole lines before line 5
        QCOMPARE(after(5, false, 2), (Lines{3, 5, 11}));
        QCOMPARE(after(4, true, -1), (Lines{3, 4, 8}));
        QCOMPARE(after(5, true, -1), (Lines{3, 8}));  // line 5 itself
        QCOMPARE(after(4, false, -1), (Lines{3, 8})); // it becomes the end of line 4
        QCOMPARE(after(1, true, -20), Lines{});
    }

    void theMachinesTimeIsToldAndPlayedBy() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.frame() != nullptr && session.times() != nullptr, kPatience);
        const double assumed = session.times()->parts.total();
        QVERIFY(assumed > 60);
        QVERIFY(!session.machine());
        Machine slow;
        slow.largestFeed = 100;
        QSignalSpy changed(&session, &Session::timesChanged);
        session.setMachine(slow);
        QVERIFY(session.jobModified());
        QTRY_VERIFY_WITH_TIMEOUT(!changed.empty(), kPatience);
        QVERIFY(session.times()->parts.total() > assumed);
        session.setPlayBy(PlayBy::time);
        QCOMPARE(session.playback().unitsPerSecond, 1.0);
        session.setSpeed(1e6);
        session.play();
        QTRY_VERIFY_WITH_TIMEOUT(!session.playback().playing, kPatience);
        QCOMPARE(session.block(), session.blockCount());
    }

    void thePanelAddsSwitchesAndRemoves() {
        Session session;
        BreakpointsPanel panel(session);
        panel.show();
        auto* kind = panel.findChild<QComboBox*>("breakpoint-kind");
        auto* add = panel.findChild<QPushButton*>("breakpoint-add");
        auto* condition = panel.findChild<QLineEdit*>("breakpoint-condition");
        auto* problem = panel.findChild<QLabel*>("breakpoint-problem");
        auto* list = panel.findChild<QTreeWidget*>();
        QCOMPARE(kind->count(), static_cast<int>(breakpointRows().size()));
        kind->setCurrentIndex(static_cast<int>(BreakpointKind::toolChange));
        add->click();
        add->click(); // the same again is not two
        kind->setCurrentIndex(static_cast<int>(BreakpointKind::condition));
        condition->setText("Z < -20 & T == 3");
        add->click();
        QVERIFY(problem->isVisible());
        QVERIFY2(problem->text().contains("9"), qPrintable(problem->text()));
        condition->setText("Z < -20 && T == 3");
        add->click();
        QVERIFY(!problem->isVisible());
        QCOMPARE(session.breakpoints().size(), std::size_t{2});
        QCOMPARE(list->topLevelItemCount(), 2);
        list->topLevelItem(0)->setCheckState(0, Qt::Unchecked);
        QVERIFY(!session.breakpoints().front().enabled);
        list->topLevelItem(1)->setSelected(true);
        panel.findChild<QPushButton*>("breakpoint-remove")->click();
        QCOMPARE(session.breakpoints().size(), std::size_t{1});
        QCOMPARE(session.breakpoints().front().kind, BreakpointKind::toolChange);
    }

    void theyAreKeptForTheFile() {
        std::vector<Breakpoint> all{atLine(7), atLine(9, false)};
        for (const BreakpointRow& row : breakpointRows()) {
            Breakpoint breakpoint;
            breakpoint.kind = row.kind;
            if (row.value == BreakpointValue::line)
                breakpoint.line = 12;
            if (row.value == BreakpointValue::height)
                breakpoint.z = -20.125;
            if (row.value == BreakpointValue::condition)
                breakpoint.condition = "Z < -20 && T == 3";
            all.push_back(breakpoint);
        }
        QVERIFY(KeptBreakpoints::read(KeptBreakpoints::written(all)) == all);
        QVERIFY(KeptBreakpoints::read({"", "nothing on", "line"}).size() <= 1);
        {
            Session session;
            const KeptBreakpoints kept(session, nullptr);
            QVERIFY(opened(session, kSample));
            session.setBreakpoints(all);
        }
        Session session;
        const KeptBreakpoints kept(session, nullptr);
        QVERIFY(session.breakpoints().empty());
        QVERIFY(opened(session, kSample));
        QVERIFY(session.breakpoints() == all);
        session.newFile();
        QVERIFY(session.breakpoints().empty());
    }

    /// The same text under another name keeps its breakpoints, and has them under that name from then on.
    void savingUnderAnotherNameTakesThemAlong() {
        const QString first = m_folder->filePath(QStringLiteral("first.nc"));
        const QString second = m_folder->filePath(QStringLiteral("second.nc"));
        const QString third = m_folder->filePath(QStringLiteral("third.nc"));
        {
            Session session;
            const KeptBreakpoints kept(session, nullptr);
            session.newFile();
            session.applyEdit(0, 0, "G21 G90\nG0 X0\nX5\n");
            session.setBreakpoints({atLine(2)});
            QVERIFY(session.saveAs(first)); // it had no name
            QCOMPARE(linesOf(session), (std::vector<std::uint32_t>{2}));
            session.setBreakpoints({atLine(2), atLine(3, false)});
            QVERIFY(session.saveAs(second));
            QCOMPARE(linesOf(session), (std::vector<std::uint32_t>{2, 3}));
            session.setBreakpoints({atLine(3)});
            QVERIFY(session.saveBeside(FilePart::text)); // "Keep Both"
            QCOMPARE(linesOf(session), (std::vector<std::uint32_t>{3}));
            QVERIFY(session.saveAs(third));
            session.newFile();
            QVERIFY(session.breakpoints().empty());
            session.setBreakpoints({atLine(1)});
            session.newFile(); // another one, although it has no name either
            QVERIFY(session.breakpoints().empty());
        }
        Session session;
        const KeptBreakpoints kept(session, nullptr);
        QVERIFY(opened(session, first));
        QCOMPARE(linesOf(session), (std::vector<std::uint32_t>{2, 3}));
        QVERIFY(opened(session, second));
        QCOMPARE(linesOf(session), (std::vector<std::uint32_t>{3}));
        QVERIFY(opened(session, third));
        QCOMPARE(linesOf(session), (std::vector<std::uint32_t>{3}));
        session.reload();
        QVERIFY(openingIsOver(session));
        QCOMPARE(linesOf(session), (std::vector<std::uint32_t>{3}));
    }

    void addingOneThatIsSwitchedOffSwitchesItOn() {
        Session session;
        BreakpointsPanel panel(session);
        panel.show();
        auto* kind = panel.findChild<QComboBox*>("breakpoint-kind");
        auto* add = panel.findChild<QPushButton*>("breakpoint-add");
        auto* list = panel.findChild<QTreeWidget*>();
        for (const BreakpointKind each : {BreakpointKind::line, BreakpointKind::toolChange}) {
            session.setBreakpoints({});
            kind->setCurrentIndex(static_cast<int>(each));
            add->click();
            list->topLevelItem(0)->setCheckState(0, Qt::Unchecked);
            QVERIFY(!session.breakpoints().front().enabled);
            add->click();
            QCOMPARE(list->topLevelItemCount(), 1);
            QCOMPARE(list->topLevelItem(0)->checkState(0), Qt::Checked);
            QVERIFY(session.breakpoints().front().enabled);
        }
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

} // namespace proveout

QTEST_MAIN(proveout::BreakpointsTest)
#include "breakpoints_test.moc"
