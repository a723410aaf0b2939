// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_commands.h"

#include <array>

#include <QApplication>
#include <QMenuBar>

#include "ui/window/about.h"
#include "ui/window/guide_window.h"
#include "ui/window/main_window.h"
#include "ui/window/panel_docks.h"

namespace proveout {

std::span<const char* const> toolBarIds() {
    static constexpr std::array kIds{
        "file-new",       "file-open", "file-save",   "",           "edit-undo",  "edit-redo",
        "edit-find",      "",          "to-start",    "play",       "to-end",     "",
        "view-fit",       "view-iso",  "view-top",    "view-front", "view-right", "",
        "view-wireframe", "view-tint", "view-legend", "path-near",  "",           "export-mesh"};
    return kIds;
}

std::span<const Command<MainWindow>> fileCommands() {
    static const std::array<Command<MainWindow>, 9> kCommands{{
        {"file-new", QT_TRANSLATE_NOOP("FileCommands", "&New"),
         QT_TRANSLATE_NOOP("FileCommands", "Create an empty NC program"), "new", "Ctrl+N", Reach::window,
         [](MainWindow& window) { window.files().newFile(); }},
        {"file-open", QT_TRANSLATE_NOOP("FileCommands", "&Open…"),
         QT_TRANSLATE_NOOP("FileCommands", "Open an NC program or a job"), "open", "Ctrl+O", Reach::window,
         [](MainWindow& window) { window.files().openByDialog(); }},
        separator<MainWindow>(),
        {"file-save", QT_TRANSLATE_NOOP("FileCommands", "&Save"),
         QT_TRANSLATE_NOOP("FileCommands", "Save the NC program, and its job if it has one"), "save",
         "Ctrl+S", Reach::window, [](MainWindow& window) { window.files().save(); }},
        {"file-save-as", QT_TRANSLATE_NOOP("FileCommands", "Save &As…"),
         QT_TRANSLATE_NOOP("FileCommands", "Save the NC program under another name"), "", "Ctrl+Shift+S",
         Reach::window, [](MainWindow& window) { window.files().saveAs(); }},
        {"file-save-job-as", QT_TRANSLATE_NOOP("FileCommands", "Save &Job As…"),
         QT_TRANSLATE_NOOP("FileCommands", "Save stock, tools and parameters of the program as a job"), "",
         "", Reach::window, [](MainWindow& window) { window.files().saveJobAs(); }},
        {"file-save-stock", QT_TRANSLATE_NOOP("FileCommands", "Save S&tock…"),
         QT_TRANSLATE_NOOP("FileCommands", "Save the remaining stock for the next setup"), "stock", "",
         Reach::window, [](MainWindow& window) { window.files().saveStock(); }},
        separator<MainWindow>(),
        {"file-quit", QT_TRANSLATE_NOOP("FileCommands", "&Quit"),
         QT_TRANSLATE_NOOP("FileCommands", "Close Proveout"), "", "Ctrl+Q", Reach::window,
         [](MainWindow& window) { window.close(); }},
    }};
    return kCommands;
}

std::span<const Command<MainWindow>> meshCommands() {
    static const std::array<Command<MainWindow>, 5> kCommands{{
        {"export-mesh", QT_TRANSLATE_NOOP("MeshCommands", "&Export Mesh…"),
         QT_TRANSLATE_NOOP("MeshCommands", "Export the decimated mesh as a closed solid"), "export", "Ctrl+E",
         Reach::window, [](MainWindow& window) { window.files().exportByDialog(true); }},
        {"export-full-mesh", QT_TRANSLATE_NOOP("MeshCommands", "Export &Full-Resolution Mesh…"),
         QT_TRANSLATE_NOOP("MeshCommands", "Export the mesh with every z-map point"), "", "Ctrl+Shift+E",
         Reach::window, [](MainWindow& window) { window.files().exportByDialog(false); }},
        separator<MainWindow>(),
        {"tune", QT_TRANSLATE_NOOP("MeshCommands", "&Tune Decimation"),
         QT_TRANSLATE_NOOP("MeshCommands", "Show the decimation parameters"), "tuning", "", Reach::window,
         [](MainWindow& window) { window.docks().activate(kTuningPanel); }},
        {"default-parameters", QT_TRANSLATE_NOOP("MeshCommands", "&Default Parameters"),
         QT_TRANSLATE_NOOP("MeshCommands", "Reset all decimation parameters to their defaults"), "", "",
         Reach::window,
         [](MainWindow& window) {
             window.session().job().asOneStep([&] { window.session().job().setParameters({}); });
         }},
    }};
    return kCommands;
}

std::span<const Command<MainWindow>> windowCommands() {
    static const std::array<Command<MainWindow>, 2> kCommands{{
        {"full-screen", QT_TRANSLATE_NOOP("WindowCommands", "&Full Screen"),
         QT_TRANSLATE_NOOP("WindowCommands", "Enter or leave full screen"), "", "F11", Reach::window,
         [](MainWindow& window) { window.toggleFullScreen(); }},
        {"reset-layout", QT_TRANSLATE_NOOP("WindowCommands", "&Reset Layout"),
         QT_TRANSLATE_NOOP("WindowCommands", "Restore the default panels and view options"), "", "",
         Reach::window, [](MainWindow& window) { window.resetLayout(); }},
    }};
    return kCommands;
}

std::span<const Command<MainWindow>> helpCommands() {
    static const std::array<Command<MainWindow>, 5> kCommands{{
        {"help-guide", QT_TRANSLATE_NOOP("HelpCommands", "&User Guide"),
         QT_TRANSLATE_NOOP("HelpCommands", "Show the page about the panel that has the focus"), "help", "F1",
         Reach::window,
         [](MainWindow& window) {
             openGuide(window, window.viewport(), window.session().document().isOpen());
         }},
        {"help-keys", QT_TRANSLATE_NOOP("HelpCommands", "&Keys and Mouse"),
         QT_TRANSLATE_NOOP("HelpCommands", "List all keyboard shortcuts and mouse actions"), "", "Shift+F1",
         Reach::window, [](MainWindow& window) { showShortcutList(window, *window.menuBar()); }},
        {"help-start-page", QT_TRANSLATE_NOOP("HelpCommands", "&Start Page"),
         QT_TRANSLATE_NOOP("HelpCommands", "Show samples and recent files"), "", "", Reach::window,
         [](MainWindow& window) { window.showStartPage(); }},
        {"help-about", QT_TRANSLATE_NOOP("HelpCommands", "&About Proveout"),
         QT_TRANSLATE_NOOP("HelpCommands", "Version, licence and the paper"), "", "", Reach::window,
         [](MainWindow& window) { showAbout(window); }},
        {"help-about-qt", QT_TRANSLATE_NOOP("HelpCommands", "About &Qt"),
         QT_TRANSLATE_NOOP("HelpCommands", "About the user interface library"), "", "", Reach::window,
         [](MainWindow&) { QApplication::aboutQt(); }},
    }};
    return kCommands;
}

} // namespace proveout
