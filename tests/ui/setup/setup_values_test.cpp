// SPDX-License-Identifier: GPL-3.0-or-later
// Form and simulation never differ: start, grid, a stock without its file, numbers out of range.
#include <algorithm>
#include <string_view>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/opened.h"
#include "ui/setup/setup_panel.h"
#include "ui/tuning/tuning_panel.h"

namespace proveout {
namespace {

constexpr int kPatience = 10'000; ///< ms

const char* const kUncalled = "G21 G90\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX30\nG0 Z5\nM30\n";

/// An open program that calls no tool, with a small stock and T1, a 4 mm cutter.
struct Opened {
    QTemporaryDir folder;
    Session session;
    SetupPanel panel{session};

    bool open(const QByteArray& text = kUncalled) {
        QFile file(folder.filePath(QStringLiteral("p.nc")));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            return false;
        file.close();
        panel.resize(400, 900);
        panel.show();
        if (!QTest::qWaitForWindowExposed(&panel) || !opened(session, file.fileName()) ||
            !QTest::qWaitFor([this] { return session.simulation().frame() != nullptr; }, kPatience))
            return false;
        Setup setup = session.job().setup();
        setup.stock = {Vec3(0), 40, 30, 10};
        setup.automaticGrid = false;
        setup.spacing = 0.5;
        setup.tools.set(1, parseCutter("flat:d=4,l=20").value());
        return session.job().setSetup(setup).has_value() && settled();
    }
    /// Waits until the newest frame has the current setup.
    bool settled() {
        return QTest::qWaitFor(
            [this] {
                return session.simulation().frame() &&
                       *session.simulation().frame()->setup == session.job().setup();
            },
            kPatience);
    }
    template<class Widget>
    Widget& find(const char* name) {
        return *panel.findChild<Widget*>(QLatin1String(name));
    }
    bool reports(const char* id) const {
        return std::ranges::any_of(session.problems().all(),
                                   [id](const Diagnostic& d) { return std::string_view(d.id) == id; });
    }
    /// Whether the panel shows a sentence.
    bool shows(const QString& text) const {
        return std::ranges::any_of(panel.findChildren<QLabel*>(), [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(text);
        });
    }
};

void type(QWidget& box, const QString& text) {
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
}

} // namespace

class SetupValuesTest : public QObject {
    Q_OBJECT

private slots:
    void theToolAtStartIsAssumedUntilOneIsChosen() {
        Opened at;
        QVERIFY(at.open());
        auto& tool = at.find<QComboBox>("start-tool");
        QTRY_COMPARE_WITH_TIMEOUT(tool.currentText(), QStringLiteral("Not set: T1 is assumed"), kPatience);
        QVERIFY(at.reports("tool-assumed"));
        QVERIFY(at.session.simulation().frame()->toolAssumed);
        tool.setFocus();
        QTest::keyClick(&tool, Qt::Key_Down); // the empty spindle
        QTRY_COMPARE_WITH_TIMEOUT(at.session.job().setup().startTool, std::optional(0), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(at.reports("no-tool"), kPatience);
        QTest::keyClick(&tool, Qt::Key_Down);
        QTRY_COMPARE_WITH_TIMEOUT(at.session.job().setup().startTool, std::optional(1), kPatience);
        QCOMPARE(tool.currentText(), QStringLiteral("T1"));
        QTRY_VERIFY_WITH_TIMEOUT(at.settled() && at.session.simulation().frame()->tool == 1, kPatience);
        QVERIFY(!at.session.simulation().frame()->toolAssumed);
        QVERIFY(!at.reports("tool-assumed") && !at.reports("no-tool"));

        const QString job = at.folder.filePath(QStringLiteral("p.proveout"));
        QVERIFY(at.session.document().saveJobAs(job));
        Opened other;
        QVERIFY(opened(other.session, job));
        QCOMPARE(other.find<QComboBox>("start-tool").currentText(), QStringLiteral("T1"));
    }

    void theStartPositionIsTypedAndForgotten() {
        Opened at;
        QVERIFY(at.open());
        auto& known = at.find<QCheckBox>("start-known");
        auto& z = at.find<QDoubleSpinBox>("start-z");
        QVERIFY(!z.isVisible() && !known.isChecked());
        known.setFocus();
        QTest::keyClick(&known, Qt::Key_Space);
        QVERIFY(z.isVisible());
        type(z, QStringLiteral("12.5"));
        QTRY_VERIFY_WITH_TIMEOUT(at.session.job().setup().start == std::optional(Vec3(0, 0, 12.5)),
                                 kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(
            at.session.program().current() && at.session.program().current()->motion(0).known(), kPatience);
        QTest::keyClick(&known, Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(!at.session.job().setup().start, kPatience);
    }

    void theGridIsAutomaticUntilASpacingIsTyped() {
        Opened at;
        TuningPanel tuning(at.session);
        QVERIFY(at.open());
        auto& automatic = at.find<QCheckBox>("spacing-automatic");
        auto& spacing = at.find<QDoubleSpinBox>("spacing");
        QVERIFY(!automatic.isChecked());
        automatic.setFocus();
        QTest::keyClick(&automatic, Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(at.session.job().setup().automaticGrid, kPatience);
        QVERIFY(at.session.job().setup().spacing <= 0.4); // a tenth of the cutter's diameter
        QCOMPARE(spacing.value(), at.session.job().setup().spacing);
        QVERIFY(tuning.findChild<QCheckBox*>(QStringLiteral("grid-automatic"))->isChecked());
        // A smaller cutter makes the grid finer.
        const double before = at.session.job().setup().spacing;
        Setup setup = at.session.job().setup();
        setup.tools.set(1, parseCutter("flat:d=0.2").value());
        QVERIFY(at.session.job().setSetup(setup).has_value());
        QVERIFY(at.session.job().setup().spacing < before);
        QCOMPARE(spacing.value(), at.session.job().setup().spacing);

        type(spacing, QStringLiteral("2"));
        QVERIFY(!automatic.isChecked());
        QTRY_COMPARE_WITH_TIMEOUT(at.session.job().setup().spacing, 2.0, kPatience);
        QVERIFY(!at.session.job().setup().automaticGrid);
        QTRY_VERIFY_WITH_TIMEOUT(at.reports("grid-coarse"), kPatience);
    }

    void aNewProgramHasAnAutomaticGrid() {
        Opened at;
        Session& session = at.session;
        QVERIFY(session.job().setup().automaticGrid);
        QVERIFY(at.open());
        session.document().newFile();
        QVERIFY(session.job().setup().automaticGrid);
    }

    void aShapeWithoutItsFileSaysSoAndNothingIsSimulatedUnderItsName() {
        Opened at;
        QVERIFY(at.open());
        auto& shape = at.find<QComboBox>("stock-shape");
        QVERIFY(at.session.simulation().frame() != nullptr);
        shape.setFocus();
        QTest::keyClick(&shape, Qt::Key_End); // a saved stock
        QTRY_COMPARE_WITH_TIMEOUT(at.session.job().setup().shape.kind, StockKind::saved, kPatience);
        QVERIFY(at.session.simulation().frame() == nullptr);
        QVERIFY(at.reports("stock-incomplete"));
        QVERIFY(at.shows(QStringLiteral("The stock has no file yet; nothing is simulated.")));
        // Also not under the name of a file that cannot be read.
        auto& file = at.find<QLineEdit>("stock-file-file");
        type(file, at.folder.filePath(QStringLiteral("none.pvstock")));
        QTRY_VERIFY_WITH_TIMEOUT(at.shows(QStringLiteral("none.pvstock")), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!at.session.job().setup().shape.file.empty(), kPatience);
        QVERIFY(at.session.simulation().frame() == nullptr);
        QTest::keyClick(&shape, Qt::Key_Home); // back to a box
        QVERIFY(at.settled());
        QVERIFY(!at.reports("stock-incomplete"));
        QVERIFY(!at.shows(QStringLiteral("nothing is simulated")));
    }

    void aNumberOutOfRangeIsRefusedWithItsRange_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("range");
        QTest::newRow("below zero") << "stock-width"
                                    << "-40"
                                    << "0.01 to 1,000,000";
        QTest::newRow("zero") << "stock-height"
                              << "0"
                              << "0.01 to 1,000,000";
        QTest::newRow("too large") << "stock-depth"
                                   << "99999999"
                                   << "0.01 to 1,000,000";
        QTest::newRow("too far") << "corner-x"
                                 << "123456789"
                                 << "-10,000,000 to 10,000,000";
        QTest::newRow("too fine") << "spacing"
                                  << "0"
                                  << "0.001 to 1,000";
        QTest::newRow("of the machine") << "rapidXY"
                                        << "0"
                                        << "1 to 1,000,000";
        QTest::newRow("of a parameter") << "allowance"
                                        << "1000"
                                        << "0 to 10 mm";
        QTest::newRow("a whole number") << "region"
                                        << "1000"
                                        << "2 to 256";
    }
    void aNumberOutOfRangeIsRefusedWithItsRange() {
        QFETCH(QString, name);
        QFETCH(QString, typed);
        QFETCH(QString, range);
        Opened at;
        TuningPanel tuning(at.session);
        tuning.show();
        QVERIFY(at.open());
        auto* box = at.panel.findChild<QAbstractSpinBox*>(name);
        if (box == nullptr)
            box = tuning.findChild<QAbstractSpinBox*>(name);
        QVERIFY(box != nullptr);
        const Setup setup = at.session.job().setup();
        const DecimationParameters parameters = at.session.job().parameters();
        const QString shown = box->text();
        connect(box, SIGNAL(refused(QString)), this, SLOT(noteRefusal(QString)));
        m_refused.clear();
        type(*box, typed);
        QVERIFY2(m_refused.contains(range), qPrintable(m_refused));
        QCOMPARE(box->text(), shown);
        QTest::qWait(400); // the delay after which edits are applied
        QVERIFY(at.session.job().setup() == setup);
        QVERIFY(at.session.job().parameters() == parameters);
        QVERIFY(!at.session.job().machine());
    }

    void noteRefusal(const QString& sentence) { m_refused = sentence; }

    void aGridThatIsRefusedLeavesTheFormAndBlocksNothing() {
        Opened at;
        QVERIFY(at.open());
        Setup wide = at.session.job().setup();
        wide.stock = {Vec3(0), 5000, 5000, 10}; // 25e12 points at 0.001 mm
        wide.spacing = 5;
        QVERIFY(at.session.job().setSetup(wide).has_value());
        auto& spacing = at.find<QDoubleSpinBox>("spacing");
        auto& blockDelete = *at.panel.findChildren<QCheckBox*>().front();
        QVERIFY(!at.session.job().setup().blockDelete);
        type(spacing, QStringLiteral("0.001"));
        blockDelete.setFocus();
        QTest::keyClick(&blockDelete, Qt::Key_Space); // together with the refused value
        QTRY_COMPARE_WITH_TIMEOUT(spacing.value(), 5.0, kPatience);
        QCOMPARE(at.session.job().setup().spacing, 5.0);
        QVERIFY(at.session.job().setup().blockDelete);
        QVERIFY(at.shows(QStringLiteral("memory")) || at.shows(QStringLiteral("points")));
        QVERIFY(at.settled());
        auto& z = at.find<QDoubleSpinBox>("corner-z");
        type(z, QStringLiteral("3"));
        QTRY_COMPARE_WITH_TIMEOUT(at.session.job().setup().stock.corner.z, 3.0, kPatience);
    }

    void aFineSpacingIsReadToItsLastDigit() {
        Opened at;
        QVERIFY(at.open());
        Setup tiny = at.session.job().setup();
        tiny.stock = {Vec3(0), 2, 2, 1};
        tiny.spacing = 0.0052;
        QVERIFY(at.session.job().setSetup(tiny).has_value());
        QCOMPARE(at.find<QDoubleSpinBox>("spacing").cleanText(), QStringLiteral("0.0052"));
        type(at.find<QDoubleSpinBox>("spacing"), QStringLiteral("0.0054"));
        QTRY_COMPARE_WITH_TIMEOUT(at.session.job().setup().spacing, 0.0054, kPatience);
    }

    /// The forms have the same limits as job files; a value beyond them is shown unchanged.
    void aValueFromAFileIsNotBent() {
        Opened at;
        QVERIFY(at.open());
        Setup setup = at.session.job().setup();
        setup.stock.width = 250'000;
        setup.spacing = 1500;
        setup.stock.depth = 3000;
        setup.stock.corner.x = -5e6;
        QVERIFY(at.session.job().setSetup(setup).has_value());
        auto& blockDelete = *at.panel.findChildren<QCheckBox*>().front();
        blockDelete.setFocus();
        QTest::keyClick(&blockDelete, Qt::Key_Space); // another edit applies all fields
        QTRY_VERIFY_WITH_TIMEOUT(!(at.session.job().setup() == setup), kPatience);
        QCOMPARE(at.session.job().setup().stock.width, 250'000.0);
        QCOMPARE(at.session.job().setup().spacing, 1500.0);
        QCOMPARE(at.session.job().setup().stock.corner.x, -5e6);
    }

private:
    QString m_refused;
};

} // namespace proveout

QTEST_MAIN(proveout::SetupValuesTest)
#include "setup_values_test.moc"
