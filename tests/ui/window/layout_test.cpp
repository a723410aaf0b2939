// SPDX-License-Identifier: GPL-3.0-or-later
// The user's arrangement of the window is restored after a restart.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <random>

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QHash>
#include <QLabel>
#include <QMenuBar>
#include <QMouseEvent>
#include <QScrollBar>
#include <QStyle>
#include <QTemporaryDir>
#include <QTemporaryFile>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "tests/random_seed.h"
#include "tests/ui/window/workstation.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/findings/problems_model.h"
#include "ui/look/languages.h"
#include "ui/look/theme.h"
#include "ui/window/dock_layouts.h"
#include "ui/window/first_geometry.h"
#include "ui/window/kept_switches.h"

namespace proveout {
namespace {

constexpr QSize kSmallScreen{1280, 800};

/// The minimum size of each dock, for the message of a failure.
QString leastSizes(const QMainWindow& window) {
    QString text;
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        const QSize least = dock->minimumSizeHint();
        text += QStringLiteral("%1 %2 × %3\n").arg(dock->objectName()).arg(least.width()).arg(least.height());
    }
    return text;
}

/// Whether the visible sentence of a problem is wider than its column; the other columns must yield space to
/// it.
bool isSentenceClipped(const QTreeView& list) {
    const QAbstractItemView& view = list; // QTreeView hides sizeHintForColumn()
    return list.isVisible() && !list.visibleRegion().isEmpty() &&
           view.sizeHintForColumn(ProblemsModel::kSentence) > list.columnWidth(ProblemsModel::kSentence);
}

/// Whether a visible text is wider than its label.
bool isClipped(const QLabel& label) {
    return label.isVisible() && !label.visibleRegion().isEmpty() && !label.wordWrap() &&
           label.textFormat() != Qt::RichText && label.pixmap().isNull() &&
           label.sizeHint().width() > label.width();
}

QDockWidget* dockOf(const Workstation& station, const char* id) {
    return station.window.findChild<QDockWidget*>(QLatin1String(id));
}

void sendMouse(QMainWindow& window, QEvent::Type type, QPoint place, Qt::MouseButtons buttons) {
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, place, window.mapToGlobal(place), button, buttons, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &event);
}

/// Opens a program whose file exists as long as `folder`: if the file was deleted, the program would count as
/// unsaved, and opening the next one would ask about it.
void openText(Workstation& station, const QTemporaryDir& folder, const QByteArray& text) {
    QFile program(folder.filePath(QStringLiteral("%1.nc").arg(qHash(text))));
    if (!program.open(QIODevice::WriteOnly))
        qFatal("cannot write the test's own file");
    program.write(text);
    program.close();
    station.open(program.fileName());
}

/// Drags the border at the right of a dock. The layout applies moves a moment later.
void dragBorder(QMainWindow& window, const QDockWidget& dock, int by) {
    const int border = window.style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, &window);
    const QPoint from(dock.geometry().right() + 1 + border / 2, dock.geometry().center().y());
    const QPoint to = from + QPoint(by, 0);
    sendMouse(window, QEvent::MouseButtonPress, from, Qt::LeftButton);
    sendMouse(window, QEvent::MouseMove, to, Qt::LeftButton);
    QTest::qWait(100);
    sendMouse(window, QEvent::MouseButtonRelease, to, Qt::NoButton);
}

} // namespace

class LayoutTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void resettingTheLayoutDocksWhateverFloatsOrIsClosed() {
        Workstation station(true);
        const QList<QDockWidget*> docks = station.window.findChildren<QDockWidget*>();
        const std::uint32_t seed = randomSeed();
        std::mt19937 random(seed);
        for (int round = 0; round < 40; ++round) {
            for (QDockWidget* dock : docks) {
                switch (random() % 4) {
                case 0:
                    dock->setFloating(true);
                    break;
                case 1:
                    dock->close();
                    break;
                case 2:
                    dock->raise();
                    break;
                default:
                    break;
                }
                if (random() % 3 == 0)
                    QCoreApplication::processEvents();
            }
            station.window.resetLayout();
            for (const QDockWidget* dock : docks) {
                const QString what =
                    QStringLiteral("seed %1, round %2: %3").arg(seed).arg(round).arg(dock->objectName());
                QVERIFY2(!dock->isFloating(), qPrintable(what));
                QVERIFY2(!dock->isHidden() ||
                             !station.window.tabifiedDockWidgets(const_cast<QDockWidget*>(dock)).isEmpty(),
                         qPrintable(what));
            }
        }
    }

    void firstSizeLeavesRoomForTheFrame_data() {
        QTest::addColumn<QSize>("screen");
        QTest::addColumn<QSize>("first"); // empty: maximised
        QTest::newRow("smaller") << QSize(1024, 768) << QSize();
        QTest::newRow("as small") << kSmallScreen << QSize();
        QTest::newRow("laptop") << QSize(1366, 768) << QSize();
        QTest::newRow("just enough") << QSize(1300, 850) << kSmallScreen;
        QTest::newRow("full HD") << QSize(1920, 1080) << QSize(1632, 918);
        QTest::newRow("WQHD") << QSize(2560, 1440) << QSize(2176, 1224);
        QTest::newRow("4K") << QSize(3840, 2160) << QSize(2200, 1400);
    }

    void firstSizeLeavesRoomForTheFrame() {
        QFETCH(QSize, screen);
        QTEST(firstWindowSize(screen), "first");
    }

    void layoutAndLanguageComeBack() {
        {
            Workstation station(false);
            dockOf(station, "dock-tuning")->hide();
            station.appearance.setTheme(Theme::dark);
            station.appearance.setLanguage(QStringLiteral("de"));
            station.window.close();
        }
        {
            Workstation station(false);
            QVERIFY(dockOf(station, "dock-tuning")->isHidden());
            QVERIFY(isDark(QApplication::palette()));
            QCOMPARE(station.appearance.language(), QStringLiteral("de"));
            // Includes strings of classes, which moc and the catalogues name differently.
            QVERIFY(QCoreApplication::translate("proveout::TuningPanel", "Measured effect") !=
                    QLatin1String("Measured effect"));
            // Menus and docks must change to the new language immediately.
            const QString german = station.window.menuBar()->actions().front()->text();
            station.appearance.setLanguage(QStringLiteral("en"));
            QTRY_VERIFY_WITH_TIMEOUT(station.window.menuBar()->actions().front()->text() != german,
                                     kPatience);
            station.window.resetLayout();
            QVERIFY(!dockOf(station, "dock-tuning")->isHidden());
            station.appearance.setTheme(Theme::light);
        }
    }

    void everyLayoutFitsASmallScreenInEveryLanguage() {
        Workstation station(true);
        station.session.playback().seek(station.session.program().blockCount());
        QTRY_COMPARE_WITH_TIMEOUT(station.session.simulation().block(),
                                  station.session.program().blockCount(), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(station.session.program().times() != nullptr, kPatience);
        for (const DockLayout& layout : dockLayouts()) {
            station.window.action(QStringLiteral("layout-") + layout.id)->trigger();
            for (const Language& language : languages()) {
                station.appearance.setLanguage(language.code);
                QTest::qWait(100);
                station.window.resize(kSmallScreen);
                QTest::qWait(100);
                QVERIFY2(station.window.size() == kSmallScreen,
                         qPrintable(QStringLiteral("%1 in %2: %3 × %4\n%5")
                                        .arg(layout.id, language.code)
                                        .arg(station.window.width())
                                        .arg(station.window.height())
                                        .arg(leastSizes(station.window))));
            }
        }
    }

    void workUnderWayDoesNotWidenTheWindow() {
        for (const Language& language : languages()) {
            Appearance before;
            before.setLanguage(language.code); // as stored in the settings
            Workstation station(false);
            QVERIFY2(station.window.size() == kSmallScreen, qPrintable(QStringLiteral("%1: %2\n%3")
                                                                           .arg(language.code)
                                                                           .arg(station.window.width())
                                                                           .arg(leastSizes(station.window))));
            station.open(sampleJobs().back().file); // while it is read, the status bar shows the progress
            station.session.playback().seek(station.session.program().blockCount());
            QTRY_COMPARE_WITH_TIMEOUT(station.session.simulation().block(),
                                      station.session.program().blockCount(), kPatience);
            QCOMPARE(station.window.size(), kSmallScreen);
        }
    }

    void noTextIsClippedInAnyLanguage() {
        Workstation station(true);
        Setup setup = station.session.job().setup(); // causes problems with long sentences
        for (const auto& [number, cutter] : station.session.job().setup().tools.tools())
            setup.tools.set(number, cutter, {ToolSource::assumed});
        QVERIFY(station.session.job().setSetup(setup));
        QTRY_VERIFY_WITH_TIMEOUT(!station.session.problems().all().empty(), kPatience);
        station.session.playback().seek(station.session.program().blockCount());
        for (const Language& language : languages()) {
            station.appearance.setLanguage(language.code);
            for (QDockWidget* dock : station.window.findChildren<QDockWidget*>()) {
                dock->raise();
                QTest::qWait(50);
                for (const QLabel* label : station.window.findChildren<QLabel*>())
                    QVERIFY2(QTest::qWaitFor([label] { return !isClipped(*label); }, 2000),
                             qPrintable(language.code + u' ' + dock->objectName() + QStringLiteral(": ") +
                                        label->text()));
                const auto* problems = dockOf(station, "dock-problems")->findChild<QTreeView*>();
                QVERIFY2(QTest::qWaitFor([&] { return !isSentenceClipped(*problems); }, 2000),
                         qPrintable(language.code));
            }
        }
    }

    void firstScreenIsAMachinists() {
        const Workstation station(true);
        for (const char* id : {"dock-program", "dock-setup", "dock-problems", "dock-timeline"})
            QVERIFY2(!dockOf(station, id)->visibleRegion().isEmpty(), id);
        QVERIFY(dockOf(station, "dock-tuning")->visibleRegion().isEmpty());
        QVERIFY(station.session.playback().state().by == PlayBy::time);
        station.window.action(QStringLiteral("layout-research"))->trigger();
        QTRY_VERIFY(!dockOf(station, "dock-tuning")->visibleRegion().isEmpty());
        QTRY_VERIFY(!dockOf(station, "dock-plots")->visibleRegion().isEmpty());
        QVERIFY(station.session.playback().state().by == PlayBy::blocks);
    }

    void chosenLayoutComesBack() {
        {
            const Workstation station(false);
            station.window.action(QStringLiteral("layout-research"))->trigger();
        } // destroyed as if it was killed, so the window's own layout was not stored
        const Workstation station(false);
        QTRY_VERIFY(!dockOf(station, "dock-plots")->visibleRegion().isEmpty());
        QVERIFY(station.window.action(QStringLiteral("layout-research"))->isChecked());
    }

    void editorIsAsWideAsItsLines() {
        const QTemporaryDir folder;
        Workstation station(false);
        station.window.resize(1600, 900);
        const auto widthWith = [&](const QByteArray& line) {
            openText(station, folder, (line + '\n').repeated(100));
            QTest::qWait(100);
            return dockOf(station, "dock-program")->width();
        };
        const int narrow = widthWith("G1 X1 F100");
        const int wide = widthWith("G1 X100.1234 Y200.1234 Z-30.1234 F1000 (finishing)");
        QVERIFY2(wide > narrow, qPrintable(QStringLiteral("%1 %2").arg(wide).arg(narrow)));
        QVERIFY(wide <= station.window.width() * 0.35);
        // A width chosen by the user is kept.
        station.window.resizeDocks({dockOf(station, "dock-program")}, {wide - 60}, Qt::Horizontal);
        QTest::qWait(100);
        const int chosen = dockOf(station, "dock-program")->width();
        QCOMPARE(widthWith("G1 X1 F100"), chosen);
    }

    void editorShowsItsFewLongLinesButNoComment() {
        const QTemporaryDir folder;
        Workstation station(false);
        station.window.resize(2560, 1000);
        const auto wantedWith = [&](const QByteArray& line) {
            openText(station, folder,
                     QByteArray("N20 G1 X-269.39 Y-254.65 Z-68.5 F200\n").repeated(100) + line + '\n');
            return station.window.editor().sizeHint().width();
        };
        const int usual = wantedWith("G1 X1");
        QVERIFY(wantedWith("N40 IF [ #5405 GE 6000 ] THEN #3000= 15 ( TOOL LIFE EXPIRED )") > usual);
        QCOMPARE(wantedWith("(" + QByteArray("A NOTE OF THE SHOP ").repeated(20) + ")"), usual);
    }

    void editorStaysAsWideAsItsLinesInEveryWindow() {
        const auto write = [](QTemporaryFile& program) {
            if (!program.open())
                qFatal("cannot write the test's own file");
            program.write(QByteArray("N100 G1 X100.1234 Y200.1234 Z-30.1234 F1000 (finishing the long side "
                                     "of the pocket, the second time)\n")
                              .repeated(100));
            program.close();
        };
        QTemporaryFile program(QDir::tempPath() + QStringLiteral("/XXXXXX.nc"));
        write(program);
        const auto wanted = [](const Workstation& station) {
            return leftDockWidth(station.window.width(),
                                 dockOf(station, "dock-program")->widget()->sizeHint().width());
        };
        const auto isFitted = [&](const Workstation& station) {
            return QTest::qWaitFor(
                [&] { return std::abs(dockOf(station, "dock-program")->width() - wanted(station)) <= 3; },
                3000);
        };
        {
            Workstation station(false);
            station.window.resize(1280, 800);
            station.open(program.fileName());
            QVERIFY(isFitted(station));
            const int narrow = wanted(station);
            for (const int width : {2000, 1400, 1280, 2560}) {
                station.window.resize(width, 1000);
                QVERIFY2(isFitted(station), qPrintable(QString::number(width)));
            }
            QVERIFY(wanted(station) > narrow);
            const auto* bar = station.window.editor().findChild<NcEditor*>()->horizontalScrollBar();
            QTRY_VERIFY2(!bar->isVisible() || bar->maximum() <= 0, "lines are cut");
            station.window.close();
        }
        { // also after a restart
            Workstation station(false);
            station.open(program.fileName());
            QVERIFY(isFitted(station));
        }
    }

    void widthThatTheUserDragsStays() {
        const QTemporaryDir folder;
        const auto openProgram = [&](Workstation& station, const QByteArray& line) {
            openText(station, folder, (line + '\n').repeated(100));
            QTest::qWait(200);
        };
        constexpr int kDragged = 130;
        int dragged = 0;
        {
            Workstation station(false);
            station.window.resize(1600, 900);
            openProgram(station, "G1 X1 F100");
            QDockWidget* dock = dockOf(station, "dock-program");
            const int before = dock->width();
            dragBorder(station.window, *dock, kDragged);
            QTRY_COMPARE(dock->width(), before + kDragged);
            dragged = dock->width();
            openProgram(station, "G1 X100.1234 Y200.1234 Z-30.1234 F1000 (finishing)");
            QCOMPARE(dock->width(), dragged);
            station.window.resize(1700, 900);
            QTest::qWait(200);
            QCOMPARE(dock->width(), dragged);
            station.window.close();
        }
        Workstation station(false);
        openProgram(station, "G1 X1 F100");
        QCOMPARE(dockOf(station, "dock-program")->width(), dragged);
    }

    void dockHasOneTitle() {
        const Workstation station(false);
        QDockWidget* plots = dockOf(station, "dock-plots");
        QTRY_VERIFY(plots->titleBarWidget() != nullptr); // its tab has the title
        QVERIFY(dockOf(station, "dock-program")->titleBarWidget() == nullptr);
        plots->setFloating(true);
        QTRY_VERIFY(plots->titleBarWidget() == nullptr);
        plots->setFloating(false);
        QTRY_VERIFY(plots->titleBarWidget() != nullptr);
        auto* close = plots->titleBarWidget()->findChild<QToolButton*>(QStringLiteral("close-dock"));
        plots->raise();
        QTest::mouseClick(close, Qt::LeftButton);
        QVERIFY(plots->isHidden());
        // The last remaining dock of a tab group has its title bar again.
        QDockWidget* problems = dockOf(station, "dock-problems");
        for (QDockWidget* other : station.window.tabifiedDockWidgets(problems))
            other->close();
        QTRY_VERIFY(problems->titleBarWidget() == nullptr);
    }

    void floatingDocksComeBackInFront() {
        {
            Workstation station(false);
            QDockWidget* tuning = dockOf(station, "dock-tuning");
            tuning->setFloating(true);
            tuning->setGeometry(QRect(station.window.geometry().center(), QSize(340, 400)));
            QTest::qWait(100);
            station.window.close();
        }
        Appearance appearance;
        Session session;
        MainWindow window(session, appearance);
        window.show();
        window.raise(); // as window managers do with the last window of a starting application
        // Until then the order of the windows changes back and forth.
        QVERIFY(QTest::qWaitForWindowActive(&window));
        const auto* tuning = window.findChild<QDockWidget*>(QStringLiteral("dock-tuning"));
        QVERIFY(tuning->isFloating());
        QVERIFY(window.geometry().contains(tuning->geometry().center()));
        const auto onTop = [&] {
            const QWidget* seen = QApplication::widgetAt(tuning->geometry().center());
            return seen != nullptr && seen->window() == tuning;
        };
        QTRY_VERIFY_WITH_TIMEOUT(onTop(), kPatience);
    }

    void viewOptionsComeBackAndAreReset() {
        const QStringList changed{"view-wireframe",   "view-tint",           "view-legend",
                                  "view-perspective", "path-whole",          "cutter-see-through",
                                  "plot-faces",       "plot-removed-volume", "view-deviation",
                                  "view-part"}; // these are disabled here
        const auto isOn = [](const Workstation& station, const QString& id) {
            return station.window.action(id)->isChecked();
        };
        QHash<QString, bool> first;
        {
            Workstation station(false);
            if (station.window.action(changed.front()) == nullptr)
                QSKIP("no OpenGL here");
            for (const QString& id : changed)
                first[id] = isOn(station, id);
            for (const QString& id : changed)
                triggerSwitch(*station.window.action(id));
            QVERIFY(!station.window.action(QStringLiteral("view-deviation"))->isEnabled());
            station.window.close();
        }
        {
            Workstation station(false);
            for (const QString& id : changed)
                QVERIFY2(isOn(station, id) != first[id], qPrintable(id));
            QVERIFY(!isOn(station, QStringLiteral("path-near")));
            station.window.action(QStringLiteral("reset-layout"))->trigger();
            for (const QString& id : changed)
                QVERIFY2(isOn(station, id) == first[id], qPrintable(id));
            QVERIFY(isOn(station, QStringLiteral("path-near")));
            station.window.close();
        }
        Workstation station(false);
        for (const QString& id : changed)
            QVERIFY2(isOn(station, id) == first[id], qPrintable(id));
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::LayoutTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "layout_test.moc"
