// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/findings/problems_panel.h"

#include <map>
#include <string>
#include <vector>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>

#include "tests/ui/opened.h"
#include "ui/findings/problems_model.h"
#include "ui/findings/rules_dialog.h"
#include "ui/findings/waive_dialog.h"

namespace proveout {
namespace {

constexpr int kPatience = 20'000; ///< ms

/// It has no problems once its tool is defined.
const QByteArray kProgram =
    "G21 G90 G17\nT1 M6\nS1000 M3\nG43 H1\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX10\nG0 Z5\nM30\n";

/// Empty settings of its own.
struct OwnFolder {
    QTemporaryDir folder;

    OwnFolder() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
        QCoreApplication::setOrganizationName(QStringLiteral("Proveout"));
    }
};

struct Bench : OwnFolder {
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
    /// Two rapids cut 1 mm deep, in lines 8 and 10.
    bool openWithRapids() {
        return open("G21 G90 G17\nT1 M6\nS1000 M3\nG43 H1\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX10\nG0 Y10\nG1 X0\n"
                    "G0 Y20\nZ5\nM30\n") &&
               defineTool() &&
               QTest::qWaitFor([this] { return session.check().report() != nullptr; }, kPatience);
    }
    [[nodiscard]] QTreeView& list() const { return *panel.findChild<QTreeView*>(); }
    bool defineTool() {
        Setup setup = session.job().setup();
        setup.tools.set(1, parseCutter("flat:d=4,l=20").value());
        return session.job().setSetup(setup).has_value() &&
               QTest::qWaitFor([this] { return session.problems().all().empty(); }, kPatience);
    }
    /// Chooses an action of the context menu of a row.
    bool choose(int row, const char* action) {
        const QModelIndex index = list().model()->index(row, ProblemsModel::kSentence);
        list().scrollTo(index);
        emit list().customContextMenuRequested(list().visualRect(index).center());
        auto* menu = panel.findChild<QMenu*>();
        auto* found = menu == nullptr ? nullptr : menu->findChild<QAction*>(QLatin1String(action));
        if (found == nullptr)
            return false;
        menu->close();
        found->trigger();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return true;
    }
    [[nodiscard]] int rowOf(const char* id) const {
        for (int row = 0; row < list().model()->rowCount(); ++row)
            if (list().model()->index(row, ProblemsModel::kId).data().toString() == QLatin1String(id))
                return row;
        return -1;
    }
    [[nodiscard]] QString textOf(const char* id, int column) const {
        return list().model()->index(rowOf(id), column).data().toString();
    }
    [[nodiscard]] QLabel& label() const { return *panel.findChild<QLabel*>(QStringLiteral("nothing-found")); }
    [[nodiscard]] QString text() const { return label().isVisible() ? label().text() : QString(); }
};

} // namespace

class ProblemsPanelTest : public QObject {
    Q_OBJECT

private slots:
    void withoutACheckNothingFoundMeansAsFarAsWasLooked() {
        Bench bench;
        bench.session.check().setOn(false);
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

    void nothingFoundByTheCheckIsSaidWithoutPlaying() {
        Bench bench;
        QVERIFY(bench.open(kProgram));
        QVERIFY(bench.defineTool());
        QTRY_COMPARE_WITH_TIMEOUT(bench.text(), QStringLiteral("No problems found."), kPatience);
        QCOMPARE(bench.session.simulation().block(), std::size_t{0});
    }

    void repeatedFindingsAreOneRowAndTheWorstIsFirst() {
        Bench bench;
        QVERIFY(bench.openWithRapids());
        QTreeView& list = bench.list();
        const auto cell = [&](int row, int column) {
            return list.model()->index(row, column).data().toString();
        };
        QCOMPARE(cell(0, ProblemsModel::kId), QStringLiteral("rapid-cuts"));
        QCOMPARE(cell(0, ProblemsModel::kLine), QStringLiteral("8"));
        QCOMPARE(cell(0, ProblemsModel::kTool), QStringLiteral("T1"));
        QCOMPARE(cell(0, ProblemsModel::kSize), QStringLiteral("1 mm"));
        QCOMPARE(cell(0, ProblemsModel::kCount), QStringLiteral("2"));
        // What was not checked follows in any order.
        for (const Qt::SortOrder order : {Qt::AscendingOrder, Qt::DescendingOrder}) {
            list.sortByColumn(ProblemsModel::kSentence, order);
            const int last = list.model()->rowCount() - 1;
            QCOMPARE(cell(last, ProblemsModel::kSeverity), QStringLiteral("Not checked"));
            QCOMPARE(cell(0, ProblemsModel::kId), QStringLiteral("rapid-cuts"));
        }
    }

    void ofOneSeverityTheFirstLineIsFirst() {
        Bench bench;
        QVERIFY(bench.open("G21 G90 G17\nT1 M6\nS1000 M3\nG0 X0 Y0 Z5\nM987\nG1 Z-1 F100\nM986\nX10\nM985\n"
                           "G0 Z5\nM30\n"));
        const QAbstractItemModel& rows = *bench.list().model();
        std::vector<int> lines;
        for (int row = 0; row < rows.rowCount(); ++row)
            if (rows.index(row, ProblemsModel::kId).data().toString() == QLatin1String("code-unknown"))
                lines.push_back(rows.index(row, ProblemsModel::kLine).data().toInt());
        QCOMPARE(lines, (std::vector<int>{5, 7, 9}));
    }

    void theFilterShowsRowsWithItsTextOnly() {
        Bench bench;
        QVERIFY(bench.openWithRapids());
        auto* filter = bench.panel.findChild<QLineEdit*>(QStringLiteral("problem-filter"));
        const int all = bench.list().model()->rowCount();
        QVERIFY(all > 3);
        filter->setText(QStringLiteral("FIXTURES"));
        QCOMPARE(bench.list().model()->rowCount(), 1);
        filter->clear();
        QCOMPARE(bench.list().model()->rowCount(), all);
    }

    void aFindingLeadsToItsBlock() {
        Bench bench;
        QVERIFY(bench.openWithRapids());
        QSignalSpy lines(&bench.session.navigation(), &NavigationHub::lineRequested);
        bench.panel.goToNeighbour(1);
        QCOMPARE(lines.count(), 1);
        QCOMPARE(lines.front().front().toUInt(), 8U);
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.simulation().block(), std::size_t{4}, kPatience);
        bench.panel.goToNeighbour(1);
        QCOMPARE(lines.count(), 2); // what was not checked has no line, so it is the same one again
        QCOMPARE(lines.back().front().toUInt(), 8U);
    }

    void whatNeedNotBeCheckedIsAccepted() {
        Bench bench;
        QVERIFY(bench.openWithRapids());
        QTreeView& list = bench.list();
        const int last = list.model()->rowCount() - 1;
        const QModelIndex row = list.model()->index(last, ProblemsModel::kSentence);
        const std::string id = row.siblingAtColumn(ProblemsModel::kId).data().toString().toStdString();
        list.scrollTo(row);
        emit list.customContextMenuRequested(list.visualRect(row).center());
        auto* menu = bench.panel.findChild<QMenu*>();
        QVERIFY(menu != nullptr);
        menu->findChild<QAction*>(QStringLiteral("accept-unchecked"))->trigger();
        QVERIFY(bench.session.check().accepted().contains(id));
        QCOMPARE(list.model()->index(last, ProblemsModel::kSeverity).data().toString(),
                 QStringLiteral("Accepted"));
        menu->close();
        Session other; // the acceptance is kept
        const ProblemsPanel panel(other);
        QVERIFY(other.check().accepted().contains(id));
    }

    void aFindingIsWaivedWithAReasonAndAPerson() {
        Bench bench;
        QVERIFY(bench.openWithRapids());
        QCOMPARE(bench.session.check().report()->faults(), std::size_t{1});
        bool asked = false;
        QTimer::singleShot(0, [&] {
            auto* dialog = bench.panel.findChild<WaiveDialog*>();
            QVERIFY(dialog != nullptr);
            auto* waive = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
            QVERIFY(!waive->isEnabled());
            dialog->findChild<QLineEdit*>(QStringLiteral("waiver-reason"))->setText(QStringLiteral("a hole"));
            QVERIFY(!waive->isEnabled()); // nobody answers for it yet
            dialog->findChild<QLineEdit*>(QStringLiteral("waiver-owner"))->setText(QStringLiteral("M. Roth"));
            asked = waive->isEnabled();
            waive->click();
        });
        QVERIFY(bench.choose(0, "waive"));
        QVERIFY(asked);
        QCOMPARE(bench.session.check().report()->faults(), std::size_t{0});
        QCOMPARE(bench.textOf("rapid-cuts", ProblemsModel::kSeverity), QStringLiteral("Waived"));
        QCOMPARE(bench.textOf("rapid-cuts", ProblemsModel::kHint),
                 QStringLiteral("Waived by M. Roth: a hole"));
        QVERIFY(bench.panel.findChild<QLabel*>(QStringLiteral("problem-summary"))
                    ->text()
                    .startsWith(QStringLiteral("Waived: 1")));
        QVERIFY(bench.session.document().job().jobModified());
        bench.session.job().undoStep();
        QCOMPARE(bench.session.check().report()->faults(), std::size_t{1});
        bench.session.job().redoStep();
        QVERIFY(bench.choose(bench.rowOf("rapid-cuts"), "withdraw-waiver"));
        QCOMPARE(bench.session.check().report()->faults(), std::size_t{1});
    }

    void aWaiverWithoutItsFindingIsRemoved() {
        Bench bench;
        QVERIFY(bench.openWithRapids());
        CheckRules rules;
        rules.waivers = {{.finding = "air-cutting", .reason = "a", .owner = "b"},
                         {.finding = "full-slot", .reason = "c", .owner = "d"}};
        bench.session.job().setCheck(rules);
        QVERIFY(bench.choose(bench.rowOf("waiver-unused"), "remove-waiver"));
        QCOMPARE(bench.session.job().check().waivers.size(), std::size_t{1});
        QVERIFY(bench.choose(bench.rowOf("waiver-unused"), "remove-waiver"));
        QVERIFY(bench.session.job().check().waivers.empty());
        QCOMPARE(bench.rowOf("waiver-unused"), -1);
    }

    void rowsOfTheCheckBeforeStayInGreyUntilTheNextResult() {
        Bench bench;
        QVERIFY(bench.openWithRapids());
        const int rows = bench.list().model()->rowCount();
        const QModelIndex first =
            bench.list().model()->index(bench.rowOf("rapid-cuts"), ProblemsModel::kSentence);
        QVERIFY(!first.data(Qt::ForegroundRole).isValid());
        QSignalSpy lines(&bench.session.navigation(), &NavigationHub::lineRequested);
        const std::string text = bench.session.document().text().text.toString();
        bench.session.document().applyEdit(text.find("G0 Y10"), 2, "G1");
        QVERIFY(bench.session.check().report() == nullptr);
        QCOMPARE(bench.list().model()->rowCount(), rows);
        const QModelIndex same =
            bench.list().model()->index(bench.rowOf("rapid-cuts"), ProblemsModel::kSentence);
        QVERIFY(same.data(Qt::ForegroundRole).isValid());
        auto* summary = bench.panel.findChild<QLabel*>(QStringLiteral("problem-summary"));
        QVERIFY(summary->text().startsWith(QStringLiteral("Checking…")));
        emit bench.list().activated(same);
        QCOMPARE(lines.count(), 1); // its block may be another one, but its line is gone to
        QTRY_VERIFY_WITH_TIMEOUT(bench.session.check().report() != nullptr, kPatience);
        QVERIFY(!bench.list()
                     .model()
                     ->index(bench.rowOf("rapid-cuts"), ProblemsModel::kSentence)
                     .data(Qt::ForegroundRole)
                     .isValid());
        QVERIFY(!summary->text().startsWith(QStringLiteral("Checking…")));
    }

    void whatIsGoneIsSaidWhereNothingIsLeft() {
        Bench bench;
        QVERIFY(bench.open(kProgram));
        QVERIFY(bench.defineTool());
        QTRY_VERIFY_WITH_TIMEOUT(bench.session.check().report() != nullptr, kPatience);
        QCOMPARE(bench.text(), QStringLiteral("No problems found."));
        const auto edit = [&bench](const char* from, const char* to) {
            const std::string text = bench.session.document().text().text.toString();
            bench.session.document().applyEdit(text.find(from), std::string(from).size(), to);
            return QTest::qWaitFor([&bench] { return bench.session.check().report() != nullptr; }, kPatience);
        };
        QVERIFY(edit("G1 Z-1", "G0 Z-1"));
        QVERIFY(bench.rowOf("rapid-cuts") >= 0);
        QVERIFY(edit("G0 Z-1", "G1 Z-1"));
        QCOMPARE(bench.text(), QStringLiteral("No problems found (since the last check: 0 new, 1 gone)."));
        QVERIFY(bench.label().toolTip().startsWith(QStringLiteral("Gone: Line 6")));
    }

    void aWaiverOfAnotherCutterIsRemoved() {
        Bench bench;
        QVERIFY(bench.openWithRapids());
        const CheckReport& report = *bench.session.check().report();
        CheckRules rules;
        rules.waivers = {report.waiverOf(report.findings.front(), "a", "b")};
        rules.waivers.front().cutter = "drill:d=1,angle=118";
        bench.session.job().setCheck(rules);
        QCOMPARE(bench.session.check().report()->faults(), std::size_t{1});
        QVERIFY(
            bench.textOf("waiver-unused", ProblemsModel::kSentence).contains(QStringLiteral("drill:d=1")));
        QVERIFY(bench.choose(bench.rowOf("waiver-unused"), "remove-waiver"));
        QVERIFY(bench.session.job().check().waivers.empty());
    }

    void aRuleIsTurnedOffForTheJobOrATool() {
        Bench bench;
        QVERIFY(bench.openWithRapids());
        QVERIFY(bench.choose(0, "turn-off-for-tool"));
        QTRY_VERIFY_WITH_TIMEOUT(bench.session.check().report() != nullptr, kPatience);
        QCOMPARE(bench.session.check().report()->faults(), std::size_t{0});
        QVERIFY(bench.session.job().check().isOff("rapid-cuts", 1));
        QVERIFY(!bench.session.job().check().isOff("rapid-cuts", 2));
        bench.session.job().undoStep();
        QTRY_VERIFY_WITH_TIMEOUT(bench.session.check().report() != nullptr, kPatience);
        QCOMPARE(bench.session.check().report()->faults(), std::size_t{1});
    }

    void theRulesDialogKeepsWhatItDoesNotShow() {
        const CheckRules rules{
            .limits = {.rapidClearance = 2},
            .off = {{"full-slot:T3", "trochoidal"}, {"air-cutting", "known"}, {"of-later", ""}},
            .accepted = {{"probing", "by hand"}},
            .waivers = {{.finding = "rapid-cuts", .reason = "a", .owner = "b"}},
            .limitsOfTools = {{"table-collision:T3.belowStock", 4.00001}, {"of-later:T1.airSeconds", 3}}};
        const RulesDialog dialog(rules, nullptr);
        QCOMPARE(dialog.rules(), rules);
        auto& list = *dialog.findChild<QListWidget*>(QStringLiteral("rules"));
        for (int row = 0; row < list.count(); ++row)
            if (list.item(row)->toolTip() == QStringLiteral("air-cutting"))
                list.item(row)->setCheckState(Qt::Checked);
        CheckRules expected = rules;
        expected.off.erase("air-cutting");
        QCOMPARE(dialog.rules(), expected);
        dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults)->click();
        expected.off.clear();
        expected.limits = {};
        expected.limitsOfTools.clear();
        QCOMPARE(dialog.rules(), expected);
    }

    void theRulesDialogEditsLimitsOfSingleTools() {
        const RulesDialog dialog({.limitsOfTools = {{"air-cutting:T2.airSeconds", 5}}}, nullptr);
        auto& table = *dialog.findChild<QTableWidget*>(QStringLiteral("tool-limits"));
        QCOMPARE(table.rowCount(), 1);
        dialog.findChild<QPushButton*>(QStringLiteral("tool-limit-add"))->click();
        QCOMPARE(table.rowCount(), 2);
        qobject_cast<QSpinBox*>(table.cellWidget(1, 0))->setValue(7);
        auto& rule = *qobject_cast<QComboBox*>(table.cellWidget(1, 1));
        rule.setCurrentIndex(rule.findData(QStringLiteral("tap-feed")));
        auto& limit = *qobject_cast<QDoubleSpinBox*>(table.cellWidget(1, 2));
        QCOMPARE(limit.value(), RuleLimits().tapFeedError);
        limit.setValue(2.5);
        using Limits = std::map<std::string, double>;
        QCOMPARE(dialog.rules().limitsOfTools,
                 (Limits{{"air-cutting:T2.airSeconds", 5}, {"tap-feed:T7.tapFeedError", 2.5}}));
        qobject_cast<QToolButton*>(table.cellWidget(0, 3))->click();
        QCOMPARE(dialog.rules().limitsOfTools, (Limits{{"tap-feed:T7.tapFeedError", 2.5}}));
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
