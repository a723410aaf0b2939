// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include <QCloseEvent>
#include <QStackedWidget>
#include <QStatusBar>

#include "ui/editor/editor_panel.h"
#include "ui/files/kept_breakpoints.h"
#include "ui/look/wheel_focus.h"
#include "ui/readout/surface_probe.h"
#include "ui/session/playback_commands.h"
#include "ui/window/document_title.h"
#include "ui/window/escape_key.h"
#include "ui/window/file_drop.h"
#include "ui/window/kept_switches.h"
#include "ui/window/layout_menu.h"
#include "ui/window/panel_docks.h"
#include "ui/window/panel_focus.h"
#include "ui/window/space_key.h"
#include "ui/window/start_page.h"
#include "ui/window/status_line.h"
#include "ui/window/undo_commands.h"
#include "ui/window/window_centre.h"
#include "ui/window/window_menus.h"
#include "ui/window/window_state.h"
#include "ui/window/window_tool_bar.h"

namespace proveout {

namespace {

const QString kViewGroup = QStringLiteral("view");
constexpr int kSavedTime = 8000; ///< ms

} // namespace

MainWindow::MainWindow(Session& session, Appearance& appearance)
    : m_session(session), m_appearance(appearance), m_files(new FileFlow(session, *this)),
      m_playback(new PlaybackCommands(session, this)), m_status(new StatusLine(session, *statusBar())),
      m_centre(new WindowCentre(session, appearance, m_files->recent(), this)),
      m_docks(new PanelDocks(*this, m_centre->pages(), {session, *m_playback}, panelTable())),
      m_undo(new UndoCommands(session, editor(), m_docks->jobPanels(), this)) {
    setObjectName(QStringLiteral("main-window"));
    setWindowIcon(QIcon(QStringLiteral(":/icons/proveout.svg")));
    setDockNestingEnabled(true);
    setCentralWidget(m_centre);
    if (const auto* pointer = viewport().findChild<SurfaceProbe*>())
        m_status->follow(*pointer);
    for (QAction* command : m_playback->actions().all()) {
        if (!command->isSeparator())
            viewport().addAction(command); // so that the same keys are active there
    }
    m_menus = new WindowMenus(*this, *m_undo, *m_playback);
    m_toolBar = new WindowToolBar(*this);
    connect(m_toolBar, &WindowToolBar::findingsWanted, this, [this] { m_docks->activate(kProblemsPanel); });
    m_state = std::make_unique<WindowState>(*this, *m_docks, m_menus->layouts(), session.playback());
    followSession();
    followFiles();
    followStartPage();
    showProgramForSearch();
    connect(&m_menus->layouts(), &LayoutMenu::chosen, this, [this] { m_state->arrange(); });
    retranslate();
    new KeptBreakpoints(session, this);
    m_viewOptions =
        new KeptSwitches(kViewGroup, viewport().actions() + m_docks->actionsOf(PanelMenu::view), this);
    m_state->restore();
    showDocument();
    new FileDrop(*m_files, *this);
    new WheelFocus(this);
    new SpaceKey(this);
    new EscapeKey(m_session.contact(), this);
}

MainWindow::~MainWindow() {
    hide(); // moves the focus while all possible targets still exist
}

EditorPanel& MainWindow::editor() {
    return *m_docks->panel<EditorPanel>();
}

QWidget& MainWindow::viewport() {
    return m_centre->viewport();
}

QAction* MainWindow::action(const QString& id) const {
    return id.isEmpty() ? nullptr : findChild<QAction*>(id);
}

void MainWindow::followSession() {
    connect(&m_session.document(), &DocumentHub::changed, this, &MainWindow::titleWindow);
    connect(&m_session.document(), &DocumentHub::textReplaced, this, &MainWindow::showDocument);
    connect(&m_session.document(), &DocumentHub::textReplaced, m_docks, &PanelDocks::fit);
    connect(&m_session.problems(), &ProblemsHub::troubled, this, [this] {
        m_docks->show(kProblemsPanel);
        m_status->reportProblem();
    });
    connect(&m_session.navigation(), &NavigationHub::lineRequested, this,
            [this] { m_docks->show(kProgramPanel); });
    connect(&m_session.navigation(), &NavigationHub::toolRequested, this,
            [this] { m_docks->show(kSetupPanel); });
}

void MainWindow::followFiles() {
    connect(m_files, &FileFlow::closeWanted, this, &QWidget::close);
    connect(m_files, &FileFlow::newBegun, this, [this] {
        m_docks->show(kProgramPanel);
        editor().setFocus();
    });
    connect(m_files, &FileFlow::saved, this,
            [this](const QString& message) { statusBar()->showMessage(message, kSavedTime); });
}

void MainWindow::followStartPage() {
    const StartPage* page = &m_centre->startPage();
    connect(page, &StartPage::openWanted, m_files, &FileFlow::openByDialog);
    connect(page, &StartPage::newWanted, m_files, &FileFlow::newFile);
    connect(page, &StartPage::fileWanted, m_files, &FileFlow::open);
    connect(page, &StartPage::backWanted, this, &MainWindow::showDocument);
}

/// Find opens a bar in the program panel.
void MainWindow::showProgramForSearch() {
    for (const char* id : {"edit-find", "edit-replace", "edit-find-next", "edit-find-previous"})
        connect(action(QLatin1String(id)), &QAction::triggered, this,
                [this] { m_docks->activate(kProgramPanel); });
}

void MainWindow::retranslate() {
    m_docks->retitle();
    m_menus->retranslate();
    m_toolBar->retranslate();
    m_playback->retranslate();
    m_undo->retranslate();
    m_status->retranslate();
    titleWindow();
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    m_state->shown();
    keepFloatingDocksInFront();
}

/// Queued, because window managers put the main window in front of floating docks when it is shown, and some
/// again when they activate it.
void MainWindow::keepFloatingDocksInFront() {
    QMetaObject::invokeMethod(m_docks, &PanelDocks::raiseFloating, Qt::QueuedConnection);
}

QByteArray MainWindow::layout() const {
    return m_state->layout();
}

void MainWindow::setLayout(const QByteArray& layout) {
    m_state->setLayout(layout);
}

void MainWindow::addNotice(QWidget* notice) {
    m_centre->addNotice(notice);
}

void MainWindow::resetLayout() {
    m_state->arrange();
    m_viewOptions->reset();
}

void MainWindow::toggleFullScreen() {
    setWindowState(windowState() ^ Qt::WindowFullScreen);
}

void MainWindow::showStartPage() {
    m_centre->pages().setCurrentWidget(&m_centre->startPage());
    m_docks->focus().activateCentre();
}

void MainWindow::showDocument() {
    m_docks->focus().showPage(m_session.document().isOpen() ? viewport()
                                                            : static_cast<QWidget&>(m_centre->startPage()));
}

void MainWindow::titleWindow() {
    if (!m_session.document().isOpen()) {
        setWindowTitle(QStringLiteral("Proveout"));
        return;
    }
    m_centre->startPage().setOpenDocument(documentName(m_session));
    setWindowTitle(documentTitle(m_session));
    setWindowModified(m_session.document().modified());
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!m_files->mayClose()) {
        event->ignore();
        return;
    }
    m_state->keep();
    event->accept();
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange)
        m_menus->followTheme();
    if (event->type() == QEvent::ActivationChange && isActiveWindow())
        keepFloatingDocksInFront();
}

} // namespace proveout
