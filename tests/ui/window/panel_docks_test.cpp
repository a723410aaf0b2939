// SPDX-License-Identifier: GPL-3.0-or-later
// A panel is one row: however many there are, each has its dock, its place in every layout and its shortcut.
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <QLabel>
#include <QMainWindow>
#include <QStackedWidget>
#include <QTest>

#include "tests/ui/window/workstation.h"
#include "ui/session/playback_commands.h"
#include "ui/window/panel_docks.h"

namespace proveout {
namespace {

constexpr int kVersion = 1;

QWidget* makeLabel(const PanelParts&, QWidget* parent) {
    return new QLabel(QStringLiteral("a panel"), parent);
}

/// Labels in place of the panels, and additional ones with the given ids.
std::vector<PanelRow> labels(const std::vector<PanelRow>& more) {
    std::vector<PanelRow> rows(panelTable().begin(), panelTable().end());
    rows.insert(rows.end(), more.begin(), more.end());
    for (PanelRow& row : rows)
        row.make = makeLabel;
    return rows;
}

const PanelRow kTenth{.id = "dock-tenth", .title = "Tenth", .icon = "path", .keys = "Ctrl+0"};
const PanelRow kEleventh{.id = "dock-eleventh", .title = "Eleventh", .icon = "path", .area = DockArea::right};

struct Docks {
    std::vector<PanelRow> rows;
    Session session;
    QMainWindow window;
    PlaybackCommands playback{session};
    QStackedWidget* centre = new QStackedWidget(&window);
    PanelDocks* docks = nullptr;

    explicit Docks(const std::vector<PanelRow>& more) : rows(labels(more)) {
        centre->addWidget(new QLabel(&window));
        window.setCentralWidget(centre);
        docks = new PanelDocks(window, *centre, {session, playback}, rows);
        window.resize(1280, 800);
        docks->arrange(dockLayouts().front());
        window.show();
    }
    [[nodiscard]] QDockWidget* dock(const char* id) const {
        return window.findChild<QDockWidget*>(QLatin1String(id));
    }
    [[nodiscard]] bool areTabs(const char* one, const char* other) const {
        return window.tabifiedDockWidgets(dock(one)).contains(dock(other));
    }
};

} // namespace

class PanelDocksTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void everyPanelOfTheTableHasItsOwnNameAndKey() {
        std::set<std::string> ids;
        std::set<std::string> keys;
        for (const PanelRow& row : panelTable()) {
            QVERIFY2(QLatin1String(row.id).startsWith(QLatin1String("dock-")), row.id);
            QVERIFY2(*row.title != '\0' && *row.icon != '\0', row.id);
            QVERIFY2(ids.insert(row.id).second, row.id);
            QVERIFY2(*row.keys == '\0' || keys.insert(row.keys).second, row.id);
        }
        for (const DockLayout& layout : dockLayouts())
            for (const std::vector<DockTabs>* places : {&layout.left, &layout.right, &layout.bottom})
                for (const DockTabs& tabs : *places)
                    for (const char* id : tabs)
                        QVERIFY2(ids.count(id) == 1, id);
    }

    void panelsThatNoLayoutNamesAreTabsInTheirArea() {
        Docks docks({kTenth, kEleventh});
        for (const DockLayout& layout : dockLayouts()) {
            docks.docks->arrange(layout);
            for (const QDockWidget* dock : docks.docks->all())
                QVERIFY2(!dock->isHidden() && !dock->isFloating(), qPrintable(dock->objectName()));
            QCOMPARE(docks.window.dockWidgetArea(docks.dock("dock-tenth")), Qt::BottomDockWidgetArea);
            QVERIFY(docks.areTabs("dock-tenth", "dock-study"));
            QCOMPARE(docks.window.dockWidgetArea(docks.dock("dock-eleventh")), Qt::RightDockWidgetArea);
            QVERIFY(docks.areTabs("dock-eleventh", "dock-tuning"));
        }
    }

    void aPanelNeedsNoKey() {
        Docks docks({kTenth, kEleventh});
        QCOMPARE(docks.dock("dock-tenth")->toggleViewAction()->shortcut(),
                 QKeySequence(QStringLiteral("Ctrl+0")));
        QAction* toggle = docks.dock("dock-eleventh")->toggleViewAction();
        QVERIFY(toggle->shortcut().isEmpty());
        docks.docks->show("dock-setup");
        QVERIFY(!docks.dock("dock-eleventh")->widget()->isVisible());
        toggle->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(docks.dock("dock-eleventh")->widget()->isVisible(), kPatience);
    }

    void theStateOfAWindowWithFewerPanelsPlacesTheOthers() {
        QByteArray kept;
        {
            Docks before({});
            before.dock("dock-tuning")->hide();
            before.window.addDockWidget(Qt::LeftDockWidgetArea, before.dock("dock-control"));
            before.dock("dock-study")->setFloating(true);
            kept = before.window.saveState(kVersion);
        }
        Docks after({kTenth, kEleventh});
        QVERIFY(after.docks->restore(kept, kVersion));
        QVERIFY(after.dock("dock-tuning")->isHidden());
        QVERIFY(after.dock("dock-study")->isFloating());
        QCOMPARE(after.window.dockWidgetArea(after.dock("dock-control")), Qt::LeftDockWidgetArea);
        QCOMPARE(after.window.dockWidgetArea(after.dock("dock-tenth")), Qt::BottomDockWidgetArea);
        QCOMPARE(after.window.dockWidgetArea(after.dock("dock-eleventh")), Qt::RightDockWidgetArea);
        for (const char* id : {"dock-tenth", "dock-eleventh"}) {
            after.docks->activate(id);
            QTRY_VERIFY_WITH_TIMEOUT(!after.dock(id)->visibleRegion().isEmpty(), kPatience);
        }
        QVERIFY(!after.docks->restore(kept, kVersion + 1));
    }

    void titlesAreMarkedForWhatPanelsShow() {
        Workstation station(true);
        const auto title = [&](const char* id) {
            return station.window.findChild<QDockWidget*>(QLatin1String(id))->windowTitle();
        };
        QCOMPARE(title(kProgramPanel), QStringLiteral("NC Program"));
        QCOMPARE(title(kSetupPanel), QStringLiteral("Setup"));
        DecimationParameters parameters = station.session.job().parameters();
        parameters.allowance = 0.3;
        station.session.job().setParameters(parameters);
        QCOMPARE(title(kSetupPanel), QStringLiteral("Setup*"));
        QCOMPARE(title(kProgramPanel), QStringLiteral("NC Program"));
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::PanelDocksTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "panel_docks_test.moc"
