// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include "tests/ui/opened.h"
#include "ui/control/control_panel.h"

namespace proveout {

class ControlTest : public QObject {
    Q_OBJECT

private slots:
    void showsTheBlockThatWasExecutedLast() {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("p.nc"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("G21 G90 G0 X1 Y2 Z3\nG91 G18\no1 sub\nG0 X#1\no1 endsub\no1 call [5]\nM2\n");
        file.close();
        Session session;
        ControlPanel panel(session);
        panel.show();
        auto* tree = panel.findChild<QTreeWidget*>();
        QVERIFY(!tree->isVisible());
        QVERIFY(opened(session, path));
        QTRY_VERIFY(session.program().current() && session.simulation().frame());
        session.playback().seek(1);
        QTRY_COMPARE(value(*tree, QStringLiteral("plane")), QStringLiteral("G17"));
        QCOMPARE(value(*tree, QStringLiteral("distance mode")), QStringLiteral("G90"));
        QCOMPARE(value(*tree, QStringLiteral("X")), QLocale().toString(1.0, 'f', 3));
        QVERIFY(value(*tree, QStringLiteral("O1")).isNull());
        session.playback().seek(2);
        QTRY_COMPARE(value(*tree, QStringLiteral("plane")), QStringLiteral("G18"));
        QCOMPARE(value(*tree, QStringLiteral("distance mode")), QStringLiteral("G91"));
        QCOMPARE(value(*tree, QStringLiteral("X")), QLocale().toString(6.0, 'f', 3));
        QCOMPARE(value(*tree, QStringLiteral("#1")), QLocale().toString(5));
        QCOMPARE(value(*tree, QStringLiteral("O1")), QStringLiteral("from line 6"));

        QSignalSpy asked(&session.navigation(), &NavigationHub::lineRequested);
        emit tree->itemActivated(found(*tree, QStringLiteral("O1")), 0);
        QCOMPARE(asked.count(), 1);
        QCOMPARE(asked.front().front().value<std::uint32_t>(), 6U);
    }

    void theToolInTheSpindleIsTheOneThatIsAssumed() {
        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("p.nc")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("(T7 D=6. FLAT)\nG21 G90\nG0 X1 Y2 Z3\nG1 Z-1 F100\nM2\n");
        file.close();
        Session session;
        ControlPanel panel(session);
        panel.show();
        auto* tree = panel.findChild<QTreeWidget*>();
        const QString name = QStringLiteral("Tool in the spindle");
        QVERIFY(opened(session, file.fileName()));
        QTRY_COMPARE(value(*tree, name), QStringLiteral("T7 (assumed)"));
        Setup setup = session.job().setup();
        setup.tools.remove(7);
        QVERIFY(session.job().setSetup(setup).has_value());
        QTRY_COMPARE(value(*tree, name), QStringLiteral("no tool"));
        setup.tools.set(7, parseCutter("flat:d=6").value());
        setup.startTool = 7;
        QVERIFY(session.job().setSetup(setup).has_value());
        QTRY_COMPARE(value(*tree, name), QStringLiteral("T7"));
    }

private:
    static QTreeWidgetItem* found(const QTreeWidget& tree, const QString& name) {
        const auto items = tree.findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
        return items.isEmpty() ? nullptr : items.front();
    }
    static QString value(const QTreeWidget& tree, const QString& name) {
        const QTreeWidgetItem* item = found(tree, name);
        return item == nullptr ? QString() : item->text(1);
    }
};

} // namespace proveout

QTEST_MAIN(proveout::ControlTest)
#include "control_test.moc"
