// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/tool_table_editor.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

namespace proveout {
namespace {

ToolTable mixed() {
    ToolTable tools;
    tools.set(1, parseCutter("flat:d=6").value(), {ToolSource::comment, 3, "T1 D=6 <FLAT>", {"l"}});
    tools.set(2, parseCutter("flat:d=10").value(), {ToolSource::assumed});
    tools.set(3, parseCutter("ball:d=4").value());
    return tools;
}

/// The text in the column for the origin of the sizes.
QString sourceOf(const ToolTableEditor& editor, int row) {
    return editor.findChild<QTreeWidget*>()->topLevelItem(row)->text(2);
}

void choose(const ToolTableEditor& editor, const char* shape) {
    auto* shapes = editor.findChild<QComboBox*>();
    shapes->setCurrentIndex(shapes->findData(QLatin1String(shape)));
    emit shapes->activated(shapes->currentIndex());
}

QPushButton& button(const ToolTableEditor& editor, const char* name) {
    return *editor.findChild<QPushButton*>(QLatin1String(name));
}

} // namespace

class ToolTableEditorTest : public QObject {
    Q_OBJECT

private slots:
    void marksWhatIsNotConfirmed() {
        ToolTableEditor editor;
        editor.show(mixed());
        QCOMPARE(sourceOf(editor, 0), QStringLiteral("Comment, line 3"));
        QCOMPARE(sourceOf(editor, 1), QStringLiteral("Assumed"));
        QCOMPARE(sourceOf(editor, 2), QStringLiteral("Defined"));
        const auto* list = editor.findChild<QTreeWidget*>();
        QVERIFY(list->topLevelItem(0)->font(1).italic());
        QVERIFY(!list->topLevelItem(2)->font(1).italic());
        const auto* origin = editor.findChild<QLabel*>(QStringLiteral("tool-origin"));
        QVERIFY(origin->text().contains(QStringLiteral("T1 D=6 &lt;FLAT&gt;")));
        QVERIFY(origin->text().contains(QStringLiteral("Flute length")));
    }

    void confirmsOneOrAll() {
        ToolTableEditor editor;
        editor.show(mixed());
        QSignalSpy edited(&editor, &ToolTableEditor::edited);
        QTest::mouseClick(&button(editor, "tool-confirm"), Qt::LeftButton);
        QCOMPARE(edited.size(), 1);
        QVERIFY(editor.tools().unconfirmedOrigin(1) == nullptr);
        QVERIFY(editor.tools().unconfirmedOrigin(2) != nullptr);
        QCOMPARE(sourceOf(editor, 0), QStringLiteral("Defined"));

        editor.show(mixed());
        QTest::mouseClick(&button(editor, "tool-confirm-all"), Qt::LeftButton);
        QVERIFY(editor.tools().unconfirmed().empty());
        QVERIFY(button(editor, "tool-confirm").isHidden());
    }

    void editingASizeConfirmsIt() {
        ToolTableEditor editor;
        editor.show(mixed());
        auto* diameter = editor.findChild<QDoubleSpinBox*>(QStringLiteral("tool-d"));
        diameter->setValue(8);
        QCOMPARE(editor.tools().find(1)->spec(), std::string("flat:d=8"));
        QVERIFY(editor.tools().unconfirmedOrigin(1) == nullptr);
        QCOMPARE(sourceOf(editor, 0), QStringLiteral("Defined"));
    }

    void otherSizesThanTheDiameterConfirmNothing() {
        ToolTableEditor editor;
        editor.show(mixed());
        const auto setLength = [&editor](double length) {
            editor.findChild<QDoubleSpinBox*>(QStringLiteral("tool-l"))->setValue(length);
        };
        setLength(20);
        setLength(21); // again, as the arrow keys do
        QCOMPARE(editor.tools().find(1)->spec(), std::string("flat:d=6,l=21"));
        const ToolOrigin* comment = editor.tools().unconfirmedOrigin(1);
        QVERIFY(comment != nullptr && comment->defaults.empty());
        QCOMPARE(comment->entered, std::vector<std::string>{"l"});
        QCOMPARE(sourceOf(editor, 0), QStringLiteral("Comment, line 3"));
        const auto* origin = editor.findChild<QLabel*>(QStringLiteral("tool-origin"));
        QVERIFY2(origin->text().contains(QStringLiteral("Entered: Flute length")),
                 qPrintable(origin->text()));
        QVERIFY(!origin->text().contains(QStringLiteral("defaults")));

        auto* list = editor.findChild<QTreeWidget*>();
        list->setCurrentItem(list->topLevelItem(1)); // the assumed tool
        setLength(30);
        choose(editor, "ball");
        QCOMPARE(editor.tools().find(2)->spec(), std::string("ball:d=10,l=30"));
        QCOMPARE(editor.tools().unconfirmedOrigin(2)->source, ToolSource::assumed);
        QCOMPARE(sourceOf(editor, 1), QStringLiteral("Assumed"));
        editor.findChild<QDoubleSpinBox*>(QStringLiteral("tool-d"))->setValue(6);
        QVERIFY(editor.tools().unconfirmedOrigin(2) == nullptr);

        list->setCurrentItem(list->topLevelItem(2)); // entered sizes stay confirmed
        setLength(30);
        QVERIFY(editor.tools().unconfirmedOrigin(3) == nullptr);
    }

    void theSizesOfAnotherShapeAreDefaults() {
        ToolTableEditor editor;
        editor.show(mixed());
        choose(editor, "cone");
        const ToolOrigin* origin = editor.tools().unconfirmedOrigin(1);
        QVERIFY(origin != nullptr);
        QVERIFY(std::ranges::count(origin->defaults, "angle") == 1);
        QVERIFY(std::ranges::count(origin->defaults, "l") == 1);
        QCOMPARE(origin->entered, std::vector<std::string>{"shape"});
        // The profile of a form cutter corresponds to the diameter of others.
        choose(editor, "form");
        QVERIFY(editor.tools().unconfirmedOrigin(1) != nullptr);
        auto* profile = editor.findChild<QLineEdit*>(QStringLiteral("tool-p"));
        profile->setText(QStringLiteral("0/0:3/0:3/9"));
        emit profile->editingFinished();
        QVERIFY(editor.tools().unconfirmedOrigin(1) == nullptr);
    }

    void aHolderDoesNotConfirmTheSizesOfTheCutter() {
        ToolTableEditor editor;
        editor.show(mixed());
        editor.findChild<QDoubleSpinBox*>(QStringLiteral("tool-so"))->setValue(60);
        auto* holder = editor.findChild<QLineEdit*>(QStringLiteral("tool-holder"));
        holder->setText(QStringLiteral("40x30"));
        emit holder->editingFinished();
        QCOMPARE(editor.tools().find(1)->body().holder.size(), std::size_t{1});
        const ToolOrigin* origin = editor.tools().unconfirmedOrigin(1);
        QVERIFY(origin != nullptr);
        QCOMPARE(origin->entered, (std::vector<std::string>{"so", "holder"}));
    }

    void anAddedToolIsAssumedUntilItsSizesAreEntered() {
        ToolTableEditor editor;
        editor.edit(7);
        QVERIFY(editor.tools().find(7) != nullptr);
        QCOMPARE(editor.tools().unconfirmedOrigin(7)->source, ToolSource::assumed);
        editor.findChild<QDoubleSpinBox*>(QStringLiteral("tool-d"))->setValue(12);
        QVERIFY(editor.tools().unconfirmed().empty());
    }

    void anotherNumberIsNoConfirmation() {
        ToolTableEditor editor;
        editor.show(mixed());
        editor.findChild<QSpinBox*>()->setValue(9);
        QVERIFY(editor.tools().find(1) == nullptr);
        QCOMPARE(editor.tools().unconfirmedOrigin(9)->line, 3U);
    }

    void leadsToTheComment() {
        ToolTableEditor editor;
        editor.show(mixed());
        QSignalSpy wanted(&editor, &ToolTableEditor::lineWanted);
        emit editor.findChild<QLabel*>(QStringLiteral("tool-origin"))->linkActivated(QStringLiteral("3"));
        QCOMPARE(wanted.size(), 1);
        QCOMPARE(wanted[0][0].toUInt(), 3U);
    }
};

} // namespace proveout

QTEST_MAIN(proveout::ToolTableEditorTest)
#include "tool_table_editor_test.moc"
