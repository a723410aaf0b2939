// SPDX-License-Identifier: GPL-3.0-or-later
// Breakpoints and the machine time, from the panel to the frame at which playback stops.
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
#include "ui/files/kept_breakpoints.h"
#include "ui/session/session.h"

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
    for (const Breakpoint& breakpoint : session.breakpoints().all())
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

    void aRunStopsBeforeItsLineAndReportsWhy() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        const std::uint32_t line = session.program().current()->blockLine(120);
        session.breakpoints().toggle(line);
        QCOMPARE(linesOf(session), std::vector<std::uint32_t>{line});
        std::vector<std::size_t> stops;
        connect(&session.playback(), &PlaybackHub::stoppedAt, this,
                [&](const BreakpointHit& hit) { stops.push_back(hit.block); });
        session.playback().setSpeed(std::numeric_limits<double>::infinity());
        session.playback().play();
        QTRY_VERIFY_WITH_TIMEOUT(!session.playback().state().playing, kPatience);
        QCOMPARE(session.simulation().block(), std::size_t{120});
        QCOMPARE(stops, std::vector<std::size_t>{120});
        session.playback().play(); // continues from there
        QTRY_VERIFY_WITH_TIMEOUT(!session.playback().state().playing, kPatience);
        QCOMPARE(session.simulation().block(), session.program().blockCount());
        QCOMPARE(stops.size(), std::size_t{1});
        session.breakpoints().toggle(line);
        QVERIFY(session.breakpoints().all().empty());
    }

    void breakpointsHoldThroughALoad() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        session.breakpoints().toggle(session.program().current()->blockLine(50));
        Setup setup = session.job().setup();
        setup.automaticGrid = false;
        setup.spacing = 2; // loads another z-map
        QVERIFY(session.job().setSetup(setup).has_value());
        session.playback().setSpeed(std::numeric_limits<double>::infinity());
        session.playback().play();
        QTRY_VERIFY_WITH_TIMEOUT(!session.playback().state().playing, kPatience);
        QCOMPARE(session.simulation().block(), std::size_t{50});
    }

    void editsMoveThemAlong() {
        Session session;
        const std::vector<Breakpoint> before{atLine(3), atLine(5), atLine(9)};
        const auto after = [&](std::uint32_t line, bool fromItsStart, std::ptrdiff_t added) {
            session.breakpoints().set(before);
            session.breakpoints().move(line, fromItsStart, added);
            return linesOf(session);
        };
        using Lines = std::vector<std::uint32_t>;
        QCOMPARE(after(5, true, 2), (Lines{3, 7, 11})); // complete lines before line 5
        QCOMPARE(after(5, false, 2), (Lines{3, 5, 11}));
        QCOMPARE(after(4, true, -1), (Lines{3, 4, 8}));
        QCOMPARE(after(5, true, -1), (Lines{3, 8}));  // line 5 itself
        QCOMPARE(after(4, false, -1), (Lines{3, 8})); // it becomes the end of line 4
        QCOMPARE(after(1, true, -20), Lines{});
    }

    void theMachinesTimeIsReportedAndPlayedBy() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(
            session.simulation().frame() != nullptr && session.program().times() != nullptr, kPatience);
        const double assumed = session.program().times()->parts.total();
        QVERIFY(assumed > 60);
        QVERIFY(!session.job().machine());
        Machine slow;
        slow.largestFeed = 100;
        QSignalSpy changed(&session.program(), &ProgramHub::timesChanged);
        session.job().setMachine(slow);
        QVERIFY(session.document().jobModified());
        QTRY_VERIFY_WITH_TIMEOUT(!changed.empty(), kPatience);
        QVERIFY(session.program().times()->parts.total() > assumed);
        session.playback().setPlayBy(PlayBy::time);
        QCOMPARE(session.playback().state().unitsPerSecond, 1.0);
        session.playback().setSpeed(1e6);
        session.playback().play();
        QTRY_VERIFY_WITH_TIMEOUT(!session.playback().state().playing, kPatience);
        QCOMPARE(session.simulation().block(), session.program().blockCount());
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
        add->click(); // an equal breakpoint is not added twice
        kind->setCurrentIndex(static_cast<int>(BreakpointKind::condition));
        condition->setText("Z < -20 & T == 3");
        add->click();
        QVERIFY(problem->isVisible());
        QVERIFY2(problem->text().contains("9"), qPrintable(problem->text()));
        condition->setText("Z < -20 && T == 3");
        add->click();
        QVERIFY(!problem->isVisible());
        QCOMPARE(session.breakpoints().all().size(), std::size_t{2});
        QCOMPARE(list->topLevelItemCount(), 2);
        list->topLevelItem(0)->setCheckState(0, Qt::Unchecked);
        QVERIFY(!session.breakpoints().all().front().enabled);
        list->topLevelItem(1)->setSelected(true);
        panel.findChild<QPushButton*>("breakpoint-remove")->click();
        QCOMPARE(session.breakpoints().all().size(), std::size_t{1});
        QCOMPARE(session.breakpoints().all().front().kind, BreakpointKind::toolChange);
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
            session.breakpoints().set(all);
        }
        Session session;
        const KeptBreakpoints kept(session, nullptr);
        QVERIFY(session.breakpoints().all().empty());
        QVERIFY(opened(session, kSample));
        QVERIFY(session.breakpoints().all() == all);
        session.document().newFile();
        QVERIFY(session.breakpoints().all().empty());
    }

    /// A text saved under another name keeps its breakpoints, and from then on they are stored under that
    /// name.
    void savingUnderAnotherNameTakesThemAlong() {
        const QString first = m_folder->filePath(QStringLiteral("first.nc"));
        const QString second = m_folder->filePath(QStringLiteral("second.nc"));
        const QString third = m_folder->filePath(QStringLiteral("third.nc"));
        {
            Session session;
            const KeptBreakpoints kept(session, nullptr);
            session.document().newFile();
            session.document().applyEdit(0, 0, "G21 G90\nG0 X0\nX5\n");
            session.breakpoints().set({atLine(2)});
            QVERIFY(session.document().saveAs(first)); // it had no name before
            QCOMPARE(linesOf(session), (std::vector<std::uint32_t>{2}));
            session.breakpoints().set({atLine(2), atLine(3, false)});
            QVERIFY(session.document().saveAs(second));
            QCOMPARE(linesOf(session), (std::vector<std::uint32_t>{2, 3}));
            session.breakpoints().set({atLine(3)});
            QVERIFY(session.document().saveBeside(FilePart::text)); // "Keep Both"
            QCOMPARE(linesOf(session), (std::vector<std::uint32_t>{3}));
            QVERIFY(session.document().saveAs(third));
            session.document().newFile();
            QVERIFY(session.breakpoints().all().empty());
            session.breakpoints().set({atLine(1)});
            session.document().newFile(); // another document, although it has no name either
            QVERIFY(session.breakpoints().all().empty());
        }
        Session session;
        const KeptBreakpoints kept(session, nullptr);
        QVERIFY(opened(session, first));
        QCOMPARE(linesOf(session), (std::vector<std::uint32_t>{2, 3}));
        QVERIFY(opened(session, second));
        QCOMPARE(linesOf(session), (std::vector<std::uint32_t>{3}));
        QVERIFY(opened(session, third));
        QCOMPARE(linesOf(session), (std::vector<std::uint32_t>{3}));
        session.document().reload();
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
            session.breakpoints().set({});
            kind->setCurrentIndex(static_cast<int>(each));
            add->click();
            list->topLevelItem(0)->setCheckState(0, Qt::Unchecked);
            QVERIFY(!session.breakpoints().all().front().enabled);
            add->click();
            QCOMPARE(list->topLevelItemCount(), 1);
            QCOMPARE(list->topLevelItem(0)->checkState(0), Qt::Checked);
            QVERIFY(session.breakpoints().all().front().enabled);
        }
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

} // namespace proveout

QTEST_MAIN(proveout::BreakpointsTest)
#include "breakpoints_test.moc"
