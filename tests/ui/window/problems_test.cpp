// SPDX-License-Identifier: GPL-3.0-or-later
// The list of problems, used as by a user.
#include <algorithm>
#include <memory>
#include <set>

#include <QApplication>
#include <QContextMenuEvent>
#include <QDir>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTemporaryFile>
#include <QTest>
#include <QTimer>
#include <QTreeView>

#include "core/nc/text/dialect.h"
#include "tests/ui/window/workstation.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/findings/problems_model.h"
#include "ui/look/languages.h"

namespace proveout {
namespace {

QTreeView& listOf(const Workstation& station) {
    auto* dock = station.window.findChild<QDockWidget*>(QStringLiteral("dock-problems"));
    dock->show();
    dock->raise();
    return *dock->findChild<QTreeView*>();
}

/// Opens a text without waiting for a frame.
void open(Workstation& station, const QByteArray& text) {
    QTemporaryFile file(QDir::tempPath() + QStringLiteral("/XXXXXX.nc"));
    if (!file.open() || file.write(text) != text.size())
        qFatal("cannot write the test's own file");
    file.close();
    station.window.files().open(file.fileName());
    if (!openingIsOver(station.session))
        qFatal("the file was not opened");
}

/// In the list; -1 if it has no such problem.
int rowOf(const Workstation& station, const char* id) {
    const QAbstractItemModel& rows = *listOf(station).model();
    for (int row = 0; row < rows.rowCount(); ++row)
        if (rows.index(row, ProblemsModel::kId).data().toString() == QLatin1String(id))
            return row;
    return -1;
}

/// Whether the cell shows the complete text.
bool isWhole(const QTreeView& list, const QModelIndex& cell) {
    const QAbstractItemView& view = list; // QTreeView hides sizeHintForColumn()
    return list.columnWidth(cell.column()) >= view.sizeHintForIndex(cell).width();
}

/// Selects an action of a row's menu with the mouse.
bool choose(QTreeView& list, int row, const char* action) {
    const QModelIndex index = list.model()->index(row, ProblemsModel::kSentence);
    list.scrollTo(index);
    const QPoint at = QPoint(list.visualRect(index).left() + 20, list.visualRect(index).center().y());
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, list.viewport()->mapToGlobal(at));
    QApplication::sendEvent(list.viewport(), &event);
    if (!QTest::qWaitFor([] { return QApplication::activePopupWidget() != nullptr; }, kPatience))
        return false;
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    auto* wanted = menu->findChild<QAction*>(QLatin1String(action));
    if (wanted == nullptr || !wanted->isEnabled())
        return false;
    QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(wanted).center());
    return true;
}

/// A clamp that is operated in many lines, which its note lists.
QByteArray clamps() {
    QByteArray text = "%\nO0001 (CLAMPS)\nG21 G90 G17\nT1 M6\nG0 X0. Y0. Z5.\nG1 Z-1. F100 S500 M3\n";
    for (int i = 0; i < 24; ++i)
        text += "M10\nX" + QByteArray::number(i) + ".\nM11\n";
    return text + "M30\n%\n";
}

const char* const kSiemens = "%_N_SINUMERIK840D_POCKET_MPF\n;$PATH=/_N_WKS_DIR/_N_TEST_WPD\n"
                             "N10 T=\"MILL10\" M6\nN20 CYCLE832(0.05,1)\nN30 G0 X0 Y0 Z5\nN40 M30\n";

} // namespace

class ProblemsTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void everySentenceIsWhole_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("id");
        QTest::newRow("a note with many lines") << clamps() << QByteArray("code-ignored");
        QTest::newRow("another control") << QByteArray(kSiemens) << QByteArray("dialect-foreign");
    }
    void everySentenceIsWhole() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, id);
        Workstation station(false);
        open(station, text);
        QTRY_VERIFY_WITH_TIMEOUT(rowOf(station, id) >= 0, kPatience);
        QTreeView& list = listOf(station);
        for (const int width : {1280, 2560, 1280}) {
            station.window.resize(width, 800);
            for (const Language& language : languages()) {
                station.appearance.setLanguage(language.code);
                QTest::qWait(50);
                for (int row = 0; row < list.model()->rowCount(); ++row) {
                    const QModelIndex sentence = list.model()->index(row, ProblemsModel::kSentence);
                    QVERIFY2(isWhole(list, sentence),
                             qPrintable(language.code + u' ' + sentence.data().toString()));
                    // The tooltip contains the complete text of all elided cells.
                    const QString tip = sentence.data(Qt::ToolTipRole).toString();
                    for (int column : {ProblemsModel::kSentence, ProblemsModel::kHint, ProblemsModel::kId})
                        QVERIFY(
                            tip.contains(sentence.siblingAtColumn(column).data().toString().toHtmlEscaped()));
                }
            }
        }
    }

    void idIsShownWhereThereIsRoom() {
        Workstation station(false);
        open(station, clamps());
        QTRY_VERIFY_WITH_TIMEOUT(rowOf(station, "code-ignored") >= 0, kPatience);
        const QTreeView& list = listOf(station);
        const QAbstractItemView& view = list; // QTreeView hides sizeHintForColumn()
        bool shown = false;
        bool hidden = false;
        for (const int width : {2560, 1280, 1000}) {
            station.window.resize(width, 800);
            QTest::qWait(100);
            int wanted = 0;
            for (int column = 0; column < ProblemsModel::kColumnCount; ++column)
                wanted += std::max(view.sizeHintForColumn(column), list.header()->sectionSizeHint(column));
            QCOMPARE(list.isColumnHidden(ProblemsModel::kId), wanted > list.viewport()->width());
            (list.isColumnHidden(ProblemsModel::kId) ? hidden : shown) = true;
        }
        QVERIFY(shown && hidden);
    }

    void allUnknownMCodesAreIgnoredAtOnce() {
        Workstation station(false);
        open(station,
             "%\nO1\nG21 G90\nT1 M6\nG0 X0. Y0. Z5.\nM16\nM161\nG1 Z-1. F100 S500 M3\nM171\nX10.\nM30\n%\n");
        QTRY_VERIFY_WITH_TIMEOUT(rowOf(station, "code-unknown") >= 0, kPatience);
        QTreeView& list = listOf(station);
        QVERIFY(choose(list, rowOf(station, "code-unknown"), "ignore-all-m-codes"));
        QCOMPARE(station.session.job().setup().ignoredM, (std::set<int>{16, 161, 171}));
        QTRY_VERIFY_WITH_TIMEOUT(rowOf(station, "code-ignored") >= 0, kPatience);
        QCOMPARE(rowOf(station, "code-unknown"), -1);
        // A single undo step.
        station.session.job().undoStep();
        QVERIFY(station.session.job().setup().ignoredM.empty());
    }

    void aTextOfAnotherControlIsNamedInTheView() {
        Workstation station(true);
        QTRY_VERIFY_WITH_TIMEOUT(station.session.simulation().frame() != nullptr, kPatience);
        open(station, kSiemens);
        QTRY_VERIFY_WITH_TIMEOUT(rowOf(station, "dialect-foreign") >= 0, kPatience);
        auto* notice = station.window.viewport().findChild<QWidget*>(QStringLiteral("foreignNotice"));
        QVERIFY(notice != nullptr && notice->isVisible());
        const QString said = notice->findChild<QLabel*>(QStringLiteral("noticeText"))->text();
        QVERIFY2(said.contains(QLatin1String("Siemens Sinumerik")), qPrintable(said));
        const auto* text = notice->findChild<QLabel*>(QStringLiteral("noticeText"));
        QTRY_VERIFY2_WITH_TIMEOUT(text->height() >= text->heightForWidth(text->width()), "it is cut off",
                                  kPatience);
        // No stock is shown for an unsupported text, neither now nor when the user tries to play it.
        station.window.action(QStringLiteral("play"))->trigger();
        station.window.action(QStringLiteral("to-end"))->trigger();
        QTest::qWait(500);
        QVERIFY(station.session.simulation().frame() == nullptr);
        QVERIFY(!station.session.playback().state().playing);
        QCOMPARE(station.session.problems().all().size(), std::size_t{1});

        // Reading it in a dialect that the user chooses is an undo step of its own.
        Setup setup = station.session.job().setup();
        setup.blockDelete = true;
        QVERIFY(station.session.job().setSetup(setup).has_value());
        auto* readAs = notice->findChild<QPushButton*>(QStringLiteral("foreignNoticeReadAs"));
        QTimer::singleShot(200, this, [] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            if (menu != nullptr)
                QTest::mouseClick(
                    menu, Qt::LeftButton, Qt::NoModifier,
                    menu->actionGeometry(menu->actions().at(static_cast<int>(DialectId::fanuc))).center());
        });
        QTest::mouseClick(readAs, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(station.session.simulation().frame() != nullptr, kPatience);
        QVERIFY(station.session.job().setup().dialect == DialectId::fanuc);
        QVERIFY(!notice->isVisible());
        station.session.job().undoStep();
        QVERIFY(!station.session.job().setup().dialect.has_value());
        QVERIFY(station.session.job().setup().blockDelete);
    }

    /// Whatever has the focus; Esc then has its own meaning there again.
    void escHidesAContactFirst() {
        Workstation station(false);
        open(station, "G21 G90\nT1 M6\nS1000 M3\nG0 X0 Y5 Z5\nG1 Z-2 F100\nX10\nG0 X20\nZ5\nM30\n");
        Session& session = station.session;
        Setup setup = session.job().setup();
        setup.stock = {Vec3(0), 40, 10, 10};
        setup.tools.set(1, parseCutter("flat:d=4,l=20").value());
        QVERIFY(session.job().setSetup(setup).has_value());
        QTRY_VERIFY_WITH_TIMEOUT(session.check().report() && rowOf(station, "rapid-cuts") >= 0, kPatience);
        QTreeView& list = listOf(station);
        auto& editor = station.window.editor();
        for (QWidget* focused : {static_cast<QWidget*>(&editor), static_cast<QWidget*>(&list)}) {
            focused->setFocus();
            list.setCurrentIndex({});
            do
                station.press(Qt::Key_F8, Qt::NoModifier);
            while (list.currentIndex().row() != rowOf(station, "rapid-cuts"));
            QVERIFY(session.contact().isShown());
            QTRY_VERIFY_WITH_TIMEOUT(session.contact().in(session.simulation().frame().get()) != nullptr,
                                     kPatience);
            QCOMPARE(editor.findChild<NcEditor*>()->caretLine(), 7);
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
            QVERIFY(!session.contact().isShown());
        }
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::ProblemsTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "problems_test.moc"
