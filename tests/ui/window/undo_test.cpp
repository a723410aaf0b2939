// SPDX-License-Identifier: GPL-3.0-or-later
// Undo and redo in the window: in the text, or in setup, tuning and machine, depending on the focus.
#include <memory>
#include <string>

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/cutter/shapes.h"
#include "tests/ui/window/workstation.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"

namespace proveout {
namespace {

/// The window with one of its boxes visible.
struct Bench {
    Workstation station{true};

    template<class Box = QDoubleSpinBox>
    Box& box(const char* dock, const char* name) {
        auto* panel = station.window.findChild<QDockWidget*>(QLatin1String(dock));
        panel->show();
        panel->raise();
        auto* found = panel->findChild<Box*>(QLatin1String(name));
        if (!QTest::qWaitFor([&] { return found->isVisible(); }, kPatience))
            qFatal("%s is not seen", name);
        found->setFocus();
        return *found;
    }
    /// Types a value like a user.
    static void type(QAbstractSpinBox& box, const QString& text) {
        box.selectAll();
        QTest::keyClicks(&box, text);
        QTest::keyClick(&box, Qt::Key_Return);
    }
    static void pressUndo(QWidget& widget) { QTest::keyClick(&widget, Qt::Key_Z, Qt::ControlModifier); }
    static void pressRedo(QWidget& widget) { QTest::keyClick(&widget, Qt::Key_Y, Qt::ControlModifier); }
    [[nodiscard]] QString undoText() const { return action("edit-undo").text().remove(u'&'); }
    [[nodiscard]] QString redoText() const { return action("edit-redo").text().remove(u'&'); }
    [[nodiscard]] QAction& action(const char* id) const { return *station.window.action(QLatin1String(id)); }
    void open(const QTemporaryDir& folder, const std::string& program) {
        QFile file(folder.filePath(QStringLiteral("p.nc")));
        if (!file.open(QIODevice::WriteOnly) ||
            file.write(program.data(), static_cast<qint64>(program.size())) < 0)
            qFatal("the program cannot be written");
        file.close();
        station.open(file.fileName());
    }
    Session& session() { return station.session; }
    double topZ() { return session().job().setup().stock.corner.z; }
};

/// A program that cuts with tools described in its comments.
std::string commented(const std::string& second, const std::string& third) {
    return "(T1 D10 FLAT)\n(T2 " + second + " FLAT)\n" + third +
           "G21 G90\nT1 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX30\nT2 M6\nG1 Y30\n" +
           (third.empty() ? "" : "T3 M6\nG1 X0\n") + "G0 Z5\nM30\n";
}

/// The button that resets the error allowance to its default.
QToolButton* resetOf(const Bench& bench) {
    for (QToolButton* button : bench.station.window.findChildren<QToolButton*>())
        if (button->accessibleName() == QStringLiteral("Reset Error allowance"))
            return button;
    qFatal("no button");
}

} // namespace

class UndoTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void aStepInTheSetupIsUndoneAndRedone() {
        Bench bench;
        auto& top = bench.box("dock-setup", "corner-z");
        const double before = bench.topZ();
        QVERIFY(!bench.action("edit-undo").isEnabled());
        Bench::type(top, QStringLiteral("-3"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.topZ(), -3.0, kPatience);
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Top Z"));
        QVERIFY(bench.session().document().modified());
        Bench::pressUndo(top);
        QCOMPARE(bench.topZ(), before);
        QCOMPARE(top.value(), before);
        QVERIFY(!bench.session().document().modified());
        QVERIFY(!bench.station.window.isWindowModified());
        QVERIFY(!bench.action("edit-undo").isEnabled());
        QCOMPARE(bench.redoText(), QStringLiteral("Redo Top Z"));
        Bench::pressRedo(top);
        QCOMPARE(bench.topZ(), -3.0);
        QVERIFY(bench.session().document().modified());
        QTest::keyClick(&top, Qt::Key_Z, Qt::ControlModifier);
        QTest::keyClick(&top, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(bench.topZ(), -3.0);
        // The simulation uses it.
        QTRY_VERIFY_WITH_TIMEOUT(bench.session().simulation().frame() &&
                                     bench.session().simulation().frame()->setup->stock.corner.z == -3.0,
                                 kPatience);
    }

    void stepsInOneBoxAreOneAndThoseInTwoAreTwo() {
        Bench bench;
        auto& top = bench.box("dock-setup", "corner-z");
        const double before = bench.topZ();
        for (int i = 1; i <= 3; ++i) {
            QTest::keyClick(&top, Qt::Key_Up);
            QTRY_COMPARE_WITH_TIMEOUT(bench.topZ(), before + i, kPatience);
        }
        auto& left = bench.box("dock-setup", "corner-x");
        const double leftBefore = left.value();
        QTest::keyClick(&left, Qt::Key_Up);
        QTRY_COMPARE_WITH_TIMEOUT(bench.session().job().setup().stock.corner.x, leftBefore + 1, kPatience);
        Bench::pressUndo(left);
        QCOMPARE(bench.session().job().setup().stock.corner.x, leftBefore);
        QCOMPARE(bench.topZ(), before + 3);
        Bench::pressUndo(left);
        QCOMPARE(bench.topZ(), before);
        QVERIFY(!bench.action("edit-undo").isEnabled());
    }

    void aStepThatIsStillHeldBackIsUndoneToo() {
        Bench bench;
        auto& top = bench.box("dock-setup", "corner-z");
        const double before = bench.topZ();
        Bench::type(top, QStringLiteral("-3"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.topZ(), -3.0, kPatience);
        auto& left = bench.box("dock-setup", "corner-x");
        const double leftBefore = left.value();
        QTest::keyClick(&left, Qt::Key_Up);
        Bench::pressUndo(left); // immediately
        QCOMPARE(left.value(), leftBefore);
        QCOMPARE(bench.topZ(), -3.0);
        QTest::qWait(400);
        QCOMPARE(bench.session().job().setup().stock.corner.x, leftBefore);
        Bench::pressUndo(left);
        QCOMPARE(bench.topZ(), before);
    }

    void tuningAndMachineHaveUndo() {
        Bench bench;
        auto& allowance = bench.box("dock-tuning", "allowance");
        const double before = bench.session().job().parameters().allowance;
        Bench::type(allowance, QStringLiteral("0.5"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.session().job().parameters().allowance, 0.5, kPatience);
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Error allowance"));
        auto& method = bench.box<QComboBox>("dock-tuning", "method");
        const DecimationParameters withMethod = bench.session().job().parameters();
        QTest::keyClick(&method, Qt::Key_Down);
        QTRY_COMPARE_WITH_TIMEOUT(bench.session().job().parameters().method, DecimationMethod::lee,
                                  kPatience);
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Decimation method"));
        auto& rapid = bench.box("dock-setup", "rapidZ");
        const auto machine = bench.session().job().machine();
        Bench::type(rapid, QStringLiteral("9000"));
        QTRY_VERIFY_WITH_TIMEOUT(
            bench.session().job().machine() && bench.session().job().machine()->rapidZ == 9000, kPatience);
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Rapid traverse Z"));
        Bench::pressUndo(rapid);
        QVERIFY(bench.session().job().machine() == machine);
        Bench::pressUndo(rapid);
        QVERIFY(bench.session().job().parameters() == withMethod);
        Bench::pressUndo(rapid);
        QCOMPARE(bench.session().job().parameters().allowance, before);
        QVERIFY(!bench.session().document().modified());
    }

    void theKeysFollowTheFocus() {
        Bench bench;
        NcEditor& editor = bench.station.window.editor().editor();
        auto& top = bench.box("dock-setup", "corner-z");
        Bench::type(top, QStringLiteral("-3"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.topZ(), -3.0, kPatience);
        bench.station.window.findChild<QDockWidget*>(QStringLiteral("dock-program"))->raise();
        editor.setFocus();
        const QByteArray text(editor.textBytes().data(), static_cast<int>(editor.textBytes().size()));
        QVERIFY(!bench.action("edit-undo").isEnabled()); // in the text there is nothing to undo
        QTest::keyClicks(&editor, QStringLiteral("G4"));
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Text change"));
        Bench::pressUndo(editor);
        QTRY_COMPARE_WITH_TIMEOUT(
            QByteArray(editor.textBytes().data(), static_cast<int>(editor.textBytes().size())), text,
            kPatience);
        Bench::pressUndo(editor);
        QCOMPARE(bench.topZ(), -3.0);
        // A view has nothing to undo, so the previously focused input still counts.
        bench.box("dock-setup", "corner-z");
        bench.station.scale().setFocus();
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Top Z"));
        Bench::pressUndo(bench.station.scale());
        QVERIFY(bench.topZ() != -3.0);
    }

    void textThatIsBeingTypedHasItsOwnUndo() {
        Bench bench;
        auto& top = bench.box("dock-setup", "corner-z");
        Bench::type(top, QStringLiteral("-3"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.topZ(), -3.0, kPatience);
        top.selectAll();
        QTest::keyClicks(&top, QStringLiteral("77"));
        Bench::pressUndo(top);
        QCOMPARE(bench.topZ(), -3.0); // only the typed digits are undone
        QVERIFY(!top.cleanText().contains(QStringLiteral("77")));
    }

    void commandsOfMenusAreStepsAndAJobLoadEndsAll() {
        Bench bench;
        DecimationParameters parameters = bench.session().job().parameters();
        parameters.allowance = 0.4;
        parameters.period = 7;
        bench.session().job().setParameters(parameters);
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Decimation parameters"));
        Setup setup = bench.session().job().setup();
        setup.tools.set(41, parseCutter("ball:d=10,l=30").value());
        QVERIFY(bench.session().job().setSetup(setup).has_value());
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Tool T41"));
        setup.stock.width += 5;
        setup.stock.corner.x -= 5;
        QVERIFY(bench.session().job().setSetup(setup).has_value());
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Stock"));
        bench.action("edit-undo").trigger();
        bench.action("edit-undo").trigger();
        QVERIFY(bench.session().job().setup().tools.find(41) == nullptr);
        QVERIFY(bench.session().job().history().canRedo());
        bench.session().document().newFile();
        QVERIFY(!bench.session().job().history().canRedo());
        QVERIFY(!bench.action("edit-undo").isEnabled() && !bench.action("edit-redo").isEnabled());
        QVERIFY(!bench.session().document().modified());
    }

    void aDefaultThatIsBroughtBackIsAStepOfItsOwn() {
        Bench bench;
        Session& session = bench.session();
        auto& allowance = bench.box("dock-tuning", "allowance");
        const double initial = session.job().parameters().allowance;
        const auto setAllowance = [&](const char* text) {
            Bench::type(allowance, QLatin1String(text));
            QTRY_COMPARE_WITH_TIMEOUT(session.job().parameters().allowance, QString(text).toDouble(),
                                      kPatience);
        };
        setAllowance("0.2");
        QToolButton* reset = resetOf(bench);
        QTest::mouseClick(reset, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(session.job().parameters().allowance, initial, kPatience);
        // The button is hidden once there is nothing to reset; keys still go to the panel.
        QWidget* const focus = QApplication::focusWidget();
        QVERIFY(focus != nullptr);
        QVERIFY(bench.station.window.findChild<QDockWidget*>("dock-tuning")->isAncestorOf(focus));
        Bench::pressUndo(*focus);
        QCOMPARE(session.job().parameters().allowance, 0.2);
        Bench::pressRedo(allowance);
        QCOMPARE(session.job().parameters().allowance, initial);
        Bench::pressUndo(allowance);
        QTRY_VERIFY_WITH_TIMEOUT(reset->isVisible(), kPatience);
        // A typed value that was not entered is a step too.
        allowance.selectAll();
        QTest::keyClicks(&allowance, QStringLiteral("0.3"));
        QTest::mouseClick(reset, Qt::LeftButton);
        QCOMPARE(session.job().parameters().allowance, initial);
        QCOMPARE(allowance.value(), initial);
        Bench::pressUndo(allowance);
        QCOMPARE(session.job().parameters().allowance, 0.3);
    }

    void theDefaultsOfTheMenuAreAStepOfTheirOwn() {
        Bench bench;
        Session& session = bench.session();
        auto& allowance = bench.box("dock-tuning", "allowance");
        bench.action("default-parameters").trigger(); // so that everything else has its default
        const double initial = session.job().parameters().allowance;
        Bench::type(allowance, QStringLiteral("0.2"));
        bench.action("default-parameters").trigger(); // before the value is applied by the timer
        QCOMPARE(session.job().parameters().allowance, initial);
        QTest::qWait(400);
        QCOMPARE(session.job().parameters().allowance, initial);
        QCOMPARE(allowance.value(), initial);
        Bench::pressUndo(allowance);
        QCOMPARE(session.job().parameters().allowance, 0.2);
    }

    void assumingAToolAndConfirmingItAreTwoSteps() {
        QTemporaryDir folder;
        Bench bench;
        bench.open(folder, "G21 G90\nT7 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX9\nM30\n");
        Session& session = bench.session();
        auto* mend = bench.station.window.findChild<QPushButton*>(QStringLiteral("toolNoticeMend"));
        QTRY_VERIFY_WITH_TIMEOUT(mend->isVisible(), kPatience);
        QTest::mouseClick(mend, Qt::LeftButton);
        QVERIFY(session.job().setup().tools.unconfirmedOrigin(7) != nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(mend->isVisible(), kPatience);
        QTest::mouseClick(mend, Qt::LeftButton);
        QVERIFY(session.job().setup().tools.find(7) != nullptr &&
                session.job().setup().tools.unconfirmed().empty());
        session.job().undoStep();
        QVERIFY(session.job().setup().tools.unconfirmedOrigin(7) != nullptr);
        session.job().undoStep();
        QVERIFY(session.job().setup().tools.find(7) == nullptr);
    }

    void undoKeepsWhatCommentsHaveChangedSince() {
        QTemporaryDir folder;
        Bench bench;
        bench.open(folder, commented("D6", ""));
        Session& session = bench.session();
        const auto spec = [&](int number) {
            const Cutter* cutter = session.job().setup().tools.find(number);
            return cutter == nullptr ? std::string() : std::string(cutter->spec());
        };
        QCOMPARE(spec(2), std::string("flat:d=6"));
        Setup setup = session.job().setup();
        setup.tools.set(1, parseCutter("flat:d=12").value());
        QVERIFY(session.job().setSetup(setup).has_value());
        session.document().applyEdit(0, session.document().text().text.size(),
                                     commented("D5", "(T3 D3 FLAT)\n"));
        QTRY_COMPARE_WITH_TIMEOUT(spec(3), std::string("flat:d=3"), kPatience);
        QCOMPARE(spec(2), std::string("flat:d=5"));
        session.job().undoStep();
        QCOMPARE(spec(1), std::string("flat:d=10"));
        QCOMPARE(spec(2), std::string("flat:d=5"));
        QCOMPARE(spec(3), std::string("flat:d=3"));
        QVERIFY(!session.document().jobModified());
        session.job().redoStep();
        QCOMPARE(spec(1), std::string("flat:d=12"));
        QCOMPARE(spec(3), std::string("flat:d=3"));
    }

    void undoneToolsFollowTheirCommentAsItIsNow() {
        QTemporaryDir folder;
        Bench bench;
        bench.open(folder, commented("D6", ""));
        Session& session = bench.session();
        Setup setup = session.job().setup();
        setup.tools.set(2, parseCutter("flat:d=12").value());
        QVERIFY(session.job().setSetup(setup).has_value());
        session.document().applyEdit(0, session.document().text().text.size(),
                                     commented("D5", "(T3 D3 FLAT)\n"));
        QTRY_VERIFY_WITH_TIMEOUT(session.job().setup().tools.find(3) != nullptr, kPatience);
        session.job().undoStep();
        QCOMPARE(std::string(session.job().setup().tools.find(2)->spec()), std::string("flat:d=5"));
    }

    void undoLeavesTheAutomaticGridAsFineAsTheCutters() {
        QTemporaryDir folder;
        Bench bench;
        bench.open(folder, commented("D6", ""));
        Session& session = bench.session();
        QVERIFY(session.job().setup().automaticGrid);
        Setup setup = session.job().setup();
        setup.stock.corner.x -= 1; // so that the stock was set by the user and is not fitted again
        QVERIFY(session.job().setSetup(setup).has_value());
        setup.stock.width += 20;
        QVERIFY(session.job().setSetup(setup).has_value());
        session.document().applyEdit(0, session.document().text().text.size(), commented("D0.5", ""));
        QTRY_VERIFY_WITH_TIMEOUT(session.job().setup().spacing <= 0.05 && session.program().current(),
                                 kPatience);
        session.job().undoStep();
        QCOMPARE(session.job().setup().stock.width, setup.stock.width - 20);
        QVERIFY2(session.job().setup().spacing <= 0.05,
                 qPrintable(QString::number(session.job().setup().spacing)));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() &&
                                     session.simulation().frame()->setup->spacing ==
                                         session.job().setup().spacing,
                                 kPatience);
    }

    void whatIsSavedIsNotModifiedWhereverUndoLeads() {
        QTemporaryDir folder;
        Bench bench;
        Session& session = bench.session();
        QVERIFY(session.document().saveAs(folder.filePath("part.nc")));
        DecimationParameters parameters = session.job().parameters();
        parameters.allowance = 0.4;
        session.job().setParameters(parameters);
        session.job().history().closeStep();
        QVERIFY(session.document().saveJobAs(folder.filePath("part.proveout")));
        QVERIFY(!session.document().jobModified());
        session.job().undoStep();
        QVERIFY(session.document().jobModified()); // the file has the other value
        session.job().redoStep();
        QVERIFY(!session.document().jobModified());
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::UndoTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "undo_test.moc"
