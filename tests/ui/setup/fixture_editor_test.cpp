// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/fixture_editor.h"

#include <algorithm>
#include <functional>

#include <QDialog>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include "tests/ui/opened.h"
#include "ui/setup/setup_panel.h"

namespace proveout {
namespace {

constexpr int kPatience = 20'000; ///< ms
const StockBox kStock{{10, 20, 5}, 80, 60, 30};

template<class Widget>
Widget& find(const QWidget& parent, const char* name) {
    auto* widget = parent.findChild<Widget*>(QLatin1String(name));
    if (widget == nullptr)
        qFatal("there is no %s", name);
    return *widget;
}

void choose(const QWidget& parent, const char* command) {
    for (QAction* action : find<QPushButton>(parent, "fixture-add").menu()->actions())
        if (action->objectName() == QLatin1String(command))
            return action->trigger();
    qFatal("there is no %s", command);
}

void rename(const QWidget& parent, const QString& name) {
    auto& line = find<QLineEdit>(parent, "name-of-fixture");
    line.setText(name);
    emit line.editingFinished();
}

QStringList names(const Fixtures& fixtures) {
    QStringList all;
    for (const auto& named : fixtures)
        all << QString::fromStdString(named.first);
    return all;
}

/// Accepts the dialog that is open.
void accept(const QWidget& parent, const std::function<void(QDialog&)>& fill) {
    const auto dialogs = parent.window()->findChildren<QDialog*>(QStringLiteral("fixture-dialog"));
    const auto found = std::ranges::find_if(dialogs, &QDialog::isVisible);
    QVERIFY(found != dialogs.end());
    QDialog* dialog = *found;
    fill(*dialog);
    dialog->accept();
}

} // namespace

class FixtureEditorTest : public QObject {
    Q_OBJECT

private slots:
    void aMeshIsAddedFromItsFile() {
        const QTemporaryDir folder;
        const auto written = [&folder](const char* name, const char* text) {
            QFile file(folder.filePath(QLatin1String(name)));
            return file.open(QIODevice::WriteOnly) && file.write(text) > 0;
        };
        QVERIFY(written("left jaw.stl",
                        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 25\nvertex 60 0 25\n"
                        "vertex 60 20 0\nendloop\nendfacet\nendsolid\n"));
        QVERIFY(written("bad.stl", "not a mesh"));
        FixtureEditor editor;
        editor.show({}, kStock);
        QSignalSpy edited(&editor, &FixtureEditor::edited);
        editor.addMesh(folder.filePath(QStringLiteral("left jaw.stl")));
        QCOMPARE(names(editor.fixtures()), QStringList({"left jaw"}));
        auto& list = find<QTreeWidget>(editor, "fixture-list");
        QCOMPARE(list.currentItem()->text(1), QStringLiteral("60 × 20 × 25"));
        QVERIFY(find<QLabel>(editor, "fixture-problem").text().contains(QStringLiteral("not closed")));
        find<QDoubleSpinBox>(editor, "fixture-turn").setValue(90);
        find<QDoubleSpinBox>(editor, "fixture-scale").setValue(2);
        QCOMPARE(list.currentItem()->text(1), QStringLiteral("40 × 120 × 50"));
        QCOMPARE(std::get<FixtureMesh>(editor.fixtures().at("left jaw")).turn, 90.0);
        editor.addMesh(folder.filePath(QStringLiteral("bad.stl")));
        QCOMPARE(list.currentItem()->text(1), QStringLiteral("Not read"));
        QVERIFY(!find<QLabel>(editor, "fixture-problem").text().isEmpty());
        QCOMPARE(edited.count(), 4);
    }

    void addsCopiesAndRemoves() {
        FixtureEditor editor;
        editor.show({}, kStock);
        QSignalSpy edited(&editor, &FixtureEditor::edited);
        QVERIFY(!find<QPushButton>(editor, "fixture-remove").isEnabled());
        choose(editor, "fixture-box");
        choose(editor, "fixture-cylinder");
        choose(editor, "fixture-box");
        QCOMPARE(names(editor.fixtures()), QStringList({"Box", "Box 2", "Cylinder"}));
        const auto& box = std::get<FixtureBox>(editor.fixtures().at("Box"));
        QCOMPARE(box.x + box.w, 10.0); // it touches the stock
        QCOMPARE(box.z, -25.0);
        QCOMPARE(edited.size(), 3);
        find<QPushButton>(editor, "fixture-duplicate").click();
        QCOMPARE(names(editor.fixtures()), QStringList({"Box", "Box 2", "Box 2 2", "Cylinder"}));
        QVERIFY(editor.fixtures().at("Box 2 2") == editor.fixtures().at("Box 2"));
        find<QPushButton>(editor, "fixture-remove").click();
        find<QPushButton>(editor, "fixture-remove").click();
        QCOMPARE(names(editor.fixtures()), QStringList({"Box", "Box 2"}));
        QCOMPARE(edited.size(), 6);
    }

    void showsTheNumbersOfTheSelectedOne() {
        FixtureEditor editor;
        const FixtureBox jaw{1, 2, 3, 40, 50, 60};
        editor.show({{"jaw", jaw}, {"pin", FixtureCylinder{7, 8, 9, 10, 11}}}, kStock);
        QSignalSpy edited(&editor, &FixtureEditor::edited);
        QCOMPARE(find<QDoubleSpinBox>(editor, "fixture-w").value(), 40.0);
        auto& list = find<QTreeWidget>(editor, "fixture-list");
        QCOMPARE(list.topLevelItem(0)->text(1), QStringLiteral("40 × 50 × 60"));
        QCOMPARE(list.topLevelItem(1)->text(1), QStringLiteral("⌀ 10 × 11"));
        list.setCurrentItem(list.topLevelItem(1));
        QCOMPARE(find<QDoubleSpinBox>(editor, "fixture-d").value(), 10.0);
        QVERIFY(editor.findChild<QDoubleSpinBox*>(QStringLiteral("fixture-w")) == nullptr);
        QCOMPARE(edited.size(), 0);
        find<QDoubleSpinBox>(editor, "fixture-h").setValue(12.5);
        QVERIFY(editor.fixtures().at("pin") == Fixture(FixtureCylinder{7, 8, 9, 10, 12.5}));
        QVERIFY(editor.fixtures().at("jaw") == Fixture(jaw));
        QCOMPARE(edited.size(), 1);
        QCOMPARE(list.topLevelItem(1)->text(1), QStringLiteral("⌀ 10 × 12.5"));
    }

    void refusesANameWithItsReason() {
        FixtureEditor editor;
        editor.show({{"a", FixtureBox{0, 0, 0, 1, 1, 1}}, {"b", FixtureBox{5, 0, 0, 1, 1, 1}}}, kStock);
        QSignalSpy edited(&editor, &FixtureEditor::edited);
        const auto& problem = find<QLabel>(editor, "fixture-problem");
        rename(editor, QString());
        QCOMPARE(problem.text(), QStringLiteral("The fixture needs a name, as in NAME=SHAPE:key=value."));
        rename(editor, QStringLiteral("b"));
        QVERIFY(problem.text().contains(u'b'));
        QCOMPARE(names(editor.fixtures()), QStringList({"a", "b"}));
        QCOMPARE(edited.size(), 0);
        rename(editor, QStringLiteral("rear clamp"));
        QVERIFY(problem.text().isEmpty());
        QCOMPARE(names(editor.fixtures()), QStringList({"b", "rear clamp"}));
        QVERIFY(editor.fixtures().at("rear clamp") == Fixture(FixtureBox{0, 0, 0, 1, 1, 1}));
        QCOMPARE(edited.size(), 1);
    }

    void refusesANumberOutOfRange() {
        FixtureEditor editor;
        editor.QWidget::show();
        QVERIFY(QTest::qWaitForWindowExposed(&editor));
        editor.show({{"a", FixtureBox{0, 0, 0, 1, 2, 3}}}, kStock);
        auto& width = find<QDoubleSpinBox>(editor, "fixture-w");
        width.setFocus();
        width.selectAll();
        QTest::keyClicks(&width, QStringLiteral("0"));
        QTest::keyClick(&width, Qt::Key_Return);
        QCOMPARE(width.value(), 1.0);
        QVERIFY(editor.fixtures().at("a") == Fixture(FixtureBox{0, 0, 0, 1, 2, 3}));
    }

    void insertsAVice() {
        FixtureEditor editor;
        editor.QWidget::show();
        editor.show({{"Fixed jaw", FixtureBox{0, 0, 0, 1, 1, 1}}}, kStock);
        QSignalSpy edited(&editor, &FixtureEditor::edited);
        choose(editor, "fixture-vice");
        QCOMPARE(edited.size(), 0);
        accept(editor, [](QDialog& dialog) {
            QCOMPARE(find<QDoubleSpinBox>(dialog, "device-opening").value(), 60.0);
            find<QDoubleSpinBox>(dialog, "device-jawWidth").setValue(100);
        });
        QCOMPARE(names(editor.fixtures()), QStringList({"Bed", "Fixed jaw", "Fixed jaw 2", "Moving jaw"}));
        QCOMPARE(std::get<FixtureBox>(editor.fixtures().at("Moving jaw")).w, 100.0);
        QCOMPARE(std::get<FixtureBox>(editor.fixtures().at("Fixed jaw 2")).y, 80.0);
        QCOMPARE(edited.size(), 1);
        choose(editor, "fixture-step-clamp");
        accept(editor, [](QDialog& dialog) { find<QDoubleSpinBox>(dialog, "device-bolt").setValue(12); });
        QCOMPARE(std::get<FixtureCylinder>(editor.fixtures().at("Bolt")).d, 12.0);
        QCOMPARE(std::get<FixtureBox>(editor.fixtures().at("Clamp")).z, 5.0);
    }

    void changesAreStepsOfTheSetup() {
        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("p.nc")));
        QVERIFY(file.open(QIODevice::WriteOnly) &&
                file.write("G21 G90\nT1 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX30\nM30\n") > 0);
        file.close();
        Session session;
        SetupPanel panel(session);
        QVERIFY(opened(session, file.fileName()));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        JobHub& job = session.job();
        choose(panel, "fixture-box");
        QTRY_COMPARE_WITH_TIMEOUT(names(job.setup().fixtures), QStringList({"Box"}), kPatience);
        QCOMPARE(job.history().undoName(), QStringLiteral("Fixture Box"));
        QVERIFY(session.document().jobModified());
        const Fixture before = job.setup().fixtures.at("Box");
        job.history().closeStep();
        find<QDoubleSpinBox>(panel, "fixture-h").setValue(77);
        QTRY_VERIFY_WITH_TIMEOUT(!(job.setup().fixtures.at("Box") == before), kPatience);
        job.undoStep();
        QVERIFY(job.setup().fixtures.at("Box") == before);
        QCOMPARE(find<QDoubleSpinBox>(panel, "fixture-h").value(), std::get<FixtureBox>(before).h);
        job.undoStep();
        QVERIFY(job.setup().fixtures.empty());
        QVERIFY(find<QTreeWidget>(panel, "fixture-list").topLevelItemCount() == 0);
        job.redoStep();
        job.redoStep();
        QCOMPARE(std::get<FixtureBox>(job.setup().fixtures.at("Box")).h, 77.0);
        // What the user changes while the setup changes by itself is kept.
        find<QDoubleSpinBox>(panel, "fixture-h").setValue(78);
        Setup other = job.setup();
        other.fixtures["pin"] = FixtureCylinder{0, 0, 0, 5, 5};
        QVERIFY(job.setSetup(other).has_value());
        QTRY_COMPARE_WITH_TIMEOUT(std::get<FixtureBox>(job.setup().fixtures.at("Box")).h, 78.0, kPatience);
        QVERIFY(job.setup().fixtures.contains("pin"));
        // The check and the view get them.
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() &&
                                     session.simulation().frame()->setup->fixtures.contains("pin"),
                                 kPatience);
    }
};

} // namespace proveout

QTEST_MAIN(proveout::FixtureEditorTest)
#include "fixture_editor_test.moc"
