// SPDX-License-Identifier: GPL-3.0-or-later
// What the user has arranged comes back after a restart.
#include <memory>

#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QTest>

#include "tests/ui/window/workstation.h"
#include "ui/theme.h"

namespace proveout {
namespace {

QDockWidget* dockOf(const Workstation& station, const char* id) {
    return station.window.findChild<QDockWidget*>(QLatin1String(id));
}

} // namespace

class LayoutTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }

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
            // Strings of classes too, which moc and the catalogues name differently.
            QVERIFY(QCoreApplication::translate("proveout::TuningPanel", "Measured effect") !=
                    QLatin1String("Measured effect"));
            // Live: menus and docks speak the new language at once.
            const QString german = station.window.menuBar()->actions().front()->text();
            station.appearance.setLanguage(QStringLiteral("en"));
            QTRY_VERIFY_WITH_TIMEOUT(station.window.menuBar()->actions().front()->text() != german,
                                     kPatience);
            station.window.resetLayout();
            QVERIFY(!dockOf(station, "dock-tuning")->isHidden());
            station.appearance.setTheme(Theme::light);
        }
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
        window.raise(); // as window managers do with the last window of an application that comes up
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
        const QStringList changed{"view-wireframe",   "view-tint",          "view-legend",
                                  "view-perspective", "path-whole",         "cutter-see-through",
                                  "plot-faces",       "plot-removed-volume"};
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
                station.window.action(id)->trigger();
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
