// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include <algorithm>
#include <utility>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDataStream>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QKeyEvent>
#include <QMenuBar>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/editor/editor_panel.h"
#include "ui/findings/problems_panel.h"
#include "ui/kept_breakpoints.h"
#include "ui/plots/plots_panel.h"
#include "ui/surface_probe.h"
#include "ui/timeline/timeline_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/wheel_focus.h"
#include "ui/window/about.h"
#include "ui/window/dock_titles.h"
#include "ui/window/document_title.h"
#include "ui/window/first_geometry.h"
#include "ui/window/fitted_dock.h"
#include "ui/window/kept_switches.h"
#include "ui/window/layout_menu.h"
#include "ui/window/main_window_tables.h"
#include "ui/window/panel_focus.h"
#include "ui/window/start_page.h"
#include "ui/window/status_line.h"
#include "ui/window/undo_commands.h"

namespace proveout {

namespace {

constexpr int kLayoutVersion = 5; // raise it when docks change: older layouts are then left alone
const QString kGeometryKey = QStringLiteral("window/geometry");
const QString kStateKey = QStringLiteral("window/state");
const QString kEditorChosenKey = QStringLiteral("window/editor-width-chosen");
const QString kPlayByKey = QStringLiteral("playback/by");
const QString kSpeedKey = QStringLiteral("playback/speed");
const QString kViewGroup = QStringLiteral("view");
constexpr int kToolBarIcon = 20;
constexpr int kMessageTime = 8000; // ms
// In the order of docks().
constexpr std::size_t kProgramDock = 0;
constexpr std::size_t kSetupDock = 1;
constexpr std::size_t kTuningDock = 2;
constexpr std::size_t kProblemsDock = 4;

void bringForward(QDockWidget& dock) {
    dock.show();
    dock.raise();
}

} // namespace

MainWindow::MainWindow(Session& session, Appearance& appearance)
    : m_session(session), m_appearance(appearance), m_files(new FileFlow(session, *this)),
      m_playback(new PlaybackCommands(session, this)), m_status(new StatusLine(session, *statusBar())),
      m_centre(new QStackedWidget(this)), m_startPage(new StartPage(appearance, m_files->recent(), this)),
      m_fileCommands(*this, kFileContext, fileCommands(), this),
      m_meshCommands(*this, kMeshContext, meshCommands(), this),
      m_windowCommands(*this, kWindowContext, windowCommands(), this),
      m_helpCommands(*this, kHelpContext, helpCommands(), this) {
    setObjectName(QStringLiteral("main-window"));
    setWindowIcon(QIcon(QStringLiteral(":/icons/proveout.svg")));
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    makePanels();
    makeDocks();
    m_undo = new UndoCommands(session, *m_editor,
                              {m_docks[kSetupDock]->widget(), m_docks[kTuningDock]->widget()}, this);
    makeMenus();
    makeToolBar();
    connect(&session.document(), &DocumentHub::changed, this, [this] {
        titleWindow();
        titleDocks();
    });
    connect(&session.document(), &DocumentHub::textReplaced, this, &MainWindow::showDocument);
    connect(&session.document(), &DocumentHub::textReplaced, m_editorDock, &FittedDock::fit);
    connect(m_layoutMenu, &LayoutMenu::chosen, this, &MainWindow::arrange);
    connect(&session.problems(), &ProblemsHub::changed, this, &MainWindow::titleDocks);
    connect(&session.problems(), &ProblemsHub::troubled, this, &MainWindow::showProblems);
    connect(&session.navigation(), &NavigationHub::lineRequested, this,
            [this] { bringForward(*m_docks[kProgramDock]); });
    for (const char* id : {"edit-find", "edit-replace", "edit-find-next", "edit-find-previous"})
        connect(action(QLatin1String(id)), &QAction::triggered, this,
                [this] { m_focus->activate(*m_docks[kProgramDock]); });
    connect(&session.navigation(), &NavigationHub::toolRequested, this,
            [this] { bringForward(*m_docks[kSetupDock]); });
    connect(m_startPage, &StartPage::openWanted, m_files, &FileFlow::openByDialog);
    connect(m_startPage, &StartPage::newWanted, m_files, &FileFlow::newFile);
    connect(m_startPage, &StartPage::fileWanted, m_files, &FileFlow::open);
    connect(m_startPage, &StartPage::backWanted, this, &MainWindow::showDocument);
    connect(m_files, &FileFlow::closeWanted, this, &QWidget::close);
    connect(m_files, &FileFlow::newBegun, this, &MainWindow::editNewProgram);
    connect(m_files, &FileFlow::saved, this,
            [this](const QString& message) { statusBar()->showMessage(message, kMessageTime); });
    retranslate();
    new KeptBreakpoints(session, this);
    m_viewOptions = new KeptSwitches(kViewGroup, m_viewport->actions() + m_plots->actions(), this);
    restore();
    showDocument();
    new WheelFocus(this);
    qApp->installEventFilter(this);
}

MainWindow::~MainWindow() {
    hide(); // moves the focus, while all that it could move to is there
}

void MainWindow::makePanels() {
    m_viewport = createViewport(m_session, this);
    if (const auto* pointer = m_viewport->findChild<SurfaceProbe*>())
        m_status->follow(*pointer);
    m_editor = new EditorPanel(m_session, this);
    auto* plots = new PlotsPanel(m_session, this);
    m_plots = plots;
    m_problems = new ProblemsPanel(m_session, this);
    m_timeline = new TimelinePanel(m_session, *m_playback, this);
    for (QAction* action : m_playback->actions().all()) {
        if (action->isSeparator())
            continue;
        m_viewport->addAction(action); // the same keys act in all three
        plots->addKeys(action);
    }
    m_centre->addWidget(m_startPage);
    m_centre->addWidget(m_viewport);
    auto* middle = new QWidget(this);
    auto* layout = new QVBoxLayout(middle);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_centre, 1);
    setCentralWidget(middle);
}

void MainWindow::makeDocks() {
    m_focus = new PanelFocus(*this, *m_centre);
    for (const Dock& row : docks()) {
        auto* dock = new QDockWidget(this);
        dock->setObjectName(QLatin1String(row.id));
        dock->setWidget(row.make(*this));
        if (!row.titleBar)
            dock->setTitleBarWidget(new QWidget(dock));
        QAction* toggle = dock->toggleViewAction();
        toggle->setObjectName(QStringLiteral("show-") + QLatin1String(row.id));
        toggle->setIcon(icon(QLatin1String(row.icon)));
        toggle->setShortcut(QKeySequence(QLatin1String(row.keys)));
        m_focus->add(*dock);
        m_docks.push_back(dock);
    }
    std::vector<QDockWidget*> titled;
    for (std::size_t i = 0; i < m_docks.size(); ++i) {
        if (docks()[i].titleBar)
            titled.push_back(m_docks[i]);
    }
    new DockTitles(*this, std::move(titled));
    m_editorDock = new FittedDock(*this, *m_docks[kProgramDock]);
}

void MainWindow::arrange() {
    const DockLayout& layout = m_layoutMenu->present();
    arrangeDocks(*this, layout);
    m_editorDock->adopt();
    m_session.playback().setPlayBy(layout.playBy);
    m_session.playback().setSpeed(layout.speed * unitSpeed(layout.playBy));
}

void MainWindow::makeToolBar() {
    m_toolBar = addToolBar(QString());
    m_toolBar->setObjectName(QStringLiteral("tool-bar"));
    m_toolBar->setMovable(false);
    m_toolBar->setIconSize({kToolBarIcon, kToolBarIcon});
    for (const char* id : toolBarIds()) {
        if (*id == '\0')
            m_toolBar->addSeparator();
        else if (QAction* command = action(QLatin1String(id)))
            m_toolBar->addAction(command); // the 3D view has none where OpenGL is not to be had
    }
    for (QToolButton* button : m_toolBar->findChildren<QToolButton*>())
        button->setFocusPolicy(Qt::TabFocus);
}

void MainWindow::retranslate() {
    for (const auto& [menu, title] : m_menus)
        menu->setTitle(QCoreApplication::translate(kMenuContext, title));
    titleDocks();
    for (CommandActions<MainWindow>* commands :
         {&m_fileCommands, &m_meshCommands, &m_windowCommands, &m_helpCommands})
        commands->retranslate();
    m_playback->retranslate();
    m_undo->retranslate();
    m_status->retranslate();
    m_layoutMenu->retranslate();
    m_toolBar->setWindowTitle(tr("Toolbar"));
    m_toolBar->toggleViewAction()->setVisible(false); // it stays
    fillChoices();
    fillSamples();
    titleWindow();
}

void MainWindow::titleDocks() {
    for (std::size_t i = 0; i < m_docks.size(); ++i)
        m_docks[i]->setWindowTitle(QCoreApplication::translate(kDockContext, docks()[i].title));
    // Each panel is marked for what it shows.
    for (const auto& [dock, modified] : {std::pair(kProgramDock, m_session.document().text().modified),
                                         std::pair(kSetupDock, m_session.document().jobModified())})
        if (modified)
            m_docks[dock]->setWindowTitle(m_docks[dock]->windowTitle() + u'*');
    if (const std::size_t count = m_session.problems().all().size(); count > 0) {
        QDockWidget* dock = m_docks[kProblemsDock];
        dock->setWindowTitle(QStringLiteral("%1 (%2)").arg(dock->windowTitle()).arg(count));
    }
}

void MainWindow::showProblems() {
    bringForward(*m_docks[kProblemsDock]);
    m_status->tellProblem();
}

void MainWindow::restore() {
    const QSettings settings;
    if (!restoreGeometry(settings.value(kGeometryKey).toByteArray()))
        applyFirstGeometry(*this);
    arrange();
    m_layoutKept = restoreState(settings.value(kStateKey).toByteArray(), kLayoutVersion);
    if (!m_layoutKept)
        return;
    m_editorDock->setChosen(settings.value(kEditorChosenKey, true).toBool());
    restorePlayback();
}

void MainWindow::restorePlayback() {
    const QSettings settings;
    const auto by = static_cast<PlayBy>(
        std::clamp(settings.value(kPlayByKey, static_cast<int>(m_session.playback().state().by)).toInt(), 0,
                   static_cast<int>(PlayBy::time)));
    const double speed = settings.value(kSpeedKey, m_session.playback().state().unitsPerSecond).toDouble();
    m_session.playback().setPlayBy(by);
    if (speed > 0)
        m_session.playback().setSpeed(speed);
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    // Docks take their sizes only once the window has its own.
    if (!std::exchange(m_layoutKept, true))
        arrange();
    // Window managers put the window that came last in front of those that came with it.
    QMetaObject::invokeMethod(this, &MainWindow::raiseFloatingDocks, Qt::QueuedConnection);
}

void MainWindow::raiseFloatingDocks() {
    for (QDockWidget* dock : m_docks) {
        if (dock->isFloating() && dock->isVisible())
            dock->raise();
    }
}

QByteArray MainWindow::layout() const {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << saveGeometry() << saveState(kLayoutVersion) << m_editorDock->isChosen();
    return bytes;
}

void MainWindow::setLayout(const QByteArray& layout) {
    QByteArray geometry;
    QByteArray state;
    QDataStream stream(layout);
    bool editorChosen = true;
    stream >> geometry >> state >> editorChosen;
    if (restoreState(state, kLayoutVersion)) {
        restoreGeometry(geometry);
        m_editorDock->setChosen(editorChosen);
        m_layoutKept = true;
    }
}

void MainWindow::addNotice(QWidget* notice) {
    static_cast<QBoxLayout*>(centralWidget()->layout())->insertWidget(0, notice);
}

void MainWindow::editNewProgram() {
    bringForward(*m_docks[kProgramDock]);
    m_editor->setFocus();
}

void MainWindow::resetLayout() {
    arrange();
    m_viewOptions->reset();
}

void MainWindow::toggleFullScreen() {
    setWindowState(windowState() ^ Qt::WindowFullScreen);
}

void MainWindow::showStartPage() {
    m_centre->setCurrentWidget(m_startPage);
    m_focus->activateCentre();
}

void MainWindow::showTuning() {
    m_focus->activate(*m_docks[kTuningDock]);
}

void MainWindow::showAbout() {
    proveout::showAbout(*this);
}

void MainWindow::showShortcuts() {
    showShortcutList(*this, *menuBar());
}

void MainWindow::showDocument() {
    m_focus->showPage(m_session.document().isOpen() ? *m_viewport : static_cast<QWidget&>(*m_startPage));
}

void MainWindow::titleWindow() {
    if (!m_session.document().isOpen()) {
        setWindowTitle(QStringLiteral("Proveout"));
        return;
    }
    m_startPage->setOpenDocument(documentName(m_session));
    setWindowTitle(documentTitle(m_session));
    setWindowModified(m_session.document().modified());
}

QAction* MainWindow::action(const QString& id) const {
    return id.isEmpty() ? nullptr : findChild<QAction*>(id);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!m_files->mayClose()) {
        event->ignore();
        return;
    }
    QSettings settings;
    settings.setValue(kGeometryKey, saveGeometry());
    settings.setValue(kStateKey, saveState(kLayoutVersion));
    settings.setValue(kEditorChosenKey, m_editorDock->isChosen());
    settings.setValue(kPlayByKey, static_cast<int>(m_session.playback().state().by));
    settings.setValue(kSpeedKey, m_session.playback().state().unitsPerSecond);
    event->accept();
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange)
        fillChoices();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    QString reason;
    if (!FileFlow::droppedFile(*event->mimeData(), reason).isEmpty())
        event->acceptProposedAction();
    else
        statusBar()->showMessage(reason, 5000);
}

void MainWindow::dropEvent(QDropEvent* event) {
    QString reason;
    const QString file = FileFlow::droppedFile(*event->mimeData(), reason);
    if (!file.isEmpty())
        m_files->open(file);
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    // Space plays from anywhere, but controls that are worked by Space keep it.
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space &&
        (qobject_cast<QAbstractButton*>(watched) != nullptr || qobject_cast<QComboBox*>(watched) != nullptr ||
         qobject_cast<QAbstractItemView*>(watched) != nullptr)) {
        event->accept();
        return true;
    }
    return QMainWindow::eventFilter(watched, event);
}

} // namespace proveout
