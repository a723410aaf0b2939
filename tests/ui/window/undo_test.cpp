// SPDX-License-Identifier: GPL-3.0-or-later
// Undo and redo in the window: of the text, and of setup, tuning and machine, as the focus is.
#include <memory>

#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include "core/cutter/shapes.h"
#include "tests/ui/window/workstation.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"

namespace proveout {
namespace {

/// The window with one of its boxes in front.
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
    /// Types a value as a user does.
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
    Session& session() { return station.session; }
    double topZ() { return session().setup().stock.corner.z; }
};

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
        QVERIFY(bench.session().modified());
        Bench::pressUndo(top);
        QCOMPARE(bench.topZ(), before);
        QCOMPARE(top.value(), before);
        QVERIFY(!bench.session().modified());
        QVERIFY(!bench.station.window.isWindowModified());
        QVERIFY(!bench.action("edit-undo").isEnabled());
        QCOMPARE(bench.redoText(), QStringLiteral("Redo Top Z"));
        Bench::pressRedo(top);
        QCOMPARE(bench.topZ(), -3.0);
        QVERIFY(bench.session().modified());
        QTest::keyClick(&top, Qt::Key_Z, Qt::ControlModifier);
        QTest::keyClick(&top, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(bench.topZ(), -3.0);
        // The simulation runs on it.
        QTRY_VERIFY_WITH_TIMEOUT(
            bench.session().frame() && bench.session().frame()->setup->stock.corner.z == -3.0, kPatience);
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
        QTRY_COMPARE_WITH_TIMEOUT(bench.session().setup().stock.corner.x, leftBefore + 1, kPatience);
        Bench::pressUndo(left);
        QCOMPARE(bench.session().setup().stock.corner.x, leftBefore);
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
        Bench::pressUndo(left); // at once
        QCOMPARE(left.value(), leftBefore);
        QCOMPARE(bench.topZ(), -3.0);
        QTest::qWait(400);
        QCOMPARE(bench.session().setup().stock.corner.x, leftBefore);
        Bench::pressUndo(left);
        QCOMPARE(bench.topZ(), before);
    }

    void tuningAndMachineHaveUndo() {
        Bench bench;
        auto& allowance = bench.box("dock-tuning", "allowance");
        const double before = bench.session().parameters().allowance;
        Bench::type(allowance, QStringLiteral("0.5"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.session().parameters().allowance, 0.5, kPatience);
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Error allowance"));
        auto& method = bench.box<QComboBox>("dock-tuning", "method");
        const DecimationParameters withMethod = bench.session().parameters();
        QTest::keyClick(&method, Qt::Key_Down);
        QTRY_COMPARE_WITH_TIMEOUT(bench.session().parameters().method, DecimationMethod::lee, kPatience);
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Decimation Method"));
        auto& rapid = bench.box("dock-setup", "rapidZ");
        const auto machine = bench.session().machine();
        Bench::type(rapid, QStringLiteral("9000"));
        QTRY_VERIFY_WITH_TIMEOUT(bench.session().machine() && bench.session().machine()->rapidZ == 9000,
                                 kPatience);
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Rapid Z"));
        Bench::pressUndo(rapid);
        QVERIFY(bench.session().machine() == machine);
        Bench::pressUndo(rapid);
        QVERIFY(bench.session().parameters() == withMethod);
        Bench::pressUndo(rapid);
        QCOMPARE(bench.session().parameters().allowance, before);
        QVERIFY(!bench.session().modified());
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
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Text Change"));
        Bench::pressUndo(editor);
        QTRY_COMPARE_WITH_TIMEOUT(
            QByteArray(editor.textBytes().data(), static_cast<int>(editor.textBytes().size())), text,
            kPatience);
        Bench::pressUndo(editor);
        QCOMPARE(bench.topZ(), -3.0);
        // A view has nothing of its own: the last place of work counts on.
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
        QCOMPARE(bench.topZ(), -3.0); // only the digits are gone
        QVERIFY(!top.cleanText().contains(QStringLiteral("77")));
    }

    void commandsOfMenusAreStepsAndAJobLoadEndsAll() {
        Bench bench;
        DecimationParameters parameters = bench.session().parameters();
        parameters.allowance = 0.4;
        parameters.period = 7;
        bench.session().setParameters(parameters);
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Decimation Parameters"));
        Setup setup = bench.session().setup();
        setup.tools.set(41, parseCutter("ball:d=10,l=30").value());
        QVERIFY(bench.session().setSetup(setup).has_value());
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Tool T41"));
        setup.stock.width += 5;
        setup.stock.corner.x -= 5;
        QVERIFY(bench.session().setSetup(setup).has_value());
        QCOMPARE(bench.undoText(), QStringLiteral("Undo Stock"));
        bench.action("edit-undo").trigger();
        bench.action("edit-undo").trigger();
        QVERIFY(bench.session().setup().tools.find(41) == nullptr);
        QVERIFY(bench.session().history().canRedo());
        bench.session().newFile();
        QVERIFY(!bench.session().history().canRedo());
        QVERIFY(!bench.action("edit-undo").isEnabled() && !bench.action("edit-redo").isEnabled());
        QVERIFY(!bench.session().modified());
    }

    void whatIsSavedIsNotModifiedWhereverUndoLeads() {
        QTemporaryDir folder;
        Bench bench;
        Session& session = bench.session();
        QVERIFY(session.saveAs(folder.filePath("part.nc")));
        DecimationParameters parameters = session.parameters();
        parameters.allowance = 0.4;
        session.setParameters(parameters);
        session.history().closeStep();
        QVERIFY(session.saveJobAs(folder.filePath("part.proveout")));
        QVERIFY(!session.jobModified());
        session.undoStep();
        QVERIFY(session.jobModified()); // the file has the other
        session.redoStep();
        QVERIFY(!session.jobModified());
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
