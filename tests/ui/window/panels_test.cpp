// SPDX-License-Identifier: GPL-3.0-or-later
// The focus between panels: their shortcuts and tabs; hidden widgets never have it.
#include <memory>

#include <QAbstractButton>
#include <QApplication>
#include <QDockWidget>
#include <QTabBar>
#include <QTest>

#include "tests/ui/window/workstation.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/window/start_page.h"

namespace proveout {
namespace {

struct Panels {
    Workstation station{true};

    /// Program and setup share a tab group, whatever the initial layout.
    Panels() {
        station.window.tabifyDockWidget(&dock("dock-program"), &dock("dock-setup"));
        dock("dock-program").raise();
        QTest::qWait(50);
    }
    QDockWidget& dock(const char* id) const {
        return *station.window.findChild<QDockWidget*>(QLatin1String(id));
    }
    /// Uses its shortcut, wherever the focus is; if it has none, the menu.
    void press(const QDockWidget& dock) {
        QAction& toggle = *dock.toggleViewAction();
        if (toggle.shortcut().isEmpty()) {
            toggle.trigger();
        } else {
            const QKeyCombination key = toggle.shortcut()[0];
            QWidget* focus = QApplication::focusWidget();
            QTest::keyClick(focus != nullptr ? focus : &station.window, key.key(), key.keyboardModifiers());
        }
        QTest::qWait(20);
    }
    static bool has(const QDockWidget& dock) {
        const QWidget* focus = QApplication::focusWidget();
        return focus != nullptr && (focus == dock.widget() || dock.widget()->isAncestorOf(focus));
    }
    /// Whether the focused widget is on the screen: Qt also counts covered tabs as visible.
    static bool focusIsSeen() {
        const QWidget* focus = QApplication::focusWidget();
        return focus != nullptr && focus->isVisible() && !focus->visibleRegion().isEmpty();
    }
    /// Clicks the tab of a dock.
    void chooseTab(const QDockWidget& dock) {
        for (QTabBar* bar : station.window.findChildren<QTabBar*>()) {
            for (int tab = 0; tab < bar->count(); ++tab) {
                if (bar->tabText(tab) == dock.windowTitle())
                    QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(tab).center());
            }
        }
        QTest::qWait(50);
    }
    [[nodiscard]] bool centreHasFocus() const {
        return station.window.centralWidget()->isAncestorOf(QApplication::focusWidget());
    }
};

} // namespace

class PanelsTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void aKeyRaisesAndFocusesAndTheSecondPressCloses() {
        Panels panels;
        for (QDockWidget* dock : panels.station.window.findChildren<QDockWidget*>()) {
            panels.station.window.viewport().setFocus();
            const QByteArray name = dock->objectName().toLatin1();
            panels.press(*dock);
            QVERIFY2(!dock->isHidden() && dock->widget()->isVisible(), name);
            QVERIFY2(Panels::has(*dock), name);
            QVERIFY2(Panels::focusIsSeen(), name);
            QVERIFY2(dock->toggleViewAction()->isChecked(), name);
            panels.press(*dock);
            QVERIFY2(dock->isHidden(), name);
            QVERIFY2(!dock->toggleViewAction()->isChecked(), name);
            QVERIFY2(Panels::focusIsSeen() && panels.centreHasFocus(), name);
            panels.press(*dock); // opens it again
            QVERIFY2(dock->widget()->isVisible() && Panels::has(*dock) && Panels::focusIsSeen(), name);
        }
    }

    void aPanelBehindATabIsRaisedNotClosed() {
        Panels panels;
        const QDockWidget& program = panels.dock("dock-program");
        const QDockWidget& setup = panels.dock("dock-setup");
        panels.press(setup);
        QVERIFY(Panels::has(setup));
        QVERIFY(!program.widget()->isVisible());
        panels.press(program);
        QVERIFY(!program.isHidden());
        QVERIFY(!setup.isHidden());
        QCOMPARE(QApplication::focusWidget(), &panels.station.window.editor().editor());
        QVERIFY(!setup.widget()->isVisible());
        // If it is visible without the focus, it gets the focus and stays open.
        panels.station.window.viewport().setFocus();
        panels.press(program);
        QVERIFY(!program.isHidden() && Panels::has(program));
    }

    void theKeyboardLeavesAPanelThatIsClosedOrCovered() {
        Panels panels;
        QDockWidget& program = panels.dock("dock-program");
        const QDockWidget& setup = panels.dock("dock-setup");
        panels.press(program);
        panels.chooseTab(setup);
        QVERIFY(setup.widget()->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(Panels::has(setup) && Panels::focusIsSeen(), kPatience);
        panels.chooseTab(program);
        QTRY_VERIFY_WITH_TIMEOUT(Panels::has(program) && Panels::focusIsSeen(), kPatience);
        // Selecting a tab while the focus is elsewhere does not move the focus.
        panels.station.window.viewport().setFocus();
        panels.chooseTab(setup);
        QVERIFY(panels.station.window.viewport().hasFocus());
        panels.press(program);
        QTest::mouseClick(program.findChild<QAbstractButton*>(QStringLiteral("close-dock")), Qt::LeftButton);
        QVERIFY(program.isHidden());
        QVERIFY(Panels::focusIsSeen() && panels.centreHasFocus());
        const NcEditor& editor = panels.station.window.editor().editor();
        const std::size_t bytes = editor.textBytes().size();
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("X9"));
        QCOMPARE(editor.textBytes().size(), bytes);
    }

    void tabGoesThroughWhatIsSeenOnly() {
        Panels panels;
        panels.station.window.viewport().setFocus();
        constexpr int kMost = 120;
        panels.station.window.editor().editor().setFocusPolicy(Qt::ClickFocus); // Tab is a character there
        int steps = 0;
        do {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            QTRY_VERIFY2_WITH_TIMEOUT(Panels::focusIsSeen(),
                                      QApplication::focusWidget()->metaObject()->className(), kPatience);
        } while (++steps < kMost && !panels.station.window.viewport().hasFocus());
        QVERIFY(steps > 3);
    }

    void findOpensThePanelThatItWorksIn() {
        Panels panels;
        QDockWidget& program = panels.dock("dock-program");
        for (const bool closed : {false, true}) {
            panels.dock("dock-setup").raise();
            program.setVisible(!closed);
            QTest::qWait(20);
            panels.station.window.viewport().setFocus();
            QTest::keyClick(&panels.station.window.viewport(), Qt::Key_F, Qt::ControlModifier);
            QTRY_VERIFY_WITH_TIMEOUT(Panels::has(program) && Panels::focusIsSeen(), kPatience);
        }
        // The same applies to commands that show a line.
        panels.dock("dock-setup").raise();
        QTest::qWait(20);
        QVERIFY(!program.widget()->isVisible());
        emit panels.station.session.navigation().lineRequested(5, 1);
        QVERIFY(program.widget()->isVisible());
    }

    void floatingPanelsTheStartPageAndFullScreen() {
        Panels panels;
        QDockWidget& tuning = panels.dock("dock-tuning");
        tuning.setFloating(true);
        panels.press(panels.dock("dock-program"));
        panels.press(tuning);
        QTRY_VERIFY_WITH_TIMEOUT(Panels::has(tuning) && Panels::focusIsSeen(), kPatience);
        panels.press(tuning);
        QVERIFY(tuning.isHidden());
        QTRY_VERIFY_WITH_TIMEOUT(Panels::focusIsSeen() && !Panels::has(tuning), kPatience);
        tuning.setFloating(false);

        panels.station.window.viewport().setFocus();
        panels.station.window.showStartPage();
        QTRY_VERIFY_WITH_TIMEOUT(Panels::focusIsSeen(), kPatience);
        auto* page = panels.station.window.findChild<StartPage*>();
        QVERIFY(page->isAncestorOf(QApplication::focusWidget()));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(panels.station.window.viewport().hasFocus(), kPatience);

        panels.press(panels.dock("dock-setup"));
        panels.station.window.toggleFullScreen();
        QTRY_VERIFY_WITH_TIMEOUT(Panels::has(panels.dock("dock-setup")) && Panels::focusIsSeen(), kPatience);
        panels.station.window.toggleFullScreen();
        QTRY_VERIFY_WITH_TIMEOUT(Panels::has(panels.dock("dock-setup")) && Panels::focusIsSeen(), kPatience);
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::PanelsTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "panels_test.moc"
