// SPDX-License-Identifier: GPL-3.0-or-later
// The complete window, used as by a user.
#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include <QAbstractItemModel>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QTreeView>

#include "core/formats/stl.h"
#include "tests/ui/window/workstation.h"
#include "ui/document/file_paths.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/findings/problems_model.h"
#include "ui/look/appearance.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/resource_paths.h"
#include "ui/session/session.h"
#include "ui/timeline/timeline_scale.h"
#include "ui/window/main_window.h"
#include "ui/window/panel_table.h"
#include "ui/window/start_page.h"

namespace proveout {
namespace {

void collect(const QMenu& menu, QList<QAction*>& actions) {
    for (QAction* action : menu.actions()) {
        if (action->menu() != nullptr)
            collect(*action->menu(), actions);
        else if (!action->isSeparator())
            actions << action;
    }
}

QList<QAction*> menuActions(const MainWindow& window) {
    QList<QAction*> actions;
    for (QAction* top : window.menuBar()->actions())
        collect(*top->menu(), actions);
    return actions;
}

} // namespace

class WindowTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void startPageOpensASample() {
        Workstation station(false);
        QCOMPARE(sampleJobs().size(), std::size_t{2});
        QVERIFY(station.window.viewport().isHidden());
        QList<QPushButton*> buttons = station.window.findChildren<QPushButton*>();
        const auto sample = std::find_if(buttons.begin(), buttons.end(), [](QPushButton* b) {
            return b->text() == QLatin1String("Core insert");
        });
        QVERIFY(sample != buttons.end());
        QTest::mouseClick(*sample, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(station.session.simulation().frame() != nullptr, kPatience);
        QCOMPARE(station.session.program().blockCount(), std::size_t{255});
        QVERIFY(!station.window.viewport().isHidden());
        QCOMPARE(station.window.files().recent().files().size(), 1);
    }

    void startPageStaysUntilItIsLeft() {
        Workstation station(true);
        auto* page = station.window.findChild<StartPage*>();
        auto* back = page->findChild<QPushButton*>(QStringLiteral("back"));
        station.window.showStartPage();
        QVERIFY(page->isVisible());
        station.appearance.setLanguage(QStringLiteral("de"));
        QTRY_VERIFY_WITH_TIMEOUT(back->text().startsWith(QStringLiteral("Zurück")), kPatience);
        station.appearance.setLanguage(QStringLiteral("en"));
        QTRY_COMPARE_WITH_TIMEOUT(back->text(), QStringLiteral("Back to core-insert.nc"), kPatience);
        DecimationParameters parameters = station.session.job().parameters();
        parameters.allowance = 0.3;
        station.session.job().setParameters(parameters); // the document is modified now
        QVERIFY(page->isVisible());
        QTest::keyClick(page, Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(station.window.viewport().isVisible(), kPatience);
        station.window.showStartPage();
        QTest::mouseClick(back, Qt::LeftButton);
        QVERIFY(station.window.viewport().isVisible());
    }

    void theFirstStartPageHasNoWayBack() {
        Workstation station(false);
        QVERIFY(!station.window.findChild<QPushButton*>(QStringLiteral("back"))->isVisible());
    }

    void aSampleIsSavedElsewhere() {
        Workstation station(true);
        const auto contents = [file = sampleJobs().front().file] {
            QFile sample(file);
            return sample.open(QIODevice::ReadOnly) ? sample.readAll() : QByteArray();
        };
        const QByteArray before = contents();
        DecimationParameters parameters = station.session.job().parameters();
        parameters.allowance = 0.3;
        station.session.job().setParameters(parameters);
        QVERIFY(station.session.document().modified());

        QString proposed; // proposed folder
        QTimer refusal;
        connect(&refusal, &QTimer::timeout, this, [&proposed] {
            if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                proposed = dialog->directory().canonicalPath();
                dialog->reject();
            }
        });
        refusal.start(50);
        QVERIFY(!station.window.files().save());
        QVERIFY(!proposed.isEmpty());
        QVERIFY2(proposed != QFileInfo(sampleJobs().front().file).canonicalPath(), qPrintable(proposed));
        QVERIFY(!before.isEmpty());
        QCOMPARE(contents(), before);
        QVERIFY(station.session.document().modified());
    }

    void theWholeLoop() {
        Workstation station(true);
        Session& session = station.session;
        // Space plays and pauses.
        station.scale().setFocus();
        QTest::keyClick(&station.scale(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().block() > 5, kPatience);
        QVERIFY(session.playback().state().playing);
        QTest::keyClick(&station.scale(), Qt::Key_Space);
        QVERIFY(!session.playback().state().playing);
        QTRY_VERIFY_WITH_TIMEOUT(!session.simulation().frame()->playing, kPatience);
        // The arrow key steps back by exactly one block, which timeline and editor show.
        const std::size_t before = session.simulation().block();
        QTest::keyClick(&station.scale(), Qt::Key_Left);
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), before - 1, kPatience);
        // The same in a focused plot.
        auto* plot = station.window.findChild<QWidget*>(QStringLiteral("faces"));
        plot->setFocus();
        QTest::keyClick(plot, Qt::Key_Right);
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), before, kPatience);
        station.scale().setFocus();
        QTest::keyClick(&station.scale(), Qt::Key_End);
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), session.program().blockCount(), kPatience);
        NcEditor& editor = station.window.editor().editor();
        QTRY_COMPARE_WITH_TIMEOUT(
            editor.markerFindNext(0, 1 << 1),
            static_cast<int>(session.program().current()->blockLine(session.program().blockCount() - 1)) - 1,
            kPatience);
        // An edit after the last motion adds a motion.
        const std::size_t blocks = session.program().blockCount();
        const int line = static_cast<int>(session.program().current()->blockLine(blocks - 1));
        editor.insertAt(QStringLiteral("G91 G1 Z1.\n"), line, 0);
        QTRY_COMPARE_WITH_TIMEOUT(session.program().blockCount(), blocks + 1, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame()->program == session.program().current() &&
                                     session.simulation().block() == blocks + 1,
                                 kPatience);
        QVERIFY(station.window.isWindowModified());
        // A larger allowance gives fewer triangles.
        const std::size_t faces = session.simulation().frame()->surface.faces;
        auto* allowance = station.window.findChild<QDoubleSpinBox*>(QStringLiteral("allowance"));
        allowance->setValue(0.5);
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame()->surface.faces < faces, kPatience);
        QCOMPARE(session.simulation().frame()->parameters.allowance, 0.5);
        // Exports, and reads the file again.
        QTemporaryDir folder;
        const QString file = folder.filePath("part.stl");
        QSignalSpy exported(&session.exports(), &ExportHub::exported);
        session.exports().exportMesh(file, {});
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        const Result<TriangleMesh> mesh = readStl(toPath(file));
        QVERIFY(mesh.has_value());
        QCOMPARE(std::uint64_t{mesh->triangles.size()}, session.exports().last()->triangles);
        QVERIFY(station.window.statusBar()->toolTip().contains(file));
        session.document().setTextModified(false);
    }

    void everyPanelHasItsDockAndItsKey() {
        Workstation station(false);
        QCOMPARE(static_cast<std::size_t>(station.window.findChildren<QDockWidget*>().size()),
                 panelTable().size());
        int withKeys = 0;
        for (const PanelRow& row : panelTable()) {
            const auto* dock = station.window.findChild<QDockWidget*>(QLatin1String(row.id));
            QVERIFY2(dock != nullptr, row.id);
            QCOMPARE(dock->toggleViewAction()->shortcut(), QKeySequence(QLatin1String(row.keys)));
            QVERIFY2(!dock->toggleViewAction()->icon().isNull(), row.id);
            QVERIFY2(!dock->windowTitle().isEmpty(), row.id);
            withKeys += dock->toggleViewAction()->shortcut().isEmpty() ? 0 : 1;
        }
        QCOMPARE(withKeys, 10);
    }

    void menusHaveAllActionsAndNoKeyIsUsedTwice() {
        Workstation station(true);
        const QList<QAction*> inMenus = menuActions(station.window);
        std::map<QString, QString> windowKeys;
        std::map<QString, QString> focusKeys;
        for (const QAction* action : station.window.findChildren<QAction*>()) {
            if (action->isSeparator() || action->menu() != nullptr || action->shortcuts().isEmpty())
                continue;
            // Qt's own line edits and editors add actions of their own.
            if (action->objectName().isEmpty() || action->objectName().startsWith(QLatin1String("_q_")))
                continue;
            QVERIFY2(inMenus.contains(const_cast<QAction*>(action)), qPrintable(action->objectName()));
            const bool everywhere = action->shortcutContext() == Qt::WindowShortcut;
            // Shortcuts of the editor and of the 3D view are active in different places.
            const bool editing = action->objectName().startsWith(QLatin1String("edit-"));
            for (const QKeySequence& key : action->shortcuts()) {
                const QString text = key.toString();
                auto& taken = everywhere ? windowKeys : focusKeys;
                const QString place = everywhere || !editing ? text : QStringLiteral("edit ") + text;
                QVERIFY2(taken.count(place) == 0,
                         qPrintable(text + u' ' + action->objectName() + u' ' + taken[place]));
                taken[place] = action->objectName();
            }
        }
        QVERIFY(windowKeys.size() > 10);
        for (const auto& [key, name] : windowKeys)
            QVERIFY2(focusKeys.count(key) == 0 && focusKeys.count(QStringLiteral("edit ") + key) == 0,
                     qPrintable(key + u' ' + name));
    }

    void everyNumberNamesItsUnitInTheToolTip() {
        Workstation station(true);
        int boxes = 0;
        for (const QAbstractSpinBox* box : station.window.findChildren<QAbstractSpinBox*>()) {
            QString unit;
            if (const auto* number = qobject_cast<const QDoubleSpinBox*>(box))
                unit = number->suffix().trimmed();
            if (const auto* number = qobject_cast<const QSpinBox*>(box))
                unit = number->suffix().trimmed();
            QVERIFY2(!box->toolTip().isEmpty(), qPrintable(box->objectName()));
            QVERIFY2(box->toolTip().contains(unit), qPrintable(box->objectName()));
            QVERIFY2(box->toolTip().contains(QLatin1String("Default")), qPrintable(box->objectName()));
            QVERIFY2(!box->accessibleName().isEmpty(), qPrintable(box->objectName()));
            ++boxes;
        }
        QVERIFY(boxes >= 12);
    }

    void badInputShowsInProblemsWithoutADialog() {
        QTemporaryDir folder;
        Workstation station(true);
        const auto tryOut = [&](const QString& name, const QByteArray& bytes) {
            QFile file(folder.filePath(name));
            if (file.open(QIODevice::WriteOnly))
                file.write(bytes);
            file.close();
            station.window.files().open(file.fileName());
            QVERIFY(openingIsOver(station.session));
        };
        auto* problems = station.window.findChild<QDockWidget*>(QStringLiteral("dock-problems"));
        const auto* list = problems->findChild<QTreeView*>();
        for (const auto& [name, bytes] : std::vector<std::pair<QString, QByteArray>>{
                 {"binary.nc", QByteArray(500, '\0')},
                 {"feedless.nc", "G21 G90\nT1 M6\nG0 X0 Y0 Z5\nG1 X5\n"},
                 {"arc.nc", "G21 G90 F100\nT1 M6\nG0 X0 Y0 Z0\nG2 X10 Y0 I3 J0\n"},
                 {"empty.nc", ""},
                 {"words.nc", "G1 X1.2.3\nQQ\n#$&\n"}}) {
            tryOut(name, bytes);
            QTRY_VERIFY2_WITH_TIMEOUT(list->model()->rowCount() > 0, qPrintable(name), kPatience);
            QVERIFY(QApplication::activeModalWidget() == nullptr);
        }
        station.window.files().open(folder.filePath("missing.nc"));
        QVERIFY(openingIsOver(station.session));
        QVERIFY(sentence(station.session.problems().all().front()).startsWith(QLatin1String("missing.nc: ")));
        QVERIFY(QApplication::activeModalWidget() == nullptr);
    }

    void anUnknownMCodeIsIgnoredFromItsProblem() {
        QTemporaryDir folder;
        QFile file(folder.filePath("clamp.nc"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("%\nO1\nG21 G90\nT1 M6\nG0 X0. Y0. Z5.\nM16\nG1 Z-1. F100 S500 M3\nX10.\nM30\n%\n");
        file.close();
        Workstation station(false);
        station.open(file.fileName());
        auto* problems = station.window.findChild<QDockWidget*>(QStringLiteral("dock-problems"));
        problems->show();
        problems->raise();
        auto* list = problems->findChild<QTreeView*>();
        const auto rowOf = [&](const char* id) {
            const QAbstractItemModel& rows = *list->model();
            for (int row = 0; row < rows.rowCount(); ++row)
                if (rows.index(row, ProblemsModel::kId).data().toString() == QLatin1String(id))
                    return row;
            return -1;
        };
        QTRY_VERIFY_WITH_TIMEOUT(rowOf("code-unknown") >= 0, kPatience);
        QVERIFY(station.session.program().current()->unverified());
        const QModelIndex index = list->model()->index(rowOf("code-unknown"), ProblemsModel::kSentence);
        list->scrollTo(index);
        const QPoint at = list->visualRect(index).center();
        QContextMenuEvent event(QContextMenuEvent::Mouse, at, list->viewport()->mapToGlobal(at));
        QApplication::sendEvent(list->viewport(), &event);
        QTRY_VERIFY_WITH_TIMEOUT(QApplication::activePopupWidget() != nullptr, kPatience);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        auto* ignore = menu->findChild<QAction*>(QStringLiteral("ignore-m-code"));
        QVERIFY(ignore != nullptr);
        QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(ignore).center());
        QTRY_VERIFY_WITH_TIMEOUT(rowOf("code-ignored") >= 0, kPatience);
        QCOMPARE(rowOf("code-unknown"), -1);
        QCOMPARE(station.session.job().setup().ignoredM, std::set<int>{16});
        QVERIFY(!station.session.program().current()->unverified());
    }

    void aProgramOfAnotherControlIsShownAndNamedOnce() {
        QTemporaryDir folder;
        QFile file(folder.filePath("plate.h"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("0 BEGIN PGM A MM\n1 TOOL CALL 5 Z S4000\n2 L X+10 Y+10 R0 FMAX\n3 END PGM A MM\n");
        file.close();
        Workstation station(false);
        station.window.files().open(file.fileName());
        QVERIFY(openingIsOver(station.session));
        QTRY_COMPARE_WITH_TIMEOUT(station.session.problems().all().size(), std::size_t{1}, kPatience);
        QCOMPARE(station.session.problems().all().front().id, "dialect-foreign");
        QCOMPARE(station.session.program().blockCount(), std::size_t{0});
        const auto* editor = station.window.findChild<NcEditor*>();
        QVERIFY(editor->text().startsWith(QLatin1String("0 BEGIN PGM A MM")));
        // Values under the pointer are requested by line; this text has none.
        QTest::mouseMove(editor->viewport(), QPoint(60, 8));
        QTest::qWait(1500);
        QCOMPARE(station.session.problems().all().size(), std::size_t{1});
    }

    void dropsAreJudgedBeforeTheyLand() {
        Workstation station(false);
        const auto enters = [&](const QList<QUrl>& urls) {
            QMimeData data;
            data.setUrls(urls);
            QDragEnterEvent event({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
            event.ignore();
            QApplication::sendEvent(&station.window, &event);
            return event.isAccepted();
        };
        QVERIFY(enters({QUrl::fromLocalFile(sampleJobs().front().file)}));
        QVERIFY(!enters({QUrl::fromLocalFile(QStringLiteral(PROVEOUT_SOURCE_DIR))}));
        QVERIFY(!enters({QUrl(QStringLiteral("https://example.org/a.nc"))}));
        QVERIFY(!enters({QUrl::fromLocalFile(QStringLiteral("/a/part.stl"))}));
        QVERIFY(!station.window.statusBar()->currentMessage().isEmpty());
    }

    void textsHaveContrast() {
        for (const QPalette& palette : {lightPalette(), darkPalette()}) {
            const auto ratio = [&](QPalette::ColorRole a, QPalette::ColorRole b) {
                return contrast(palette.color(a), palette.color(b));
            };
            QVERIFY(ratio(QPalette::WindowText, QPalette::Window) >= 4.5);
            QVERIFY(ratio(QPalette::Text, QPalette::Base) >= 4.5);
            QVERIFY(ratio(QPalette::Text, QPalette::AlternateBase) >= 4.5);
            QVERIFY(ratio(QPalette::ButtonText, QPalette::Button) >= 4.5);
            QVERIFY(ratio(QPalette::HighlightedText, QPalette::Highlight) >= 4.5);
            QVERIFY(ratio(QPalette::PlaceholderText, QPalette::Base) >= 4.5);
            QVERIFY(ratio(QPalette::PlaceholderText, QPalette::Window) >= 4.5);
            QVERIFY(ratio(QPalette::Link, QPalette::Base) >= 4.5);
            QVERIFY(ratio(QPalette::ToolTipText, QPalette::ToolTipBase) >= 4.5);
            const MeaningColors colors = meaningColors(palette);
            for (const QColor& ink : {colors.error, colors.warning, colors.note, colors.toolChange,
                                      colors.word, colors.coordinate, colors.comment})
                QVERIFY(contrast(ink, palette.color(QPalette::Base)) >= 4.5);
            QVERIFY(contrast(colors.accent, palette.color(QPalette::Base)) >= 3);
        }
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::WindowTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_test.moc"
