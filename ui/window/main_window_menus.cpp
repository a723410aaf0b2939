// SPDX-License-Identifier: GPL-3.0-or-later
// The menus of the main window, made from its tables.
#include <functional>

#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

#include "ui/editor/editor_panel.h"
#include "ui/findings/problems_panel.h"
#include "ui/plots/plots_panel.h"
#include "ui/resource_paths.h"
#include "ui/window/checkpoint_menu.h"
#include "ui/window/layout_menu.h"
#include "ui/window/main_window.h"
#include "ui/window/main_window_tables.h"
#include "ui/window/recent_menu.h"
#include "ui/window/undo_commands.h"

namespace proveout {

namespace {

QList<QAction*> listOf(const std::vector<QAction*>& actions) {
    return {actions.begin(), actions.end()};
}

} // namespace

QMenu* MainWindow::addMenu(const char* title, const QList<QAction*>& actions) {
    QMenu* menu = menuBar()->addMenu(QString());
    menu->addActions(actions);
    menu->setToolTipsVisible(true);
    m_menus.emplace_back(menu, title);
    return menu;
}

void MainWindow::makeMenus() {
    QMenu* file = addMenu(QT_TRANSLATE_NOOP("Menus", "&File"), listOf(m_fileCommands.all()));
    auto* recent = new RecentMenu(*m_files, this);
    file->insertMenu(m_fileCommands.all()[2], recent);
    m_menus.emplace_back(recent, QT_TRANSLATE_NOOP("Menus", "Open &Recent"));

    QMenu* edit =
        addMenu(QT_TRANSLATE_NOOP("Menus", "&Edit"), listOf(m_undo->actions().all()) + m_editor->actions());
    edit->addSeparator();
    edit->addActions(m_problems->actions());

    QList<QAction*> viewActions = m_viewport->actions();
    for (QAction* action : m_playback->actions().all())
        viewActions.removeAll(action);
    QMenu* view = addMenu(QT_TRANSLATE_NOOP("Menus", "&View"), viewActions);
    if (!m_plots->actions().isEmpty()) {
        view->addSeparator();
        QMenu* plots = view->addMenu(QString());
        plots->addActions(m_plots->actions());
        m_menus.emplace_back(plots, QT_TRANSLATE_NOOP("Menus", "P&lots"));
    }
    QMenu* simulate = addMenu(QT_TRANSLATE_NOOP("Menus", "&Simulate"), listOf(m_playback->actions().all()));
    simulate->addSeparator();
    simulate->addAction(&m_editor->followAction());
    auto* checkpoints = new CheckpointMenu(m_session, this);
    simulate->addMenu(checkpoints);
    m_menus.emplace_back(checkpoints, QT_TRANSLATE_NOOP("Menus", "Rewind &Memory"));
    addMenu(QT_TRANSLATE_NOOP("Menus", "&Mesh"), listOf(m_meshCommands.all()));

    QMenu* window = addMenu(QT_TRANSLATE_NOOP("Menus", "&Window"), {});
    for (QDockWidget* dock : m_docks)
        window->addAction(dock->toggleViewAction());
    window->addSeparator();
    m_layoutMenu = new LayoutMenu(this);
    window->addMenu(m_layoutMenu);
    m_menus.emplace_back(m_layoutMenu, QT_TRANSLATE_NOOP("Menus", "L&ayout"));
    m_themeMenu = window->addMenu(icon(QStringLiteral("theme")), QString());
    m_languageMenu = window->addMenu(icon(QStringLiteral("language")), QString());
    m_menus.emplace_back(m_themeMenu, QT_TRANSLATE_NOOP("Menus", "&Theme"));
    m_menus.emplace_back(m_languageMenu, QT_TRANSLATE_NOOP("Menus", "&Language"));
    window->addSeparator();
    window->addActions(listOf(m_windowCommands.all()));

    QMenu* help = addMenu(QT_TRANSLATE_NOOP("Menus", "&Help"), listOf(m_helpCommands.all()));
    m_samplesMenu = new QMenu(this);
    help->insertMenu(m_helpCommands.find("help-about"), m_samplesMenu);
    help->insertSeparator(m_helpCommands.find("help-about"));
    m_menus.emplace_back(m_samplesMenu, QT_TRANSLATE_NOOP("Menus", "Open Sa&mple"));
}

void MainWindow::fillChoices() {
    const auto fill = [this](QMenu* menu, const QList<QPair<QString, QString>>& choices,
                             const QString& present, const std::function<void(const QString&)>& choose) {
        menu->clear();
        auto* group = new QActionGroup(menu);
        for (const auto& [key, text] : choices) {
            QAction* action = menu->addAction(text);
            action->setCheckable(true);
            action->setChecked(key == present);
            group->addAction(action);
            // Queued, because a change of language fills this menu again.
            connect(
                action, &QAction::triggered, this, [choose, key = key] { choose(key); },
                Qt::QueuedConnection);
        }
    };
    fill(m_themeMenu,
         {{themeKey(Theme::system), tr("Same as &System")},
          {themeKey(Theme::light), tr("&Light")},
          {themeKey(Theme::dark), tr("&Dark")}},
         themeKey(m_appearance.theme()),
         [this](const QString& key) { m_appearance.setTheme(themeFromKey(key)); });
    QList<QPair<QString, QString>> all;
    for (const Language& language : languages())
        all.append({language.code, language.name});
    fill(m_languageMenu, all, m_appearance.language(),
         [this](const QString& code) { m_appearance.setLanguage(code); });
}

void MainWindow::fillSamples() {
    m_samplesMenu->clear();
    for (const SampleJob& sample : sampleJobs())
        connect(m_samplesMenu->addAction(sample.name), &QAction::triggered, this,
                [this, file = sample.file] { m_files->open(file); });
}

} // namespace proveout
