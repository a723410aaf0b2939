// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_menus.h"

#include <utility>

#include <QDockWidget>
#include <QMenuBar>

#include "ui/editor/editor_panel.h"
#include "ui/look/resource_paths.h"
#include "ui/session/playback_commands.h"
#include "ui/viewport/viewport.h"
#include "ui/window/appearance_menus.h"
#include "ui/window/layout_menu.h"
#include "ui/window/main_window.h"
#include "ui/window/memory_menu.h"
#include "ui/window/panel_docks.h"
#include "ui/window/recent_menu.h"
#include "ui/window/undo_commands.h"
#include "ui/window/window_commands.h"

namespace proveout {

namespace {

QList<QAction*> listOf(const std::vector<QAction*>& actions) {
    return {actions.begin(), actions.end()};
}

} // namespace

WindowMenus::WindowMenus(MainWindow& window, const UndoCommands& undo, const PlaybackCommands& playback)
    : QObject(&window), m_window(window), m_file(window, kFileContext, fileCommands(), &window),
      m_mesh(window, kMeshContext, meshCommands(), &window),
      m_ofWindow(window, kWindowContext, windowCommands(), &window),
      m_help(window, kHelpContext, helpCommands(), &window),
      m_appearance(new AppearanceMenus(window.appearance(), &window)), m_layouts(new LayoutMenu(&window)),
      m_samples(new QMenu(&window)) {
    addFile();
    addEdit(undo);
    addView(playback);
    addSimulate(playback);
    addMesh();
    addWindow();
    addHelp();
}

void WindowMenus::addTitled(QMenu& menu, const char* title) {
    m_titles.emplace_back(&menu, title);
}

QMenu& WindowMenus::add(const char* title, const QList<QAction*>& actions) {
    QMenu& menu = *m_window.menuBar()->addMenu(QString());
    menu.addActions(actions);
    menu.setToolTipsVisible(true);
    addTitled(menu, title);
    return menu;
}

/// The commands of each panel form a group of their own.
void WindowMenus::addOfPanels(QMenu& menu, PanelMenu place) {
    const PanelDocks& docks = m_window.docks();
    for (std::size_t i = 0; i < docks.all().size(); ++i) {
        const PanelRow& row = docks.rows()[i];
        const QList<QAction*> actions = docks.all()[i]->widget()->actions();
        if (row.menu != place || actions.isEmpty())
            continue;
        if (!menu.isEmpty() && !menu.actions().back()->isSeparator())
            menu.addSeparator();
        if (*row.submenu == '\0') {
            menu.addActions(actions);
        } else {
            QMenu& own = *menu.addMenu(QString());
            own.addActions(actions);
            addTitled(own, row.submenu);
        }
    }
}

void WindowMenus::addFile() {
    QMenu& menu = add(QT_TRANSLATE_NOOP("Menus", "&File"), listOf(m_file.all()));
    auto* recent = new RecentMenu(m_window.files(), &m_window);
    menu.insertMenu(m_file.all()[2], recent);
    addTitled(*recent, QT_TRANSLATE_NOOP("Menus", "Open &Recent"));
}

void WindowMenus::addEdit(const UndoCommands& undo) {
    addOfPanels(add(QT_TRANSLATE_NOOP("Menus", "&Edit"), listOf(undo.actions().all())), PanelMenu::edit);
}

void WindowMenus::addView(const PlaybackCommands& playback) {
    QList<QAction*> actions = m_window.viewport().actions();
    for (QAction* action : playback.actions().all())
        actions.removeAll(action); // they are active in the view, but belong in another menu
    addOfPanels(add(QT_TRANSLATE_NOOP("Menus", "&View"), actions), PanelMenu::view);
}

void WindowMenus::addSimulate(const PlaybackCommands& playback) {
    QMenu& menu = add(QT_TRANSLATE_NOOP("Menus", "&Simulate"), listOf(playback.actions().all()));
    menu.addSeparator();
    menu.addAction(&m_window.editor().followAction());
    addMemory(menu);
}

void WindowMenus::addMemory(QMenu& menu) {
    const auto add = [&](const char* name, const char* title, const char* key, MemoryMenu::Apply apply) {
        auto* choice = new MemoryMenu(QLatin1String(key), std::move(apply), &m_window);
        choice->setObjectName(QLatin1String(name));
        menu.addMenu(choice);
        addTitled(*choice, title);
    };
    add("checkpoint-menu", QT_TRANSLATE_NOOP("Menus", "Rewind &Memory"), "simulation/checkpoint-megabytes",
        [&playback = m_window.session().playback()](std::size_t bytes) {
            playback.setCheckpointBudget(bytes);
        });
    // There is no such view where OpenGL is missing.
    add("graphics-memory-menu", QT_TRANSLATE_NOOP("Menus", "&Graphics Memory"), "view/graphics-megabytes",
        [view = qobject_cast<Viewport*>(&m_window.viewport())](std::size_t bytes) {
            if (view != nullptr)
                view->picture().setMemory(bytes);
        });
}

void WindowMenus::addMesh() {
    add(QT_TRANSLATE_NOOP("Menus", "&Mesh"), listOf(m_mesh.all()));
}

void WindowMenus::addWindow() {
    QMenu& menu = add(QT_TRANSLATE_NOOP("Menus", "&Window"), {});
    for (const QDockWidget* dock : m_window.docks().all())
        menu.addAction(dock->toggleViewAction());
    menu.addSeparator();
    menu.addMenu(m_layouts);
    menu.addMenu(&m_appearance->theme());
    menu.addMenu(&m_appearance->language());
    addTitled(*m_layouts, QT_TRANSLATE_NOOP("Menus", "L&ayout"));
    addTitled(m_appearance->theme(), QT_TRANSLATE_NOOP("Menus", "&Theme"));
    addTitled(m_appearance->language(), QT_TRANSLATE_NOOP("Menus", "&Language"));
    menu.addSeparator();
    menu.addActions(listOf(m_ofWindow.all()));
}

void WindowMenus::addHelp() {
    QMenu& menu = add(QT_TRANSLATE_NOOP("Menus", "&Help"), listOf(m_help.all()));
    QAction* about = m_help.find("help-about");
    menu.insertMenu(about, m_samples);
    menu.insertSeparator(about);
    addTitled(*m_samples, QT_TRANSLATE_NOOP("Menus", "Open Sa&mple"));
}

void WindowMenus::fillSamples() {
    m_samples->clear();
    for (const SampleJob& sample : sampleJobs())
        connect(m_samples->addAction(sample.name), &QAction::triggered, this,
                [this, file = sample.file] { m_window.files().open(file); });
}

void WindowMenus::retranslate() {
    for (const auto& [menu, title] : m_titles)
        menu->setTitle(QCoreApplication::translate("Menus", title));
    for (CommandActions<MainWindow>* commands : {&m_file, &m_mesh, &m_ofWindow, &m_help})
        commands->retranslate();
    m_layouts->retranslate();
    m_appearance->fill();
    fillSamples();
}

void WindowMenus::followTheme() {
    m_appearance->fill();
}

} // namespace proveout
